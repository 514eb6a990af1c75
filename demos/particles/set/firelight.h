// The light of the fire, and of what little there is besides, in the cellar.
#pragma once

#include "room/set/light_bake.h"

namespace particles {

// fire: the foot of the flames, which the light is that of when they are brightest. low, high: the room's
// corners.
room::LightBake firelightBake(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& fire);

}  // namespace particles
