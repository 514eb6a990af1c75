#include "bounds.h"

#include <algorithm>
#include <array>

namespace room {

Box boundsOf(const MeshData& mesh) {
  Box box;
  for (const Vertex& v : mesh.vertices) {
    box.low = glm::min(box.low, v.position);
    box.high = glm::max(box.high, v.position);
  }
  return box;
}

bool isOutside(const Box& box, const glm::dmat4& clip) {
  std::array<glm::dvec4, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                            i & 4 ? box.high.z : box.low.z);
    corners[static_cast<std::size_t>(i)] = clip * glm::dvec4(corner, 1.0);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (double side : {-1.0, 1.0}) {
      const auto beyond = [&](const glm::dvec4& c) { return side * c[axis] > c.w; };
      if (std::all_of(corners.begin(), corners.end(), beyond)) return true;
    }
  }
  return false;
}

}  // namespace room
