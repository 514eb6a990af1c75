#include "parlour_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "room/noise.h"
#include "room/set/materials.h"

namespace skinning {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::fractionOf;
using room::smoothStep;

// 1 inside a shape whose edge is where the distance is 0.
double inside(double distance, double soft) {
  return 1 - smoothStep(-soft, soft, distance);
}
double line(double distance, double width, double soft) {
  return 1 - smoothStep(width - soft, width + soft, std::abs(distance));
}

// A leaf from the origin along +y.
double leaf(dvec2 p, double length, double width) {
  const double t = glm::clamp(p.y / length, 0.0, 1.0);
  const double half = width * std::sin(glm::pi<double>() * std::pow(t, 0.75));
  return std::max(std::abs(p.x) - half, std::max(-p.y, p.y - length));
}

// As seen from axes that are turned clockwise.
dvec2 turnedBy(dvec2 p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle), p.y * std::cos(angle) + p.x * std::sin(angle)};
}

// The damask's flower around the origin, about 1 wide and 2 high, mirrored.
double flower(dvec2 p) {
  p.x = std::abs(p.x);
  double shape = inside(leaf(p - dvec2(0, -0.12), 0.62, 0.15), 0.012);
  const double cut = inside(leaf(p - dvec2(0, 0.02), 0.36, 0.055), 0.012);
  for (int i = 0; i < 4; ++i) {
    const double angle = 0.42 + 0.52 * i;
    shape = std::max(
        shape, inside(leaf(turnedBy(p - dvec2(0, -0.10 - 0.05 * i), angle), 0.52 - 0.07 * i, 0.085), 0.012));
  }
  for (int i = 0; i < 2; ++i) {
    const double angle = 2.3 + 0.45 * i;
    shape = std::max(shape, inside(leaf(turnedBy(p - dvec2(0, -0.30), angle), 0.42, 0.07), 0.012));
  }
  shape = std::max(shape, inside(glm::length(p - dvec2(0, -0.74)) - 0.085, 0.012));
  return shape * (1 - cut);
}

// A star of n points as a distance, about the origin.
double starShape(dvec2 p, double radius, int points) {
  const double step = glm::two_pi<double>() / points;
  const double angle = std::atan2(p.x, p.y);
  const double within = std::abs(fractionOf(angle / step + 0.5) - 0.5) * 2;
  return glm::length(p) - radius * glm::mix(1.0, 0.38, within);
}

double moonShape(dvec2 p, double radius) {
  return std::max(glm::length(p) - radius,
                  0.84 * radius - glm::length(p - dvec2(0.42 * radius, 0.06 * radius)));
}

// A disc with rays between `inner` and `outer`.
double sunShape(dvec2 p, double inner, double outer, int rays) {
  return std::min(glm::length(p) - 0.82 * inner, std::max(starShape(p, outer, rays), inner - glm::length(p)));
}

// Circles, spokes and signs between the radii 0 and 1: how much gold.
double wheel(dvec2 p, double soft) {
  const double r = glm::length(p);
  double gold = 0;
  for (double radius : {0.385, 0.40, 0.60, 0.745, 0.76})
    gold = std::max(gold, line(r - radius, 0.0035, soft));
  const double angle = std::atan2(p.y, p.x) / glm::two_pi<double>() + 0.5;
  const double twelfth = fractionOf(angle * 12) - 0.5;
  const double across = twelfth / 12 * glm::two_pi<double>() * r;
  if (r > 0.40 && r < 0.745)
    gold = std::max(gold, line((0.5 - std::abs(twelfth)) / 12 * 6.2832 * r, 0.003, soft));
  // Degrees.
  const double tick = std::abs(fractionOf(angle * 72) - 0.5) / 72 * glm::two_pi<double>() * r;
  if (r > 0.745 && r < 0.79) gold = std::max(gold, line(tick, 0.0022, soft));
  // A sign in each house, and a star in each field.
  const int house = static_cast<int>(std::floor(angle * 12));
  const dvec2 sign(across, r - 0.672);
  const double kSize = 0.047;
  double shape = 1;
  switch (house % 4) {
    case 0:
      shape = moonShape(sign, kSize);
      break;
    case 1:
      shape = std::abs(glm::length(sign) - 0.7 * kSize) - 0.007;
      shape = std::min(shape, glm::length(sign) - 0.012);
      break;
    case 2:
      shape = starShape(sign, 1.1 * kSize, 5);
      break;
    default:
      shape = std::max(std::abs(std::abs(sign.x) + 0.6 * sign.y - 0.02) - 0.008, std::abs(sign.y) - kSize);
      break;
  }
  gold = std::max(gold, inside(shape, soft));
  gold = std::max(gold, inside(starShape({across, r - 0.50}, 0.034, 6), soft));
  return gold;
}

}  // namespace

room::Texel damask(double u, double v) {
  // Half-drop: two columns, the second moved by half a repeat.
  const dvec2 place(2 * u, 2 * v);
  double shape = 0;
  for (int dx = -1; dx <= 2; ++dx) {
    for (int dy = -1; dy <= 2; ++dy) {
      const dvec2 center(dx + 0.5, 2 * dy + ((dx & 1) != 0 ? 1.0 : 0.0));
      const dvec2 d = (place - center) * dvec2(1.05, 1.0);
      if (std::abs(d.x) < 0.8 && std::abs(d.y) < 1.1) shape = std::max(shape, flower(d));
    }
  }
  const double weave = room::fractalNoise(u, v, 90, 90, 2, 911);
  const double faded = room::fractalNoise(u, v, 3, 3, 3, 912);
  room::Texel t;
  t.color = glm::mix(dvec3(0.33, 0.085, 0.105), dvec3(0.52, 0.235, 0.150), 0.85 * shape);
  t.color *= 0.95 + 0.16 * weave + 0.16 * faded;
  return t;
}

room::Texel floorboards(double u, double v) {
  constexpr int kBoards = 7;
  const double row = v * kBoards;
  const int number = static_cast<int>(std::floor(row));
  room::Texel t = room::wood(fractionOf(u + room::hash(number, 1, 921)),
                             fractionOf(0.5 * v + room::hash(number, 2, 921)));
  const double edge = std::min(fractionOf(row), 1 - fractionOf(row));
  t.color *= (0.42 + 0.18 * room::hash(number, 3, 921)) * (0.25 + 0.75 * smoothStep(0.0, 0.05, edge));
  return t;
}

room::Texel velvet(double u, double v) {
  const double nap = room::fractalNoise(u, v, 40, 8, 3, 931);
  const double pile = room::fractalNoise(u, v, 128, 128, 1, 932);
  room::Texel t;
  t.color = dvec3(0.40, 0.07, 0.13) * (0.92 + 0.40 * nap + 0.18 * pile);
  return t;
}

room::Texel zodiacCloth(double u, double v) {
  const dvec2 p = 2.0 * dvec2(u, v) - 1.0;
  const double r = glm::length(p);
  const double gold = wheel(p / 0.74, 0.0030);
  const double weave = room::fractalNoise(u, v, 160, 160, 2, 941);
  const double cloud = room::fractalNoise(u, v, 5, 5, 3, 942);
  room::Texel t;
  t.color = dvec3(0.075, 0.085, 0.22) * (1.0 + 0.30 * weave + 0.45 * cloud);
  // Stars outside the wheel, and the hem.
  const double n = 13;
  const dvec2 cell = glm::floor(p * n);
  const dvec2 jitter(room::hash(static_cast<int>(cell.x) + 50, static_cast<int>(cell.y) + 50, 943),
                     room::hash(static_cast<int>(cell.x) + 50, static_cast<int>(cell.y) + 50, 944));
  const dvec2 in = p * n - cell - 0.3 - 0.4 * jitter;
  double stars = r > 0.60 ? inside(starShape(in, 0.10 + 0.10 * jitter.x, 5), 0.02) : 0.0;
  const double hem = std::max(line(r - 0.955, 0.012, 0.002), line(r - 0.925, 0.003, 0.002));
  const double thread = 0.85 + 0.3 * weave;
  t.color = glm::mix(t.color, dvec3(0.72, 0.52, 0.20) * thread, std::max({gold, 0.85 * stars, hem}));
  return t;
}

room::Texel cards(double u, double v) {
  const int card = std::min(static_cast<int>(u * 4), 3);
  const dvec2 p(fractionOf(u * 4) - 0.5, (v - 0.5) * 1.7);
  const dvec3 cream(0.88, 0.81, 0.66), ink(0.10, 0.12, 0.26), gold(0.80, 0.58, 0.20), red(0.52, 0.12, 0.10);
  const double margin = std::max(std::abs(p.x) - 0.41, std::abs(p.y) - 0.76);
  room::Texel t;
  const std::array<dvec3, 4> fields = {dvec3(0.62, 0.30, 0.14), ink, dvec3(0.12, 0.25, 0.28), red};
  t.color = glm::mix(cream, fields[static_cast<std::size_t>(card)], inside(margin, 0.01));
  t.color = glm::mix(t.color, gold, line(margin + 0.035, 0.009, 0.005));
  double shape = 1;
  if (card == 0) shape = sunShape(p, 0.20, 0.36, 16);
  if (card == 1) shape = moonShape(p - dvec2(-0.02, 0.14), 0.26);
  if (card == 2) shape = starShape(p - dvec2(0, 0.14), 0.34, 8);
  if (card == 3)
    shape =
        std::min(std::abs(fractionOf((p.x + p.y) * 6) - 0.5), std::abs(fractionOf((p.x - p.y) * 6) - 0.5)) -
        0.10;
  const double field = inside(margin + 0.06, 0.01);
  t.color = glm::mix(t.color, card == 3 ? glm::mix(red, gold, 0.6) : glm::mix(gold, cream, 0.35),
                     field * inside(shape, 0.012));
  if (card == 1 || card == 2) {
    for (int i = 0; i < 5; ++i) {
      const dvec2 at(0.30 * std::sin(2.1 * i + card), -0.28 - 0.10 * i + 0.05 * card);
      t.color = glm::mix(t.color, cream, field * inside(starShape(p - at, 0.045, 5), 0.012));
    }
  }
  t.color *= 0.94 + 0.12 * room::fractalNoise(u, v, 32, 16, 3, 951);
  return t;
}

room::Texel starChart(double u, double v) {
  const dvec2 p((u - 0.5) * 2, (v - 0.5) * 2);
  room::Texel t;
  const double stain = room::fractalNoise(u, v, 4, 4, 4, 961);
  t.color = dvec3(0.80, 0.70, 0.50) * (0.92 + 0.35 * stain);
  const double disc = inside(glm::length(p) - 0.86, 0.006);
  t.color = glm::mix(t.color, dvec3(0.10, 0.14, 0.24), disc);
  const dvec3 gold(0.86, 0.70, 0.38);
  t.color = glm::mix(t.color, gold, disc * wheel(p / 0.92, 0.004));
  // Planets on their rings in the middle.
  for (int i = 0; i < 5; ++i) {
    const double radius = 0.09 + 0.05 * i;
    t.color = glm::mix(t.color, gold, line(glm::length(p) - radius, 0.003, 0.003));
    const dvec2 planet = radius * dvec2(std::cos(2.3 * i + 0.5), std::sin(2.3 * i + 0.5));
    t.color = glm::mix(t.color, dvec3(0.95, 0.85, 0.6), inside(glm::length(p - planet) - 0.018, 0.004));
  }
  t.color = glm::mix(t.color, gold, inside(sunShape(p, 0.035, 0.062, 12), 0.004));
  for (const dvec2 corner : {dvec2(-0.8, 0.8), dvec2(0.8, 0.8), dvec2(-0.8, -0.8), dvec2(0.8, -0.8)})
    t.color = glm::mix(t.color, dvec3(0.35, 0.20, 0.12), inside(starShape(p - corner, 0.11, 8), 0.008));
  return t;
}

room::Texel brass(double u, double v) {
  const double tarnish = smoothStep(-0.1, 0.5, room::fractalNoise(u, v, 4, 4, 5, 971));
  room::Texel t;
  t.color = glm::mix(dvec3(0.78, 0.58, 0.26), dvec3(0.40, 0.26, 0.11), 0.7 * tarnish);
  t.color *= 0.95 + 0.15 * room::fractalNoise(u, v, 64, 8, 2, 972);
  return t;
}

room::Texel leather(double u, double v) {
  const room::CellDistance grain = room::cellNoise(u, v, 40, 40, 981);
  const double worn = smoothStep(0.1, 0.5, room::fractalNoise(u, v, 5, 5, 4, 982));
  room::Texel t;
  t.color = dvec3(0.78) * (0.85 + 0.25 * grain.nearest) * (1 + 0.35 * worn);
  return t;
}

room::Texel pages(double u, double v) {
  room::Texel t;
  t.color = dvec3(0.80, 0.70, 0.50) * (0.80 + 0.35 * room::noise(u * 4, v * 120, 4, 120, 991) +
                                       0.1 * room::fractalNoise(u, v, 6, 6, 3, 992));
  return t;
}

room::Texel china(double u, double v) {
  room::Texel t;
  t.color = dvec3(0.86, 0.84, 0.80);
  const double band = line(v - 0.86, 0.035, 0.01);
  const double flowers = inside(starShape({fractionOf(u * 7) - 0.5, (v - 0.62) * 3}, 0.24, 6), 0.03);
  t.color = glm::mix(t.color, dvec3(0.16, 0.22, 0.50), std::max(band, flowers));
  return t;
}

room::Texel nightSky(double u, double v) {
  const double clouds = smoothStep(0.0, 0.45, room::fractalNoise(0.6 * u, 0.9 * v, 4, 6, 5, 995));
  const double toMoon = glm::length(dvec2(0.72 * (u - 0.70), v - 0.74));
  room::Texel t;
  t.color = glm::mix(dvec3(0.20, 0.29, 0.48), dvec3(0.05, 0.09, 0.21), v);
  t.color += dvec3(0.30, 0.36, 0.46) * (0.35 + 0.65 * clouds) * std::exp(-toMoon * toMoon / 0.06);
  t.color += dvec3(0.10, 0.12, 0.16) * clouds;
  const double moon = inside(toMoon - 0.072, 0.004);
  t.color = glm::mix(
      t.color, dvec3(0.97, 0.96, 0.88) * (0.95 + 0.25 * room::fractalNoise(u, v, 18, 18, 3, 996)), moon);
  // Bare branches of a tree before it.
  double tree = 1;
  for (int i = 0; i < 9; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0, height = 0.10 + 0.085 * i;
    const dvec2 d(u - 0.16 - 0.05 * std::sin(4 * v), v);
    tree = std::min(tree, std::abs(d.x) - 0.035 * (1.05 - v));
    const double along = side * d.x, rise = d.y - height - 1.1 * along - 0.02 * std::sin(30 * along + i);
    if (along > 0 && along < 0.30 - 0.02 * i)
      tree = std::min(tree, std::abs(rise) - 0.012 * (1 - along / 0.32));
  }
  t.color = glm::mix(t.color, dvec3(0.015, 0.02, 0.04), inside(tree, 0.006));
  return t;
}

}  // namespace skinning
