// A GL front end and a renderer that draw nothing: EGL by itself, with counters and failures on demand.
#pragma once

#include "layer/gl/front_end.h"

namespace anteroom::fake {

struct World {
  bool noDevice = false;
  bool noMemory = false;  // for contexts and images
  bool fencesPass = true;
  int devices = 0, contexts = 0, images = 0;  // alive
  int flushes = 0, finishes = 0;
  render::Caps caps;
};
World& world();

// What the fake context that is current in this thread has as framebuffer; null images: none.
const render::Framebuffer& currentFramebuffer();
const render::Framebuffer& currentReadFramebuffer();
// Deletes the texture that eglBindTexImage filled.
void deleteTexture();

}  // namespace anteroom::fake
