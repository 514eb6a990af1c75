// The chapel: its walls and windows, what stands in it, and the lamp that swings.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "daylight.h"
#include "room/mesh.h"
#include "room/texture.h"

namespace postprocessing {

// Vertex colors and the sun's texture hold light over this.
inline constexpr float kLightScale = 2;

enum class Surface {
  Solid,  // textured, lit at its vertices
  Floor,  // the same, and the sun from a texture
  Glass,  // textured, shines by itself
  Flame,  // shines by itself in its vertex colors
  Dust    // textured, adds to what is behind it, fades by its vertex colors
};

struct Part {
  Surface surface = Surface::Solid;
  const room::Texture* texture = nullptr;  // none for flames
  room::MeshData data;
  std::vector<glm::vec3> colors;  // of the vertices; worked out last for what does not shine by itself
  std::unique_ptr<room::Mesh> mesh;
  bool swings = false;
};

class Chapel {
 public:
  Chapel();

  const std::vector<Part>& parts() const { return parts_; }
  // Light of the sun on the floor, in the units of vertex colors.
  const room::Texture& sunOnFloor() const { return sunOnFloor_; }
  // Positions to texture coordinates of sunOnFloor.
  static glm::dmat4 floorProjection();
  // Where the lamp hangs at this time, seconds; the other parts stand still.
  static glm::dmat4 lampAt(double time);

 private:
  void makeMaterials();
  void addShell();
  void addWindow(const GlazedLancet& window, room::MeshData& stone, room::MeshData& frame);
  void addGable(room::MeshData& stone);
  void addShafts();
  void addRoof();
  void addColumns();
  void addRoodBeam();
  void addPews();
  void addAltar();
  void addLamp();
  void addCandle(glm::dvec3 foot, double height, bool swings);
  Part& add(const room::Texture& texture, room::MeshData data, Surface surface = Surface::Solid);
  Part& addFlames(room::MeshData flames);
  // A box that also stands in the way of the daylight.
  void addBlock(room::MeshData& mesh, glm::dvec3 center, glm::dvec3 size, int number = 0);
  void light();

  std::vector<GlazedLancet> windows_;
  std::vector<room::Block> blocks_;
  std::vector<Part> parts_;
  room::MeshData wax_;
  room::MeshData flames_;
  room::MeshData swingingWax_;
  room::MeshData swingingFlames_;
  std::vector<room::Texture> glass_;
  std::vector<room::Texture> softGlass_;
  room::Texture ashlar_, flagstones_, wood_, darkWood_, brass_, iron_, linen_, velvet_, sunOnFloor_;
};

}  // namespace postprocessing
