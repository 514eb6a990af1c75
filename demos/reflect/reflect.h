// The Reflect demo: a shining ball in the middle of a playroom, and a train around it, after section 5 of
// ATI's "Rooms" paper; README.md tells which file does what.
//
//   1. Six faces of a cube map, 256x256 each, every frame: the room from the middle of the ball, its
//      things drawn with fewer polygons, and only those whose bounding boxes reach into the face's view.
//   2. The room. The train's vehicles are lit at their vertices by a directional light that moves.
//   3. The ball: lit the same way, and the cube map by reflection mapping, mixed in one pass.
//   4. How many things each face has left out, in an overlay, where Settings::culled says so.
#pragma once

#include <memory>

#include "room/demo.h"

namespace reflect {

inline constexpr int kUnits = 1;  // texture units that the passes take

std::unique_ptr<room::Demo> makeReflect();

}  // namespace reflect
