// Bump mapping by DOT3, section 2.1 of the paper: normal maps in tangent space, lit by a light vector a
// vertex, and in the object's space, lit by one for all of it.
#pragma once

#include "light_vectors.h"

namespace lighting {

// color += N.L * base * light color * destination alpha. gain: times the light.
void drawBump(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view, double gain);

}  // namespace lighting
