#include "candlelight.h"

#include <algorithm>
#include <cmath>

namespace skinning {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::LitPoint;
using room::Obstacles;

constexpr int kSamples = 8;
constexpr dvec3 kAmbient(0.050, 0.040, 0.046);

// The i-th of the points that stand for a flame, on a spiral over a sphere.
dvec3 spread(int i, double radius) {
  const double height = 1 - (2 * i + 1.0) / kSamples, angle = 2.4 * i;
  const double around = std::sqrt(1 - height * height);
  return radius * dvec3(around * std::cos(angle), height, around * std::sin(angle));
}

// How much of the room's own dim light gets to a point: less in corners and beside what stands there.
double opennessAt(const LitPoint& at, const Obstacles& obstacles, const dvec3& low, const dvec3& high) {
  double open = room::opennessInBox(at, low, high, 0.45, 0.30);
  if (at.normal.y < 0.9) return open;
  for (const room::UprightCylinder& c : obstacles.cylinders()) {
    if (c.foot.y > at.position.y + 0.05 || c.foot.y + c.height < at.position.y + 0.002) continue;
    const double away =
        glm::distance(dvec2(at.position.x, at.position.z), dvec2(c.foot.x, c.foot.z)) - c.radius;
    open *= 1 - 0.70 * std::exp(-std::max(away, 0.0) / (0.02 + 0.5 * c.radius));
  }
  return open;
}

dvec3 flameLight(const Flame& flame, const LitPoint& at, const Obstacles& obstacles) {
  double direct = 0;
  for (int i = 0; i < kSamples; ++i) {
    const dvec3 way = flame.position + spread(i, flame.radius) - at.start;
    const double facing = glm::dot(at.normal, way);
    if (facing <= 0 || obstacles.blocked(at.start, way)) continue;
    const double squared = glm::dot(way, way) + 0.012;
    direct += facing / (squared * std::sqrt(squared));
  }
  const double distance = glm::distance(at.position, flame.position);
  const double back = 0.045 * at.open / (0.6 + distance * distance);
  return flame.color * (direct / kSamples * (0.5 + 0.5 * at.open) + back);
}

}  // namespace

room::LightBake candlelightBake(const dvec3& low, const dvec3& high) {
  room::BakeStyle style;
  style.openness = [low, high](const LitPoint& at, const Obstacles& obstacles) {
    return opennessAt(at, obstacles, low, high);
  };
  style.film = room::halfSaturatedAsMixed;
  room::LightBake light(std::move(style));
  light.add([](const LitPoint& at, const Obstacles&) { return kAmbient * at.open; });
  return light;
}

room::Source lightOf(const Flame& flame) {
  return [flame](const LitPoint& at, const Obstacles& obstacles) { return flameLight(flame, at, obstacles); };
}

}  // namespace skinning
