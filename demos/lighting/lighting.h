// The Lighting demo: Final = Bump * Spot + Specular + Shadows, after section 2 of ATI's "Rooms" paper;
// README.md tells which file does what.
//
// For each light in turn, so that lights add up rightly:
//   1. Mask: destination alpha = attenuation * projected falloff * back-projection ramp     (2 texture units)
//   2. Shadows: destination alpha is darkened where the light is hidden, each pixel once    (stencil)
//   3. Bump: color += DOT3(normal map, light vector) * base * light color * destination alpha  (3 units)
//   4. Specular: color += highlight cube map * gloss * light color * destination alpha      (2 units)
// on top of a pass that lays down depth, the stencil values of the receivers and the ambient light.
#pragma once

#include <memory>

#include "room/demo.h"

namespace lighting {

inline constexpr int kUnits = 3;  // texture units that the passes take

// What every pass starts from: room::resetPasses(), color written but alpha not, depth tested but not
// written.
void beginPass();

std::unique_ptr<room::Demo> makeLighting();

}  // namespace lighting
