#include "spot_mask.h"

#include <GLES/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "lighting.h"
#include "room/noise.h"
#include "room/passes.h"

namespace lighting {
namespace {

// NEAREST filtering shows its texels unless they are smaller than pixels.
constexpr int kFalloffSize = 1024;
constexpr int kRampSize = 256;

// What a shaded bulb projects: a bright core that fades into spokes; 0 at the edge.
float bulbAt(double x, double y) {
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x) / glm::two_pi<double>() + 0.5;
  const double edge = 1 - room::smoothStep(0.76, 0.97, r);
  const double core = 0.52 + 0.40 * std::exp(-3.2 * r * r);
  const double rings =
      0.08 * room::bell(r, 0.74, 0.05) - 0.05 * room::bell(r, 0.58, 0.06) + 0.04 * room::bell(r, 0.42, 0.07);
  // The shade's dents smear the filament into faint spokes.
  const double spokes = room::fractalNoise(angle, 0.5, 24, 1, 3, 401) * 0.16 * room::smoothStep(0.1, 0.6, r);
  return static_cast<float>(std::clamp(edge * (core + rings + spokes), 0.0, 1.0));
}

// What a stage light projects: an even disc with the rings of its lens; 0 at the edge.
float lensAt(double x, double y) {
  const double r = std::hypot(x, y);
  const double edge = 1 - room::smoothStep(0.885, 0.945, r);
  const double halo = 0.10 * (1 - room::smoothStep(0.90, 0.99, r));
  const double core = 0.74 + 0.12 * std::exp(-5.0 * r * r);
  const double rings = 0.16 * room::bell(r, 0.87, 0.030) - 0.12 * room::bell(r, 0.79, 0.035) +
                       0.07 * room::bell(r, 0.66, 0.05) - 0.06 * room::bell(r, 0.50, 0.05) +
                       0.05 * room::bell(r, 0.30, 0.06);
  return static_cast<float>(std::clamp(edge * (core + rings) + (1 - edge) * halo, 0.0, 1.0));
}

room::Texture falloff(float (*at)(double, double)) {
  const room::Image image =
      room::generate(kFalloffSize, kFalloffSize, 1,
                     [at](double u, double v, float* out) { *out = at(2 * u - 1, 2 * v - 1); });
  return room::makeTexture(image, room::Filter::Nearest, GL_CLAMP_TO_EDGE, GL_ALPHA);
}

// 256x1 along the light's axis: 0 behind the near plane, 1 in front of it, fading out at the range.
room::Image rampImage() {
  return room::generate(kRampSize, 1, 1, [](double u, double, float* out) {
    const bool behind = u < 1.0 / kRampSize;
    *out = behind ? 0.0F : static_cast<float>(1 - room::smoothStep(0.8, 1.0 - 1.0 / kRampSize, u));
  });
}

}  // namespace

SpotMask::SpotMask()
    : falloff_{falloff(bulbAt), falloff(lensAt)},
      ramp_(room::makeTexture(rampImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE, GL_ALPHA)) {}

void SpotMask::draw(const LightVectors& lit, int lightIndex, const Spotlight& light, const glm::dmat4& view,
                    bool cone) const {
  beginPass();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  if (cone) {
    room::useTexture(0, falloff_[static_cast<std::size_t>(lightIndex)]);
    room::modulate();
    room::useTexture(1, ramp_);
    room::modulate();
  }
  for (const auto& [part, colors] : lit.parts()) {
    place(*part, view);
    part->mesh->bindPositions();
    if (part->material->space == NormalSpace::Tangent) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(4, GL_FLOAT, 0, colors->data());
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
      room::setColor(glm::dvec3(1), light.attenuation(glm::distance(centerOf(*part), light.position)));
    }
    if (cone) {
      room::loadTextureMatrix(0, light.projection() * part->model);
      room::loadTextureMatrix(1, light.nearPlane() * part->model);
      room::useTexCoords(0, *part->mesh, true);
      room::useTexCoords(1, *part->mesh, true);
    }
    part->mesh->draw();
  }
}

void drawSpot(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view) {
  beginPass();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  room::setColor(light.color * 0.5);
  for (const LitPart& one : lit.parts()) {
    place(*one.part, view);
    one.part->mesh->bindPositions();
    one.part->mesh->draw();
  }
}

}  // namespace lighting
