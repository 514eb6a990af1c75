#include "daylight.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "room/transform.h"

namespace postprocessing {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kGamma = 2.2;
constexpr dvec3 kAmbient(0.050, 0.055, 0.078);
constexpr double kWindowLight = 1.5;
constexpr double kSunLight = 5.5;
constexpr double kSunRadius = 0.011;  // radians: twice the real one, for the panes are not clear
constexpr int kSunSamples = 12;
constexpr int kOpenSamples = 24;
constexpr double kOpenRange = 1.3;  // metres beyond which nothing takes ambient light away
constexpr double kStart = 2e-3;     // metres off the surface where rays begin

dvec3 linear(const dvec3& display) {
  return glm::pow(glm::clamp(display, 0.0, 1.0), dvec3(kGamma));
}

dvec3 pixelAt(const room::Image& image, double u, double v) {
  const OIIO::ImageSpec& spec = image.spec();
  const int x = std::clamp(static_cast<int>(u * spec.width), 0, spec.width - 1);
  const int y = std::clamp(static_cast<int>(v * spec.height), 0, spec.height - 1);
  const auto* p = static_cast<const float*>(image.pixeladdr(x, y));
  return {p[0], p[1], p[2]};
}

// Points in the unit disc, each for the same share of it.
dvec2 spiral(int i, int count) {
  const double r = std::sqrt((i + 0.5) / count);
  return r * dvec2(std::cos(2.399963 * i), std::sin(2.399963 * i));
}

// Where the ray enters the block, in units of its direction; more than `length` if it does not.
double entry(const Block& block, const dvec3& from, const dvec3& inverse, double length) {
  const dvec3 a = (block.low - from) * inverse;
  const dvec3 b = (block.high - from) * inverse;
  const dvec3 near = glm::min(a, b);
  const dvec3 far = glm::max(a, b);
  const double enter = std::max({near.x, near.y, near.z, 0.0});
  const double leave = std::min({far.x, far.y, far.z});
  return enter < leave ? enter : length + 1;
}

// Axis-parallel rays would make 0 * infinity of a block's face that they lie in.
dvec3 inverseOf(const dvec3& direction) {
  dvec3 inverse;
  for (int i = 0; i < 3; ++i) inverse[i] = 1 / (std::abs(direction[i]) > 1e-9 ? direction[i] : 1e-9);
  return inverse;
}

}  // namespace

Daylight::Daylight(const std::vector<GlazedLancet>& windows, double glassPlane, dvec3 toSun,
                   std::vector<Block> blocks)
    : windows_(windows), glassPlane_(glassPlane), toSun_(glm::normalize(toSun)), blocks_(std::move(blocks)) {
  constexpr int kColumns = 2;
  constexpr int kRows = 8;
  constexpr int kSamples = 12;  // a patch each way
  for (const GlazedLancet& window : windows_) {
    const Lancet& lancet = window.lancet;
    const dvec2 size = dvec2(lancet.width, lancet.top() - lancet.sill) / dvec2(kColumns, kRows);
    for (int i = 0; i < kColumns * kRows; ++i) {
      const dvec2 corner(i % kColumns, i / kColumns);
      dvec3 sum(0);
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const dvec2 uv =
            (corner + (dvec2(k % kSamples, k / kSamples) + 0.5) / double{kSamples}) / dvec2(kColumns, kRows);
        const double x = (uv.x - 0.5) * lancet.width;
        const double y = lancet.sill + uv.y * (lancet.top() - lancet.sill);
        if (lancet.inset(x, y) > 0) sum += linear(pixelAt(window.glass, uv.x, uv.y));
      }
      const dvec2 middle = (corner + 0.5) * size;
      patches_.push_back(
          {dvec3(lancet.center - lancet.width / 2 + middle.x, lancet.sill + middle.y, glassPlane),
           sum * (size.x * size.y / (kSamples * kSamples))});
    }
  }
}

bool Daylight::blocked(const dvec3& from, const dvec3& direction, double length) const {
  const dvec3 inverse = inverseOf(direction);
  return std::any_of(blocks_.begin(), blocks_.end(),
                     [&](const Block& block) { return entry(block, from, inverse, length) < length; });
}

// How much of the hemisphere nothing near stands in, in [0,1], by cosine.
double Daylight::openness(const dvec3& point, const dvec3& normal) const {
  const dvec3 up = std::abs(normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const glm::dmat3 frame = glm::transpose(glm::dmat3(room::rotationToAxes(normal, up)));
  double open = 0;
  for (int i = 0; i < kOpenSamples; ++i) {
    const dvec2 d = spiral(i, kOpenSamples);
    const dvec3 ray = frame * dvec3(d, std::sqrt(1 - glm::dot(d, d)));
    const dvec3 inverse = inverseOf(ray);
    double nearest = kOpenRange;
    for (const Block& block : blocks_) nearest = std::min(nearest, entry(block, point, inverse, kOpenRange));
    open += nearest / kOpenRange;
  }
  return open / kOpenSamples;
}

dvec3 Daylight::throughGlass(const dvec3& point, const dvec3& direction) const {
  const dvec3 hit = point + direction * ((glassPlane_ - point.z) / direction.z);
  for (const GlazedLancet& window : windows_) {
    const Lancet& lancet = window.lancet;
    const double x = hit.x - lancet.center;
    if (std::abs(x) > lancet.width / 2 || lancet.inset(x, hit.y) <= 0) continue;
    return linear(
        pixelAt(window.glass, x / lancet.width + 0.5, (hit.y - lancet.sill) / (lancet.top() - lancet.sill)));
  }
  return dvec3(0);
}

dvec3 Daylight::diffuse(dvec3 point, dvec3 normal) const {
  const dvec3 start = point + normal * kStart;
  const double open = openness(start, normal);
  dvec3 light = kAmbient * (0.8 + 0.2 * normal.y) * open;
  for (const Patch& patch : patches_) {
    const dvec3 way = patch.center - start;
    const double square = glm::dot(way, way);
    const double distance = std::sqrt(square);
    const double here = glm::dot(normal, way) / distance;
    const double there = -way.z / distance;
    if (here <= 0 || there <= 0 || blocked(start, way, 1.0)) continue;
    light += patch.color * (kWindowLight * here * there / (square + 0.05));
  }
  // What the floor throws back of the sun; it lies about this place.
  const dvec3 way = dvec3(0, 0, -2.2) - start;
  const double square = glm::dot(way, way) + 0.8;
  light += dvec3(0.80, 0.56, 0.36) * open * std::max(0.15 + glm::dot(normal, way) / std::sqrt(square), 0.0) *
           std::max(-way.y, 0.05) / (square * std::sqrt(square)) * 0.9;
  return light;
}

dvec3 Daylight::sun(dvec3 point, dvec3 normal) const {
  const double facing = glm::dot(normal, toSun_);
  if (facing <= 0) return dvec3(0);
  const dvec3 start = point + normal * kStart;
  const glm::dmat3 frame = glm::transpose(glm::dmat3(room::rotationToAxes(toSun_, dvec3(0, 1, 0))));
  dvec3 sum(0);
  for (int i = 0; i < kSunSamples; ++i) {
    const dvec3 ray = frame * dvec3(spiral(i, kSunSamples) * kSunRadius, 1);
    const dvec3 color = throughGlass(start, ray);
    if (color == dvec3(0)) continue;
    if (!blocked(start, ray, (glassPlane_ - start.z) / ray.z)) sum += color;
  }
  return sum * (kSunLight * facing / kSunSamples);
}

glm::vec3 displayed(const dvec3& linear, double scale) {
  return glm::vec3(glm::pow(glm::max(linear, dvec3(0)), dvec3(1 / kGamma)) / scale);
}

}  // namespace postprocessing
