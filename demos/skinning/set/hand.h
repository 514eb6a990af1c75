// The hand's skin: a smooth surface around the bones, made once at rest. Lengths as in skeleton.h.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "skinning/skeleton.h"

namespace skinning {

inline constexpr std::size_t kHandVertices = 5766;
inline constexpr std::size_t kInfluences = 4;

struct SkinVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;  // the palm's side is the left half of the texture, the back the right half
  std::array<float, kInfluences> weights;
  std::array<std::uint8_t, kInfluences> bones;
};

struct HandMesh {
  std::vector<SkinVertex> vertices;  // kHandVertices
  std::vector<std::uint16_t> indices;
};
HandMesh makeHand();

// What texture coordinates show: x and y at rest of a point of the half's unit square.
inline constexpr glm::dvec2 kChartLow{-76, -124}, kChartHigh{94, 216};

}  // namespace skinning
