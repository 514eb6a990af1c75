// What stands in the room. Lengths in metres, y up, the floor at 0.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "can.h"
#include "room/noise.h"
#include "room/set/furniture.h"
#include "room/set/materials.h"
#include "scene.h"

namespace lighting {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::board;
using room::crate;
using room::MeshData;
using room::placed;

constexpr unsigned kBothLights = 3;
constexpr unsigned kWarmLight = 1;
constexpr double kCell = 0.20;  // tessellation of the walls

// The same outline with fewer polygons, for shadows.
std::unique_ptr<room::Mesh> outlineOf(const MeshData& data) {
  return std::make_unique<room::Mesh>(data);
}

// A crumpled sheet: what many random cuts leave of a ball.
MeshData paperBall(double radius, int seed) {
  constexpr int kCuts = 22;
  std::array<glm::dvec4, kCuts> cuts;  // direction, distance
  for (int i = 0; i < kCuts; ++i) {
    const double y = 2 * (i + 0.5) / kCuts - 1;
    const double angle = i * 2.4 + room::hash(i, seed, 311) * 1.2;
    const double ring = std::sqrt(1 - y * y);
    cuts[static_cast<std::size_t>(i)] = {ring * std::cos(angle), y, ring * std::sin(angle),
                                         0.62 + 0.33 * room::hash(i, seed, 312)};
  }
  return room::surface(28, 16, [=](double u, double v) {
    const double angle = -u * glm::two_pi<double>();
    const double polar = (1 - v) * glm::pi<double>();
    const dvec3 direction(std::sin(polar) * std::cos(angle), std::cos(polar),
                          std::sin(polar) * std::sin(angle));
    double r = 1.15;
    for (const glm::dvec4& cut : cuts) {
      const double toward = glm::dot(dvec3(cut), direction);
      if (toward > 1e-6) r = std::min(r, cut.w / toward);
    }
    return radius * r * direction;
  });
}

}  // namespace

void Scene::addShell() {
  const dvec3 low = kRoomMin;
  const dvec3 high = kRoomMax;
  const dvec3 size = high - low;
  const dvec3 x(size.x, 0, 0);
  const dvec3 y(0, size.y, 0);
  const dvec3 z(0, 0, size.z);
  add(tiles_, room::rectangle({low.x, low.y, high.z}, x, -z, kCell, 1 / room::kTileExtent),
      {Receiver::Floor});
  add(brick_, room::rectangle(low, x, y, kCell, 1 / room::kBrickExtent), {Receiver::Back});
  add(brick_, room::rectangle({low.x, low.y, high.z}, -z, y, kCell, 1 / room::kBrickExtent),
      {Receiver::Left});
  add(brick_, room::rectangle({high.x, low.y, low.z}, z, y, kCell, 1 / room::kBrickExtent),
      {Receiver::Right});
  add(brick_, room::rectangle(high - y, -x, y, kCell, 1 / room::kBrickExtent), {});
  add(plaster_, room::rectangle({low.x, high.y, low.z}, x, z, kCell, 1 / room::kPlasterExtent), {});

  MeshData beams;
  for (int i = 0; i < 3; ++i) {
    beams.append(room::box({0.20, 0.24, size.z}, kCell, 1 / room::kWoodExtent, {0.3 * i, 0.17 * i}),
                 placed({-1.9 + 2.0 * i, high.y - 0.12, (low.z + high.z) / 2}));
  }
  add(wood_, std::move(beams), {});
}

// Each skirting board stands so near its wall that it may share the wall's shadows.
void Scene::addSkirting() {
  constexpr double kHeight = 0.13;
  constexpr double kThick = 0.02;
  const dvec3 size = kRoomMax - kRoomMin;
  const double middle = (kRoomMin.z + kRoomMax.z) / 2;
  const auto skirting = [&](double length, const dvec3& position, double turn, Receiver receiver) {
    MeshData mesh;
    mesh.append(room::box({length, kHeight, kThick}, kCell, 1 / room::kWoodExtent), placed(position, turn));
    mesh.append(room::box({length, 0.018, kThick * 1.5}, kCell, 1 / room::kWoodExtent),
                placed(position + dvec3(0, kHeight / 2, 0), turn));
    add(paintedWood_, std::move(mesh), {receiver});
  };
  const double y = kHeight / 2;
  skirting(size.x, {0, y, kRoomMin.z + kThick / 2}, 0, Receiver::Back);
  skirting(size.z, {kRoomMin.x + kThick / 2, y, middle}, glm::half_pi<double>(), Receiver::Left);
  skirting(size.z, {kRoomMax.x - kThick / 2, y, middle}, glm::half_pi<double>(), Receiver::Right);
}

void Scene::addCan() {
  const dvec3 stand(0.55, 0, -0.95);
  Part& can = add(can_, room::surface(156, 60, canSurface()), {Receiver::None, kBothLights, 0.85});
  can.model = placed(stand, 0.4);
  can.shadowMesh = outlineOf(room::surface(40, 12, canSurface()));

  // Leaning on the can, away from it to the front and left; its foot keeps it from sliding.
  const double tilt = glm::radians(72.0);
  const double away = glm::radians(212.0);
  const double radius = 0.351;
  const double upper = canRadius(2 * radius * std::sin(tilt) * 0.98);
  const double distance = upper + 0.02 + radius * std::cos(tilt);
  Part& lid = add(lid_, room::surface(64, 32, lidSurface()), {Receiver::None, kBothLights, 0.65});
  dmat4 lean = placed(stand + distance * dvec3(std::cos(away), 0, -std::sin(away)), away);
  lean = glm::translate(lean, dvec3(0, radius * std::sin(tilt), 0));
  lid.model = glm::rotate(lean, -tilt, dvec3(0, 0, 1));
  lid.shadowMesh = outlineOf(room::surface(40, 8, lidSurface()));

  MeshData handles;
  for (double side : {0.0, glm::pi<double>()}) {
    const dvec3 out(std::cos(side), 0, std::sin(side));
    const dvec3 across(-out.z, 0, out.x);
    const double r = canRadius(0.56);
    const std::vector<dvec3> path = {out * (r - 0.01) - across * 0.075 + dvec3(0, 0.56, 0),
                                     out * (r + 0.045) - across * 0.075 + dvec3(0, 0.55, 0),
                                     out * (r + 0.045) + across * 0.075 + dvec3(0, 0.55, 0),
                                     out * (r - 0.01) + across * 0.075 + dvec3(0, 0.56, 0)};
    handles.append(room::tube(path, 0.0085, 0.03, 10, 2), placed(stand, 0.4));
  }
  const std::vector<dvec3> grip = {{-0.07, 0.095, 0}, {-0.06, 0.135, 0}, {0.06, 0.135, 0}, {0.07, 0.095, 0}};
  handles.append(room::tube(grip, 0.0085, 0.03, 10, 2), lid.model);
  add(pipePaint_, std::move(handles), {Receiver::None, kBothLights, 0.6});
}

void Scene::addCrates() {
  const MeshData large = crate(0.80);
  const MeshData small = crate(0.46);
  MeshData mesh;
  MeshData outline;
  const auto put = [&](const MeshData& one, double side, const dmat4& where) {
    mesh.append(one, where);
    outline.append(room::box(dvec3(side), 1.0, 1.0), where);
  };
  put(large, 0.80, placed({-1.75, 0.40, -2.25}, 0.16));
  put(small, 0.46, placed({-1.80, 1.03, -2.28}, -0.35));
  put(small, 0.46, placed({-0.88, 0.23, -1.95}, 0.62));
  Part& crates = add(wood_, std::move(mesh), {Receiver::None, kBothLights});
  crates.shadowMesh = outlineOf(outline);
}

void Scene::addBench() {
  const dmat4 where = placed({2.42, 0, -1.05}, glm::half_pi<double>());
  MeshData planks;
  for (int i = 0; i < 3; ++i) {
    planks.append(board({1.9, 0.035, 0.125}, 60 + i), where * placed({0, 0.455, (i - 1) * 0.14}));
  }
  for (int i = 0; i < 2; ++i) {
    planks.append(board({1.9, 0.12, 0.03}, 70 + i), where * placed({0, 0.70 + 0.17 * i, 0.25 + 0.03 * i}));
  }
  add(paintedWood_, std::move(planks), {Receiver::None, kBothLights});
  MeshData legs;
  for (double x : {-0.75, 0.75}) {
    legs.append(room::tube({{x, 0.0, -0.17}, {x, 0.425, -0.17}, {x, 0.425, 0.22}, {x, 0.94, 0.31}}, 0.017,
                           0.05, 12, 2),
                where);
    legs.append(room::tube({{x, 0.425, 0.17}, {x, 0.0, 0.23}}, 0.017, 0.02, 12, 2), where);
  }
  add(iron_, std::move(legs), {Receiver::None, kBothLights, 0.5});
}

void Scene::addPipes() {
  MeshData pipes;
  const double back = kRoomMin.z + 0.11;
  pipes.append(room::tube({{2.62, 0.0, back}, {2.62, 2.46, back}, {-2.86, 2.46, back}, {-2.86, 2.46, 3.9}},
                          0.055, 0.16, 20, 2));
  pipes.append(room::tube({{2.40, 0.0, back}, {2.40, 2.30, back}, {-3.0, 2.30, back}}, 0.032, 0.12, 16, 2));
  const auto collar = [&](const dvec3& position, const dvec3& along, double radius) {
    const dvec3 half = along * 0.022;
    pipes.append(room::tube({position - half, position + half}, radius * 1.3, 0.01, 20, 2));
    const std::vector<dvec2> disc = {{radius * 1.3, 0.0}, {0.0, 0.0}};
    for (double sign : {-1.0, 1.0}) {
      const dvec3 axis = along * sign;
      const dmat4 turn =
          std::abs(axis.y) > 0.5
              ? glm::scale(dmat4(1.0), dvec3(1, 1, 1)) *
                    glm::rotate(dmat4(1.0), axis.y > 0 ? 0.0 : glm::pi<double>(), dvec3(1, 0, 0))
              : glm::rotate(dmat4(1.0), -glm::half_pi<double>() * axis.x, dvec3(0, 0, 1));
      pipes.append(room::lathe(disc, 20, 1), glm::translate(dmat4(1.0), position + half * sign) * turn);
    }
  };
  collar({2.62, 0.42, back}, {0, 1, 0}, 0.055);
  collar({2.62, 1.75, back}, {0, 1, 0}, 0.055);
  collar({2.40, 1.15, back}, {0, 1, 0}, 0.032);
  collar({1.7, 2.46, back}, {1, 0, 0}, 0.055);
  collar({-0.6, 2.46, back}, {1, 0, 0}, 0.055);
  collar({-2.2, 2.46, back}, {1, 0, 0}, 0.055);
  add(pipePaint_, std::move(pipes), {Receiver::None, kBothLights, 0.35});
}

void Scene::addPoster() {
  const dvec3 center(0.75, 1.58, kRoomMin.z + 0.03);
  const dvec2 size(0.84, 1.2);
  MeshData sheet = room::surface(
      8, 10, [&](double u, double v) { return center + dvec3((u - 0.5) * size.x, (v - 0.5) * size.y, 0); });
  add(poster_, std::move(sheet), {Receiver::Back});
  MeshData frame;
  constexpr double kBar = 0.045;
  int number = 40;
  for (double sign : {-1.0, 1.0}) {
    frame.append(board({size.x + 2 * kBar, kBar, 0.045}, ++number),
                 placed(center + dvec3(0, sign * (size.y + kBar) / 2, 0)));
    frame.append(board({kBar, size.y, 0.045}, ++number),
                 placed(center + dvec3(sign * (size.x + kBar) / 2, 0, 0)));
  }
  add(wood_, std::move(frame), {Receiver::None, kBothLights});
}

void Scene::addPaper() {
  MeshData balls;
  const MeshData first = paperBall(0.066, 1);
  const MeshData second = paperBall(0.054, 2);
  balls.append(first, placed({1.15, 0.055, -0.35}, 0.5));
  balls.append(second, placed({0.10, 0.045, 0.12}, 1.9));
  balls.append(second, placed({1.42, 0.045, -0.72}, 3.0));
  balls.append(first, placed({0.60, 0.765, -0.93}, 2.2));
  balls.append(second, placed({0.45, 0.775, -0.86}, 4.0));
  balls.append(second, placed({0.50, 0.765, -1.08}, 1.0));
  add(paper_, std::move(balls), {Receiver::None, kBothLights});
}

void Scene::addLamps() {
  const auto hang = [this](std::vector<std::size_t>& group) { group.push_back(parts_.size() - 1); };

  // The pendant's origin is its bulb; the shade opens downwards.
  const std::vector<dvec2> shade = {{0.245, -0.035}, {0.250, -0.033}, {0.245, -0.020}, {0.20, 0.055},
                                    {0.13, 0.105},   {0.06, 0.130},   {0.045, 0.16},   {0.045, 0.20},
                                    {0.02, 0.215},   {0.0, 0.22}};
  add(enamel_, room::lathe(shade, 48, 28, {4, 1}), {Receiver::None, 2U, 0.8});
  hang(pendant_);
  const std::vector<dvec2> inside = {
      {0.0, 0.12}, {0.06, 0.118}, {0.125, 0.098}, {0.195, 0.048}, {0.243, -0.034}};
  addGlowing(room::lathe(inside, 48, 12), {0.80, 0.66, 0.45});
  hang(pendant_);
  addGlowing(room::sphere(0.042, 20, 12), {1.0, 0.96, 0.84});
  hang(pendant_);
  add(iron_, room::tube({{0, 0.20, 0}, {0, 0.95, 0}}, 0.007, 0.01, 8, 2), {Receiver::None, 2U});
  hang(pendant_);

  // The stage light looks along its z axis.
  const std::vector<dvec2> barrel = {
      {0.0, -0.16}, {0.05, -0.155}, {0.075, -0.12}, {0.08, 0.08}, {0.105, 0.13}};
  MeshData housing;
  const dmat4 forward = glm::rotate(dmat4(1.0), glm::half_pi<double>(), dvec3(1, 0, 0));
  housing.append(room::lathe(barrel, 32, 16, {2, 1}), forward);
  add(iron_, std::move(housing), {Receiver::None, kWarmLight, 0.6});
  hang(fixture_);
  MeshData lens;
  lens.append(room::lathe({{0.104, 0.0}, {0.0, 0.012}}, 32, 4),
              glm::translate(dmat4(1.0), dvec3(0, 0, 0.10)) * forward);
  addGlowing(std::move(lens), {0.72, 0.86, 1.0});
  hang(fixture_);
}

}  // namespace lighting
