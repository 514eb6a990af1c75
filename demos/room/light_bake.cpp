#include "light_bake.h"

#include <OpenImageIO/parallel.h>

#include <algorithm>
#include <cmath>

#include "transform.h"

namespace room {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kGamma = 2.2;
constexpr double kBrightest = 4.6;  // of linear light, where half of it is displayed as 1
constexpr double kStart = 4e-3;     // metres off the surface where rays begin
constexpr double kOpenRange = 1.1;  // metres beyond which nothing takes ambient light away
constexpr int kOpenRays = 20;
constexpr int kSunRays = 12;
constexpr int kLampRays = 6;
constexpr int kSkyPatches = 4;  // an opening each way

// Narrows t to where from + t * way is between low and high; false if that is nowhere.
bool slab(double from, double way, double low, double high, dvec2& t) {
  if (std::abs(way) < 1e-12) return from > low && from < high;
  const double a = (low - from) / way;
  const double b = (high - from) / way;
  t = {std::max(t.x, std::min(a, b)), std::min(t.y, std::max(a, b))};
  return t.x < t.y;
}

// Where way meets the cylinder, 1 if it does not.
double cylinderEntry(const UprightCylinder& c, const dvec3& from, const dvec3& way) {
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

// Points in the unit disc, each for the same share of it.
dvec2 spiral(int i, int count) {
  const double r = std::sqrt((i + 0.5) / count);
  return r * dvec2(std::cos(2.399963 * i), std::sin(2.399963 * i));
}

glm::dmat3 framePointing(const dvec3& axis) {
  const dvec3 up = std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return glm::transpose(glm::dmat3(rotationToAxes(axis, up)));
}

}  // namespace

double LightBake::entry(const PlacedBlock& block, const dvec3& from, const dvec3& way) {
  // Turned back into the block's axes.
  const auto local = [&block](const dvec3& v) {
    return dvec3(block.cosine * v.x - block.sine * v.z, v.y, block.sine * v.x + block.cosine * v.z);
  };
  const dvec3 start = local(from - block.center);
  const dvec3 step = local(way);
  dvec2 t(0, 1);
  const bool met = slab(start.x, step.x, -block.half.x, block.half.x, t) &&
                   slab(start.y, step.y, -block.half.y, block.half.y, t) &&
                   slab(start.z, step.z, -block.half.z, block.half.z, t);
  return met ? t.x : 1;
}

void LightBake::add(const Block& block) {
  blocks_.push_back({block.center, block.half, std::cos(block.turn), std::sin(block.turn)});
}

bool LightBake::blocked(const dvec3& from, const dvec3& way) const {
  return std::any_of(
             cylinders_.begin(), cylinders_.end(),
             [&](const UprightCylinder& cylinder) { return cylinderEntry(cylinder, from, way) < 1; }) ||
         std::any_of(blocks_.begin(), blocks_.end(),
                     [&](const PlacedBlock& block) { return entry(block, from, way) < 1; });
}

// By the distances to what stands within reach.
double LightBake::openness(const dvec3& point, const dvec3& normal) const {
  const auto isNear = [&](const dvec3& center, double radius) {
    const double reach = kOpenRange + radius;
    const dvec3 way = center - point;
    return glm::dot(way, way) < reach * reach;
  };
  std::vector<const UprightCylinder*> cylinders;
  for (const UprightCylinder& c : cylinders_) {
    if (isNear(c.foot + dvec3(0, c.height / 2, 0), std::hypot(c.radius, c.height / 2)))
      cylinders.push_back(&c);
  }
  std::vector<const PlacedBlock*> blocks;
  for (const PlacedBlock& b : blocks_) {
    if (isNear(b.center, glm::length(b.half))) blocks.push_back(&b);
  }
  const glm::dmat3 frame = framePointing(normal);
  double open = 0;
  for (int i = 0; i < kOpenRays; ++i) {
    const dvec2 d = spiral(i, kOpenRays);
    const dvec3 way = frame * dvec3(d, std::sqrt(1 - glm::dot(d, d))) * kOpenRange;
    double nearest = 1;
    for (const UprightCylinder* c : cylinders) nearest = std::min(nearest, cylinderEntry(*c, point, way));
    for (const PlacedBlock* b : blocks) nearest = std::min(nearest, entry(*b, point, way));
    open += nearest;
  }
  return open / kOpenRays;
}

dvec3 LightBake::lampLight(const dvec3& start, const dvec3& normal) const {
  dvec3 sum(0);
  for (const Lamp& lamp : lamps_) {
    const dvec3 way = lamp.center - start;
    const double square = glm::dot(way, way);
    // A ball is seen by surfaces that face a little away from its middle.
    const double size = lamp.radius / std::sqrt(square);
    const double facing = (glm::dot(normal, way) / std::sqrt(square) + size) / (1 + size);
    if (facing <= 0) continue;
    double seen = 1;
    if (lamp.shadows) {
      const glm::dmat3 frame = framePointing(way / std::sqrt(square));
      seen = 0;
      for (int i = 0; i < kLampRays; ++i) {
        const dvec3 to = way + frame * dvec3(spiral(i, kLampRays) * lamp.radius, 0);
        if (!blocked(start, to)) seen += 1.0 / kLampRays;
      }
    }
    sum += lamp.color * (seen * facing / (square + lamp.radius * lamp.radius));
  }
  return sum;
}

dvec3 LightBake::skyLight(const dvec3& start, const dvec3& normal) const {
  dvec3 sum(0);
  for (const Opening& opening : openings_) {
    const dvec3 inward = glm::cross(opening.a, opening.b);
    const double area = glm::length(inward) / (kSkyPatches * kSkyPatches);
    for (int i = 0; i < kSkyPatches * kSkyPatches; ++i) {
      const dvec2 at = (dvec2(i % kSkyPatches, i / kSkyPatches) + 0.5) / double{kSkyPatches};
      const dvec3 way = opening.corner + opening.a * at.x + opening.b * at.y - start;
      const double square = glm::dot(way, way);
      const double here = glm::dot(normal, way);
      const double there = -glm::dot(glm::normalize(inward), way);
      if (here <= 0 || there <= 0 || blocked(start, way)) continue;
      sum += opening.sky * (here * there * area / (3.14159 * square * square + 0.05));
    }
  }
  return sum;
}

dvec3 LightBake::sunLight(const dvec3& start, const dvec3& normal) const {
  constexpr double kFar = 50;  // metres
  const dvec3 toward = glm::normalize(sun_.toward);
  const double facing = glm::dot(normal, toward);
  if (facing <= 0 || sun_.color == dvec3(0)) return dvec3(0);
  const glm::dmat3 frame = framePointing(toward);
  int seen = 0;
  for (int i = 0; i < kSunRays; ++i) {
    const dvec3 ray = frame * dvec3(spiral(i, kSunRays) * sun_.radius, 1);
    if (!blocked(start, ray * kFar)) ++seen;
  }
  return sun_.color * (facing * seen / kSunRays);
}

dvec3 LightBake::light(const dvec3& point, const dvec3& normal) const {
  const dvec3 start = point + normal * kStart;
  const double open = openness(start, normal);
  return (ambient_ * (0.85 + 0.15 * normal.y) + lampLight(start, normal)) * (0.25 + 0.75 * open) * open +
         skyLight(start, normal) + sunLight(start, normal);
}

glm::vec3 LightBake::halfLight(const dvec3& point, const dvec3& normal) const {
  // Bright light saturates, as on film.
  const dvec3 film = kBrightest * (1.0 - glm::exp(-light(point, normal) / kBrightest));
  return glm::vec3(glm::pow(film, dvec3(1 / kGamma)) * 0.5);
}

Image LightBake::lightmap(int width, int height, dvec3 origin, dvec3 a, dvec3 b) const {
  const dvec3 normal = glm::normalize(glm::cross(a, b));
  return generate(width, height, 3, [&](double u, double v, float* out) {
    const glm::vec3 half = halfLight(origin + a * u + b * v, normal);
    for (int i = 0; i < 3; ++i) out[i] = half[i];
  });
}

std::vector<glm::vec3> LightBake::vertexLight(const MeshData& mesh) const {
  std::vector<glm::vec3> light(mesh.vertices.size());
  OIIO::parallel_for_chunked(
      0, static_cast<std::int64_t>(light.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          const Vertex& v = mesh.vertices[i];
          light[i] = halfLight(v.position, v.normal);
        }
      });
  return light;
}

glm::dmat4 rectangleCoordinates(dvec3 origin, dvec3 a, dvec3 b) {
  // Row 0 of the matrix gives s = dot(p - origin, a) / |a|^2, row 1 t.
  glm::dmat4 rows(0.0);
  rows[0] = glm::dvec4(a, -glm::dot(a, origin)) / glm::dot(a, a);
  rows[1] = glm::dvec4(b, -glm::dot(b, origin)) / glm::dot(b, b);
  rows[3] = glm::dvec4(0, 0, 0, 1);
  return glm::transpose(rows);
}

}  // namespace room
