#include "mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>
#include <stdexcept>

namespace room {
namespace {

struct PackedVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
  std::array<std::uint8_t, 4> color;
};
static_assert(sizeof(PackedVertex) == 36);

const void* bufferOffset(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);
}

std::uint8_t toByte(float x) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0F, 1.0F) * 255));
}

glm::dvec3 anyPerpendicular(glm::dvec3 n) {
  const glm::dvec3 axis = std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(axis, n));
}

// Replaces each inner corner of a path by an arc that leaves the legs `bend` metres before it.
std::vector<glm::dvec3> roundCorners(const std::vector<glm::dvec3>& path, double bend) {
  constexpr int kSteps = 8;
  std::vector<glm::dvec3> smooth = {path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const glm::dvec3 from = path[i] + glm::normalize(path[i - 1] - path[i]) * bend;
    const glm::dvec3 to = path[i] + glm::normalize(path[i + 1] - path[i]) * bend;
    for (int step = 0; step <= kSteps; ++step) {
      const double t = static_cast<double>(step) / kSteps;
      smooth.push_back(glm::mix(glm::mix(from, path[i], t), glm::mix(path[i], to, t), t));
    }
  }
  smooth.push_back(path.back());
  return smooth;
}

}  // namespace

void MeshData::append(const MeshData& other, const glm::dmat4& transform) {
  const std::size_t base = vertices.size();
  if (base + other.vertices.size() > 65536) throw std::length_error("a mesh needs indices beyond 16 bits");
  const glm::dmat3 rotation(transform);
  for (Vertex v : other.vertices) {
    v.position = glm::dvec3(transform * glm::dvec4(v.position, 1.0));
    v.normal = rotation * v.normal;
    v.tangent = rotation * v.tangent;
    v.bitangent = rotation * v.bitangent;
    v.side = rotation * v.side;
    vertices.push_back(v);
  }
  for (std::uint16_t index : other.indices) indices.push_back(static_cast<std::uint16_t>(base + index));
}

Vertex surfaceVertex(const SurfaceFunction& point, double u, double v) {
  constexpr double kStep = 1e-4;
  const auto alongU = [&](double row) { return point(u + kStep, row) - point(u - kStep, row); };
  const double v0 = std::max(v - kStep, 0.0);
  const double v1 = std::min(v + kStep, 1.0);
  const glm::dvec3 dv = point(u, v1) - point(u, v0);
  glm::dvec3 du = alongU(v);
  if (glm::dot(du, du) < 1e-16) du = alongU(v < 0.5 ? v + 20 * kStep : v - 20 * kStep);
  Vertex vertex;
  vertex.position = point(u, v);
  vertex.normal = glm::normalize(glm::cross(du, dv));
  vertex.tangent = glm::normalize(du - vertex.normal * glm::dot(vertex.normal, du));
  vertex.bitangent = glm::cross(vertex.normal, vertex.tangent);
  vertex.uv = {u, v};
  vertex.side = vertex.normal;
  return vertex;
}

MeshData surface(int columns, int rows, const SurfaceFunction& point, glm::dvec2 repeat) {
  MeshData mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      Vertex v = surfaceVertex(point, static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      v.uv *= repeat;
      mesh.vertices.push_back(v);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = row * (columns + 1) + column;
      const int b = a + columns + 1;
      for (int index : {a, a + 1, b + 1, a, b + 1, b})
        mesh.indices.push_back(static_cast<std::uint16_t>(index));
    }
  }
  return mesh;
}

SurfaceFunction latheFunction(std::vector<glm::dvec2> profile) {
  std::vector<double> length = {0.0};
  for (std::size_t i = 1; i < profile.size(); ++i) {
    length.push_back(length.back() + glm::distance(profile[i - 1], profile[i]));
  }
  return [profile = std::move(profile), length = std::move(length)](double u, double v) {
    const double at = std::clamp(v, 0.0, 1.0) * length.back();
    const auto next = std::upper_bound(length.begin() + 1, length.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - length.begin());
    const glm::dvec2 p =
        glm::mix(profile[i - 1], profile[i], (at - length[i - 1]) / (length[i] - length[i - 1]));
    const double angle = -u * glm::two_pi<double>();
    return glm::dvec3(p.x * std::cos(angle), p.y, p.x * std::sin(angle));
  };
}

MeshData lathe(const std::vector<glm::dvec2>& profile, int columns, int rows, glm::dvec2 repeat) {
  return surface(columns, rows, latheFunction(profile), repeat);
}

MeshData rectangle(glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b, double cell, double texels) {
  const int columns = std::max(1, static_cast<int>(std::ceil(glm::length(a) / cell)));
  const int rows = std::max(1, static_cast<int>(std::ceil(glm::length(b) / cell)));
  return surface(columns, rows, [=](double u, double v) { return origin + a * u + b * v; },
                 {glm::length(a) * texels, glm::length(b) * texels});
}

MeshData box(glm::dvec3 size, double cell, double texels, glm::dvec2 shift) {
  MeshData mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (double side : {-1.0, 1.0}) {
      int first = (axis + 1) % 3;
      int second = (axis + 2) % 3;
      if (size[second] > size[first]) std::swap(first, second);
      glm::dvec3 a(0);
      glm::dvec3 b(0);
      glm::dvec3 outside(0);
      a[first] = size[first];
      b[second] = size[second];
      outside[axis] = side * size[axis];
      if (glm::dot(glm::cross(a, b), outside) < 0) b = -b;
      MeshData face = rectangle((outside - a - b) * 0.5, a, b, cell, texels);
      for (Vertex& v : face.vertices) v.uv += shift + glm::dvec2(0.37 * axis, 0.11 * axis + 0.23 * side);
      mesh.append(face);
    }
  }
  return mesh;
}

MeshData tube(const std::vector<glm::dvec3>& path, double radius, double bend, int sides, double texels) {
  const std::vector<glm::dvec3> line = roundCorners(path, bend);
  MeshData mesh;
  glm::dvec3 side = anyPerpendicular(glm::normalize(line[1] - line[0]));
  double length = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec3 back = i > 0 ? glm::normalize(line[i] - line[i - 1]) : glm::normalize(line[1] - line[0]);
    const glm::dvec3 ahead = i + 1 < line.size() ? glm::normalize(line[i + 1] - line[i]) : back;
    const glm::dvec3 along = glm::normalize(back + ahead);
    side = glm::normalize(side - along * glm::dot(side, along));
    const glm::dvec3 other = glm::cross(along, side);
    if (i > 0) length += glm::distance(line[i], line[i - 1]);
    for (int k = 0; k <= sides; ++k) {
      const double angle = glm::two_pi<double>() * k / sides;
      Vertex v;
      v.normal = side * std::cos(angle) + other * std::sin(angle);
      v.tangent = other * std::cos(angle) - side * std::sin(angle);
      v.bitangent = along;
      v.side = v.normal;
      v.position = line[i] + v.normal * radius;
      v.uv = {std::round(std::max(1.0, glm::two_pi<double>() * radius * texels)) * k / sides,
              length * texels};
      mesh.vertices.push_back(v);
    }
  }
  for (std::size_t row = 0; row + 1 < line.size(); ++row) {
    for (int k = 0; k < sides; ++k) {
      const int a = static_cast<int>(row) * (sides + 1) + k;
      const int b = a + sides + 1;
      for (int index : {a, a + 1, b + 1, a, b + 1, b})
        mesh.indices.push_back(static_cast<std::uint16_t>(index));
    }
  }
  // The normal must be tangent x bitangent: T = other, B = along gives N = other x along = side at angle 0.
  return mesh;
}

MeshData sphere(double radius, int columns, int rows) {
  return surface(columns, rows, [radius](double u, double v) {
    const double angle = -u * glm::two_pi<double>();
    const double polar = (1.0 - v) * glm::pi<double>();
    return radius *
           glm::dvec3(std::sin(polar) * std::cos(angle), std::cos(polar), std::sin(polar) * std::sin(angle));
  });
}

Mesh::Mesh(const MeshData& data, const std::vector<glm::vec3>& colors)
    : indexCount_(static_cast<GLsizei>(data.indices.size())) {
  std::vector<PackedVertex> packed;
  packed.reserve(data.vertices.size());
  for (std::size_t i = 0; i < data.vertices.size(); ++i) {
    const Vertex& v = data.vertices[i];
    const glm::vec3 c = colors.at(i);
    packed.push_back({v.position, v.normal, v.uv, {toByte(c.r), toByte(c.g), toByte(c.b), 255}});
  }
  glGenBuffers(2, buffers_);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(packed.size() * sizeof(PackedVertex)), packed.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.indices.size() * sizeof(std::uint16_t)),
               data.indices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

Mesh::~Mesh() {
  glDeleteBuffers(2, buffers_);
}

void Mesh::bindPositions() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glVertexPointer(3, GL_FLOAT, sizeof(PackedVertex), bufferOffset(offsetof(PackedVertex, position)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Mesh::bindNormals() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glNormalPointer(GL_FLOAT, sizeof(PackedVertex), bufferOffset(offsetof(PackedVertex, normal)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Mesh::bindColors() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(PackedVertex), bufferOffset(offsetof(PackedVertex, color)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Mesh::bindTexCoords() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glTexCoordPointer(2, GL_FLOAT, sizeof(PackedVertex), bufferOffset(offsetof(PackedVertex, uv)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Mesh::bindPositionsAsTexCoords() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glTexCoordPointer(3, GL_FLOAT, sizeof(PackedVertex), bufferOffset(offsetof(PackedVertex, position)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Mesh::draw() const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_SHORT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

}  // namespace room
