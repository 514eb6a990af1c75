#include "light_bake.h"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kFlames = 14;

// Whether the segment from + t * way, t in (0,1), is inside low..high of one coordinate; narrows t.
bool slab(double from, double way, double low, double high, dvec2& t) {
  if (std::abs(way) < 1e-12) return from > low && from < high;
  const double a = (low - from) / way;
  const double b = (high - from) / way;
  t = {std::max(t.x, std::min(a, b)), std::min(t.y, std::max(a, b))};
  return t.x < t.y;
}

bool meets(const UprightCylinder& c, const dvec3& from, const dvec3& way) {
  dvec2 t(0, 1);
  if (!slab(from.y, way.y, c.foot.y, c.foot.y + c.height, t)) return false;
  const dvec2 start(from.x - c.foot.x, from.z - c.foot.z);
  const dvec2 step(way.x, way.z);
  const double a = glm::dot(step, step);
  const double b = glm::dot(start, step);
  const double outside = glm::dot(start, start) - c.radius * c.radius;
  if (a < 1e-12) return outside < 0;
  const double root = b * b - a * outside;
  if (root <= 0) return false;
  return std::max(t.x, (-b - std::sqrt(root)) / a) < std::min(t.y, (-b + std::sqrt(root)) / a);
}

}  // namespace

LightBake::LightBake(dvec3 low, dvec3 high, dvec3 fire) : low_(low), high_(high) {
  for (int i = 0; i < kFlames; ++i) {
    const double along = (i + 0.5) / kFlames;
    const double radius = 0.17 * (1 - 0.7 * along);
    flames_.push_back(fire +
                      dvec3(radius * std::cos(2.4 * i), 0.08 + 0.75 * along, radius * std::sin(2.4 * i)));
  }
}

void LightBake::add(const Block& block) {
  blocks_.push_back({block.center, block.half, std::cos(block.turn), std::sin(block.turn)});
}

bool LightBake::visible(const dvec3& from, const dvec3& to) const {
  const dvec3 way = to - from;
  for (const UprightCylinder& cylinder : cylinders_) {
    if (meets(cylinder, from, way)) return false;
  }
  return std::none_of(blocks_.begin(), blocks_.end(), [&](const PlacedBlock& block) {
    // Turned back into the block's axes.
    const auto local = [&block](const dvec3& v) {
      return dvec3(block.cosine * v.x - block.sine * v.z, v.y, block.sine * v.x + block.cosine * v.z);
    };
    const dvec3 start = local(from - block.center);
    const dvec3 step = local(way);
    dvec2 t(0, 1);
    for (int axis = 0; axis < 3; ++axis) {
      if (!slab(start[axis], step[axis], -block.half[axis], block.half[axis], t)) return false;
    }
    return true;
  });
}

// How much of the room's own dim light gets to a point: less in corners and beside what stands there.
double LightBake::openness(const dvec3& point, const dvec3& normal) const {
  double open = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > 0.9) continue;
    for (double distance : {point[axis] - low_[axis], high_[axis] - point[axis]}) {
      open *= 1 - 0.40 * std::exp(-std::max(distance, 0.0) / 0.35);
    }
  }
  if (normal.y < 0.9 || point.y > 0.02) return open;
  for (const UprightCylinder& c : cylinders_) {
    const double away =
        std::max(glm::distance(dvec2(point.x, point.z), dvec2(c.foot.x, c.foot.z)) - c.radius, 0.0);
    open *= 1 - 0.75 * std::exp(-(away + 2 * c.foot.y) / 0.10);
  }
  for (const PlacedBlock& b : blocks_) {
    const dvec3 d = point - b.center;
    const dvec2 local(b.cosine * d.x - b.sine * d.z, b.sine * d.x + b.cosine * d.z);
    const double away = glm::length(glm::max(glm::abs(local) - dvec2(b.half.x, b.half.z), dvec2(0)));
    open *= 1 - 0.75 * std::exp(-(away + 2 * std::max(b.center.y - b.half.y, 0.0)) / 0.10);
  }
  return open;
}

dvec3 LightBake::halfLight(const dvec3& point, const dvec3& normal) const {
  const dvec3 start = point + normal * 0.01;
  double direct = 0;
  for (const dvec3& flame : flames_) {
    const dvec3 toFlame = flame - start;
    const double facing = glm::dot(normal, toFlame);
    if (facing <= 0 || !visible(start, flame)) continue;
    const double squared = glm::dot(toFlame, toFlame) + 0.10;
    direct += facing / (squared * std::sqrt(squared));
  }
  direct /= static_cast<double>(flames_.size());
  const double open = openness(point, normal);
  const dvec3 bounce = dvec3(0.16, 0.085, 0.038) * open;
  const dvec3 night = dvec3(0.030, 0.042, 0.070) * open;
  const dvec3 light = dvec3(5.4, 3.2, 1.5) * (direct * (0.35 + 0.65 * open)) + bounce + night;
  // Bright light saturates, as on film.
  return 1.0 - glm::exp(-0.9 * light);
}

room::Image LightBake::lightmap(int width, int height, dvec3 origin, dvec3 a, dvec3 b) const {
  const dvec3 normal = glm::normalize(glm::cross(a, b));
  return room::generate(width, height, 3, [&](double u, double v, float* out) {
    const dvec3 light = halfLight(origin + a * u + b * v, normal);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(light[i]);
  });
}

}  // namespace particles
