// Matrices that the demos share, in float64; they are rounded once, when GL gets them.
#pragma once

#include <glm/glm.hpp>

#include "demo.h"

namespace room {

// [-1,1] to [0,1] in x, y and z.
glm::dmat4 biasMatrix();

// Flattens what lies between a point light and a plane (unit normal, dot(normal, p) + offset = 0) onto that
// plane. A result with w <= 0 comes from a point at or behind the light and must be clipped away.
glm::dmat4 planarShadow(glm::dvec4 plane, glm::dvec3 light);

// The rotation that takes the unit vector `forward` to +Z and `up`, as far as it is perpendicular, to +Y.
glm::dmat4 rotationToAxes(glm::dvec3 forward, glm::dvec3 up);

// The demo's own eye, as the view turns it about the target's upright axis and moves it to or from the
// target.
glm::dvec3 orbited(const View& view, const glm::dvec3& eye, const glm::dvec3& target);

// Loads onto the current matrix stack.
void loadMatrix(const glm::dmat4& m);

}  // namespace room
