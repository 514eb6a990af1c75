// What the playroom is made of. Functions of texture coordinates in [0,1).
#pragma once

#include "room/image.h"

namespace reflect {

inline constexpr double kPaperWidth = 0.8;  // metres that one repeat of the wallpaper covers

// Painted panelling below, paper with stars above.
room::Texel wallpaperTexel(double u, double v);
room::Texel boardsTexel(double u, double v);
// u around, v from the middle outwards.
room::Texel rugTexel(double u, double v);
// Dusk over roofs, with a moon.
room::Texel duskTexel(double u, double v);
// White, with the brush's strokes; things bring their color in their vertices.
room::Texel paintTexel(double u, double v);
// What is left of the light under a vehicle, from end to end and from side to side.
room::Texel vehicleShadowTexel(double u, double v);

}  // namespace reflect
