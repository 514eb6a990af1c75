// Chapter 2: from array elements to clip coordinates, lit colors and texture coordinates.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "layer/render/state.h"

namespace anteroom::reference {

struct Vertex {
  glm::dvec4 clip{0};
  glm::dvec4 front{0}, back{0};  // colors, clamped to [0, 1]
  std::array<glm::dvec4, gen::kMaxTextureUnits> texCoord{};
  std::array<double, gen::kMaxClipPlanes> planeDistance{};
  double fogDistance = 0;  // |z| in eye coordinates
  double pointSize = 1;    // derived size, pixels
};

// The point between two vertices; t = 0 is a.
Vertex mix(const Vertex& a, const Vertex& b, double t);

// State that is the same for all vertices of a draw.
class VertexStage {
 public:
  explicit VertexStage(const render::State& state);
  // Element `index` of the enabled arrays.
  Vertex process(int64_t index) const;

 private:
  glm::dvec4 attribute(gen::Attribute attribute, int64_t index) const;
  template <class Term>
  void blend(int64_t index, Term term) const;
  glm::dvec4 eyePosition(int64_t index) const;
  glm::dvec3 eyeNormal(int64_t index) const;
  glm::dvec4 light(const glm::dvec4& eye, const glm::dvec3& normal, const glm::dvec4& color) const;
  glm::dvec4 textureCoordinate(int unit, int64_t index, const glm::dvec4& eye,
                               const glm::dvec3& normal) const;

  const render::State& state_;
  glm::dmat3 normalMatrix_{1.0};
  std::vector<glm::dmat3> paletteNormals_;
};

}  // namespace anteroom::reference
