// The Particles demo: a fire in a brazier, after section 6 of ATI's "Rooms" paper; README.md tells which file
// does what.
//
//   1. Room: base texture * lightmap (second texture unit) * flicker; furniture has its light in its
//      vertices.
//   2. Fire: one array of point sprites whose sizes are written anew every frame and shrink with
//      distance; the same as screen-aligned quads where Settings::quads says so.
#pragma once

#include <memory>

#include "room/demo.h"

namespace particles {

inline constexpr int kUnits = 2;  // texture units that the passes take

std::unique_ptr<room::Demo> makeParticles();

}  // namespace particles
