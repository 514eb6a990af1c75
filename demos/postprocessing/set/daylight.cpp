#include "daylight.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

Daylight::Daylight(const std::vector<GlazedLancet>& windows, double glassPlane, const dvec3& toSun)
    : windows_(windows), glassPlane_(glassPlane), toSun_(glm::normalize(toSun)) {
  for (const GlazedLancet& window : windows_) addPatches(window);
}

// Cuts a window into rectangles that shine alike all over.
void Daylight::addPatches(const GlazedLancet& window) {
  constexpr int kColumns = 2;
  constexpr int kRows = 8;
  constexpr int kSamples = 12;  // a patch each way
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
        {dvec3(lancet.center - lancet.width / 2 + middle.x, lancet.sill + middle.y, glassPlane_),
         sum * (size.x * size.y / (kSamples * kSamples))});
  }
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

dvec3 Daylight::sky(const room::LitPoint& at, const room::Obstacles& obstacles) const {
  dvec3 light = kAmbient * (0.8 + 0.2 * at.normal.y) * at.open;
  for (const Patch& patch : patches_) {
    const dvec3 way = patch.center - at.start;
    const double square = glm::dot(way, way);
    const double distance = std::sqrt(square);
    const double here = glm::dot(at.normal, way) / distance;
    const double there = -way.z / distance;
    if (here <= 0 || there <= 0 || obstacles.blocked(at.start, way)) continue;
    light += patch.color * (kWindowLight * here * there / (square + 0.05));
  }
  // What the floor throws back of the sun; it lies about this place.
  const dvec3 way = dvec3(0, 0, -2.2) - at.start;
  const double square = glm::dot(way, way) + 0.8;
  light += dvec3(0.80, 0.56, 0.36) * at.open *
           std::max(0.15 + glm::dot(at.normal, way) / std::sqrt(square), 0.0) * std::max(-way.y, 0.05) /
           (square * std::sqrt(square)) * 0.9;
  return light;
}

dvec3 Daylight::sun(const room::LitPoint& at, const room::Obstacles& obstacles) const {
  const double facing = glm::dot(at.normal, toSun_);
  if (facing <= 0) return dvec3(0);
  const glm::dmat3 frame = room::framePointing(toSun_);
  dvec3 sum(0);
  for (int i = 0; i < kSunSamples; ++i) {
    const dvec3 ray = frame * dvec3(room::spiral(i, kSunSamples) * kSunRadius, 1);
    const dvec3 color = throughGlass(at.start, ray);
    if (color == dvec3(0)) continue;
    if (!obstacles.blocked(at.start, ray * ((glassPlane_ - at.start.z) / ray.z))) sum += color;
  }
  return sum * (kSunLight * facing / kSunSamples);
}

}  // namespace postprocessing
