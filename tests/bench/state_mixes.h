#pragma once

#include <vector>

#include "pixels.h"

namespace bench {

// A combination of state that no other mix shares, and the colour that a quad facing the viewer gets from it.
struct StateMix {
  const char* name;
  void (*apply)();
  Rgb wanted;
};

// In the order of drawing. Every mix starts from resetMixState().
const std::vector<StateMix>& stateMixes();

// Makes what the mixes draw: arrays of a quad at eye z = -1 with normal (0, 0, 1), and three textures. The
// current context keeps them.
void beginMixes();
// Back to the initial state of a context, but for the projection, the arrays and the textures.
void resetMixState();
void drawMixQuad();

}  // namespace bench
