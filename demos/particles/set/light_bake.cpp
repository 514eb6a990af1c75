#include "light_bake.h"

#include <algorithm>
#include <cmath>

namespace particles {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kFlames = 14;

}  // namespace

LightBake::LightBake(dvec3 low, dvec3 high, dvec3 fire) : low_(low), high_(high) {
  for (int i = 0; i < kFlames; ++i) {
    const double along = (i + 0.5) / kFlames;
    const double radius = 0.17 * (1 - 0.7 * along);
    flames_.push_back(fire +
                      dvec3(radius * std::cos(2.4 * i), 0.08 + 0.75 * along, radius * std::sin(2.4 * i)));
  }
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
  for (const room::UprightCylinder& c : obstacles_.cylinders()) {
    const double away =
        std::max(glm::distance(dvec2(point.x, point.z), dvec2(c.foot.x, c.foot.z)) - c.radius, 0.0);
    open *= 1 - 0.75 * std::exp(-(away + 2 * c.foot.y) / 0.10);
  }
  for (const room::Obstacles::PlacedBlock& b : obstacles_.blocks()) {
    const dvec3 beside = glm::abs(b.local(point - b.center)) - b.half;
    const double away = glm::length(glm::max(dvec2(beside.x, beside.z), dvec2(0)));
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
    if (facing <= 0 || obstacles_.blocked(start, toFlame)) continue;
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
