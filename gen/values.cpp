#include "gen/values.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace anteroom::gen {
namespace {

glm::dvec3 normalizeOrZero(glm::dvec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  v /= largest;
  return v / glm::length(v);
}

glm::dvec4 largestOne(const glm::dvec4& v) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) largest = std::max(largest, std::abs(v[i]));
  return largest > 0 && std::isfinite(largest) ? v / largest : v;
}

// Columns such that cofactors(M) * n is n M^-1 times the determinant, also when there is no inverse.
glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

double largestEntry(const glm::dmat3& m) {
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
  return largest;
}

bool fitsFloat(const glm::dmat3& m) {
  return largestEntry(m) < 1e37;
}

// Cofactors / (determinant * scale) is the inverse transpose. The upper matrix is scaled first so that
// neither product can overflow or vanish when the matrix is far from 1. All 0 for a matrix that is 0 or not
// finite.
struct Cofactors {
  explicit Cofactors(const glm::dmat4& matrix) {
    const glm::dmat3 upper(matrix);
    scale = largestEntry(upper);
    if (!(scale > 0) || !std::isfinite(scale)) return;
    const glm::dmat3 unit = upper / scale;
    m = cofactors(unit);
    determinant = glm::dot(unit[0], m[0]);
  }
  double sign() const { return determinant < 0 ? -1 : 1; }

  glm::dmat3 m{0.0};
  double scale = 0, determinant = 0;
};

}  // namespace

glm::dmat4 clipProjection(const State& state) {
  glm::dmat4 m = state.projection;
  for (int c = 0; c < 4; ++c) m[c][2] = (m[c][2] + m[c][3]) * 0.5;
  return m;
}

glm::dmat4 modelviewProjection(const State& state) {
  glm::dmat4 m = state.projection * state.modelview;
  for (int c = 0; c < 4; ++c) m[c][2] = (m[c][2] + m[c][3]) * 0.5;
  return m;
}

glm::dmat3 normalMatrix(const glm::dmat4& matrix, bool rescale) {
  const Cofactors c(matrix);
  if (rescale) {                                // f = 1 / |third row of the inverse|
    const double length = glm::length(c.m[2]);  // this row, times the determinant
    return length > 0 ? c.m * (c.sign() / length) : c.m;
  }
  const glm::dmat3 inverseTranspose = c.m / (c.determinant * c.scale);
  if (c.determinant != 0 && fitsFloat(inverseTranspose)) return inverseTranspose;
  const glm::dmat3 own = c.m * c.scale * c.scale;
  return fitsFloat(own) ? own : c.m;
}

glm::dmat3 normalMatrix(const State& state) {
  if (!state.lighting.normalize) return normalMatrix(state.modelview, state.lighting.rescaleNormal);
  const Cofactors c(state.modelview);
  const double largest = largestEntry(c.m);  // only the direction matters
  return largest > 0 ? c.m * (c.sign() / largest) : c.m;
}

glm::dvec3 currentEyeNormal(const State& state) {
  const glm::dvec3 normal = normalMatrix(state) * glm::dvec3(state.attributes[kNormal].current);
  return state.lighting.normalize ? normalizeOrZero(normal) : normal;
}

glm::dvec4 eyePlane(const ClipPlane& plane) {
  return largestOne(plane.equation);
}

glm::dvec4 objectPlane(const State& state, const ClipPlane& plane) {
  return largestOne(glm::transpose(state.modelview) * plane.equation);
}

const ClipPlane& enabledPlane(const State& state, int index) {
  for (const ClipPlane& plane : state.clipPlanes)
    if (plane.enabled && index-- == 0) return plane;
  return state.clipPlanes[0];
}

glm::dvec4 currentTexCoord(const State& state, int unit) {
  const glm::dvec4 coord = state.units[unit].matrix * glm::dvec4(state.attributes[texCoord(unit)].current);
  return coord.w == 0 ? coord : coord / coord.w;
}

const Light& enabledLight(const State& state, int index) {
  for (const Light& light : state.lighting.lights)
    if (light.enabled && index-- == 0) return light;
  return state.lighting.lights[0];
}

glm::dvec3 lightPosition(const Light& light) {
  return glm::dvec3(light.position) / light.position.w;
}

glm::dvec3 lightDirection(const Light& light) {
  return normalizeOrZero(glm::dvec3(light.position));
}

glm::dvec3 halfVector(const Light& light) {
  return normalizeOrZero(lightDirection(light) + glm::dvec3(0, 0, 1));
}

glm::dvec3 spotDirection(const Light& light) {
  return normalizeOrZero(light.spotDirection);
}

double cosCutoff(const Light& light) {
  return light.spotCutoff == 90 ? 0 : std::cos(light.spotCutoff * std::numbers::pi / 180);
}

double constantSpot(const Light& light) {
  if (light.spotCutoff == 180) return 1;
  const double cosine = std::max(glm::dot(-lightDirection(light), spotDirection(light)), 0.0);
  return cosine < cosCutoff(light) ? 0 : std::pow(cosine, static_cast<double>(light.spotExponent));
}

bool variesByVertex(const Light& light) {
  return light.position.w != 0 && (light.spotCutoff != 180 || light.attenuation != glm::vec3(1, 0, 0));
}

glm::dvec3 constantAmbient(const State& state) {
  glm::dvec3 sum(state.lighting.modelAmbient);
  for (const Light& light : state.lighting.lights) {
    if (!light.enabled || variesByVertex(light)) continue;
    sum += glm::dvec3(light.ambient) * (light.position.w == 0 ? constantSpot(light) : 1.0);
  }
  return sum;
}

glm::dvec4 viewportTransform(const Rect& viewport) {
  const glm::dvec2 half(viewport.width / 2.0, viewport.height / 2.0);
  return {viewport.x + half.x, viewport.y + half.y, half};
}

glm::dvec2 pointSizeRange(const Points& points) {
  const double most = std::clamp(points.sizeMax, points.deviceMin, points.deviceMax);
  const double least = std::clamp(points.sizeMin, points.deviceMin, points.deviceMax);
  return {std::min(least, most), most};
}

float smallestPointSize(const State& state) {
  return static_cast<float>(pointSizeRange(state.points).x);
}

float constantPointSize(const State& state) {
  const Points& points = state.points;
  const glm::dvec2 range = pointSizeRange(points);
  const double size = std::clamp(static_cast<double>(points.size), range.x, range.y);
  const bool whole = !points.sprite && !points.smooth && !state.multisample;
  return static_cast<float>(whole ? std::max(1.0, std::floor(size + 0.5)) : size);
}

}  // namespace anteroom::gen
