#include "cellar.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "room/noise.h"
#include "room/set/materials.h"

namespace particles {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kFlagstoneExtent = 2.4;

// Worn stone slabs in rows of different breadth, each split at random.
room::Texel flagstones(double u, double v) {
  constexpr int kRows = 5;
  constexpr int kColumns = 4;
  const double wobble = 0.05 * room::fractalNoise(u, v, 12, 12, 2, 660);
  const double y = v * kRows + wobble;
  const int row = (static_cast<int>(std::floor(y)) + kRows) % kRows;
  const double shifted = u * kColumns + 0.8 * room::hash(row, 0, 661) + wobble;
  const int column = static_cast<int>(std::floor(shifted)) % kColumns;
  const double split = 0.40 + 0.35 * room::hash(column, row, 662);
  dvec2 inCell(room::fractionOf(shifted), room::fractionOf(y));
  const bool second = inCell.x > split;
  const double left = second ? split : 0.0;
  const double right = second ? 1.0 : split;
  const dvec2 metres(kFlagstoneExtent / kColumns, kFlagstoneExtent / kRows);
  const double edge = std::min(std::min(inCell.x - left, right - inCell.x) * metres.x,
                               std::min(inCell.y, 1 - inCell.y) * metres.y);
  const double body = room::smoothStep(0.003, 0.020, edge + 0.006 * room::fractalNoise(u, v, 48, 48, 2, 663));
  const double tone = room::hash(2 * column + (second ? 1 : 0), row, 664);
  dvec3 stone = glm::mix(dvec3(0.42, 0.39, 0.35), dvec3(0.60, 0.55, 0.47), tone);
  stone *= 0.95 + 0.30 * room::fractalNoise(u, v, 10, 10, 5, 665);
  room::Texel t;
  t.color =
      glm::mix(dvec3(0.13, 0.115, 0.10), stone, body) * (0.92 + 0.16 * room::smoothStep(0.0, 0.09, edge));
  return t;
}

room::Texel sootyPlaster(double u, double v) {
  room::Texel t = room::plaster(u, v);
  t.color *= dvec3(0.62, 0.58, 0.54);
  return t;
}

}  // namespace

Cellar::Cellar() : light_(firelightBake(kRoomMin, kRoomMax, kBrazier + dvec3(0, kCoalHeight, 0))) {
  makeMaterials();
  addBrazier();
  addBarrels();
  addCrates();
  addPosts();
  addFirewood();
  addStool();
  addShelf();
  addWalls();
  finish(wood_, wooden_);
  finish(iron_, metal_);
  finish(glass_, bottles_);
  addCoals();
  addWindow();
}

void Cellar::makeMaterials() {
  brick_ = room::materialTexture(512, room::brick);
  flagstones_ = room::materialTexture(512, flagstones);
  plaster_ = room::materialTexture(256, sootyPlaster);
  wood_ = room::materialTexture(256, room::wood);
  iron_ = room::materialTexture(
      128, [](double u, double v) { return room::paintedMetal(u, v, dvec3(0.20, 0.19, 0.19)); });
  glass_ = room::materialTexture(
      64, [](double u, double v) { return room::paintedMetal(u, v, dvec3(0.17, 0.34, 0.20)); });
}

void Cellar::addWalls() {
  const dvec3 size = kRoomMax - kRoomMin;
  const dvec3 x(size.x, 0, 0);
  const dvec3 y(0, size.y, 0);
  const dvec3 z(0, 0, size.z);
  addWall(flagstones_, kFlagstoneExtent, {kRoomMin.x, kRoomMin.y, kRoomMax.z}, x, -z);
  addWall(plaster_, room::kPlasterExtent, {kRoomMin.x, kRoomMax.y, kRoomMin.z}, x, z);
  addWall(brick_, room::kBrickExtent, kRoomMin, x, y);
  addWall(brick_, room::kBrickExtent, {kRoomMin.x, kRoomMin.y, kRoomMax.z}, -z, y);
  addWall(brick_, room::kBrickExtent, {kRoomMax.x, kRoomMin.y, kRoomMin.z}, z, y);
}

void Cellar::addWall(const room::Texture& base, double extent, dvec3 origin, dvec3 a, dvec3 b) {
  const room::MeshData data = room::rectangle(origin, a, b, 1.0, 1 / extent);
  Wall& wall = walls_.emplace_back();
  wall.mesh = std::make_unique<room::Mesh>(data);
  wall.base = &base;
  wall.normal = glm::normalize(glm::cross(a, b));
  const bool floor = wall.normal.y > 0.5;
  wall.lightmap = room::makeTexture(light_.lightmap(floor ? 256 : 128, floor ? 256 : 64, origin, a, b),
                                    room::Filter::Linear, GL_CLAMP_TO_EDGE);
  wall.toLightmap = room::rectangleCoordinates(origin, a, b);
}

void Cellar::addGlowing(const room::Texture& base, const room::MeshData& data,
                        const std::vector<glm::vec3>& colors) {
  furniture_.push_back({std::make_unique<room::Mesh>(data, colors), &base, true});
}

void Cellar::finish(const room::Texture& base, const room::MeshData& data) {
  furniture_.push_back({std::make_unique<room::Mesh>(data, light_.vertexLight(data)), &base});
}

}  // namespace particles
