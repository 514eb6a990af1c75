// Draws the chapel.
#pragma once

#include "chapel.h"
#include "room/camera.h"

namespace postprocessing {

// As it is; lamp: where the lamp hangs.
void drawScene(const Chapel& chapel, const room::Camera& camera, const glm::dmat4& lamp);
// What shines in white, all that can stand before it in black.
void drawMask(const Chapel& chapel, const room::Camera& camera, const glm::dmat4& lamp);

}  // namespace postprocessing
