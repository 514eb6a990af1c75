// What stands and hangs in the chapel. Lengths in metres, y up, the floor at 0.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "chapel.h"
#include "measures.h"
#include "room/noise.h"
#include "room/set/materials.h"

namespace postprocessing {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::MeshData;

dmat4 at(const dvec3& position) {
  return glm::translate(dmat4(1.0), position);
}

// A beam from one point to another in a plane of constant z.
MeshData strut(dvec2 from, dvec2 to, double z, dvec2 thick, int number) {
  const dvec2 along = to - from;
  const dmat4 where =
      glm::rotate(at(dvec3((from + to) * 0.5, z)), std::atan2(along.y, along.x), dvec3(0, 0, 1));
  MeshData mesh;
  mesh.append(room::box({glm::length(along), thick.x, thick.y}, 0.3, 1 / room::kWoodExtent,
                        {room::hash(number, 3, 7), room::hash(number, 4, 7)}),
              where);
  return mesh;
}

}  // namespace

void Chapel::addRoof() {
  const double length = kRoomMax.z - kRoomMin.z;
  const double middle = (kRoomMin.z + kRoomMax.z) / 2;
  const dvec3 along(0, 0, length);
  const double rise = kRidge - kEaves;
  MeshData boards;
  boards.append(room::rectangle({kRoomMin.x, kEaves, kRoomMin.z}, {kRoomMax.x, rise, 0}, along, 0.4, 0.7));
  boards.append(room::rectangle({0, kRidge, kRoomMin.z}, {kRoomMax.x, -rise, 0}, along, 0.4, 0.7));
  add(darkWood_, std::move(boards));

  MeshData timber;
  int number = 100;
  constexpr int kRafters = 14;
  for (int i = 0; i < kRafters; ++i) {
    const double z = kRoomMin.z + 0.35 + (length - 0.5) * i / (kRafters - 1);
    for (double side : {-1.0, 1.0}) {
      timber.append(strut({side * kRoomMax.x, kEaves - 0.07}, {0, kRidge - 0.07}, z, {0.14, 0.10}, ++number));
    }
  }
  for (double z : kColumnZ) {
    addBlock(timber, {0, kColumnTop + 0.24, z}, {2 * kRoomMax.x, 0.24, 0.22}, ++number);
    addBlock(timber, {0, (kColumnTop + 0.36 + kRidge) / 2, z}, {0.20, kRidge - kColumnTop - 0.36, 0.18},
             ++number);
    for (double side : {-1.0, 1.0}) {
      timber.append(strut({side * 0.08, kColumnTop + 0.6}, {side * 1.5, 5.50}, z, {0.13, 0.12}, ++number));
      timber.append(strut({side * (kColumnX - 0.12), 3.35}, {side * 1.05, kColumnTop + 0.16}, z, {0.14, 0.14},
                          ++number));
    }
  }
  for (double x : {-kColumnX, kColumnX}) {
    addBlock(timber, {x, kColumnTop + 0.06, middle}, {0.20, 0.12, length}, ++number);
  }
  add(darkWood_, std::move(timber));
}

void Chapel::addColumns() {
  const std::vector<dvec2> shaft = {{0.27, 0.225}, {0.28, 0.27}, {0.25, 0.31}, {0.20, 0.34},
                                    {0.19, 0.40},  {0.18, 3.62}, {0.21, 3.65}, {0.21, 3.69},
                                    {0.19, 3.71},  {0.20, 3.80}, {0.26, 3.98}, {0.29, 4.02}};
  MeshData mesh;
  for (double z : kColumnZ) {
    for (double x : {-kColumnX, kColumnX}) {
      mesh.append(room::lathe(shaft, 28, 60, {1, 1.6}), at({x, 0, z}));
      blocks_.push_back({{x, 2.1, z}, {0.12, 1.9, 0.12}});
      addBlock(mesh, {x, 0.11, z}, {0.60, 0.22, 0.60});
      addBlock(mesh, {x, 4.08, z}, {0.60, 0.12, 0.60});
    }
  }
  add(ashlar_, std::move(mesh));
}

// A carved beam across the chancel that carries a cross.
void Chapel::addRoodBeam() {
  const double z = kColumnZ[0];
  MeshData wood;
  addBlock(wood, {0, 3.06, z}, {2 * kColumnX - 0.2, 0.17, 0.16}, 201);
  addBlock(wood, {0, 3.165, z}, {2 * kColumnX - 0.2, 0.04, 0.22}, 202);
  addBlock(wood, {0, 3.62, z}, {0.085, 0.88, 0.06}, 203);
  addBlock(wood, {0, 3.80, z}, {0.54, 0.085, 0.06}, 204);
  for (double side : {-1.0, 1.0}) {
    wood.append(
        strut({side * (kColumnX - 0.14), 2.45}, {side * (kColumnX - 0.62), 2.98}, z, {0.10, 0.10}, 205));
  }
  add(darkWood_, std::move(wood));
  for (double x : {-1.3, -0.75, 0.75, 1.3}) addCandle({x, 3.185, z}, 0.20, false);
}

void Chapel::addPews() {
  constexpr double kFrom = 0.78;
  constexpr double kTo = 1.80;
  MeshData mesh;
  int number = 300;
  for (int row = 0; row < 4; ++row) {
    const double z = -2.35 + 1.0 * row;
    for (double side : {-1.0, 1.0}) {
      const double x = side * (kFrom + kTo) / 2;
      const double width = kTo - kFrom;
      addBlock(mesh, {x, 0.43, z}, {width, 0.04, 0.38}, ++number);
      addBlock(mesh, {x, 0.72, z + 0.20}, {width, 0.40, 0.03}, ++number);
      addBlock(mesh, {x, 0.945, z + 0.20}, {width + 0.02, 0.05, 0.08}, ++number);
      addBlock(mesh, {x, 0.20, z + 0.20}, {width, 0.10, 0.025}, ++number);
      addBlock(mesh, {x, 0.80, z + 0.30}, {width, 0.025, 0.16}, ++number);
      for (double end : {kFrom, kTo}) {
        addBlock(mesh, {side * end, 0.30, z + 0.02}, {0.05, 0.60, 0.46}, ++number);
        addBlock(mesh, {side * end, 0.78, z + 0.20}, {0.05, 0.36, 0.11}, ++number);
        mesh.append(room::sphere(0.062, 14, 10), at({side * end, 1.02, z + 0.20}));
      }
    }
  }
  add(wood_, std::move(mesh));

  MeshData books;
  addBlock(books, {0.95, 0.46, -0.40}, {0.13, 0.035, 0.19});
  addBlock(books, {-1.20, 0.46, 0.62}, {0.13, 0.035, 0.19});
  add(velvet_, std::move(books));
}

void Chapel::addAltar() {
  constexpr double kZ = -4.95;
  MeshData stone;
  addBlock(stone, {0, 0.07, kZ + 0.1}, {3.6, 0.14, 2.0});
  addBlock(stone, {0, 0.21, kZ}, {2.9, 0.14, 1.5});
  addBlock(stone, {0, 0.70, kZ}, {1.9, 0.84, 0.66});
  add(ashlar_, std::move(stone));
  MeshData linen;
  addBlock(linen, {0, 1.135, kZ}, {2.06, 0.03, 0.80});
  addBlock(linen, {0, 1.00, kZ + 0.395}, {2.06, 0.24, 0.012});
  add(linen_, std::move(linen));
  MeshData velvet;
  addBlock(velvet, {0, 0.62, kZ + 0.35}, {1.7, 0.68, 0.02});
  add(velvet_, std::move(velvet));

  const std::vector<dvec2> small = {{0.085, 0.0},  {0.085, 0.015}, {0.03, 0.05}, {0.018, 0.07}, {0.035, 0.12},
                                    {0.016, 0.16}, {0.016, 0.27},  {0.05, 0.30}, {0.05, 0.31},  {0.0, 0.31}};
  const std::vector<dvec2> tall = {{0.17, 0.0},   {0.17, 0.03},  {0.06, 0.09}, {0.028, 0.14}, {0.06, 0.22},
                                   {0.026, 0.28}, {0.022, 0.70}, {0.05, 0.75}, {0.022, 0.80}, {0.022, 1.20},
                                   {0.10, 1.26},  {0.10, 1.28},  {0.0, 1.28}};
  MeshData brass;
  for (double x : {-0.85, -0.60, 0.60, 0.85}) {
    brass.append(room::lathe(small, 20, 30), at({x, 1.15, kZ - 0.1}));
    addCandle({x, 1.46, kZ - 0.1}, 0.26, false);
  }
  for (double x : {-1.45, 1.45}) {
    brass.append(room::lathe(tall, 24, 48), at({x, 0.14, -4.05}));
    addCandle({x, 1.42, -4.05}, 0.42, false);
  }
  add(brass_, std::move(brass));
}

// A wheel of iron on a chain, about the point where the chain is fixed.
void Chapel::addLamp() {
  constexpr double kDrop = 2.75;
  constexpr double kRadius = 0.62;
  constexpr int kSides = 48;
  constexpr int kCandles = 8;
  MeshData iron;
  const auto onWheel = [](double turn, double radius) {
    return dvec3(radius * std::cos(turn * glm::two_pi<double>()), -kDrop,
                 radius * std::sin(turn * glm::two_pi<double>()));
  };
  for (double height : {-0.035, 0.035}) {
    std::vector<dvec3> wheel;
    for (int i = 0; i <= kSides; ++i) {
      wheel.push_back(onWheel(static_cast<double>(i) / kSides, kRadius) + dvec3(0, height, 0));
    }
    iron.append(room::tube(wheel, 0.016, 0.02, 8, 2));
  }
  iron.append(room::tube({{0, 0.2, 0}, {0, -kDrop + 0.75, 0}}, 0.012, 0.01, 8, 2));
  iron.append(room::sphere(0.05, 16, 10), at({0, -kDrop + 0.75, 0}));
  for (int i = 0; i < kCandles; ++i) {
    const double turn = static_cast<double>(i) / kCandles;
    const dvec3 foot = onWheel(turn, kRadius);
    if (i % 2 == 0) iron.append(room::tube({dvec3(0, -kDrop + 0.75, 0), foot}, 0.008, 0.01, 8, 2));
    if (i < kCandles / 2) iron.append(room::tube({foot, onWheel(turn + 0.5, kRadius)}, 0.012, 0.01, 8, 2));
    const std::vector<dvec2> cup = {{0.0, -0.05}, {0.03, -0.04}, {0.055, 0.05}, {0.03, 0.052}, {0.0, 0.052}};
    iron.append(room::lathe(cup, 16, 12), at(foot));
    addCandle(foot + dvec3(0, 0.05, 0), 0.16, true);
  }
  add(iron_, std::move(iron)).swings = true;

  add(linen_, std::move(wax_));
  add(linen_, std::move(swingingWax_)).swings = true;
  addFlames(std::move(flames_));
  addFlames(std::move(swingingFlames_)).swings = true;
}

Part& Chapel::addFlames(MeshData flames) {
  Part& part = parts_.emplace_back();
  part.surface = Surface::Flame;
  for (const room::Vertex& v : flames.vertices) {
    const glm::vec3 foot(1.0F, 0.95F, 0.75F);
    const glm::vec3 tip(1.0F, 0.62F, 0.22F);
    part.colors.push_back(glm::mix(foot, tip, static_cast<float>(v.uv.y)));
  }
  part.data = std::move(flames);
  return part;
}

void Chapel::addCandle(dvec3 foot, double height, bool swings) {
  const std::vector<dvec2> candle = {
      {0.021, 0.0}, {0.020, height}, {0.014, height + 0.006}, {0.0, height + 0.004}};
  const std::vector<dvec2> flame = {{0.0, 0.0},     {0.008, 0.006}, {0.0135, 0.022},
                                    {0.011, 0.040}, {0.005, 0.062}, {0.0, 0.078}};
  (swings ? swingingWax_ : wax_).append(room::lathe(candle, 14, 4), at(foot));
  (swings ? swingingFlames_ : flames_)
      .append(room::lathe(flame, 12, 12), at(foot + dvec3(0, height + 0.012, 0)));
}

}  // namespace postprocessing
