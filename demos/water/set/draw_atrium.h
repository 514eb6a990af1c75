// Draws the atrium. Every function starts from room::resetPasses() and the camera's matrices.
#pragma once

#include "atrium.h"
#include "room/camera.h"
#include "water/sheet.h"

namespace water {

// Color = base * 2 * lightmap (units 0 and 1); leaves unit 2 alone.
void drawLightmapped(const Surface& surface);
// The room without its floor; loads the camera's matrices.
void drawAboveFloor(const Atrium& atrium, const room::Camera& camera);
// The empty pool.
void drawPool(const Atrium& atrium);
// Water lilies, which lean with the water; the camera's matrices are loaded again.
void drawLilies(const Atrium& atrium, const Sheet& sheet, const room::Camera& camera);
// The sun's light in the dust: adds to what is there, and hides nothing.
void drawShaft(const Atrium& atrium);

}  // namespace water
