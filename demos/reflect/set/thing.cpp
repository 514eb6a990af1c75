#include "thing.h"

#include <algorithm>
#include <cmath>

namespace reflect {

void Painted::add(const room::MeshData& piece, const glm::dvec3& color, const glm::dmat4& where) {
  mesh.append(piece, where);
  paint.resize(mesh.vertices.size(), color);
}

int Detail::cells(int fine, int least) const {
  return std::max(least, static_cast<int>(std::lround(fine * share)));
}

std::vector<glm::vec3> litColors(const Painted& painted, const room::LightBake& light) {
  std::vector<glm::vec3> colors = light.vertexLight(painted.mesh);
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] *= glm::vec3(painted.paint[i]);
  return colors;
}

std::vector<glm::vec3> plainColors(const Painted& painted) {
  return {painted.paint.begin(), painted.paint.end()};
}

}  // namespace reflect
