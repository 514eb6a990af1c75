#include "candlelight.h"

#include <algorithm>
#include <cmath>

namespace skinning {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kSamples = 8;
constexpr dvec3 kAmbient(0.050, 0.040, 0.046);

// Whether the way from `from` meets the pillar.
bool meets(const Pillar& pillar, const dvec3& from, const dvec3& way) {
  dvec2 t(0, 1);
  const double low = pillar.foot.y - from.y, high = low + pillar.height;
  if (std::abs(way.y) > 1e-12) {
    t.x = std::max(t.x, std::min(low / way.y, high / way.y));
    t.y = std::min(t.y, std::max(low / way.y, high / way.y));
  } else if (low > 0 || high < 0) {
    return false;
  }
  const dvec2 start(from.x - pillar.foot.x, from.z - pillar.foot.z), step(way.x, way.z);
  const double a = glm::dot(step, step), b = glm::dot(start, step);
  const double outside = glm::dot(start, start) - pillar.radius * pillar.radius;
  if (a < 1e-12) return outside < 0 && t.x < t.y;
  const double root = b * b - a * outside;
  if (root <= 0) return false;
  return std::max(t.x, (-b - std::sqrt(root)) / a) < std::min(t.y, (-b + std::sqrt(root)) / a);
}

// The i-th of the points that stand for a flame, on a spiral over a sphere.
dvec3 spread(int i, double radius) {
  const double height = 1 - (2 * i + 1.0) / kSamples, angle = 2.4 * i;
  const double around = std::sqrt(1 - height * height);
  return radius * dvec3(around * std::cos(angle), height, around * std::sin(angle));
}

}  // namespace

bool Candlelight::visible(const dvec3& from, const dvec3& to) const {
  return std::ranges::none_of(pillars_, [&](const Pillar& pillar) { return meets(pillar, from, to - from); });
}

// How much of the room's own dim light gets to a point: less in corners and beside what stands there.
double Candlelight::openness(const dvec3& point, const dvec3& normal) const {
  double open = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > 0.9) continue;
    for (double distance : {point[axis] - low_[axis], high_[axis] - point[axis]})
      open *= 1 - 0.45 * std::exp(-std::max(distance, 0.0) / 0.30);
  }
  if (normal.y < 0.9) return open;
  for (const Pillar& p : pillars_) {
    if (p.foot.y > point.y + 0.05 || p.foot.y + p.height < point.y + 0.002) continue;
    const double away = glm::distance(dvec2(point.x, point.z), dvec2(p.foot.x, p.foot.z)) - p.radius;
    open *= 1 - 0.70 * std::exp(-std::max(away, 0.0) / (0.02 + 0.5 * p.radius));
  }
  return open;
}

dvec3 Candlelight::halfLight(const dvec3& point, const dvec3& normal) const {
  const dvec3 start = point + normal * 0.004;
  dvec3 light = kAmbient;
  const double open = openness(point, normal);
  light *= open;
  for (const Flame& flame : flames_) {
    double direct = 0;
    for (int i = 0; i < kSamples; ++i) {
      const dvec3 to = flame.position + spread(i, flame.radius);
      const dvec3 way = to - start;
      const double facing = glm::dot(normal, way);
      if (facing <= 0 || !visible(start, to)) continue;
      const double squared = glm::dot(way, way) + 0.012;
      direct += facing / (squared * std::sqrt(squared));
    }
    light += flame.color * (direct / kSamples * (0.5 + 0.5 * open));
    // What comes back from the walls.
    const double distance = glm::distance(point, flame.position);
    light += 0.045 * open * flame.color / (0.6 + distance * distance);
  }
  // Bright light saturates, as on film.
  return 1.0 - glm::exp(-0.9 * light);
}

}  // namespace skinning
