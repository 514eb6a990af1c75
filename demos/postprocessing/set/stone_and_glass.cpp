#include "stone_and_glass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "room/noise.h"
#include "room/set/materials.h"

namespace postprocessing {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::fractalNoise;
using room::fractionOf;
using room::hash;
using room::smoothStep;

constexpr double kLead = 0.007;  // half the width of a came, metres
constexpr dvec3 kRuby(0.86, 0.09, 0.10);
constexpr dvec3 kCobalt(0.12, 0.26, 0.88);
constexpr dvec3 kGold(0.98, 0.74, 0.20);
constexpr dvec3 kEmerald(0.12, 0.62, 0.34);

int indexOf(double x) {
  return static_cast<int>(std::floor(x));
}

// Metres from x to the nearest multiple of the spacing.
double toLine(double x, double spacing) {
  return std::abs(fractionOf(x / spacing + 0.5) - 0.5) * spacing;
}

struct Pane {
  dvec3 color;
  double edge;      // metres to the nearest came
  double identity;  // in [0,1), one number a pane
};

// A flower of eight petals about a golden disc.
Pane medallion(dvec2 p, double radius) {
  const double r = glm::length(p);
  const double turn = (std::atan2(p.y, p.x) / glm::two_pi<double>() + 0.5) * 8;
  const int petal = indexOf(turn) & 7;
  const double spoke = toLine(turn, 1.0) * glm::two_pi<double>() / 8 * r;
  const double core = 0.30 * radius;
  const double rim = 0.74 * radius;
  const double edge = std::min({std::abs(r - core), std::abs(r - rim), radius - r});
  if (r < core) return {kGold, edge, 0.8};
  const bool even = (petal & 1) == 0;
  if (r < rim) return {even ? kRuby : kCobalt, std::min(edge, spoke), hash(petal, 1, 611)};
  return {even ? kEmerald : kGold, std::min(edge, spoke), hash(petal, 2, 611)};
}

Pane diamonds(double x, double y) {
  constexpr double kPane = 0.105;
  const double a = (x + y * 0.62) / kPane;
  const double b = (x - y * 0.62) / kPane;
  const double identity = hash(indexOf(a), indexOf(b), 612);
  dvec3 color = glm::mix(dvec3(1.06, 0.98, 0.74), dvec3(0.90, 1.02, 0.94), identity);
  if (hash(indexOf(a), indexOf(b), 613) > 0.86) color = {0.97, 0.80, 0.42};
  return {color, std::min(toLine(a, 1.0), toLine(b, 1.0)) * kPane * 0.85, identity};
}

Pane paneAt(const Lancet& lancet, double x, double y, double inset) {
  constexpr double kBorder = 0.10;
  constexpr double kSegment = 0.17;
  if (inset < kBorder) {
    const int segment = indexOf(y / kSegment);
    const std::array<dvec3, 3> colors = {kRuby, kCobalt, kGold};
    return {colors[static_cast<std::size_t>(((segment % 3) + 3) % 3)],
            std::min({inset, kBorder - inset, toLine(y, kSegment)}), hash(segment, x < 0 ? 1 : 2, 614)};
  }
  const double radius = lancet.width / 2 - kBorder - 0.045;
  const double spacing = 2.45 * radius;
  const double first = lancet.spring + radius * 0.35;
  const double along = (first - y) / spacing;
  const dvec2 fromCenter(x, (fractionOf(along + 0.5) - 0.5) * spacing);
  const double outside = glm::length(fromCenter) - radius;
  const bool inGlass = along > -0.5 && first - std::round(along) * spacing - radius > lancet.sill + kBorder;
  if (outside < 0 && inGlass) return medallion(fromCenter, radius);
  Pane pane = diamonds(x, y);
  pane.edge = std::min(pane.edge, inset - kBorder);
  if (inGlass) pane.edge = std::min(pane.edge, outside);
  return pane;
}

}  // namespace

double Lancet::archAt(double x) const {
  const double side = std::abs(x) + width / 2;
  return spring + std::sqrt(std::max(width * width - side * side, 0.0));
}

double Lancet::inset(double x, double y) const {
  const double beside =
      y < spring ? width / 2 - std::abs(x) : width - std::hypot(std::abs(x) + width / 2, y - spring);
  return std::min(beside, y - sill);
}

dvec3 stainedGlass(const Lancet& lancet, double u, double v) {
  const double x = (u - 0.5) * lancet.width;
  const double y = lancet.sill + v * (lancet.top() - lancet.sill);
  const Pane pane = paneAt(lancet, x, y, lancet.inset(x, y));
  const double streak = fractalNoise(u, v, 6, 20, 4, 615);
  dvec3 color = pane.color * (0.86 + 0.22 * pane.identity + 0.25 * streak);
  color *= 0.90 + 0.18 * v;  // brighter towards the sky
  const double bar = smoothStep(0.010, 0.015, toLine(y, 0.48));
  return color * smoothStep(kLead * 0.7, kLead * 1.3, pane.edge) * bar;
}

room::Texel ashlar(double u, double v) {
  constexpr int kColumns = 4;
  constexpr int kRows = 8;
  const dvec2 size = dvec2(kAshlarExtent) / dvec2(kColumns, kRows);
  const int row = indexOf(v * kRows);
  // Every course breaks its joints elsewhere.
  const double x = u * kColumns + (row & 1) * 0.5 + (hash(row, 1, 621) - 0.5) * 0.3;
  const int column = ((indexOf(x) % kColumns) + kColumns) % kColumns;
  const dvec2 inCell = dvec2(fractionOf(x), fractionOf(v * kRows)) * size;
  const dvec2 toEdge = glm::min(inCell, size - inCell);
  const double grain = fractalNoise(u, v, 64, 64, 3, 622);
  const double body =
      smoothStep(0.004, 0.012, std::min(toEdge.x, toEdge.y) + 0.006 * fractalNoise(u, v, 48, 48, 2, 623));
  const double tone = hash(column, row, 624);
  dvec3 color = glm::mix(dvec3(0.60, 0.55, 0.47), dvec3(0.72, 0.67, 0.58), tone);
  color *= 0.95 + 0.22 * grain + 0.25 * fractalNoise(u, v, 5, 5, 4, 625);
  const double damp = smoothStep(0.05, 0.5, fractalNoise(u, v, 3, 3, 4, 626));
  color = glm::mix(color, dvec3(0.36, 0.35, 0.31), 0.45 * damp);
  room::Texel t;
  t.color = glm::mix(dvec3(0.38, 0.35, 0.31), color, body);
  t.height = body * 0.006 + grain * 0.003;
  return t;
}

room::Texel flagstones(double u, double v) {
  constexpr int kRows = 4;
  const int row = indexOf(v * kRows);
  const int columns = 3 + (row & 1);
  const double x = u * columns + hash(row, 1, 631);
  const int column = indexOf(x) % columns;
  const dvec2 size(kFlagstoneExtent / columns, kFlagstoneExtent / kRows);
  const dvec2 inCell = dvec2(fractionOf(x), fractionOf(v * kRows)) * size;
  const dvec2 toEdge = glm::min(inCell, size - inCell);
  const double grain = fractalNoise(u, v, 96, 96, 3, 632);
  const double body =
      smoothStep(0.003, 0.012, std::min(toEdge.x, toEdge.y) + 0.010 * fractalNoise(u, v, 32, 32, 2, 633));
  dvec3 color = glm::mix(dvec3(0.50, 0.48, 0.45), dvec3(0.70, 0.65, 0.57), hash(column, row, 634));
  color *= 0.95 + 0.18 * grain + 0.35 * fractalNoise(u, v, 6, 6, 4, 635);
  room::Texel t;
  t.color = glm::mix(dvec3(0.20, 0.18, 0.16), color, body);
  t.height = body * 0.005 + grain * 0.001;
  return t;
}

room::Texel brass(double u, double v) {
  room::Texel t;
  const double tarnish = fractalNoise(u, v, 4, 4, 5, 641);
  t.color = glm::mix(dvec3(0.86, 0.66, 0.28), dvec3(0.40, 0.30, 0.14), smoothStep(-0.2, 0.35, tarnish));
  t.gloss = 0.8;
  return t;
}

}  // namespace postprocessing
