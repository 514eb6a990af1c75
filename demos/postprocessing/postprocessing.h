// The Postprocessing demo: light bloom, after section 4 of ATI's "Rooms" paper; README.md tells which file
// does what. The glare of a bright window spreads over its surroundings, and whatever comes between cuts it.
//
//   1. Mask: the glass white, all that can stand before it black                (256x256 framebuffer object)
//   2. Reductions: the mask at 128, 64, 32 and 16, each from the one before     (linear filtering, 4 taps)
//   3. Glare: the four, magnified and added up with weights
//   4. The scene, and the glare over it: scene + glare * (1 - scene)
#pragma once

#include <memory>

#include "room/demo.h"

namespace postprocessing {

inline constexpr int kUnits = 2;  // texture units that the passes take

std::unique_ptr<room::Demo> makePostprocessing();

}  // namespace postprocessing
