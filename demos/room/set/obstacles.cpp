#include "obstacles.h"

#include <algorithm>
#include <cmath>

namespace room {
namespace {

using glm::dvec2;
using glm::dvec3;

// Narrows t to where from + t * way is between low and high; false if that is nowhere.
bool slab(double from, double way, double low, double high, dvec2& t) {
  if (std::abs(way) < 1e-12) return from > low && from < high;
  const double a = (low - from) / way;
  const double b = (high - from) / way;
  t = {std::max(t.x, std::min(a, b)), std::min(t.y, std::max(a, b))};
  return t.x < t.y;
}

// Where way meets the shape, 1 if it does not.
double entry(const UprightCylinder& c, const dvec3& from, const dvec3& way) {
  dvec2 t(0, 1);
  if (!slab(from.y, way.y, c.foot.y, c.foot.y + c.height, t)) return 1;
  const dvec2 start(from.x - c.foot.x, from.z - c.foot.z);
  const dvec2 step(way.x, way.z);
  const double a = glm::dot(step, step);
  const double b = glm::dot(start, step);
  const double outside = glm::dot(start, start) - c.radius * c.radius;
  if (a < 1e-12) return outside < 0 ? t.x : 1;
  const double root = b * b - a * outside;
  if (root <= 0) return 1;
  const double enter = std::max(t.x, (-b - std::sqrt(root)) / a);
  return enter < std::min(t.y, (-b + std::sqrt(root)) / a) ? enter : 1;
}

double entry(const Obstacles::PlacedBlock& block, const dvec3& from, const dvec3& way) {
  const dvec3 start = block.local(from - block.center);
  const dvec3 step = block.local(way);
  dvec2 t(0, 1);
  const bool met = slab(start.x, step.x, -block.half.x, block.half.x, t) &&
                   slab(start.y, step.y, -block.half.y, block.half.y, t) &&
                   slab(start.z, step.z, -block.half.z, block.half.z, t);
  return met ? t.x : 1;
}

}  // namespace

void Obstacles::add(const Block& block) {
  blocks_.push_back({block.center, block.half, std::cos(block.turn), std::sin(block.turn)});
}

bool Obstacles::blocked(const dvec3& from, const dvec3& way) const {
  const auto meets = [&](const auto& shape) { return entry(shape, from, way) < 1; };
  return std::any_of(cylinders_.begin(), cylinders_.end(), meets) ||
         std::any_of(blocks_.begin(), blocks_.end(), meets);
}

double Obstacles::freeShare(const dvec3& from, const dvec3& way) const {
  double nearest = 1;
  for (const UprightCylinder& cylinder : cylinders_) nearest = std::min(nearest, entry(cylinder, from, way));
  for (const PlacedBlock& block : blocks_) nearest = std::min(nearest, entry(block, from, way));
  return nearest;
}

Obstacles Obstacles::within(const dvec3& point, double distance) const {
  const auto isNear = [&](const dvec3& center, double radius) {
    const dvec3 way = center - point;
    return glm::dot(way, way) < (distance + radius) * (distance + radius);
  };
  Obstacles near;
  for (const UprightCylinder& c : cylinders_) {
    if (isNear(c.foot + dvec3(0, c.height / 2, 0), std::hypot(c.radius, c.height / 2)))
      near.cylinders_.push_back(c);
  }
  for (const PlacedBlock& b : blocks_) {
    if (isNear(b.center, glm::length(b.half))) near.blocks_.push_back(b);
  }
  return near;
}

}  // namespace room
