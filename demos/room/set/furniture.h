// Furniture that stands in more than one room. Lengths in metres.
#pragma once

#include "room/mesh.h"

namespace room {

// Moved to a position after a turn (radians) about the y axis.
glm::dmat4 placed(const glm::dvec3& position, double turn = 0);
// A board about the origin whose texture differs from its neighbours' by their numbers.
MeshData board(const glm::dvec3& size, int number);
// A cube of planks and frames about the origin.
MeshData crate(double side);

}  // namespace room
