// Boxes around things, and whether a camera can see them.
#pragma once

#include <glm/glm.hpp>

#include "mesh.h"

namespace room {

struct Box {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};
};

Box boundsOf(const MeshData& mesh);

// Whether all of the box is on the outer side of one of the planes of clip volume, section 2.11; `clip` is
// projection * modelview. A box that is not may still be out of sight.
bool isOutside(const Box& box, const glm::dmat4& clip);

}  // namespace room
