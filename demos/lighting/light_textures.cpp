#include "light_textures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "room/noise.h"
#include "room/texture.h"

namespace lighting {
namespace {

// NEAREST filtering shows its texels unless they are smaller than pixels.
constexpr int kFalloffSize = 1024;
constexpr int kRampSize = 256;
constexpr int kHighlightSize = 128;
constexpr int kGlowSize = 128;

double ring(double r, double at, double width) {
  return std::exp(-((r - at) / width) * ((r - at) / width));
}

float bulbAt(double x, double y) {
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x) / glm::two_pi<double>() + 0.5;
  const double edge = 1 - room::smoothStep(0.76, 0.97, r);
  const double core = 0.52 + 0.40 * std::exp(-3.2 * r * r);
  const double rings = 0.08 * ring(r, 0.74, 0.05) - 0.05 * ring(r, 0.58, 0.06) + 0.04 * ring(r, 0.42, 0.07);
  // The shade's dents smear the filament into faint spokes.
  const double spokes = room::fractalNoise(angle, 0.5, 24, 1, 3, 401) * 0.16 * room::smoothStep(0.1, 0.6, r);
  return static_cast<float>(std::clamp(edge * (core + rings + spokes), 0.0, 1.0));
}

float lensAt(double x, double y) {
  const double r = std::hypot(x, y);
  const double edge = 1 - room::smoothStep(0.885, 0.945, r);
  const double halo = 0.10 * (1 - room::smoothStep(0.90, 0.99, r));
  const double core = 0.74 + 0.12 * std::exp(-5.0 * r * r);
  const double rings = 0.16 * ring(r, 0.87, 0.030) - 0.12 * ring(r, 0.79, 0.035) +
                       0.07 * ring(r, 0.66, 0.05) - 0.06 * ring(r, 0.50, 0.05) + 0.05 * ring(r, 0.30, 0.06);
  return static_cast<float>(std::clamp(edge * (core + rings) + (1 - edge) * halo, 0.0, 1.0));
}

room::Image falloff(float (*at)(double, double)) {
  return room::generate(kFalloffSize, kFalloffSize, 1,
                        [at](double u, double v, float* out) { *out = at(2 * u - 1, 2 * v - 1); });
}

}  // namespace

room::Image bulbFalloff() {
  return falloff(bulbAt);
}

room::Image lensFalloff() {
  return falloff(lensAt);
}

room::Image rampImage() {
  return room::generate(kRampSize, 1, 1, [](double u, double, float* out) {
    const bool behind = u < 1.0 / kRampSize;
    *out = behind ? 0.0F : static_cast<float>(1 - room::smoothStep(0.8, 1.0 - 1.0 / kRampSize, u));
  });
}

std::array<room::Image, 6> highlightFaces() {
  std::array<room::Image, 6> faces;
  for (int face = 0; face < 6; ++face) {
    faces[static_cast<std::size_t>(face)] =
        room::generate(kHighlightSize, kHighlightSize, 1, [face](double s, double t, float* out) {
          const glm::dvec3 d = room::cubeDirection(face, s, t);
          const double core = ring(d.x, 0, 0.11) * ring(d.y, 0, 0.62);
          const double sheen = ring(d.x, 0, 0.42) * ring(d.y, 0, 0.80);
          *out = static_cast<float>((0.62 * core + 0.38 * sheen) * room::smoothStep(-0.05, 0.35, d.z));
        });
  }
  return faces;
}

room::Image glowImage() {
  return room::generate(kGlowSize, kGlowSize, 1, [](double u, double v, float* out) {
    const double r = std::hypot(2 * u - 1, 2 * v - 1);
    const double soft = std::max(1 - r, 0.0);
    *out = static_cast<float>(soft * soft * (0.35 + 0.65 * std::exp(-18 * r * r)));
  });
}

}  // namespace lighting
