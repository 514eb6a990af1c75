// A GL front end that does nothing, on a renderer that draws nothing: EGL by itself, with counters and
// failures on demand.
#pragma once

#include "layer/gl/front_end.h"
#include "tests/fake_renderer/fake_renderer.h"

namespace anteroom::fake {

struct World {
  bool noDevice = false;
  int devices = 0, contexts = 0;  // alive
  test::FakeLog log;              // of all devices
  render::Caps caps;
};
World& world();

// What the fake context that is current in this thread has as framebuffer; null images: none.
const render::Framebuffer& currentFramebuffer();
const render::Framebuffer& currentReadFramebuffer();
// Deletes the texture that eglBindTexImage filled.
void deleteTexture();

}  // namespace anteroom::fake
