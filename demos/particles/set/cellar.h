// The cellar: walls with lightmaps, furniture with its light in the vertices, and what glows by itself.
#pragma once

#include <memory>
#include <vector>

#include "firelight.h"
#include "room/mesh.h"
#include "room/texture.h"

namespace particles {

inline constexpr glm::dvec3 kRoomMin{-3.1, 0.0, -3.0};
inline constexpr glm::dvec3 kRoomMax{3.1, 2.75, 4.2};
inline constexpr glm::dvec3 kBrazier{0.0, 0.0, -0.75};
inline constexpr double kCoalHeight = 0.66;  // metres: where the flames start

struct Wall {
  std::unique_ptr<room::Mesh> mesh;
  const room::Texture* base;
  room::Texture lightmap;
  glm::dmat4 toLightmap;  // from positions to texture coordinates
  glm::dvec3 normal;
};

struct Furniture {
  std::unique_ptr<room::Mesh> mesh;  // the vertex colors are half the light, or, where it glows, its color
  const room::Texture* base;
  bool glows = false;
};

class Cellar {
 public:
  Cellar();
  const std::vector<Wall>& walls() const { return walls_; }
  const std::vector<Furniture>& furniture() const { return furniture_; }

 private:
  // Each adds meshes and what they are to the light; the light is baked when all of them stand.
  void addBrazier();
  void addCoals();
  void addBarrels();
  void addCrates();
  void addPosts();
  void addFirewood();
  void addStool();
  void addShelf();
  void addWindow();

  void makeMaterials();
  void addWalls();
  void addWall(const room::Texture& base, double extent, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b);
  void addGlowing(const room::Texture& base, const room::MeshData& data,
                  const std::vector<glm::vec3>& colors);
  void finish(const room::Texture& base, const room::MeshData& data);

  room::LightBake light_;
  room::Texture brick_, flagstones_, plaster_, wood_, iron_, glass_;
  room::MeshData wooden_, metal_, bottles_;
  std::vector<Wall> walls_;
  std::vector<Furniture> furniture_;
};

}  // namespace particles
