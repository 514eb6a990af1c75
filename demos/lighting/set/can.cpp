#include "can.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "room/noise.h"
#include "room/set/materials.h"

namespace lighting {
namespace {

constexpr int kFlutes = 26;
constexpr double kWallTop = 0.775;
constexpr double kSheet = 0.012;

// 1 where the sheet is pressed into vertical flutes.
double fluted(double y) {
  const double lower = room::smoothStep(0.09, 0.12, y) * (1 - room::smoothStep(0.33, 0.36, y));
  const double upper = room::smoothStep(0.42, 0.45, y) * (1 - room::smoothStep(0.60, 0.63, y));
  return std::max(lower, upper);
}

// Walked from the foot up outside, over the rolled rim, down inside to the middle of the bottom.
std::vector<glm::dvec2> canProfile() {
  constexpr int kSteps = 60;
  std::vector<glm::dvec2> profile = {{0.245, 0.0}};
  for (int i = 0; i <= kSteps; ++i) {
    const double y = kWallTop * i / kSteps;
    profile.emplace_back(canRadius(y), y);
  }
  const glm::dvec2 rim(canRadius(kWallTop) - 0.001, kCanHeight - 0.014);
  for (int i = 0; i <= 12; ++i) {
    const double angle = -0.5 + 4.1 * i / 12;
    profile.emplace_back(rim + 0.0155 * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  for (int i = kSteps / 2; i >= 0; --i) {
    const double y = 0.04 + (kWallTop - 0.04) * i * 2 / kSteps;
    profile.emplace_back(canRadius(y) - kSheet, y);
  }
  profile.emplace_back(0.0, 0.04);
  return profile;
}

double heightOf(const room::SurfaceFunction& surface, double v) {
  return surface(0.0, v).y;
}

}  // namespace

double canRadius(double y) {
  const double taper = 0.262 + 0.068 * y / kWallTop;
  return taper +
         0.010 * (room::bell(y, 0.04, 0.014) + room::bell(y, 0.39, 0.016) + 0.8 * room::bell(y, 0.67, 0.013));
}

room::SurfaceFunction canSurface() {
  return [round = room::latheFunction(canProfile())](double u, double v) {
    glm::dvec3 p = round(u, v);
    const double r = std::hypot(p.x, p.z);
    if (r < 0.2) return p;
    const double push = 1 + 0.0055 * fluted(p.y) * std::cos(u * kFlutes * glm::two_pi<double>()) / r;
    return glm::dvec3(p.x * push, p.y, p.z * push);
  };
}

room::Texel canTexel(double u, double v) {
  static const room::SurfaceFunction surface = room::latheFunction(canProfile());
  const double y = heightOf(surface, v);
  const bool outside = v < 0.46;
  room::Texel t = room::zinc(u, v, 44, 42);

  // Dirt gathers at the foot, under the beads and in the flutes; the inside is never clean.
  const double grime = room::fractalNoise(u, v, 10, 8, 3, 201);
  const double low = (1 - room::smoothStep(0.02, 0.22, y + 0.12 * grime)) * 0.65;
  const double groove = 0.5 - 0.5 * std::cos(u * kFlutes * glm::two_pi<double>());
  const double dirt = std::clamp(low + fluted(y) * groove * 0.32 + (outside ? 0.0 : 0.55), 0.0, 0.9);
  t.color = glm::mix(t.color, glm::dvec3(0.19, 0.16, 0.13), dirt);
  t.gloss *= 1 - 0.8 * dirt;

  // Two rows of punched holes under the rim.
  if (outside && y > 0.68) {
    const double circumference = glm::two_pi<double>() * 0.33;
    for (double row : {0.712, 0.742}) {
      const double offset = row > 0.73 ? 0.5 : 0.0;
      const double x = u * 52 + offset;
      const double dx = (room::fractionOf(x) - 0.5) * circumference / 52;
      const double d = std::hypot(dx, y - row);
      const double hole = 1 - room::smoothStep(0.0070, 0.0095, d);
      t.color = glm::mix(t.color, glm::dvec3(0.025), hole);
      t.gloss *= 1 - hole;
      t.height -= 0.004 * (1 - room::smoothStep(0.006, 0.014, d));
    }
  }
  // Dents.
  t.height += 0.010 * room::fractalNoise(u, v, 5, 6, 2, 202);
  return t;
}

room::SurfaceFunction lidSurface() {
  std::vector<glm::dvec2> profile = {{0.0, 0.088}, {0.30, 0.052}, {0.336, 0.046}, {0.340, 0.0}};
  profile.emplace_back(0.349, -0.002);
  profile.emplace_back(0.351, 0.012);
  profile.emplace_back(0.345, 0.05);
  for (int i = 1; i <= 40; ++i) {
    const double r = 0.343 * (1 - i / 40.0);
    const double dome = 0.055 + 0.048 * (1 - (r / 0.343) * (r / 0.343));
    profile.emplace_back(r, dome + 0.007 * (room::bell(r, 0.27, 0.012) + room::bell(r, 0.16, 0.012)));
  }
  return room::latheFunction(profile);
}

room::Texel lidTexel(double u, double v) {
  room::Texel t = room::zinc(u, v, 44, 22);
  const bool below = v < 0.42;
  const double spokes = std::cos(u * 8 * glm::two_pi<double>());
  t.height += 0.010 * room::fractalNoise(u, v, 5, 4, 3, 211) +
              0.005 * room::smoothStep(0.3, 0.8, spokes) * room::bell(v, 0.66, 0.05);
  if (below) {
    t.color *= 0.5;
    t.gloss *= 0.3;
  }
  return t;
}

}  // namespace lighting
