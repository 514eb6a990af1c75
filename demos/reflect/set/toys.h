// Toys and furniture, each standing on the origin.
#pragma once

#include "thing.h"

namespace reflect {

Painted bear(const Detail& detail);
Painted ringTower(const Detail& detail);
Painted drum(const Detail& detail);
Painted spinningTop(const Detail& detail);
Painted blockTower(const Detail& detail);
Painted scatteredBlocks(const Detail& detail);
Painted beachBall(const Detail& detail);
Painted rocket(const Detail& detail);
Painted shelf(const Detail& detail);  // 1.3 m wide along x, its front to +z
Painted books(const Detail& detail);  // those in the shelf
Painted chest(const Detail& detail);  // 0.9 m wide along x
Painted floorLamp(const Detail& detail);
Painted lampShade(const Detail& detail);
Painted ballStand(const Detail& detail);

}  // namespace reflect
