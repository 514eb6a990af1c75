// The Skinning demo: a porcelain hand that waves, makes a fist and points, after section 7 of ATI's "Rooms"
// paper; README.md tells which file does what.
//
//   1. Parlour: base texture * light in the vertices * flicker of the candles.
//   2. Shadows: the hand flattened onto the table and the wall by its palette matrices, once for each of
//      a few places of the lamp's flame, each darkening every pixel once (stencil).
//   3. Hand, in one pass: unit 0 RGB = Base.RGB * Diffuse.RGB, alpha = Specular.A * Base.A (crossbar: the
//      cube map of unit 1); unit 1 RGB = Previous.RGB + Previous.A. Diffuse is GL's lighting by vertex,
//      Specular a cube map of what the parlour shows to a mirror, the gloss is the base map's alpha. The
//      crystal ball is drawn alike.
//
// 20 bones, 5,766 vertices, up to 4 bones each; the palette is loaded every frame.
#pragma once

#include <memory>

#include "room/demo.h"

namespace skinning {

inline constexpr int kUnits = 2;  // texture units that the passes take

std::unique_ptr<room::Demo> makeSkinning();

}  // namespace skinning
