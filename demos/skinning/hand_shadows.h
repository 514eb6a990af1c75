// The hand's shadows on table and wall: the hand flattened by its palette matrices, once for each of a few places of
// the lamp's flame, each darkening every pixel once (section 2.4 of the paper, with the palette of 7.1).
#pragma once

#include <GLES/gl.h>

#include "skin.h"

namespace skinning {

// The stencil bits of what takes shadows; the bits below are the shadows' own.
inline constexpr GLuint kTableBit = 0x80, kWallBit = 0x40;

void drawShadows(const Skin& skin, const glm::dmat4& view);

}  // namespace skinning
