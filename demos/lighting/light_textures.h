// The small pictures that light is made of.
#pragma once

#include <array>

#include "room/image.h"

namespace lighting {

// What a spotlight projects: a bright core, the rings of a reflector, and streaks of its filament; 0 at the edge.
room::Image falloffImage();
// 256x1 along the light's axis: 0 behind the near plane, 1 in front of it, fading out at the range.
room::Image rampImage();
// A highlight about the +Z axis: a sharp core in a broad sheen.
std::array<room::Image, 6> highlightFaces();
// A soft disc.
room::Image glowImage();

}  // namespace lighting
