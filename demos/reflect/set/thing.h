// What the playroom is made of: things that can be drawn, culled and replaced by something simpler.
#pragma once

#include <memory>
#include <vector>

#include "room/bounds.h"
#include "room/mesh.h"
#include "room/set/light_bake.h"
#include "room/texture.h"

namespace reflect {

// A mesh with a color for every vertex.
struct Painted {
  room::MeshData mesh;
  std::vector<glm::dvec3> paint;

  void add(const room::MeshData& piece, const glm::dvec3& color, const glm::dmat4& where = glm::dmat4(1.0));
};

// How finely round things are cut: 1 for the scene, less for its reflection.
struct Detail {
  double share = 1;
  // A number of cells, at least `least`.
  int cells(int fine, int least) const;
};
inline constexpr Detail kFine{1.0};
inline constexpr Detail kProxy{0.3};

struct Thing {
  std::unique_ptr<room::Mesh> mesh;
  std::unique_ptr<room::Mesh> proxy;  // the same with fewer polygons
  const room::Texture* texture = nullptr;
  room::Box bounds;  // before `model`
  glm::dmat4 model{1.0};
  bool vertexLit = false;  // by the light that moves; what stands still has its light in its colors, halved
  float scale = 2;         // what texture times color is multiplied by
  bool shadow = false;     // lies on the floor and darkens it by its texture
};

// Colors of a thing that stands still.
std::vector<glm::vec3> litColors(const Painted& painted, const room::LightBake& light);
std::vector<glm::vec3> plainColors(const Painted& painted);

}  // namespace reflect
