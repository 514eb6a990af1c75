// Procedural materials. Each is a function of texture coordinates in [0,1) that repeats seamlessly.
#pragma once

#include "room/image.h"

namespace room {

// Metres that one repeat covers.
inline constexpr double kBrickExtent = 1.92;
inline constexpr double kTileExtent = 1.6;
inline constexpr double kPlasterExtent = 2.4;
inline constexpr double kWoodExtent = 1.0;
inline constexpr double kMetalExtent = 0.5;
inline constexpr double kPaperExtent = 0.25;

Texel brick(double u, double v);
Texel checkerTiles(double u, double v);
Texel plaster(double u, double v);
Texel wood(double u, double v);
// Wood under worn paint of the given color.
Texel paintedWood(double u, double v, glm::dvec3 paint);
// Enamelled or bare metal with scratches and some rust.
Texel paintedMetal(double u, double v, glm::dvec3 paint);
// Zinc with its crystals, for one repeat of the given number of crystals across and up.
Texel zinc(double u, double v, int crystalsX, int crystalsY);
Texel paper(double u, double v);
// A picture of two searchlights over a town; fills [0,1]^2 once.
Texel poster(double u, double v);

}  // namespace room
