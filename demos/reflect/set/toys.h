// Toys and furniture, each standing on the origin.
#pragma once

#include <array>

#include "thing.h"

namespace reflect {

Painted bear(const Detail& detail);
Painted ringTower(const Detail& detail);
Painted drum(const Detail& detail);
Painted spinningTop(const Detail& detail);
Painted blockTower(const Detail& detail);
// Their middles; each is turned by its number.
inline constexpr std::array<glm::dvec3, 5> kScatteredBlocks = {
    {{0, 0.06, 0}, {0.26, 0.06, 0.10}, {-0.22, 0.06, 0.20}, {0.10, 0.06, 0.32}, {0.02, 0.18, 0.01}}};
inline constexpr double scatteredTurn(std::size_t number) {
  return 1.3 * static_cast<double>(number) + 0.2;
}
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
