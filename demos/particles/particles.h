// The Particles demo: a fire in a brazier, after the Imageon "Rooms" demos.
//
//   1. Room: base texture * lightmap (second texture unit) * flicker; furniture has its light in its
//   vertices.
//   2. Fire: one array of point sprites whose sizes are written anew every frame and shrink with distance;
//   the
//      same as screen-aligned quads where Settings::quads says so.
#pragma once

#include <memory>

#include "room/demo.h"

namespace particles {

std::unique_ptr<room::Demo> makeParticles();

}  // namespace particles
