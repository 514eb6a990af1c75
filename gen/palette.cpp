#include "gen/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "gen/gen.h"
#include "gen/values.h"

namespace anteroom::gen {
namespace {

constexpr uint32_t kRowSize = 16;  // in std140 also a column of a mat3

uint32_t rows(const VertexKey& key) {
  return key.paletteW ? 4 : 3;
}

// Matrices that a program computed in float and loaded are orthogonal to about 10^-7.
constexpr double kOrthogonal = 1e-6;

bool isOrthogonal(const glm::dmat4& matrix) {
  const glm::dmat3 m(matrix);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      if (!(std::abs(glm::dot(m[a], m[b]) - (a == b ? 1 : 0)) < kOrthogonal)) return false;
  return true;
}

}  // namespace

bool isAffine(const Palette& palette) {
  return std::ranges::all_of(palette.matrices, [](const glm::dmat4& m) {
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
  });
}

bool isOrthogonal(const Palette& palette) {
  return std::ranges::all_of(palette.matrices, [](const glm::dmat4& m) { return isOrthogonal(m); });
}

std::string_view paletteType(const VertexKey& key) {
  return key.paletteW ? "mat4" : "mat3x4";
}

std::string declarePalette(const VertexKey& key) {
  if (!key.palette) return "";
  std::string members = fmt::format("  {} palette[{}];\n", paletteType(key), kPaletteMatrices);
  if (key.paletteNormals) members += fmt::format("  mat3 paletteNormals[{}];\n", kPaletteMatrices);
  return fmt::format("layout(std140, set = 3, binding = 0) uniform Palette {{\n{}}};\n", members);
}

uint32_t paletteSize(const VertexKey& key) {
  if (!key.palette) return 0;
  return (rows(key) + (key.paletteNormals ? 3 : 0)) * kRowSize * kPaletteMatrices;
}

Groups paletteGroups(const VertexKey& key) {
  if (!key.palette) return 0;
  const Groups rescaled = kGroupLighting;  // RESCALE_NORMAL
  return kGroupPalette | (key.paletteNormals ? rescaled : 0);
}

void packPalette(const VertexKey& key, const State& state, std::byte* out) {
  if (!key.palette || !state.palette) return;
  const auto put = [&](const glm::dvec4& v) {
    const glm::vec4 rounded(v);
    std::memcpy(out, &rounded, kRowSize);
    out += kRowSize;
  };
  for (const glm::dmat4& m : state.palette->matrices)
    for (int r = 0; r < static_cast<int>(rows(key)); ++r) put({m[0][r], m[1][r], m[2][r], m[3][r]});
  if (!key.paletteNormals) return;
  for (const glm::dmat4& m : state.palette->matrices) {
    const glm::dmat3 normals = normalMatrix(m, state.lighting.rescaleNormal);
    for (int c = 0; c < 3; ++c) put({normals[c], 0});
  }
}

}  // namespace anteroom::gen
