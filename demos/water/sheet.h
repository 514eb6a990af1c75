// The water's surface: a lattice of heights, and the arrays that GL draws it from, made anew every frame.
#pragma once

#include <GLES/gl.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace water {

inline constexpr int kLattice = 64;  // vertices along each side of the pool

// Heights over the water level in metres, rows along z.
using Heights = std::vector<double>;

inline std::size_t latticeIndex(int column, int row) {
  return static_cast<std::size_t>(row) * kLattice + static_cast<std::size_t>(column);
}
// Where a vertex is, x and z from the middle of the pool.
glm::dvec2 latticePoint(int column, int row);
// The cell that a place lies in.
struct LatticePlace {
  std::size_t vertex;  // of its lowest column and row
  glm::dvec2 part;     // [0,1), of the cell
};
LatticePlace latticePlace(glm::dvec2 place);

// What a function of the vertices is at a place between them; x and z from the middle of the pool.
template <typename Function>
auto onLattice(glm::dvec2 place, const Function& of) {
  const LatticePlace at = latticePlace(place);
  return (1 - at.part.y) * ((1 - at.part.x) * of(at.vertex) + at.part.x * of(at.vertex + 1)) +
         at.part.y * ((1 - at.part.x) * of(at.vertex + kLattice) + at.part.x * of(at.vertex + kLattice + 1));
}

class Caustics;

class Sheet {
 public:
  Sheet();
  // Normals from the heights' differences, and, for the eye, where the refracted ray through every vertex
  // meets the pool, how much light comes from there and how much is reflected.
  void update(const Heights& heights, const Caustics& caustics, const glm::dvec3& eye);
  // Height and normal between the vertices; x and z from the middle of the pool.
  struct Point {
    double height;
    glm::dvec3 normal;
  };
  Point at(glm::dvec2 place) const;
  // Points the arrays at the vertices. Color: what is left of refracted light, and in alpha what is
  // reflected.
  void bindPositions() const;
  void bindNormals() const;
  void bindColors() const;
  void bindTexCoords() const;
  void draw() const;

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 color;
    glm::vec2 uv;
  };
  std::vector<Vertex> vertices_;
  std::vector<std::uint16_t> indices_;
};

}  // namespace water
