// The small pictures that light is made of.
#pragma once

#include <array>

#include "room/image.h"

namespace lighting {

// What a spotlight projects; 0 at the edge. A shaded bulb: a bright core that fades into spokes. A stage
// light: an even disc with the rings of its lens.
room::Image bulbFalloff();
room::Image lensFalloff();
// 256x1 along the light's axis: 0 behind the near plane, 1 in front of it, fading out at the range.
room::Image rampImage();
// A highlight about the +Z axis, drawn out along y as on brushed sheet metal: a sharp core in a broad sheen.
std::array<room::Image, 6> highlightFaces();
// A soft disc.
room::Image glowImage();

}  // namespace lighting
