#include "light_bake.h"

#include <OpenImageIO/parallel.h>

#include <algorithm>
#include <cmath>

#include "room/transform.h"

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

// By the distances to what stands within reach.
double LightBake::openness(const dvec3& point, const dvec3& normal) const {
  const Obstacles near = obstacles_.within(point, kOpenRange);
  const glm::dmat3 frame = framePointing(normal);
  double open = 0;
  for (int i = 0; i < kOpenRays; ++i) {
    const dvec2 d = spiral(i, kOpenRays);
    open += near.freeShare(point, frame * dvec3(d, std::sqrt(1 - glm::dot(d, d))) * kOpenRange);
  }
  return open / kOpenRays;
}

dvec3 LightBake::lampLight(const dvec3& start, const dvec3& normal) const {
  dvec3 sum(0);
  for (const Lamp& lamp : lamps_) {
    const dvec3 way = lamp.center - start;
    const double square = std::max(glm::dot(way, way), 1e-9);
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
        if (!obstacles_.blocked(start, to)) seen += 1.0 / kLampRays;
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
      if (here <= 0 || there <= 0 || obstacles_.blocked(start, way)) continue;
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
    if (!obstacles_.blocked(start, ray * kFar)) ++seen;
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
