// Draws the parlour.
#pragma once

#include "parlour.h"
#include "room/camera.h"

namespace skinning {

// Color = base * light in the vertices, then * 2 * flicker; marks in the stencil what takes the hand's shadows.
void drawParlour(const Parlour& parlour, double flicker);

// The air around the candles' flames.
class Halos {
 public:
  Halos();
  void draw(const Parlour& parlour, const room::Camera& camera, double flicker) const;

 private:
  room::Texture halo_;
};

}  // namespace skinning
