// The Water demo: a pool in an atrium and puddles about it, after section 3 of ATI's "Rooms" paper; README.md
// tells which file does what.
//
//   1. Room: base texture * lightmap (second texture unit); furniture has its light in its vertices.
//   2. Refraction: the lattice of the surface, moved every frame, with the pool's picture on it; texture
//      coordinates are where the refracted ray from the eye meets the pool.
//   3. Reflection: a cube map of the room, drawn once from the middle of the surface, by reflection
//      mapping. The texture matrix turns reflection vectors from eye coordinates to the world's. Both are
//      mixed by Fresnel's share in the vertices' alpha, in one pass.
//   4. Puddles: the room mirrored about the floor and turned inside out, in a framebuffer object,
//      projected onto the floor by Bias * CP * CV where the alpha of its base map says that water stands.
#pragma once

#include <memory>

#include "room/demo.h"

namespace water {

inline constexpr int kUnits = 3;  // texture units that the passes take

std::unique_ptr<room::Demo> makeWater();

}  // namespace water
