// Triangle meshes with a T,B,N frame at every vertex, and the shapes that furniture is made of.
#pragma once

#include <GLES/gl.h>

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace room {

struct Vertex {
  glm::dvec3 position;   // metres
  glm::dvec3 normal;     // unit length, as are the next two
  glm::dvec3 tangent;    // along growing u
  glm::dvec3 bitangent;  // along growing v
  glm::dvec2 uv;
  glm::dvec3
      side;  // normal of the side of the body that the vertex belongs to: what faces away is in its shade
};

struct MeshData {
  std::vector<Vertex> vertices;  // at most 65,536: the core has no wider indices
  std::vector<std::uint16_t> indices;

  void append(const MeshData& other, const glm::dmat4& transform = glm::dmat4(1.0));
};

// (u, v) in [0,1]^2 to a point; the outside is where dP/du x dP/dv points.
using SurfaceFunction = std::function<glm::dvec3(double u, double v)>;

// The tangent frame of a surface by central differences, also at poles where dP/du vanishes.
Vertex surfaceVertex(const SurfaceFunction& point, double u, double v);
// A grid of columns x rows cells; texture coordinates are (u, v) * repeat.
MeshData surface(int columns, int rows, const SurfaceFunction& point, glm::dvec2 repeat = {1.0, 1.0});

// A profile of (radius, height) points, from below outside, turned about the y axis.
// spacing: the profile is walked by arc length, v in [0,1].
SurfaceFunction latheFunction(std::vector<glm::dvec2> profile);
MeshData lathe(const std::vector<glm::dvec2>& profile, int columns, int rows, glm::dvec2 repeat = {1.0, 1.0});

// A rectangle at origin with edges a and b (outside: a x b), split into cells of at most `cell` metres,
// textured by `texels` repeats a metre.
MeshData rectangle(glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b, double cell, double texels);
// A box about the origin; the texture runs along its longest edge, moved by shift so that boards differ.
MeshData box(glm::dvec3 size, double cell, double texels, glm::dvec2 shift = {0.0, 0.0});
// A pipe along a path of points with rounded corners.
MeshData tube(const std::vector<glm::dvec3>& path, double radius, double bend, int sides, double texels);
MeshData sphere(double radius, int columns, int rows);

// The mesh in buffer objects: position, normal, texture coordinate, and a constant color a vertex.
class Mesh {
 public:
  Mesh(const MeshData& data, const std::vector<glm::vec3>& colors);
  // The same color everywhere.
  explicit Mesh(const MeshData& data, const glm::vec3& color = glm::vec3(1))
      : Mesh(data, std::vector<glm::vec3>(data.vertices.size(), color)) {}
  ~Mesh();
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  // Points the arrays at the buffers. Which are enabled is the pass's business.
  void bindPositions() const;
  void bindNormals() const;
  void bindColors() const;
  // For the active client texture unit.
  void bindTexCoords() const;
  void bindPositionsAsTexCoords() const;
  void draw() const;

 private:
  GLuint buffers_[2] = {0, 0};
  GLsizei indexCount_ = 0;
};

}  // namespace room
