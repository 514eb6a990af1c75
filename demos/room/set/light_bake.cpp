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
constexpr int kSunRays = 12;
constexpr int kLampRays = 6;
constexpr int kSkyPatches = 4;  // an opening each way

// Dim light gets into corners less than in proportion to their openness.
double dimShare(double open) {
  return (0.25 + 0.75 * open) * open;
}

dvec3 lampLight(const Lamp& lamp, const LitPoint& at, const Obstacles& obstacles) {
  const dvec3 way = lamp.center - at.start;
  const double square = std::max(glm::dot(way, way), 1e-9);
  // A ball is seen by surfaces that face a little away from its middle.
  const double size = lamp.radius / std::sqrt(square);
  const double facing = (glm::dot(at.normal, way) / std::sqrt(square) + size) / (1 + size);
  if (facing <= 0) return dvec3(0);
  double seen = 1;
  if (lamp.shadows) {
    const glm::dmat3 frame = framePointing(way / std::sqrt(square));
    seen = 0;
    for (int i = 0; i < kLampRays; ++i) {
      const dvec3 to = way + frame * dvec3(spiral(i, kLampRays) * lamp.radius, 0);
      if (!obstacles.blocked(at.start, to)) seen += 1.0 / kLampRays;
    }
  }
  return lamp.color * (seen * facing / (square + lamp.radius * lamp.radius)) * dimShare(at.open);
}

dvec3 skyLight(const Opening& opening, const LitPoint& at, const Obstacles& obstacles) {
  dvec3 sum(0);
  const dvec3 inward = glm::cross(opening.a, opening.b);
  const double area = glm::length(inward) / (kSkyPatches * kSkyPatches);
  for (int i = 0; i < kSkyPatches * kSkyPatches; ++i) {
    const dvec2 patch = (dvec2(i % kSkyPatches, i / kSkyPatches) + 0.5) / double{kSkyPatches};
    const dvec3 way = opening.corner + opening.a * patch.x + opening.b * patch.y - at.start;
    const double square = glm::dot(way, way);
    const double here = glm::dot(at.normal, way);
    const double there = -glm::dot(glm::normalize(inward), way);
    if (here <= 0 || there <= 0 || obstacles.blocked(at.start, way)) continue;
    sum += opening.sky * (here * there * area / (3.14159 * square * square + 0.05));
  }
  return sum;
}

dvec3 sunLight(const Sun& sun, const LitPoint& at, const Obstacles& obstacles) {
  constexpr double kFar = 50;  // metres
  const dvec3 toward = glm::normalize(sun.toward);
  const double facing = glm::dot(at.normal, toward);
  if (facing <= 0) return dvec3(0);
  const glm::dmat3 frame = framePointing(toward);
  int seen = 0;
  for (int i = 0; i < kSunRays; ++i) {
    const dvec3 ray = frame * dvec3(spiral(i, kSunRays) * sun.radius, 1);
    if (!obstacles.blocked(at.start, ray * kFar)) ++seen;
  }
  return sun.color * (facing * seen / kSunRays);
}

}  // namespace

dvec2 spiral(int i, int count) {
  const double r = std::sqrt((i + 0.5) / count);
  return r * dvec2(std::cos(2.399963 * i), std::sin(2.399963 * i));
}

glm::dmat3 framePointing(const dvec3& axis) {
  const dvec3 up = std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return glm::transpose(glm::dmat3(rotationToAxes(axis, up)));
}

Openness opennessByRays(double range, int rays) {
  return [range, rays](const LitPoint& at, const Obstacles& obstacles) {
    const Obstacles near = obstacles.within(at.start, range);
    const glm::dmat3 frame = framePointing(at.normal);
    double open = 0;
    for (int i = 0; i < rays; ++i) {
      const dvec2 d = spiral(i, rays);
      open += near.freeShare(at.start, frame * dvec3(d, std::sqrt(1 - glm::dot(d, d))) * range);
    }
    return open / rays;
  };
}

double opennessInBox(const LitPoint& at, const dvec3& low, const dvec3& high, double share, double reach) {
  double open = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(at.normal[axis]) > 0.9) continue;
    for (double distance : {at.position[axis] - low[axis], high[axis] - at.position[axis]}) {
      open *= 1 - share * std::exp(-std::max(distance, 0.0) / reach);
    }
  }
  return open;
}

dvec3 halfGamma(const dvec3& light) {
  return glm::pow(glm::max(light, dvec3(0)), dvec3(1 / kGamma)) * 0.5;
}

dvec3 halfSaturated(const dvec3& light) {
  return halfGamma(kBrightest * (1.0 - glm::exp(-light / kBrightest)));
}

dvec3 halfSaturatedAsMixed(const dvec3& light) {
  return 1.0 - glm::exp(-0.9 * light);
}

void LightBake::add(const Lamp& lamp) {
  add([lamp](const LitPoint& at, const Obstacles& obstacles) { return lampLight(lamp, at, obstacles); });
}

void LightBake::add(const Opening& opening) {
  add([opening](const LitPoint& at, const Obstacles& obstacles) { return skyLight(opening, at, obstacles); });
}

void LightBake::add(const Sun& sun) {
  add([sun](const LitPoint& at, const Obstacles& obstacles) { return sunLight(sun, at, obstacles); });
}

void LightBake::addAmbient(const dvec3& ambient) {
  add([ambient](const LitPoint& at, const Obstacles&) {
    return ambient * (0.85 + 0.15 * at.normal.y) * dimShare(at.open);
  });
}

dvec3 LightBake::light(const dvec3& point, const dvec3& normal) const {
  LitPoint at{point, normal, point + normal * style_.start};
  if (style_.openness) at.open = style_.openness(at, obstacles_);
  dvec3 sum(0);
  for (const Source& source : sources_) sum += source(at, obstacles_);
  return sum;
}

glm::vec3 LightBake::halfLight(const dvec3& point, const dvec3& normal) const {
  return glm::vec3(style_.film(light(point, normal)));
}

Image LightBake::lightmap(int width, int height, dvec3 origin, dvec3 a, dvec3 b) const {
  const dvec3 normal = glm::normalize(glm::cross(a, b));
  return generate(width, height, 3, [&](double u, double v, float* out) {
    const glm::vec3 half = halfLight(origin + a * u + b * v, normal);
    for (int i = 0; i < 3; ++i) out[i] = half[i];
  });
}

std::vector<glm::vec3> LightBake::vertexLight(const MeshData& mesh, const glm::dmat4& place) const {
  std::vector<glm::vec3> light(mesh.vertices.size());
  OIIO::parallel_for_chunked(
      0, static_cast<std::int64_t>(light.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          const Vertex& v = mesh.vertices[i];
          light[i] = halfLight(glm::dvec3(place * glm::dvec4(v.position, 1.0)), glm::dmat3(place) * v.normal);
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
