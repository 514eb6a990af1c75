#include "glow.h"

#include <GLES/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "lighting/lighting.h"
#include "room/passes.h"

namespace lighting {
namespace {

constexpr int kGlowSize = 128;

// A soft disc.
room::Image glowImage() {
  return room::generate(kGlowSize, kGlowSize, 1, [](double u, double v, float* out) {
    const double r = std::hypot(2 * u - 1, 2 * v - 1);
    const double soft = std::max(1 - r, 0.0);
    *out = static_cast<float>(soft * soft * (0.35 + 0.65 * std::exp(-18 * r * r)));
  });
}

// The shell of the light's cone. It fades where it is seen edge-on, as there is least air behind it, and with
// distance.
void drawBeam(const Spotlight& light, const glm::dvec3& eye) {
  constexpr int kSides = 64;
  constexpr std::size_t kPoints = 2 * (kSides + 1);
  constexpr int kRings = 16;
  constexpr double kLength = 4.2;
  const glm::dvec3 side = glm::normalize(glm::cross(light.direction, light.up));
  const glm::dvec3 other = glm::cross(side, light.direction);
  const double slope = std::tan(light.halfAngle * 0.92);
  glEnableClientState(GL_COLOR_ARRAY);
  std::array<glm::vec3, kPoints> points;
  std::array<glm::vec4, kPoints> colors;
  glVertexPointer(3, GL_FLOAT, 0, points.data());
  glColorPointer(4, GL_FLOAT, 0, colors.data());
  for (int ring = 0; ring < kRings; ++ring) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto corner = static_cast<double>(i / 2);
      const double along = kLength * (ring + static_cast<double>(i % 2)) / kRings;
      const double angle = glm::two_pi<double>() * corner / kSides;
      const glm::dvec3 out = side * std::cos(angle) + other * std::sin(angle);
      const glm::dvec3 point = light.position + light.direction * along + out * (slope * along);
      const glm::dvec3 normal = glm::normalize(out - light.direction * slope);
      const double facing = glm::dot(normal, glm::normalize(eye - point));
      const double fade = 1 - along / kLength;
      points[i] = point;
      colors[i] = glm::vec4(light.color * (light.beam * fade * fade * facing * facing), 1.0);
    }
    glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(kPoints));
  }
  glDisableClientState(GL_COLOR_ARRAY);
}

}  // namespace

Glow::Glow() : disc_(room::makeTexture(glowImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE)) {}

void Glow::draw(const Scene& scene, const room::Camera& camera) const {
  beginPass();
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  room::useCamera(camera);
  for (const Spotlight& light : scene.lights()) {
    if (light.beam > 0) drawBeam(light, camera.eye);
  }
  room::useTexture(0, disc_);
  room::modulate();
  for (const Spotlight& light : scene.lights()) {
    const double facing = glm::dot(light.direction, glm::normalize(camera.eye - light.position));
    room::setColor(light.color * (0.25 + 0.45 * std::max(facing, 0.0)));
    room::drawBillboard(camera, light.position, 1.3, 0.06);
  }
}

}  // namespace lighting
