// The ball's surroundings, section 5.1 of the paper: six faces of a cube map, drawn every frame from the
// middle of the ball, of things with fewer polygons, and only of those whose bounding boxes reach into a
// face's view.
#pragma once

#include <array>

#include "room/camera.h"
#include "room/framebuffer.h"
#include "room/reflection.h"
#include "set/playroom.h"

namespace reflect {

class DynamicCubemap {
 public:
  // The functions outlive it. Throws room::MissingExtension without cube maps.
  explicit DynamicCubemap(const room::FramebufferFunctions& gl);

  void render(const Playroom& playroom, double time);
  // How many things each face has left out the last time.
  const std::array<int, 6>& culled() const { return culled_; }
  // The ball with these surroundings, or without; needs beginLit().
  void drawBall(const room::Camera& camera, bool reflection) const;

 private:
  room::ReflectionMapping mapping_;
  room::CubeTarget surroundings_;
  room::Mesh ball_;
  std::array<int, 6> culled_{};
};

// Draws what a face sees, 0 to 5 for +X -X +Y -Y +Z -Z, into the viewport; upright: as one sees it who stands
// there, half a turn from how it is stored. Returns how many things it has left out.
int drawFace(const Playroom& playroom, int face, double time, bool upright = false);

}  // namespace reflect
