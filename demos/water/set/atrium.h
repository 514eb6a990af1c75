// The atrium about the pool: what is lit by lightmaps, what has its light in the vertices, what shines.
#pragma once

#include <memory>
#include <vector>

#include "measures.h"
#include "room/mesh.h"
#include "room/set/light_bake.h"
#include "room/texture.h"

namespace water {

// Lightmaps and vertex colors hold light over this.
inline constexpr float kLightScale = 2;

struct Surface {
  room::MeshData data;
  std::unique_ptr<room::Mesh> mesh;
  const room::Texture* base = nullptr;
  const room::Texture* lightmap = nullptr;
  glm::dmat4 toLightmap{1.0};  // from positions to texture coordinates
};

struct Furniture {
  std::unique_ptr<room::Mesh> mesh;
  const room::Texture* base = nullptr;
  float scale = kLightScale;  // what texture times vertex color is multiplied by
  bool twoSided = false;
};

class Atrium {
 public:
  Atrium();

  // All of it flat, with water standing on it where its base map's alpha says so.
  const std::vector<Surface>& floor() const { return floor_; }
  const std::vector<Surface>& walls() const { return walls_; }
  const std::vector<Furniture>& furniture() const { return furniture_; }
  // The empty pool, and its picture, unfolded and lit, halved like the lightmaps.
  const room::Mesh& pool() const { return *pool_; }
  const room::Texture& poolTexture() const { return poolTexture_; }
  // Light in dusty air, to be added to what is behind.
  const room::Mesh& shaft() const { return *shaft_; }
  const room::Texture& shaftTexture() const { return shaftTexture_; }
  // What floats: a lily about the origin.
  const room::Mesh& lilyLeaves() const { return *lilyLeaves_; }
  const room::Mesh& lilyPetals() const { return *lilyPetals_; }
  const room::Texture& leaf() const { return leaf_; }
  const room::Texture& petal() const { return petal_; }

 private:
  void makeMaterials();
  // What stands: each adds to the meshes and to what is in the light.
  void addColumns();
  void addRim();
  void addRoofBeams();
  void addUrn();
  void addPlants();
  void addAmphorae();
  void addBench();
  void addLampStand();
  // What is lit when all of that stands.
  void addFloor();
  void addWalls();
  void addCeiling();
  void addPool();
  void addSky();
  void addShaft();
  void addLily();
  Surface& addSurface(std::vector<Surface>& to, const room::Texture& base, room::MeshData data);
  // A lightmap over a rectangle, which surfaces that lie in it can share.
  void setLightmap(Surface& surface, const room::Texture& lightmap, glm::dvec3 origin, glm::dvec3 a,
                   glm::dvec3 b);
  const room::Texture& addLightmap(int width, int height, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b);
  void finish(const room::Texture& base, const room::MeshData& data, bool twoSided = false);
  void addGlowing(const room::Texture& base, const room::MeshData& data, glm::vec3 color);

  room::LightBake light_;
  room::Texture fresco_, slabs_, marble_, white_, red_, wood_, terracotta_, bronze_, leaf_, petal_, sky_,
      cloth_;
  room::Texture poolTexture_, shaftTexture_;
  std::vector<std::unique_ptr<room::Texture>> lightmaps_;
  room::MeshData marbleMesh_, whiteMesh_, redMesh_, woodMesh_, clayMesh_, bronzeMesh_, leafMesh_, flameMesh_,
      clothMesh_;
  std::vector<Surface> floor_;
  std::vector<Surface> walls_;
  std::vector<Furniture> furniture_;
  std::unique_ptr<room::Mesh> pool_, shaft_, lilyLeaves_, lilyPetals_;
};

}  // namespace water
