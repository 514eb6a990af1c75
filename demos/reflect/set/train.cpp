#include "train.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "room/set/furniture.h"

namespace reflect {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::placed;

constexpr dvec3 kRed(0.85, 0.12, 0.10);
constexpr dvec3 kGreen(0.10, 0.45, 0.22);
constexpr dvec3 kBlue(0.12, 0.30, 0.72);
constexpr dvec3 kYellow(0.96, 0.74, 0.14);
constexpr dvec3 kBlack(0.13, 0.13, 0.14);
constexpr dvec3 kCream(0.95, 0.90, 0.78);
constexpr dvec3 kWood(0.90, 0.68, 0.42);
constexpr dvec3 kGold(0.95, 0.75, 0.30);

room::MeshData block(const dvec3& size) {
  return room::box(size, 1, 1.5);
}

// From the origin along x, closed at both ends.
room::MeshData rod(double radius, double length, const Detail& detail) {
  room::MeshData mesh;
  const double bevel = std::min(0.006, radius * 0.3);
  const std::vector<dvec2> profile = {
      {0, 0},     {radius - bevel, 0}, {radius, bevel}, {radius, length - bevel}, {radius - bevel, length},
      {0, length}};
  // The y axis becomes x.
  mesh.append(room::lathe(profile, detail.cells(28, 8), detail.cells(20, 6)),
              glm::rotate(dmat4(1.0), -glm::half_pi<double>(), dvec3(0, 0, 1)));
  return mesh;
}

void addWheels(Painted& to, const Detail& detail, double length, double radius) {
  for (double x : {-length * 0.31, length * 0.31}) {
    for (double side : {-1.0, 1.0}) {
      // Turned so that the axle lies along z.
      const dmat4 turn = glm::rotate(dmat4(1.0), -side * glm::half_pi<double>(), dvec3(0, 1, 0));
      const dmat4 where = placed({x, radius, side * 0.052}) * turn;
      to.add(rod(radius, 0.02, detail), kBlack, where);
      to.add(rod(radius * 0.55, 0.026, detail), kYellow, where);
    }
  }
}

void addFrame(Painted& to, const Detail& detail, double length, const dvec3& color) {
  to.add(block({length, 0.03, 0.12}), color, placed({0, 0.06, 0}));
  addWheels(to, detail, length, 0.042);
  for (double end : {-1.0, 1.0}) {
    to.add(room::sphere(0.014, detail.cells(12, 5), detail.cells(8, 4)), kBlack,
           placed({end * (length / 2 + 0.014), 0.06, 0}));
  }
}

Painted engine(const Detail& detail) {
  Painted p;
  addFrame(p, detail, 0.32, kRed);
  p.add(rod(0.055, 0.20, detail), kGreen, placed({-0.045, 0.132, 0}));
  for (double x : {0.0, 0.07, 0.135}) p.add(rod(0.0575, 0.010, detail), kGold, placed({x, 0.132, 0}));
  p.add(rod(0.040, 0.008, detail), kGold, placed({0.153, 0.132, 0}));
  p.add(block({0.115, 0.15, 0.125}), kGreen, placed({-0.10, 0.15, 0}));
  p.add(block({0.15, 0.018, 0.15}), kRed, placed({-0.10, 0.235, 0}));
  for (double side : {-1.0, 1.0})
    p.add(block({0.06, 0.055, 0.004}), kCream, placed({-0.10, 0.185, side * 0.0635}));
  const std::vector<dvec2> chimney = {{0.020, 0.0},   {0.018, 0.05},  {0.032, 0.085}, {0.036, 0.090},
                                      {0.036, 0.098}, {0.024, 0.098}, {0.0, 0.07}};
  p.add(room::lathe(chimney, detail.cells(24, 8), detail.cells(24, 8)), kBlack, placed({0.105, 0.18, 0}));
  p.add(room::sphere(0.026, detail.cells(20, 8), detail.cells(14, 6)), kGold, placed({0.025, 0.188, 0}));
  p.add(room::sphere(0.017, detail.cells(16, 6), detail.cells(10, 5)), kYellow, placed({0.158, 0.195, 0}));
  p.add(block({0.045, 0.035, 0.12}), kYellow, placed({0.165, 0.04, 0}));
  return p;
}

Painted openWagon(const Detail& detail, const dvec3& color, bool blocks) {
  Painted p;
  addFrame(p, detail, 0.28, kBlack);
  for (double side : {-1.0, 1.0}) {
    p.add(block({0.28, 0.07, 0.012}), color, placed({0, 0.11, side * 0.060}));
    p.add(block({0.012, 0.07, 0.12}), color, placed({side * 0.134, 0.11, 0}));
  }
  constexpr std::array<dvec3, 4> kColors = {kRed, kBlue, kYellow, kGreen};
  for (int i = 0; i < 4; ++i) {
    const double x = -0.095 + 0.063 * i;
    const dvec3& paint = kColors[static_cast<std::size_t>(i)];
    if (blocks) {
      p.add(block(dvec3(0.055)), paint, placed({x, 0.125, i % 2 == 0 ? -0.024 : 0.022}, 0.3 * i));
    } else {
      p.add(room::sphere(0.030, detail.cells(20, 7), detail.cells(14, 5)), paint,
            placed({x, 0.135, i % 2 == 0 ? 0.012 : -0.014}));
    }
  }
  return p;
}

Painted logWagon(const Detail& detail) {
  Painted p;
  addFrame(p, detail, 0.28, kGreen);
  for (int i = 0; i < 5; ++i) {
    const bool upper = i >= 3;
    const double z = upper ? (i - 3.5) * 0.042 : (i - 1) * 0.040;
    p.add(rod(0.020, 0.24, detail), kWood, placed({-0.12, upper ? 0.131 : 0.096, z}));
  }
  for (double x : {-0.10, 0.10}) {
    for (double side : {-1.0, 1.0})
      p.add(block({0.010, 0.09, 0.008}), kRed, placed({x, 0.115, side * 0.064}));
  }
  return p;
}

Painted tankWagon(const Detail& detail) {
  Painted p;
  addFrame(p, detail, 0.28, kBlack);
  p.add(rod(0.058, 0.25, detail), kYellow, placed({-0.125, 0.135, 0}));
  for (double x : {-0.08, 0.075}) p.add(rod(0.0605, 0.012, detail), kRed, placed({x, 0.135, 0}));
  p.add(room::lathe({{0.024, 0}, {0.024, 0.02}, {0.02, 0.026}, {0, 0.026}}, detail.cells(20, 8), 6), kRed,
        placed({0, 0.19, 0}));
  return p;
}

Painted coach(const Detail& detail, const dvec3& color) {
  Painted p;
  addFrame(p, detail, 0.29, kBlack);
  p.add(block({0.28, 0.12, 0.118}), color, placed({0, 0.135, 0}));
  p.add(block({0.284, 0.012, 0.122}), kCream, placed({0, 0.118, 0}));
  p.add(block({0.30, 0.016, 0.136}), kCream, placed({0, 0.203, 0}));
  for (int i = 0; i < 4; ++i) {
    for (double side : {-1.0, 1.0})
      p.add(block({0.042, 0.042, 0.004}), kBlack * 1.6, placed({-0.099 + 0.066 * i, 0.163, side * 0.060}));
  }
  return p;
}

}  // namespace

Painted vehicle(int number, const Detail& detail) {
  switch (number) {
    case 0:
      return engine(detail);
    case 1:
      return openWagon(detail, kBlue, true);
    case 2:
      return tankWagon(detail);
    case 3:
      return logWagon(detail);
    case 4:
      return openWagon(detail, kRed, false);
    default:
      return coach(detail, kRed);
  }
}

Painted track(const Detail& detail) {
  Painted p;
  const int sides = detail.cells(96, 32);
  for (double offset : {-0.052, 0.052}) {
    std::vector<dvec3> rail;
    for (int i = 0; i <= sides; ++i) {
      const double angle = glm::two_pi<double>() * i / sides;
      const double r = kTrackRadius + offset;
      rail.emplace_back(r * std::cos(angle), kRailTop - 0.009, r * std::sin(angle));
    }
    p.add(room::tube(rail, 0.009, 0.004, detail.cells(8, 4), 2), dvec3(0.72, 0.72, 0.74));
  }
  const int sleepers = detail.cells(48, 24);
  for (int i = 0; i < sleepers; ++i) {
    const double angle = glm::two_pi<double>() * i / sleepers;
    p.add(room::box({0.20, 0.018, 0.045}, 1, 2, {0.13 * i, 0.37 * i}), dvec3(0.80, 0.60, 0.40),
          glm::rotate(dmat4(1.0), angle, dvec3(0, 1, 0)) * placed({kTrackRadius, 0.010, 0}));
  }
  return p;
}

dmat4 vehicleAt(int number, double time) {
  constexpr double kSpeed = 0.42;  // metres a second
  const double angle = (kSpeed * time - kVehicleSpacing * number) / kTrackRadius - 1.05;
  // Counterclockwise as seen from above; x turned along the tangent.
  const dvec3 where(kTrackRadius * std::cos(angle), kRailTop, -kTrackRadius * std::sin(angle));
  return placed(where, angle + glm::half_pi<double>());
}

}  // namespace reflect
