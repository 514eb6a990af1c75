// OES_matrix_palette: what a key must know of the matrices, and their block of constants: an array of them by
// rows, three each unless key.paletteW, and then, if key.paletteNormals, one of matrices for normals.
#pragma once

#include <string>
#include <string_view>

#include "gen/key.h"

namespace anteroom::gen {

// Whether every last row is (0, 0, 0, 1).
bool isAffine(const Palette& palette);
// Whether every upper 3x3 matrix is its own inverse transpose, to float's precision.
bool isOrthogonal(const Palette& palette);

// GLSL; the declaration is empty without a palette.
std::string_view paletteType(const VertexKey& key);
std::string declarePalette(const VertexKey& key);

uint32_t paletteSize(const VertexKey& key);  // bytes
Groups paletteGroups(const VertexKey& key);

}  // namespace anteroom::gen
