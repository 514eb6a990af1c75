#include "hand_textures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "hand.h"
#include "room/noise.h"

namespace skinning {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kBaseWidth = 1024, kBaseHeight = 1024;

// ---- Drawing on the palm: distances in millimetres

double segment(dvec2 p, dvec2 a, dvec2 b) {
  const dvec2 along = b - a;
  const double t = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + along * t);
}

// A smooth curve through the points (Catmull and Rom), as short segments.
double curve(dvec2 p, const std::vector<dvec2>& through) {
  constexpr int kSteps = 8;
  constexpr double kFar = 6;  // no stroke is so wide
  double nearest = 1e9;
  dvec2 low = through.front(), high = low;
  for (const dvec2& point : through) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  if (glm::any(glm::lessThan(p, low - kFar)) || glm::any(glm::greaterThan(p, high + kFar))) return nearest;
  dvec2 from = through.front();
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const dvec2 a = through[i == 0 ? 0 : i - 1], b = through[i], c = through[i + 1];
    const dvec2 d = through[std::min(i + 2, through.size() - 1)];
    for (int step = 1; step <= kSteps; ++step) {
      const double t = static_cast<double>(step) / kSteps, t2 = t * t, t3 = t2 * t;
      const dvec2 to = 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t2 +
                              (3.0 * b - a - 3.0 * c + d) * t3);
      nearest = std::min(nearest, segment(p, from, to));
      from = to;
    }
  }
  return nearest;
}

double circle(dvec2 p, dvec2 center, double radius) {
  return std::abs(glm::distance(p, center) - radius);
}

// A star of straight rays.
double star(dvec2 p, dvec2 center, double radius, int rays) {
  double nearest = 1e9;
  for (int i = 0; i < rays; ++i) {
    const double angle = glm::pi<double>() * i / rays + 0.3;
    const dvec2 ray = radius * dvec2(std::cos(angle), std::sin(angle));
    nearest = std::min(nearest, segment(p, center - ray, center + ray));
  }
  return nearest;
}

double crescent(dvec2 p, dvec2 center, double radius) {
  const double outer = glm::distance(p, center) - radius;
  const double inner = 0.82 * radius - glm::distance(p, center + dvec2(0.45 * radius, 0.12 * radius));
  return std::max(outer, inner);
}

double triangle(dvec2 p, dvec2 center, double radius) {
  double nearest = 1e9;
  for (int i = 0; i < 3; ++i) {
    const auto corner = [&](int k) {
      const double angle = glm::half_pi<double>() + k * glm::two_pi<double>() / 3;
      return center + radius * dvec2(std::cos(angle), std::sin(angle));
    };
    nearest = std::min(nearest, segment(p, corner(i), corner(i + 1)));
  }
  return nearest;
}

// How much ink: a stroke of `width` with soft edges.
double stroke(double distance, double width) {
  return 1 - room::smoothStep(0.5 * width - 0.25, 0.5 * width + 0.35, distance);
}

dvec2 between(std::size_t finger, std::size_t joint, double share) {
  const RestBone& bone = restBones()[phalanx(finger, joint)];
  return dvec2(glm::mix(bone.from, bone.to, share));
}

// The lines of heart, head, life and fate, and the mounts' signs: x the ink, y the gold.
dvec2 palmPaint(dvec2 p) {
  double ink = 0, gold = 0;
  const auto draw = [&](double& paint, double distance, double width) {
    paint = std::max(paint, stroke(distance, width));
  };
  draw(ink, curve(p, {{-41, 55}, {-24, 57}, {-4, 63}, {8, 72}, {16, 83}}), 1.15);        // heart
  draw(ink, curve(p, {{38, 64}, {22, 62}, {2, 56}, {-14, 47}, {-28, 36}}), 1.15);        // head
  draw(ink, curve(p, {{38, 63}, {24, 58}, {10, 44}, {3, 26}, {4, 12}, {11, 2}}), 1.25);  // life
  draw(ink, curve(p, {{-3, 4}, {-4, 26}, {-1, 52}, {6, 80}}), 0.85);                     // fate
  draw(ink, curve(p, {{-19, 20}, {-16, 44}, {-12, 70}}), 0.7);                           // sun
  for (double y : {-4.0, -7.5}) draw(ink, curve(p, {{-26, y}, {0, y - 3}, {26, y}}), 1.0);
  for (double y : {-18.0, -20.4, -34.0}) draw(gold, curve(p, {{-40, y}, {0, y - 4}, {40, y}}), 1.4);
  // A sun, stars and the moon on the mounts.
  const dvec2 sun(-11, 78);
  draw(gold, glm::distance(p, sun), 4.2);
  draw(gold, circle(p, sun, 3.6), 0.8);
  draw(gold, star(p, {28, 79}, 4.2, 3), 0.9);
  draw(gold, triangle(p, {9, 84}, 4.0), 0.9);
  draw(gold, circle(p, {-29, 69}, 2.9), 0.9);
  draw(gold, segment(p, {-29, 66}, {-29, 60.5}), 0.9);
  draw(gold, segment(p, {-31, 63}, {-27, 63}), 0.9);
  draw(gold, crescent(p, {-26, 30}, 6.5), 0.3);
  draw(gold, circle(p, {30, 36}, 5.4), 0.9);
  draw(gold, star(p, {30, 36}, 4.6, 4), 0.8);
  // Bands at the joints and a sign on each fingertip.
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    for (std::size_t joint = 0; joint < kPhalanges; ++joint) {
      const RestBone& bone = restBones()[phalanx(finger, joint)];
      const dvec2 along = glm::normalize(dvec2(bone.to - bone.from)), across(along.y, -along.x);
      const dvec2 d = p - dvec2(bone.from) - along * (joint == 0 ? 11.0 : 0.0);
      if (std::abs(glm::dot(d, across)) > 13) continue;
      for (double offset : {-0.9, 0.9}) draw(ink, std::abs(glm::dot(d, along) - offset), 0.75);
    }
  }
  draw(gold, star(p, between(0, 2, 0.62), 3.4, 2), 0.8);
  draw(gold, circle(p, between(1, 2, 0.62), 2.6), 0.8);
  draw(gold, triangle(p, between(2, 2, 0.62), 3.0), 0.8);
  draw(gold, crescent(p, between(3, 2, 0.6), 2.9), 0.3);
  return {ink, gold};
}

// On the back: a vine along the middle, rings around the forearm and gilded nails.
dvec2 backPaint(dvec2 p) {
  double ink = 0, gold = 0;
  const auto draw = [&](double& paint, double distance, double width) {
    paint = std::max(paint, stroke(distance, width));
  };
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    const RestBone& bone = restBones()[phalanx(finger, 2)];
    const dvec2 along = glm::normalize(dvec2(bone.to - bone.from)), across(along.y, -along.x);
    const dvec2 d = p - dvec2(glm::mix(bone.from, bone.to, 0.78));
    const dvec2 nail(glm::dot(d, across) / (0.66 * bone.toRadius),
                     glm::dot(d, along) / (1.05 * bone.toRadius));
    gold = std::max(gold, 1 - room::smoothStep(0.88, 1.02, glm::length(nail)));
    const dvec2 knuckle(restBones()[phalanx(finger, 0)].from);
    draw(ink, curve(p, {knuckle * dvec2(0.25, 0.15), knuckle * dvec2(0.55, 0.5), knuckle}), 1.0);
    draw(gold, circle(p, knuckle, 4.2), 1.0);
  }
  for (double y : {-18.0, -20.4, -34.0}) draw(gold, curve(p, {{-40, y}, {0, y - 4}, {40, y}}), 1.4);
  return {ink, gold};
}

// Fine cracks in the glaze.
double crackle(double u, double v) {
  const double bend = 0.006 * room::fractalNoise(u, v, 9, 9, 3, 901);
  const room::CellDistance large = room::cellNoise(u + bend, v - bend, 15, 15, 902);
  const room::CellDistance small = room::cellNoise(u - bend, v + bend, 34, 34, 903);
  const auto line = [](const room::CellDistance& cell, double width) {
    return 1 - room::smoothStep(0.0, width, cell.second - cell.nearest);
  };
  const double fine =
      line(small, 0.055) * room::smoothStep(-0.05, 0.25, room::fractalNoise(u, v, 6, 6, 3, 904));
  return std::max(line(large, 0.035), 0.6 * fine);
}

}  // namespace

room::Image handBase() {
  return room::generate(kBaseWidth, kBaseHeight, 4, [](double u, double v, float* out) {
    const bool back = u >= 0.5;
    const dvec2 place(2 * u - (back ? 1 : 0), v);
    const dvec2 p = kChartLow + place * (kChartHigh - kChartLow);
    const dvec2 paint = back ? backPaint(p) : palmPaint(p);
    const double cracks = crackle(place.x, place.y);
    const double cloud = room::fractalNoise(place.x, place.y, 5, 5, 4, 905);
    const double worn = room::smoothStep(0.10, 0.34, room::fractalNoise(place.x, place.y, 16, 16, 4, 906));
    dvec3 color = glm::mix(dvec3(0.93, 0.88, 0.79), dvec3(0.82, 0.74, 0.62), 0.5 + 0.8 * cloud);
    color = glm::mix(color, dvec3(0.47, 0.36, 0.25), 0.62 * cracks);
    color = glm::mix(color, dvec3(0.10, 0.12, 0.30), 0.92 * paint.x * (1 - 0.75 * worn));
    color = glm::mix(color, dvec3(0.70, 0.43, 0.09), paint.y * (1 - 0.5 * worn));
    double gloss = 0.66 + 0.25 * cloud;
    gloss = glm::mix(gloss, 0.28, 0.8 * cracks);
    gloss = glm::mix(gloss, 0.38, paint.x);
    gloss = glm::mix(gloss, 1.0, paint.y);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(glm::clamp(color[i], 0.0, 1.0));
    out[3] = static_cast<float>(glm::clamp(gloss, 0.0, 1.0));
  });
}

}  // namespace skinning
