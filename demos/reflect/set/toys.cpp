#include "toys.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "room/noise.h"
#include "room/set/furniture.h"

namespace reflect {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::hash;
using room::placed;

constexpr dvec3 kRed(0.82, 0.15, 0.12);
constexpr dvec3 kGreen(0.25, 0.58, 0.28);
constexpr dvec3 kBlue(0.18, 0.38, 0.75);
constexpr dvec3 kYellow(0.95, 0.76, 0.20);
constexpr dvec3 kOrange(0.92, 0.48, 0.14);
constexpr dvec3 kViolet(0.50, 0.28, 0.62);
constexpr dvec3 kCream(0.94, 0.89, 0.78);
constexpr dvec3 kDark(0.10, 0.08, 0.07);
constexpr dvec3 kOak(0.74, 0.56, 0.38);
constexpr std::array<dvec3, 6> kColors = {kRed, kYellow, kBlue, kGreen, kOrange, kViolet};

const dvec3& colorOf(int number) {
  return kColors[static_cast<std::size_t>(number) % kColors.size()];
}

room::MeshData ball(double radius, const Detail& detail) {
  return room::sphere(radius, detail.cells(28, 8), detail.cells(18, 6));
}

room::MeshData lathe(const std::vector<dvec2>& profile, const Detail& detail) {
  return room::lathe(profile, detail.cells(36, 12),
                     detail.cells(3 * static_cast<int>(profile.size()), static_cast<int>(profile.size())),
                     {2, 1});
}

room::MeshData box(const dvec3& size, const Detail& detail) {
  return room::box(size, detail.share < 1 ? 2 : 0.16, 1.2, {size.x * 3.1, size.z * 1.7});
}

// A ball drawn out along the axes.
dmat4 oval(const dvec3& center, const dvec3& size, double tilt = 0) {
  return glm::scale(glm::rotate(placed(center), tilt, dvec3(0, 0, 1)), size);
}

// Scaled normals point elsewhere and are longer; for ovals they are the gradient's.
void addOval(Painted& to, const dvec3& color, const dvec3& center, const dvec3& size, const Detail& detail,
             double tilt = 0) {
  room::MeshData mesh = ball(1, detail);
  const dmat4 where = oval(center, size, tilt);
  const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(where)));
  std::vector<dvec3> normals;
  for (const room::Vertex& v : mesh.vertices) normals.push_back(glm::normalize(turn * v.normal));
  const std::size_t first = to.mesh.vertices.size();
  to.add(mesh, color, where);
  for (std::size_t i = 0; i < normals.size(); ++i) to.mesh.vertices[first + i].normal = normals[i];
}

}  // namespace

// Sits, looking along +z.
Painted bear(const Detail& detail) {
  constexpr dvec3 kFur(0.62, 0.40, 0.22);
  constexpr dvec3 kPale(0.82, 0.64, 0.42);
  Painted p;
  addOval(p, kFur, {0, 0.17, 0}, {0.145, 0.17, 0.125}, detail);
  addOval(p, kPale, {0, 0.165, 0.045}, {0.105, 0.125, 0.095}, detail);
  addOval(p, kFur, {0, 0.40, 0.01}, {0.125, 0.115, 0.11}, detail);
  addOval(p, kPale, {0, 0.365, 0.10}, {0.055, 0.045, 0.05}, detail);
  addOval(p, kDark, {0, 0.382, 0.148}, {0.018, 0.013, 0.012}, detail);
  for (double side : {-1.0, 1.0}) {
    addOval(p, kFur, {side * 0.095, 0.495, 0}, {0.045, 0.045, 0.025}, detail);
    addOval(p, kPale, {side * 0.095, 0.493, 0.014}, {0.029, 0.029, 0.018}, detail);
    addOval(p, kDark, {side * 0.045, 0.425, 0.103}, {0.014, 0.014, 0.010}, detail);
    addOval(p, kFur, {side * 0.165, 0.235, 0.035}, {0.045, 0.115, 0.048}, detail, side * 0.6);
    addOval(p, kFur, {side * 0.105, 0.062, 0.135}, {0.062, 0.060, 0.125}, detail);
    addOval(p, kPale, {side * 0.105, 0.070, 0.245}, {0.046, 0.048, 0.020}, detail);
    addOval(p, kRed, {side * 0.040, 0.292, 0.105}, {0.042, 0.028, 0.014}, detail, side * 0.35);
  }
  return p;
}

Painted ringTower(const Detail& detail) {
  Painted p;
  p.add(lathe({{0.13, 0}, {0.13, 0.025}, {0.115, 0.035}, {0, 0.035}}, detail), kOak);
  double y = 0.035;
  for (int i = 0; i < 5; ++i) {
    const double thick = 0.034 - 0.003 * i;
    const double radius = 0.090 - 0.013 * i;
    y += thick;
    p.add(room::surface(detail.cells(36, 12), detail.cells(14, 6),
                        [=](double u, double v) {
                          const double around = -u * glm::two_pi<double>();
                          const double across = v * glm::two_pi<double>() - glm::half_pi<double>();
                          const double r = radius + thick * std::cos(across);
                          return dvec3(r * std::cos(around), y + thick * std::sin(across),
                                       r * std::sin(around));
                        }),
          colorOf(i));
    y += thick;
  }
  p.add(ball(0.045, detail), kRed, placed({0, y + 0.03, 0}));
  return p;
}

Painted drum(const Detail& detail) {
  constexpr double kRadius = 0.20;
  constexpr double kHeight = 0.24;
  Painted p;
  p.add(lathe({{kRadius, 0.02}, {kRadius, kHeight - 0.02}}, detail), kRed);
  for (double y : {0.0, kHeight - 0.035}) {
    p.add(lathe({{kRadius - 0.01, y},
                 {kRadius + 0.012, y},
                 {kRadius + 0.012, y + 0.035},
                 {kRadius - 0.01, y + 0.035}},
                detail),
          kYellow);
  }
  p.add(lathe({{kRadius, kHeight - 0.012}, {0, kHeight - 0.010}}, detail), kCream);
  constexpr int kCords = 12;
  for (int i = 0; i < kCords; ++i) {
    const auto rim = [](double turn, double y) {
      return dvec3((kRadius + 0.006) * std::cos(turn), y, (kRadius + 0.006) * std::sin(turn));
    };
    const double a = glm::two_pi<double>() * i / kCords;
    const double b = glm::two_pi<double>() * (i + 0.5) / kCords;
    const double c = glm::two_pi<double>() * (i + 1) / kCords;
    p.add(
        room::tube({rim(a, 0.03), rim(b, kHeight - 0.03), rim(c, 0.03)}, 0.004, 0.01, detail.cells(6, 3), 2),
        kCream);
  }
  for (double side : {-1.0, 1.0}) {
    const dmat4 lie = glm::rotate(placed({side * 0.03, kHeight + 0.003, 0.02 * side}, 0.5 + side * 0.5),
                                  -glm::half_pi<double>(), dvec3(0, 0, 1));
    p.add(lathe({{0.009, -0.15}, {0.007, 0.12}, {0.018, 0.14}, {0.012, 0.16}, {0, 0.165}}, detail), kOak,
          lie);
  }
  return p;
}

Painted spinningTop(const Detail& detail) {
  Painted p;
  const dmat4 lean = glm::rotate(placed({0, 0.005, 0}), 0.42, dvec3(0.3, 0, 1));
  p.add(lathe({{0.003, 0}, {0.02, 0.03}, {0.10, 0.075}}, detail), kBlue, lean);
  p.add(lathe({{0.10, 0.075}, {0.115, 0.092}, {0.10, 0.108}}, detail), kYellow, lean);
  p.add(lathe({{0.10, 0.108}, {0.05, 0.135}, {0.012, 0.145}}, detail), kRed, lean);
  p.add(lathe({{0.012, 0.140}, {0.008, 0.20}, {0.018, 0.215}, {0.012, 0.228}, {0, 0.23}}, detail), kOak,
        lean);
  return p;
}

Painted blockTower(const Detail& detail) {
  constexpr double kSide = 0.15;
  Painted p;
  const auto put = [&](int column, int level, double turn, int color) {
    p.add(box(dvec3(kSide), detail), colorOf(color),
          placed({column * (kSide + 0.012) / 2, (level + 0.5) * kSide, 0}, turn));
  };
  put(-2, 0, 0.05, 2);
  put(0, 0, -0.08, 1);
  put(2, 0, 0.03, 3);
  put(-1, 1, 0.02, 0);
  put(1, 1, -0.10, 4);
  put(0, 2, 0.20, 5);
  // A roof of two slopes.
  room::MeshData roof;
  for (double side : {-1.0, 1.0}) {
    roof.append(room::box({0.165, 0.02, 0.19}, 1, 1.2),
                glm::rotate(placed({side * 0.052, 3 * kSide + 0.06, 0}, 0.0), -side * 0.80, dvec3(0, 0, 1)));
  }
  p.add(roof, kRed, placed({0, 0, 0}, 0.20));
  return p;
}

Painted scatteredBlocks(const Detail& detail) {
  Painted p;
  for (std::size_t i = 0; i < kScatteredBlocks.size(); ++i) {
    p.add(box(dvec3(0.12), detail), colorOf(static_cast<int>(i) + 1),
          placed(kScatteredBlocks[i], scatteredTurn(i)));
  }
  return p;
}

Painted beachBall(const Detail& detail) {
  constexpr double kRadius = 0.17;
  Painted p;
  p.add(ball(kRadius, detail), kCream, glm::rotate(placed({0, kRadius, 0}), 0.7, dvec3(1, 0, 0.4)));
  // Sectors by the vertices' own longitude.
  for (std::size_t i = 0; i < p.paint.size(); ++i) {
    const int sector = static_cast<int>(std::floor(p.mesh.vertices[i].uv.x * 6 + 1e-9));
    if (sector % 2 == 0) p.paint[i] = colorOf(sector / 2);
  }
  return p;
}

Painted rocket(const Detail& detail) {
  Painted p;
  p.add(lathe({{0.05, 0.10}, {0.085, 0.22}, {0.09, 0.36}, {0.075, 0.48}}, detail), kCream);
  p.add(lathe({{0.075, 0.48}, {0.045, 0.58}, {0.0, 0.66}}, detail), kRed);
  p.add(lathe({{0.03, 0.05}, {0.055, 0.06}, {0.052, 0.11}, {0.0, 0.11}}, detail), kDark * 2.0);
  for (int i = 0; i < 3; ++i) {
    const double angle = glm::two_pi<double>() * i / 3 + 0.4;
    const dmat4 fin = glm::rotate(placed({0.115 * std::cos(angle), 0.12, -0.115 * std::sin(angle)}, angle),
                                  -0.45, dvec3(0, 0, 1));
    p.add(room::box({0.022, 0.26, 0.10}, 1, 1.2), kRed, fin);
  }
  for (double y : {0.30, 0.41}) {
    addOval(p, kBlue, {0.03, y, 0.078}, {0.030, 0.030, 0.012}, detail);
  }
  return p;
}

Painted shelf(const Detail& detail) {
  Painted p;
  for (double x : {-0.64, 0.0, 0.64}) p.add(box({0.03, 0.94, 0.32}, detail), kCream, placed({x, 0.47, 0}));
  for (double y : {0.04, 0.48, 0.94}) p.add(box({1.31, 0.03, 0.33}, detail), kCream, placed({0, y, 0}));
  p.add(box({1.28, 0.92, 0.015}, detail), kCream * 0.85, placed({0, 0.48, -0.155}));
  return p;
}

Painted books(const Detail& detail) {
  Painted p;
  for (int compartment = 0; compartment < 4; ++compartment) {
    double x = (compartment % 2 == 0 ? -0.60 : 0.04);
    const double end = x + (compartment == 1 ? 0.36 : 0.50);
    const double y = compartment < 2 ? 0.055 : 0.495;
    for (int i = 0; x < end; ++i) {
      const double thick = 0.022 + 0.035 * hash(i, compartment, 920);
      const double high = 0.22 + 0.14 * hash(i, compartment, 921);
      const double deep = 0.18 + 0.05 * hash(i, compartment, 922);
      const dvec3 color = colorOf(static_cast<int>(97 * hash(i, compartment, 923)));
      p.add(room::box({thick - 0.003, high, deep}, detail.share < 1 ? 1 : 0.2, 1.5),
            glm::mix(color, dvec3(0.35, 0.28, 0.22), 0.35 * hash(i, compartment, 924)),
            placed({x + thick / 2, y + high / 2, -0.03}));
      x += thick;
    }
  }
  return p;
}

Painted chest(const Detail& detail) {
  Painted p;
  p.add(box({0.90, 0.40, 0.46}, detail), kBlue * 0.85 + 0.05, placed({0, 0.24, 0}));
  p.add(box({0.94, 0.05, 0.50}, detail), kBlue, placed({0, 0.465, 0}));
  for (double x : {-0.43, 0.43}) p.add(box({0.05, 0.44, 0.48}, detail), kYellow, placed({x, 0.22, 0}));
  p.add(box({0.10, 0.07, 0.02}, detail), kYellow, placed({0, 0.42, 0.245}));
  return p;
}

Painted floorLamp(const Detail& detail) {
  Painted p;
  p.add(lathe({{0.16, 0}, {0.16, 0.015}, {0.03, 0.05}, {0.014, 0.09}, {0.012, 1.45}, {0, 1.46}}, detail),
        kOak * 0.7);
  return p;
}

Painted lampShade(const Detail& detail) {
  Painted p;
  p.add(lathe({{0.20, 1.36}, {0.13, 1.66}}, detail), dvec3(1.0, 0.86, 0.58));
  p.add(lathe({{0.13, 1.66}, {0.20, 1.36}}, detail), dvec3(1.0, 0.93, 0.74));
  return p;
}

Painted ballStand(const Detail& detail) {
  Painted p;
  p.add(lathe({{0.34, 0},
               {0.34, 0.03},
               {0.30, 0.05},
               {0.22, 0.07},
               {0.20, 0.11},
               {0.24, 0.145},
               {0.25, 0.17},
               {0.23, 0.17},
               {0.0, 0.10}},
              detail),
        kOak * 0.75);
  return p;
}

}  // namespace reflect
