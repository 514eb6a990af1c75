#include "painted_stone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "measures.h"
#include "room/noise.h"

namespace water {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::fractalNoise;
using room::fractionOf;
using room::hash;
using room::smoothStep;

constexpr dvec3 kRed(0.56, 0.125, 0.075);
constexpr dvec3 kBlack(0.085, 0.075, 0.075);
constexpr dvec3 kOchre(0.80, 0.56, 0.20);
constexpr dvec3 kCream(0.86, 0.79, 0.63);
constexpr dvec3 kGreen(0.16, 0.30, 0.22);

// 1 on a line of the given half width about 0, softened over 4 mm.
double line(double distance, double half) {
  return 1 - smoothStep(half - 0.002, half + 0.002, std::abs(distance));
}

// Distance to the outline of a box about a center, negative inside.
double toBox(dvec2 p, dvec2 center, dvec2 half) {
  const dvec2 d = glm::abs(p - center) - half;
  return glm::length(glm::max(d, dvec2(0))) + std::min(std::max(d.x, d.y), 0.0);
}

// A slender candlestick of leaves and discs, as painters put between panels.
double candlestick(dvec2 p, double low, double high) {
  if (p.y < low || p.y > high) return 0;
  const double along = (p.y - low) / 0.26;
  const double cell = fractionOf(along) - 0.5;
  const double spread = std::abs(p.x) * 9;
  double paint = line(p.x, 0.006);
  paint = std::max(
      paint, line(std::abs(cell + 0.28 - spread * spread * 0.8) * 0.26, std::abs(p.x) < 0.085 ? 0.008 : 0.0));
  paint = std::max(paint, 1 - smoothStep(0.020, 0.024, std::hypot(p.x, (cell - 0.1) * 0.26 * 0.8)));
  return paint;
}

// A rearing bird of two ovals and a tail, within 0.2 m about the middle.
double bird(dvec2 p) {
  const auto oval = [&](dvec2 center, dvec2 half, double turn) {
    const dvec2 d = p - center;
    const dvec2 r(std::cos(turn) * d.x + std::sin(turn) * d.y, std::cos(turn) * d.y - std::sin(turn) * d.x);
    return 1 - smoothStep(0.9, 1.1, glm::length(r / half));
  };
  return std::max({oval({0, 0}, {0.085, 0.042}, 0.35), oval({0.085, 0.062}, {0.030, 0.026}, 0.0),
                   oval({0.125, 0.062}, {0.022, 0.007}, -0.15), oval({-0.105, -0.055}, {0.07, 0.016}, 0.55),
                   oval({-0.01, -0.065}, {0.006, 0.035}, 0.1)});
}

dvec3 dado(dvec2 p, double u, double v) {
  const double vein = std::abs(fractalNoise(u, v, 6, 12, 5, 801));
  dvec3 color = glm::mix(kBlack, dvec3(0.25, 0.21, 0.19), std::exp(-vein * 30) * 0.6);
  const double frame = toBox(p, {kPanel / 2, 0.50}, {0.80, 0.30});
  color = glm::mix(color, kRed * 0.75, frame < -0.05 ? 0.55 : 0.0);
  return glm::mix(color, kOchre, std::max(line(frame, 0.008), line(frame + 0.05, 0.004)));
}

dvec3 field(dvec2 p) {
  const double edge = std::min(p.x, kPanel - p.x);
  if (edge < 0.16) {
    const double x = p.x < 1 ? p.x : p.x - kPanel;
    const dvec3 strip = glm::mix(kGreen * 0.75, kOchre, 0.85 * candlestick({x, p.y}, 1.16, 2.98));
    return glm::mix(strip, kCream, line(edge - 0.155, 0.007));
  }
  dvec3 color = kRed;
  const double frame = toBox(p, {kPanel / 2, 2.07}, {0.76, 0.90});
  color = glm::mix(color, kRed * 0.62, frame > 0 ? 0.75 : 0.0);
  color = glm::mix(color, kOchre, std::max(line(frame, 0.010), 0.8 * line(frame + 0.06, 0.004)));
  const dvec2 middle(kPanel / 2, 2.16);
  const double medallion = glm::length((p - middle) * dvec2(1, 0.92));
  if (medallion < 0.27) {
    color = glm::mix(kGreen * 0.55, kBlack, 0.4);
    color = glm::mix(color, kCream, bird(p - middle));
    const double ground =
        line(p.y - middle.y + 0.125, 0.006) * (1 - smoothStep(0.10, 0.16, std::abs(p.x - middle.x)));
    color = glm::mix(color, kOchre, ground);
  }
  return glm::mix(color, kOchre, line(medallion - 0.27, 0.014));
}

dvec3 frieze(dvec2 p) {
  dvec3 color = kBlack;
  const double x = fractionOf(p.x / 0.21) * 0.21 - 0.105;
  const double wave = p.y - 3.22 - 0.035 * std::sin(p.x / 0.21 * glm::two_pi<double>());
  color = glm::mix(color, kOchre,
                   std::max(line(wave, 0.013), 1 - smoothStep(0.016, 0.022, std::hypot(x, p.y - 3.22))));
  return glm::mix(color, kCream, std::max(line(p.y - 3.11, 0.012), line(p.y - 3.335, 0.012)));
}

dvec3 upper(dvec2 p) {
  dvec3 color = kCream * dvec3(0.97, 0.95, 0.92);
  const double span = fractionOf(p.x / (kPanel / 2)) - 0.5;
  const double sag = p.y - (3.66 + 0.9 * span * span);
  const double leaves = 0.010 + 0.012 * std::abs(std::sin(span * 40));
  color = glm::mix(color, kGreen, line(sag, leaves) * 0.9);
  color = glm::mix(color, kRed,
                   1 - smoothStep(0.030, 0.036, std::hypot((0.5 - std::abs(span)) * kPanel / 2, p.y - 3.89)));
  return glm::mix(color, kRed, std::max(line(p.y - 4.10, 0.016), line(p.y - 4.15, 0.006)));
}

}  // namespace

room::Texel fresco(double u, double v) {
  const dvec2 p(u * kPanel, v * kRoomMax.y);
  dvec3 color = p.y < 0.95    ? dado(p, u, v)
                : p.y < 1.08  ? kCream * 0.8
                : p.y < 3.1   ? field(p)
                : p.y < 3.345 ? frieze(p)
                              : upper(p);
  color = glm::mix(color, kGreen, p.y < 1.1 ? line(p.y - 1.015, 0.022) : 0.0);
  // Lime that has come through, and paint that has gone.
  const double age = fractalNoise(u, v, 4, 8, 6, 811);
  color *= 0.97 + 0.30 * age + 0.10 * fractalNoise(u, v, 60, 120, 2, 812);
  color = glm::mix(color, dvec3(0.70, 0.62, 0.52),
                   0.22 * smoothStep(0.18, 0.40, fractalNoise(u, v, 5, 11, 6, 813)));
  const double crack = std::abs(fractalNoise(u, v, 3, 5, 6, 814));
  const double where = smoothStep(0.05, 0.25, fractalNoise(u, v, 2, 4, 2, 815));
  color *= 1 - 0.5 * where * (1 - smoothStep(0.002, 0.010, crack));
  room::Texel t;
  t.color = color;
  return t;
}

double puddle(double u, double v) {
  const double shape = fractalNoise(u, v, 3, 3, 4, 820) + 0.10 * fractalNoise(u, v, 24, 24, 3, 821);
  return smoothStep(0.045, 0.075, shape);
}

room::Texel slabs(double u, double v) {
  constexpr int kSlabs = 6;
  constexpr double kSide = kFloorExtent / kSlabs;
  const dvec2 at = dvec2(u, v) * double{kSlabs};
  const glm::ivec2 slab(at);
  const dvec2 inSlab = (at - dvec2(slab)) * kSide;
  const dvec2 toEdge = glm::min(inSlab, kSide - inSlab);
  const double chip = 0.004 * fractalNoise(u, v, 64, 64, 2, 830);
  const double cloud =
      fractalNoise(u + hash(slab.x, slab.y, 831), v + hash(slab.x, slab.y, 832), 10, 14, 5, 833);
  dvec3 color = glm::mix(dvec3(0.62, 0.55, 0.45), dvec3(0.76, 0.70, 0.60), hash(slab.x, slab.y, 834));
  color *= 0.97 + 0.30 * cloud;
  color = glm::mix(color, dvec3(0.45, 0.37, 0.28), 0.5 * std::exp(-std::abs(cloud) * 40));
  // A small dark stone where four slabs meet.
  const double diamond = 0.115 - (toEdge.x + toEdge.y) + chip;
  const dvec3 dark = dvec3(0.17, 0.19, 0.20) * (0.9 + 0.5 * fractalNoise(u, v, 24, 24, 4, 835));
  color = glm::mix(color, dark, smoothStep(0.0, 0.003, diamond));
  const double joint = std::min(diamond > 0 ? 1.0 : std::min(toEdge.x, toEdge.y), std::abs(diamond));
  color = glm::mix(dvec3(0.24, 0.20, 0.16), color, smoothStep(0.001, 0.005, joint + chip));
  color *= 0.95 + 0.35 * fractalNoise(u, v, 5, 5, 4, 836);
  // Wet stone is darker, also about the water.
  const double shape = fractalNoise(u, v, 3, 3, 4, 820) + 0.10 * fractalNoise(u, v, 24, 24, 3, 821);
  const double damp = smoothStep(-0.05, 0.07, shape);
  room::Texel t;
  t.color = glm::mix(color, color * color * dvec3(0.80, 0.82, 0.86), damp);
  return t;
}

room::Texel marble(double u, double v) {
  const double warp = fractalNoise(u, v, 3, 3, 4, 840);
  const double vein = std::abs(fractalNoise(u + 0.15 * warp, v + 0.1 * warp, 5, 8, 5, 841));
  room::Texel t;
  t.color = glm::mix(dvec3(0.60, 0.58, 0.57), dvec3(0.78, 0.76, 0.72), smoothStep(0.0, 0.10, vein));
  t.color *= 0.97 + 0.15 * warp;
  return t;
}

room::Texel stucco(double u, double v, dvec3 paint) {
  room::Texel t;
  t.color = paint * (0.97 + 0.16 * fractalNoise(u, v, 8, 8, 5, 850));
  t.color = glm::mix(t.color, dvec3(0.55, 0.50, 0.43),
                     0.35 * smoothStep(0.12, 0.40, fractalNoise(u, v, 7, 7, 6, 851)));
  return t;
}

room::Texel terracotta(double u, double v) {
  room::Texel t;
  t.color =
      glm::mix(dvec3(0.58, 0.29, 0.17), dvec3(0.70, 0.42, 0.27), 0.5 + fractalNoise(u, v, 4, 12, 4, 860));
  t.color = glm::mix(t.color, dvec3(0.72, 0.65, 0.56),
                     0.5 * smoothStep(0.15, 0.35, fractalNoise(u, v, 5, 5, 5, 861)));
  t.color *= 0.96 + 0.06 * std::sin(v * 60 * glm::pi<double>());
  return t;
}

room::Texel bronze(double u, double v) {
  room::Texel t;
  const double green = smoothStep(0.02, 0.25, fractalNoise(u, v, 5, 5, 5, 870));
  t.color = glm::mix(dvec3(0.46, 0.31, 0.15), dvec3(0.22, 0.36, 0.29), green);
  return t;
}

room::Texel leafTexel(double u, double v) {
  const double side = std::abs(2 * u - 1);
  room::Texel t;
  t.color = glm::mix(dvec3(0.16, 0.33, 0.20), dvec3(0.40, 0.55, 0.30), smoothStep(0.0, 0.9, v));
  t.color = glm::mix(t.color, dvec3(0.66, 0.66, 0.38), smoothStep(0.72, 0.80, side));
  t.color *= 0.95 + 0.25 * fractalNoise(u, v, 10, 2, 3, 880);
  return t;
}

room::Texel petalTexel(double u, double v) {
  room::Texel t;
  t.color = glm::mix(dvec3(0.95, 0.88, 0.80), dvec3(0.90, 0.42, 0.52), smoothStep(0.25, 1.0, v));
  t.color *= 0.96 + 0.12 * fractalNoise(u, v, 16, 2, 3, 881);
  return t;
}

room::Texel skyTexel(double u, double v) {
  const double cloud = smoothStep(0.0, 0.40, fractalNoise(u, v, 3, 4, 6, 890) + 0.06);
  room::Texel t;
  t.color =
      glm::mix(glm::mix(dvec3(0.40, 0.62, 0.88), dvec3(0.66, 0.78, 0.88), v), dvec3(1.0, 0.93, 0.82), cloud);
  return t;
}

namespace {

// The pictures of the bottom, before they are cut into stones: p in metres from the middle.
dvec3 poolPicture(dvec2 p) {
  constexpr dvec3 kDeep(0.045, 0.16, 0.34);
  constexpr dvec3 kTurquoise(0.16, 0.52, 0.56);
  constexpr dvec3 kWhite(0.88, 0.88, 0.80);
  constexpr dvec3 kGold(0.86, 0.66, 0.24);
  const double border = kPoolHalf.x - std::max(std::abs(p.x), std::abs(p.y));
  if (border < 0) {  // the walls: waves in bands
    const double along = std::abs(p.x) > std::abs(p.y) ? p.y : p.x;
    const double band = fractionOf((-border + 0.04 * std::sin(along * 16)) / 0.22);
    return band < 0.25 ? kWhite : band < 0.6 ? kTurquoise : kDeep;
  }
  if (border < 0.10) return kDeep;
  if (border < 0.14) return kGold;
  if (border < 0.40) {  // a running wave
    const double along = std::abs(p.x) > std::abs(p.y) ? p.y : p.x;
    const dvec2 cell((fractionOf(along / 0.26) - 0.5) * 0.26, border - 0.27);
    const double r = glm::length(cell);
    const double spiral = fractionOf(r / 0.075 - std::atan2(cell.y, cell.x) / glm::two_pi<double>());
    return r < 0.12 && spiral < 0.5 ? kDeep : kWhite;
  }
  if (border < 0.44) return kGold;
  const double r = glm::length(p);
  const double angle = std::atan2(p.y, p.x);
  // A star of sixteen points within a star of eight.
  const auto star = [&](int points, double outer, double inner) {
    const double turn = std::abs(fractionOf(angle * points / glm::two_pi<double>()) - 0.5) * 2;
    return glm::mix(inner, outer, turn) - r;
  };
  if (r < 0.16) return kGold;
  if (star(8, 0.72, 0.30) > 0) return fractionOf(angle * 8 / glm::two_pi<double>()) < 0.5 ? kGold : kWhite;
  if (star(16, 1.16, 0.62) > 0)
    return fractionOf(angle * 16 / glm::two_pi<double>()) < 0.5 ? kTurquoise : kWhite;
  if (std::abs(r - 1.24) < 0.035) return kWhite;
  return r < 1.24 ? kDeep : kTurquoise;
}

}  // namespace

dvec3 poolMosaic(dvec2 unfolded) {
  constexpr double kStone = 0.034;  // metres
  const dvec2 at = unfolded / kStone + 512.0;
  const glm::ivec2 stone(at);
  const dvec2 middle = (dvec2(stone) + 0.5 - 512.0) * kStone;
  dvec3 color = poolPicture(middle) * (0.78 + 0.42 * hash(stone.x, stone.y, 901));
  color +=
      (dvec3(hash(stone.x, stone.y, 902), hash(stone.x, stone.y, 903), hash(stone.x, stone.y, 904)) - 0.5) *
      0.06;
  const dvec2 inStone = at - dvec2(stone);
  const dvec2 toEdge = glm::min(inStone, 1.0 - inStone);
  return glm::mix(dvec3(0.30, 0.30, 0.28), color, smoothStep(0.03, 0.11, std::min(toEdge.x, toEdge.y)));
}

}  // namespace water
