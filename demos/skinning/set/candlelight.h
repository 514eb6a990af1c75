// The light of lamp, candles and moon in the parlour.
#pragma once

#include "room/set/light_bake.h"

namespace skinning {

struct Flame {
  glm::dvec3 position;  // metres
  glm::dvec3 color;     // light at a metre's distance
  double radius;        // metres: how soft its shadows are
};

// Without any flame yet. low, high: the room's corners.
room::LightBake candlelightBake(const glm::dvec3& low, const glm::dvec3& high);
// The flame, and what the walls throw back of it.
room::Source lightOf(const Flame& flame);

}  // namespace skinning
