// What lights the train and the ball, section 5.1 of the paper: a directional GL light that goes around the
// room, and materials that take their color from the vertices.
#pragma once

#include "room/camera.h"
#include "set/thing.h"

namespace reflect {

enum class Version { Fine, Proxy };

// room::resetPasses(), the camera's matrices, and the light where it is at a time, seconds.
void beginLit(const room::Camera& camera, double time);
// Color = texture * scale * the vertices' color, which holds the light of what stands still and the paint of
// what is lit here.
void drawThing(const room::Camera& camera, const Thing& thing, Version version);

}  // namespace reflect
