#include "tests/reference/clipping.h"

#include <cmath>
#include <functional>

namespace anteroom::reference {

namespace {

// Positive inside.
using Distance = std::function<double(const Vertex&)>;

constexpr double kGuardBand = 32;  // view volumes

bool finite(const Vertex& v) {
  return std::isfinite(v.clip.x) && std::isfinite(v.clip.y) && std::isfinite(v.clip.z) &&
         std::isfinite(v.clip.w);
}

std::vector<Distance> planes(const gen::State& fixed, double xyBand) {
  std::vector<Distance> result{
      [](const Vertex& v) { return v.clip.w + v.clip.z; },
      [](const Vertex& v) { return v.clip.w - v.clip.z; },
      [xyBand](const Vertex& v) { return xyBand * v.clip.w + v.clip.x; },
      [xyBand](const Vertex& v) { return xyBand * v.clip.w - v.clip.x; },
      [xyBand](const Vertex& v) { return xyBand * v.clip.w + v.clip.y; },
      [xyBand](const Vertex& v) { return xyBand * v.clip.w - v.clip.y; },
  };
  for (size_t i = 0; i < gen::kMaxClipPlanes; ++i)
    if (fixed.clipPlanes[i].enabled) result.push_back([i](const Vertex& v) { return v.planeDistance[i]; });
  return result;
}

}  // namespace

bool pointIsVisible(const Vertex& point, const gen::State& fixed) {
  if (!finite(point) || !(point.clip.w > 0)) return false;
  for (const Distance& distance : planes(fixed, 1))
    if (!(distance(point) >= 0)) return false;
  return true;
}

bool clipLine(Vertex& a, Vertex& b, const gen::State& fixed) {
  if (!finite(a) || !finite(b)) return false;
  double from = 0, to = 1;
  for (const Distance& distance : planes(fixed, 1)) {
    const double da = distance(a), db = distance(b);
    if (!(da >= 0) && !(db >= 0)) return false;
    if (da < 0) from = std::max(from, da / (da - db));
    if (db < 0) to = std::min(to, da / (da - db));
  }
  if (from > to) return false;
  const Vertex start = from > 0 ? mix(a, b, from) : a;
  const Vertex end = to < 1 ? mix(a, b, to) : b;
  a = start;
  b = end;
  return a.clip.w > 0 && b.clip.w > 0;
}

std::vector<Vertex> clipPolygon(std::vector<Vertex> polygon, const gen::State& fixed) {
  for (const Vertex& v : polygon)
    if (!finite(v)) return {};
  for (const Distance& distance : planes(fixed, kGuardBand)) {
    std::vector<Vertex> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vertex& a = polygon[i];
      const Vertex& b = polygon[(i + 1) % polygon.size()];
      const double da = distance(a), db = distance(b);
      if (da >= 0) kept.push_back(a);
      // From the inside to the outside in both directions, so that neighbours share the same new vertex.
      if (da >= 0 && db < 0) kept.push_back(mix(a, b, da / (da - db)));
      if (da < 0 && db >= 0) kept.push_back(mix(b, a, db / (db - da)));
    }
    polygon = std::move(kept);
    if (polygon.size() < 3) return {};
  }
  for (const Vertex& v : polygon)
    if (!(v.clip.w > 0)) return {};
  return polygon;
}

}  // namespace anteroom::reference
