#include "firelight.h"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::LitPoint;
using room::Obstacles;

constexpr int kFlames = 14;

// Bright light saturates but stays the fire's: per channel alone, iron beside the flames would turn grey.
dvec3 warmFilm(const dvec3& light) {
  const double brightest = std::max({light.r, light.g, light.b, 1e-9});
  const dvec3 inColor = light * ((1 - std::exp(-0.9 * brightest)) / brightest);
  return glm::mix(room::halfSaturatedAsMixed(light), inColor, 0.6);
}

// What a thing takes of the dim light on the floor beside it.
double besideThing(double away, double foot) {
  return 1 - 0.75 * std::exp(-(away + 2 * foot) / 0.10);
}

// Less in the room's corners and on the floor beside what stands there.
double opennessAt(const LitPoint& at, const Obstacles& obstacles, const dvec3& low, const dvec3& high) {
  double open = room::opennessInBox(at, low, high, 0.40, 0.35);
  if (at.normal.y < 0.9 || at.position.y > 0.02) return open;
  for (const room::UprightCylinder& c : obstacles.cylinders()) {
    const double away =
        glm::distance(dvec2(at.position.x, at.position.z), dvec2(c.foot.x, c.foot.z)) - c.radius;
    open *= besideThing(std::max(away, 0.0), c.foot.y);
  }
  for (const Obstacles::PlacedBlock& b : obstacles.blocks()) {
    const dvec3 beside = glm::abs(b.local(at.position - b.center)) - b.half;
    const double away = glm::length(glm::max(dvec2(beside.x, beside.z), dvec2(0)));
    open *= besideThing(away, std::max(b.center.y - b.half.y, 0.0));
  }
  return open;
}

// Of places all over the flames, which makes shadows soft.
dvec3 flamesLight(const std::vector<dvec3>& flames, const LitPoint& at, const Obstacles& obstacles) {
  double direct = 0;
  for (const dvec3& flame : flames) {
    const dvec3 way = flame - at.start;
    const double facing = glm::dot(at.normal, way);
    if (facing <= 0 || obstacles.blocked(at.start, way)) continue;
    const double squared = glm::dot(way, way) + 0.10;
    direct += facing / (squared * std::sqrt(squared));
  }
  direct /= static_cast<double>(flames.size());
  return dvec3(5.4, 3.2, 1.5) * (direct * (0.35 + 0.65 * at.open));
}

}  // namespace

room::LightBake firelightBake(const dvec3& low, const dvec3& high, const dvec3& fire) {
  room::BakeStyle style;
  style.start = 0.01;
  style.openness = [low, high](const LitPoint& at, const Obstacles& obstacles) {
    return opennessAt(at, obstacles, low, high);
  };
  style.film = warmFilm;
  room::LightBake light(std::move(style));
  std::vector<dvec3> flames;
  for (int i = 0; i < kFlames; ++i) {
    const double along = (i + 0.5) / kFlames;
    const double radius = 0.17 * (1 - 0.7 * along);
    flames.push_back(fire +
                     dvec3(radius * std::cos(2.4 * i), 0.08 + 0.75 * along, radius * std::sin(2.4 * i)));
  }
  light.add([flames](const LitPoint& at, const Obstacles& obstacles) {
    return flamesLight(flames, at, obstacles);
  });
  // What the walls throw back, and the night outside.
  light.add([](const LitPoint& at, const Obstacles&) {
    return (dvec3(0.16, 0.085, 0.038) + dvec3(0.030, 0.042, 0.070)) * at.open;
  });
  return light;
}

}  // namespace particles
