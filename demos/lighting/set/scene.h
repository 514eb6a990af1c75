// The furnished room: what stands in it, what it is made of, and how it moves.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "lighting/spotlight.h"
#include "room/mesh.h"
#include "room/texture.h"

namespace lighting {

inline constexpr int kLights = 2;
inline constexpr glm::dvec3 kRoomMin{-3.0, 0.0, -3.0};
inline constexpr glm::dvec3 kRoomMax{3.0, 2.9, 3.9};

enum class NormalSpace { Tangent, Object };

struct Material {
  room::Texture base;
  room::Texture normal;
  room::Texture gloss;
  NormalSpace space = NormalSpace::Tangent;
};

// Surfaces that shadows fall on; each has a plane and its own stencil value.
enum class Receiver : unsigned { None, Floor, Back, Left, Right };
inline constexpr std::array kReceivers = {Receiver::Floor, Receiver::Back, Receiver::Left, Receiver::Right};
glm::dvec4 planeOf(Receiver receiver);

struct Part {
  const Material* material = nullptr;  // none: it shines by itself, in its vertex colors
  room::MeshData data;
  std::unique_ptr<room::Mesh> mesh;
  std::unique_ptr<room::Mesh> shadowMesh;  // a simpler shape with the same outline, where the mesh is fine
  glm::dmat4 model{1.0};
  glm::dvec3 center{0};  // object space, for what is done once an object
  double radius = 0;     // of a sphere about the center that holds it all
  Receiver receiver = Receiver::None;
  unsigned castsFor = 0;  // bit n: throws a shadow in light n
  double shine = 0;       // strength of the specular highlight

  const room::Mesh& outline() const { return shadowMesh ? *shadowMesh : *mesh; }
};

class Scene {
 public:
  Scene();
  void animate(double time);

  const std::vector<Part>& parts() const { return parts_; }
  const std::array<Spotlight, kLights>& lights() const { return lights_; }

 private:
  struct Options {
    Receiver receiver = Receiver::None;
    unsigned castsFor = 0;
    double shine = 0;
  };
  void makeMaterials();
  Part& add(const Material& material, room::MeshData data, const Options& options);
  Part& addGlowing(room::MeshData data, glm::vec3 color);
  void addShell();
  void addSkirting();
  void addCan();
  void addCrates();
  void addBench();
  void addPipes();
  void addPoster();
  void addPaper();
  void addLamps();

  Material brick_, tiles_, plaster_, wood_, paintedWood_, pipePaint_, enamel_, iron_, paper_, poster_, can_,
      lid_;
  std::vector<Part> parts_;
  std::vector<std::size_t> pendant_;  // parts that swing
  std::vector<std::size_t> fixture_;  // parts that turn
  std::array<Spotlight, kLights> lights_;
};

}  // namespace lighting
