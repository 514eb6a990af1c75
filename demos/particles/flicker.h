// The light of the fire, which flickers, section 6.3 of the paper: lightmaps and baked light times smooth
// noise out of a table.
#pragma once

#include "room/image.h"
#include "set/cellar.h"

namespace particles {

// Smooth noise in [-1,1] looked up in a small image: its rows are independent and repeat after kCells.
class NoiseTable {
 public:
  static constexpr int kRows = 8;
  static constexpr int kCells = 64;
  NoiseTable();
  // x in cells, any finite number.
  double at(double x, int row) const;

 private:
  room::Image image_;
};

// What the room sees of the fire.
struct Flicker {
  double strength;  // [0,1]
  glm::dvec3 lean;  // where the flames lean to, at most about 1

  // Light with the color that it has at a strength: a dim fire is redder.
  static glm::dvec3 lightOf(double strength);
};

// Color = base * flicker, then * 2 * lightmap.
void drawWalls(const Cellar& cellar, const Flicker& flicker);
// Color = base * light in the vertices, then * 2 * flicker.
void drawFurniture(const Cellar& cellar, const Flicker& flicker);

}  // namespace particles
