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

double ring(double r, double at, double width) { return std::exp(-((r - at) / width) * ((r - at) / width)); }

float falloffAt(double x, double y) {
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x) / glm::two_pi<double>() + 0.5;
  const double edge = 1 - room::smoothStep(0.80, 0.97, r);
  const double core = 0.50 + 0.42 * std::exp(-3.2 * r * r);
  const double rings = 0.10 * ring(r, 0.78, 0.05) - 0.05 * ring(r, 0.60, 0.06) + 0.05 * ring(r, 0.44, 0.07);
  // The reflector's facets smear the filament into faint spokes.
  const double spokes = room::fractalNoise(angle, 0.5, 24, 1, 3, 401) * 0.14 * room::smoothStep(0.1, 0.6, r);
  return static_cast<float>(std::clamp(edge * (core + rings + spokes), 0.0, 1.0));
}

}  // namespace

room::Image falloffImage() {
  return room::generate(kFalloffSize, kFalloffSize, 1,
                        [](double u, double v, float* out) { *out = falloffAt(2 * u - 1, 2 * v - 1); });
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
          const double cosine = std::max(room::cubeDirection(face, s, t).z, 0.0);
          *out = static_cast<float>(0.60 * std::pow(cosine, 48.0) + 0.40 * std::pow(cosine, 6.0));
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
