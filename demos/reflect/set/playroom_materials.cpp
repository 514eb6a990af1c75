#include "playroom_materials.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "playroom.h"
#include "room/noise.h"
#include "room/set/materials.h"

namespace reflect {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::fractalNoise;
using room::fractionOf;
using room::smoothStep;

constexpr double kRail = 0.86;  // height of the panelling

}  // namespace

room::Texel wallpaperTexel(double u, double v) {
  const dvec2 p(u * kPaperWidth, v * kRoomMax.y);
  room::Texel t;
  if (p.y < kRail) {
    const double groove = std::abs(fractionOf(p.x / 0.1) - 0.5) * 0.1;
    t.color = dvec3(0.86, 0.83, 0.76) * (0.70 + 0.30 * smoothStep(0.001, 0.008, groove));
    if (p.y < 0.12) t.color = dvec3(0.82, 0.79, 0.72) * (0.7 + 0.3 * smoothStep(0.0, 0.012, 0.12 - p.y));
    if (p.y > kRail - 0.07)
      t.color = dvec3(0.90, 0.87, 0.80) * (0.75 + 0.25 * smoothStep(0.0, 0.02, p.y - kRail + 0.07));
  } else {
    t.color = dvec3(0.36, 0.52, 0.56);
    const double stripe = std::abs(fractionOf(p.x / 0.4) - 0.5);
    t.color *= 0.97 + 0.06 * smoothStep(0.20, 0.22, stripe);
    const dvec2 cell(0.2, 0.2);
    const int row = static_cast<int>(std::floor(p.y / cell.y));
    const double shift = (row & 1) * 0.5;
    const dvec2 d((fractionOf(p.x / cell.x + shift) - 0.5) * cell.x,
                  (fractionOf(p.y / cell.y) - 0.5) * cell.y);
    const double r = glm::length(d);
    const double angle = std::atan2(d.x, d.y);
    const double star = (row % 3 == 0 ? 0.020 : 0.013) * (0.66 + 0.34 * std::cos(5 * angle));
    t.color = glm::mix(t.color, dvec3(0.95, 0.82, 0.50), 1 - smoothStep(star - 0.002, star + 0.001, r));
  }
  t.color *= 0.97 + 0.08 * fractalNoise(u, v, 6, 18, 4, 930);
  return t;
}

room::Texel boardsTexel(double u, double v) {
  constexpr int kBoards = 7;
  const double across = v * kBoards;
  const int board = static_cast<int>(across);
  room::Texel t = room::wood(fractionOf(u + 0.37 * board), fractionOf(v + 0.21 * board));
  const double tone = 0.88 + 0.24 * room::hash(board, 1, 931);
  const double seam = std::min(fractionOf(across), 1 - fractionOf(across)) / kBoards;
  const double end = std::abs(fractionOf(u + 0.43 * board) - 0.5);
  const double body = smoothStep(0.0008, 0.004, seam) * smoothStep(0.0008, 0.003, end);
  t.color = t.color * dvec3(1.18, 1.05, 0.90) * tone * (0.35 + 0.65 * body);
  return t;
}

room::Texel rugTexel(double u, double v) {
  constexpr dvec3 kWine(0.50, 0.11, 0.13);
  constexpr dvec3 kNavy(0.12, 0.17, 0.32);
  constexpr dvec3 kSand(0.82, 0.70, 0.50);
  dvec3 color = kWine;
  if (v > 0.955) {
    color = kSand;
  } else if (v > 0.86) {
    color = std::abs(fractionOf(u * 48) - 0.5) * 0.17 + 0.865 < v ? kNavy : kSand;
  } else if (v > 0.83) {
    color = kSand;
  } else if (v > 0.50 && v < 0.54) {
    color = kNavy;
  } else if (v < 0.47) {
    const double petals = 0.32 + 0.12 * std::cos(u * 12 * glm::two_pi<double>());
    color = v < petals ? kNavy : kWine;
    if (std::abs(v - petals) < 0.012) color = kSand;
  } else {
    const dvec2 d((fractionOf(u * 24) - 0.5) * 0.30, v - 0.685);
    if (std::abs(d.x) + std::abs(d.y) < 0.085) color = kSand;
    if (std::abs(d.x) + std::abs(d.y) < 0.055) color = kNavy;
  }
  room::Texel t;
  t.color = color * (0.80 + 0.25 * fractalNoise(u, v, 128, 64, 2, 932)) *
            (0.97 + 0.15 * fractalNoise(u, v, 8, 4, 4, 933));
  return t;
}

room::Texel duskTexel(double u, double v) {
  room::Texel t;
  t.color = glm::mix(dvec3(0.62, 0.50, 0.56), dvec3(0.10, 0.19, 0.44), smoothStep(0.05, 0.75, v));
  t.color += dvec3(0.10, 0.08, 0.10) * fractalNoise(u, v, 3, 9, 4, 934);
  const double moon = glm::distance(dvec2(u * 1.2, v), dvec2(0.92, 0.74));
  t.color = glm::mix(t.color, dvec3(0.98, 0.94, 0.82), 1 - smoothStep(0.055, 0.06, moon));
  t.color += dvec3(0.25, 0.24, 0.22) * std::exp(-moon * 9);
  const double x = u * 5;
  const double roof =
      0.10 + 0.10 * room::hash(static_cast<int>(x), 3, 935) + 0.10 * (0.5 - std::abs(fractionOf(x) - 0.5));
  if (v < roof) t.color = dvec3(0.05, 0.055, 0.09);
  return t;
}

room::Texel paintTexel(double u, double v) {
  room::Texel t;
  t.color = dvec3(0.94) *
            (0.98 + 0.10 * fractalNoise(u, v, 4, 24, 4, 940) + 0.06 * fractalNoise(u, v, 6, 6, 3, 941));
  return t;
}

room::Texel vehicleShadowTexel(double u, double v) {
  // Of a box with round corners, by the distance from it.
  const dvec2 beyond = glm::max(glm::abs(dvec2(u, v) - 0.5) - dvec2(0.36, 0.18), dvec2(0));
  const double away = glm::length(beyond / dvec2(0.14, 0.32));
  room::Texel t;
  t.color = dvec3(1 - 0.72 * (1 - smoothStep(0.0, 1.0, away)));
  return t;
}

}  // namespace reflect
