// Puddles that mirror what stands about them, section 3.3 of the paper: the room seen by a camera that is
// flipped about the floor, drawn into a texture and projected back onto the floor.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "room/camera.h"
#include "room/framebuffer.h"
#include "set/atrium.h"

namespace water {

class Puddles {
 public:
  // The functions outlive it.
  explicit Puddles(const room::FramebufferFunctions& gl);

  // drawRoom: all that is over the floor, as a camera sees it; what is inside the floor needs no clip plane,
  // for it is not drawn.
  void render(const room::Camera& camera, const std::function<void(const room::Camera&)>& drawRoom);
  // Unit 2 mixes the mirror's picture in: the base map's alpha, which says where water stands, times the
  // alpha of the vertices is how much of it.
  void begin(const room::Camera& camera) const;
  // Gives a piece of the floor its vertices' alpha, for the eye of the camera.
  void wet(const Surface& floor, const glm::dvec3& eye);

 private:
  room::RenderTarget mirror_;
  std::vector<glm::vec4> colors_;  // of the vertices
};

}  // namespace water
