// The room in the pool's surface, section 3.2 of the paper: a cube map that is drawn once, and reflection
// mapping whose texture matrix turns eye coordinates back to the world's.
#pragma once

#include <functional>

#include "room/camera.h"
#include "room/framebuffer.h"
#include "room/reflection.h"

namespace water {

class Reflection {
 public:
  // The functions outlive it. Throws room::MissingExtension without cube maps.
  explicit Reflection(const room::FramebufferFunctions& gl);

  // Draws the six faces. draw: the room, as a camera sees it.
  void render(const std::function<void(const room::Camera&)>& draw);
  // Unit 1: the surroundings, alone or over what unit 0 has, by the share in the vertices' alpha.
  void begin(const glm::dmat4& view, bool overRefraction) const;
  void end() const;

 private:
  room::ReflectionMapping mapping_;
  room::CubeTarget surroundings_;
};

// The share of light that is reflected, by the cosine of the angle to the normal.
double reflectedShare(double cosine);

}  // namespace water
