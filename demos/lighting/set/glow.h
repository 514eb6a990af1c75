// The air about the lamps, as far as its dust shows.
#pragma once

#include "room/camera.h"
#include "scene.h"

namespace lighting {

class Glow {
 public:
  Glow();
  // Added to what is there.
  void draw(const Scene& scene, const room::Camera& camera) const;

 private:
  room::Texture disc_;
};

}  // namespace lighting
