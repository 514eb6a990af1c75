// What stands in the cellar. Lengths in metres, y up, the floor at 0.
#include "room/set/furniture.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cellar.h"
#include "room/noise.h"
#include "room/set/materials.h"

namespace particles {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::board;
using room::MeshData;
using room::placed;

// A lathe with the grain of the wood along its axis.
MeshData turned(const std::vector<dvec2>& profile, int columns, int rows, dvec2 repeat) {
  MeshData mesh = room::lathe(profile, columns, rows, {repeat.y, repeat.x});
  for (room::Vertex& v : mesh.vertices) v.uv = {v.uv.y, v.uv.x};
  return mesh;
}

MeshData ring(double radius, double thick) {
  return room::surface(40, 8, [=](double u, double v) {
    const double around = -u * glm::two_pi<double>();
    const double across = v * glm::two_pi<double>() - glm::half_pi<double>();
    const double r = radius + thick * std::cos(across);
    return dvec3(r * std::cos(around), thick * std::sin(across), r * std::sin(around));
  });
}

// About the y axis, standing on the origin.
struct Barrel {
  MeshData staves;
  MeshData hoops;
};

constexpr double kBarrelHeight = 0.86;
double barrelRadius(double y) {
  const double middle = 2 * y / kBarrelHeight - 1;
  return 0.325 - 0.062 * middle * middle;
}

Barrel makeBarrel() {
  Barrel barrel;
  std::vector<dvec2> profile;
  for (int i = 0; i <= 10; ++i)
    profile.emplace_back(barrelRadius(kBarrelHeight * i / 10), kBarrelHeight * i / 10);
  const double rim = barrelRadius(kBarrelHeight);
  for (const dvec2 p : {dvec2(rim - 0.022, kBarrelHeight), dvec2(rim - 0.026, kBarrelHeight - 0.035)})
    profile.push_back(p);
  barrel.staves = turned(profile, 40, 26, {1, 3});
  // The lid's boards run straight across.
  MeshData lid = room::lathe({{rim - 0.02, 0}, {0, 0}}, 40, 4);
  for (room::Vertex& v : lid.vertices) v.uv = dvec2(v.position.x, v.position.z) / room::kWoodExtent;
  for (double y : {0.0, kBarrelHeight - 0.034}) {
    dmat4 where = glm::translate(dmat4(1.0), dvec3(0, y, 0));
    if (y == 0)
      where = glm::rotate(glm::translate(where, dvec3(0, 0.034, 0)), glm::pi<double>(), dvec3(1, 0, 0));
    barrel.staves.append(lid, where);
  }
  for (double y : {0.035, 0.20, 0.62, 0.785}) {
    const double low = barrelRadius(y);
    const double high = barrelRadius(y + 0.045);
    barrel.hoops.append(
        room::lathe({{low - 0.01, y}, {low + 0.006, y}, {high + 0.006, y + 0.045}, {high - 0.01, y + 0.045}},
                    40, 6, {4, 0.3}));
  }
  return barrel;
}

MeshData log(double radius, double length, int number) {
  MeshData mesh = turned(
      {{0.0, 0.0}, {radius, 0.002}, {radius * 1.02, length * 0.5}, {radius, length - 0.002}, {0.0, length}},
      14, 10, {0.5, 0.5});
  for (room::Vertex& v : mesh.vertices) v.uv += dvec2(room::hash(number, 3, 671), room::hash(number, 4, 671));
  return mesh;
}

// The y axis turned to point along the z axis.
const dmat4& lying() {
  static const dmat4 matrix = glm::rotate(dmat4(1.0), glm::half_pi<double>(), dvec3(1, 0, 0));
  return matrix;
}

}  // namespace

void Cellar::addBrazier() {
  const dmat4 here = placed(kBrazier);
  const std::vector<dvec2> bowl = {{0.0, 0.50},   {0.15, 0.51},  {0.27, 0.57}, {0.35, 0.68},  {0.375, 0.71},
                                   {0.36, 0.715}, {0.335, 0.69}, {0.26, 0.60}, {0.14, 0.545}, {0.0, 0.54}};
  metal_.append(room::lathe(bowl, 48, 30, {4, 2}), here);
  metal_.append(ring(0.372, 0.016), here * placed({0, 0.70, 0}));
  metal_.append(ring(0.36, 0.011), here * placed({0, 0.20, 0}));
  for (int i = 0; i < 3; ++i) {
    const dmat4 turn = placed(kBrazier, i * glm::two_pi<double>() / 3 + 0.5);
    metal_.append(
        room::tube({{0.33, 0.68, 0}, {0.37, 0.60, 0}, {0.34, 0.25, 0}, {0.44, 0.0, 0}}, 0.016, 0.05, 8, 2),
        turn);
    light_.add(room::UprightCylinder{dvec3(turn * glm::dvec4(0.43, 0, 0, 1)), 0.02, 0.10});
    light_.add(room::UprightCylinder{dvec3(turn * glm::dvec4(0.36, 0.10, 0, 1)), 0.02, 0.40});
  }
  for (int i = 0; i < 12; ++i) {
    const dmat4 turn = placed(kBrazier, i * glm::two_pi<double>() / 12);
    metal_.append(room::tube({{0.365, 0.69, 0}, {0.385, 0.80, 0}, {0.43, 0.90, 0}}, 0.008, 0.04, 6, 2), turn);
  }
  light_.add(room::UprightCylinder{kBrazier + dvec3(0, 0.54, 0), 0.33, 0.10});
}

// A bed of coals and four burning logs.
void Cellar::addCoals() {
  const dmat4 here = placed(kBrazier);
  MeshData coals = room::surface(56, 28, [](double u, double v) {
    const double angle = -u * glm::two_pi<double>();
    const double radius = 0.318 * (1 - v);
    const dvec2 at(radius * std::cos(angle), radius * std::sin(angle));
    const double lump = room::cellNoise((at.x + 0.4) / 0.8, (at.y + 0.4) / 0.8, 11, 11, 680).nearest;
    return dvec3(at.x, kCoalHeight + 0.04 * (1 - radius / 0.32) - 0.045 * lump * lump, at.y);
  });
  const dvec2 charred(0.30, 0.21);
  for (int i = 0; i < 4; ++i) {
    dmat4 where = placed({0, 0.62, 0}, i * glm::half_pi<double>() + 0.4);
    where = glm::translate(where, dvec3(-0.23, 0, 0.03));
    where = glm::rotate(where, -glm::radians(38.0 + 6 * i), dvec3(0, 0, 1));
    coals.append(log(0.042, 0.44, i), where);
  }
  std::vector<glm::vec3> colors;
  for (room::Vertex& v : coals.vertices) {
    const double heat = 0.5 + 0.8 * room::noise(v.position.x * 14 + 20,
                                                v.position.z * 14 + v.position.y * 9 + 20, 256, 256, 681);
    const double high = room::smoothStep(kCoalHeight, kCoalHeight + 0.22, v.position.y);
    const double glow = glm::clamp(heat - 0.35 * high, 0.0, 1.0);
    colors.emplace_back(glm::mix(dvec3(0.10, 0.03, 0.02), dvec3(1.0, 0.50, 0.14), glow * glow));
    v.uv *= charred;
  }
  MeshData inPlace;
  inPlace.append(coals, here);
  addGlowing(wood_, inPlace, colors);
}

void Cellar::addBarrels() {
  const Barrel barrel = makeBarrel();
  const auto put = [&](const dmat4& where) {
    wooden_.append(barrel.staves, where);
    metal_.append(barrel.hoops, where);
  };
  for (const dvec3 foot : {dvec3(-2.55, 0, -2.45), dvec3(-1.80, 0, -2.58), dvec3(-2.66, 0, -1.62)}) {
    put(placed(foot, foot.x * 7));
    light_.add(room::UprightCylinder{foot, 0.285, kBarrelHeight - 0.03});
  }
  // One lies on top of two.
  const dvec3 lyingAt(-2.30, kBarrelHeight + 0.31, -2.93);
  put(placed(lyingAt, 0.06) * lying());
  light_.add(room::Block{lyingAt + dvec3(0, 0, 0.43), {0.25, 0.25, 0.40}});
}

void Cellar::addCrates() {
  const auto put = [this](double side, const dvec3& foot, double turn) {
    wooden_.append(room::crate(side), placed(foot + dvec3(0, side / 2, 0), turn));
    light_.add(room::Block{foot + dvec3(0, side / 2, 0), dvec3(side / 2 - 0.05), turn});
  };
  put(0.74, {2.45, 0, -2.35}, 0.12);
  put(0.50, {2.48, 0.74, -2.42}, -0.30);
  put(0.50, {1.70, 0, -2.55}, 0.35);
}

// Posts that carry the beams.
void Cellar::addPosts() {
  int number = 20;
  for (double x : {-1.55, 1.55}) {
    for (double z : {-1.75, 2.2}) {
      const double height = kRoomMax.y - 0.2;
      ++number;
      wooden_.append(
          room::box({0.19, height, 0.19}, 0.1, 1 / room::kWoodExtent, {0.3 * number, 0.2 * number}),
          placed({x, height / 2, z}));
      light_.add(room::Block{{x, height / 2, z}, {0.085, height / 2, 0.085}});
      for (double side : {-1.0, 1.0}) {
        dmat4 brace = placed({x, height - 0.26, z + side * 0.26});
        brace = glm::rotate(brace, side * glm::quarter_pi<double>(), dvec3(1, 0, 0));
        wooden_.append(board({0.09, 0.72, 0.10}, ++number), brace);
      }
    }
    const double length = kRoomMax.z - kRoomMin.z;
    wooden_.append(room::box({0.22, 0.2, length}, 0.2, 1 / room::kWoodExtent, {0.17 * number, 0.4}),
                   placed({x, kRoomMax.y - 0.1, (kRoomMin.z + kRoomMax.z) / 2}));
    light_.add(room::Block{{x, kRoomMax.y - 0.1, 0.6}, {0.10, 0.09, length / 2}});
  }
}

void Cellar::addFirewood() {
  constexpr double kRadius = 0.075;
  constexpr double kLength = 0.62;
  const dvec3 corner(2.28, 0, -0.98);
  int number = 0;
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i < 5 - row; ++i) {
      const double r = kRadius * (0.9 + 0.12 * room::hash(row, i, 672));
      const dvec3 at = corner + dvec3((room::hash(row, i, 673) - 0.5) * 0.07, kRadius + row * kRadius * 1.72,
                                      (i + row * 0.5) * kRadius * 2);
      const dmat4 across =
          glm::rotate(glm::translate(dmat4(1.0), at), -glm::half_pi<double>(), dvec3(0, 0, 1));
      wooden_.append(log(r, kLength, ++number), across);
    }
  }
  light_.add(room::Block{corner + dvec3(kLength / 2, 0.13, 0.30), {kLength / 2 - 0.05, 0.11, 0.30}});
  light_.add(room::Block{corner + dvec3(kLength / 2, 0.34, 0.30), {kLength / 2 - 0.05, 0.11, 0.13}});
  // One has been carried to the fire.
  wooden_.append(log(kRadius * 0.9, kLength, 30), placed({0.75, kRadius * 0.9, -0.05}, 0.8) * lying());
  const dvec3 middle =
      dvec3(std::sin(0.8), 0, std::cos(0.8)) * (kLength / 2) + dvec3(0.75, kRadius * 0.8, -0.05);
  light_.add(room::Block{middle, {kRadius * 0.7, kRadius * 0.6, kLength / 2}, 0.8});
}

void Cellar::addStool() {
  const dvec3 foot(-1.15, 0, 0.15);
  wooden_.append(
      turned({{0.0, 0.40}, {0.16, 0.40}, {0.175, 0.415}, {0.175, 0.435}, {0.16, 0.445}, {0.0, 0.445}}, 32, 14,
             {0.4, 1}),
      placed(foot));
  for (int i = 0; i < 3; ++i) {
    wooden_.append(room::tube({{0.10, 0.405, 0}, {0.14, 0.22, 0}, {0.185, 0.0, 0}}, 0.018, 0.02, 8, 2),
                   placed(foot, 1 + i * glm::two_pi<double>() / 3));
    const double angle = 1 + i * glm::two_pi<double>() / 3;
    light_.add(room::UprightCylinder{foot + dvec3(0.165 * std::cos(angle), 0, -0.165 * std::sin(angle)),
                                     0.012, 0.15});
  }
  light_.add(room::UprightCylinder{foot + dvec3(0, 0.40, 0), 0.165, 0.03});
  // A bottle beside it.
  const std::vector<dvec2> bottle = {{0.0, 0.0},    {0.036, 0.0},  {0.04, 0.02},  {0.04, 0.17},
                                     {0.016, 0.22}, {0.014, 0.29}, {0.017, 0.30}, {0.0, 0.30}};
  bottles_.append(room::lathe(bottle, 20, 28), placed(foot + dvec3(-0.28, 0, 0.10)));
  light_.add(room::UprightCylinder{foot + dvec3(-0.28, 0, 0.10), 0.030, 0.17});
}

void Cellar::addShelf() {
  const dvec3 center(0.35, 1.62, kRoomMin.z + 0.13);
  wooden_.append(board({1.5, 0.035, 0.24}, 90), placed(center));
  for (double x : {-0.6, 0.6}) {
    wooden_.append(board({0.05, 0.20, 0.04}, 91), placed(center + dvec3(x, -0.115, -0.10)));
    dmat4 brace = placed(center + dvec3(x, -0.115, 0.0));
    brace = glm::rotate(brace, glm::radians(48.0), dvec3(1, 0, 0));
    wooden_.append(board({0.04, 0.26, 0.035}, 92), brace);
  }
  light_.add(room::Block{center, {0.74, 0.012, 0.11}});
  const std::vector<dvec2> bottle = {{0.0, 0.0},     {0.040, 0.0},  {0.044, 0.02}, {0.044, 0.18},
                                     {0.017, 0.235}, {0.014, 0.30}, {0.018, 0.31}, {0.0, 0.31}};
  for (double x : {-0.58, -0.46, -0.33, -0.05, 0.42, 0.55}) {
    bottles_.append(room::lathe(bottle, 20, 28),
                    placed(center + dvec3(x, 0.0175, 0.03 * std::sin(40 * x)), 9 * x));
  }
  const std::vector<dvec2> jug = {{0.0, 0.0},   {0.07, 0.0},  {0.10, 0.06}, {0.10, 0.12},
                                  {0.06, 0.19}, {0.07, 0.23}, {0.06, 0.23}, {0.05, 0.19}};
  wooden_.append(room::lathe(jug, 28, 24, {0.3, 0.2}), placed(center + dvec3(0.19, 0.0175, 0)));
}

// High up, towards the street at night.
void Cellar::addWindow() {
  const dvec3 center(-0.95, 2.18, kRoomMin.z + 0.012);
  MeshData pane = room::rectangle(center - dvec3(0.34, 0.20, 0), {0.68, 0, 0}, {0, 0.40, 0}, 0.1, 1);
  std::vector<glm::vec3> sky;
  for (const room::Vertex& v : pane.vertices) {
    const double up = (v.position.y - center.y) / 0.4 + 0.5;
    sky.emplace_back(glm::mix(dvec3(0.17, 0.24, 0.42), dvec3(0.05, 0.08, 0.20), up));
  }
  addGlowing(plaster_, pane, sky);
  MeshData bars;
  for (int i = -2; i <= 2; ++i) {
    bars.append(room::tube({center + dvec3(0.125 * i, -0.2, 0.03), center + dvec3(0.125 * i, 0.2, 0.03)},
                           0.011, 0.01, 8, 2));
  }
  finish(iron_, bars);
  MeshData frame;
  for (double sign : {-1.0, 1.0}) {
    frame.append(board({0.80, 0.06, 0.09}, 95), placed(center + dvec3(0, sign * 0.23, 0.02)));
    frame.append(board({0.06, 0.40, 0.09}, 96), placed(center + dvec3(sign * 0.37, 0, 0.02)));
  }
  finish(wood_, frame);
}

}  // namespace particles
