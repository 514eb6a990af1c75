#include "sheet.h"

#include <algorithm>
#include <cmath>

#include "caustics.h"
#include "reflection.h"
#include "refraction.h"
#include "set/measures.h"

namespace water {

using glm::dvec2;
using glm::dvec3;

dvec2 latticePoint(int column, int row) {
  return (dvec2(column, row) / double{kLattice - 1} * 2.0 - 1.0) * kPoolHalf;
}

LatticePlace latticePlace(dvec2 place) {
  const dvec2 at =
      glm::clamp((place / kPoolHalf + 1.0) * (0.5 * (kLattice - 1)), dvec2(0), dvec2(kLattice - 1.001));
  const dvec2 low = glm::floor(at);
  return {latticeIndex(static_cast<int>(low.x), static_cast<int>(low.y)), at - low};
}

Sheet::Sheet() : vertices_(latticeIndex(0, kLattice)) {
  for (int row = 0; row + 1 < kLattice; ++row) {
    for (int column = 0; column + 1 < kLattice; ++column) {
      const std::size_t a = latticeIndex(column, row);
      const std::size_t b = a + kLattice;
      for (std::size_t index : {a, b, b + 1, a, b + 1, a + 1})
        indices_.push_back(static_cast<std::uint16_t>(index));
    }
  }
}

void Sheet::update(const Heights& heights, const Caustics& caustics, const dvec3& eye) {
  const dvec2 cell = 2.0 * kPoolHalf / double{kLattice - 1};
  for (int row = 0; row < kLattice; ++row) {
    const int below = std::max(row - 1, 0);
    const int above = std::min(row + 1, kLattice - 1);
    for (int column = 0; column < kLattice; ++column) {
      const int left = std::max(column - 1, 0);
      const int right = std::min(column + 1, kLattice - 1);
      const double slopeX =
          (heights[latticeIndex(right, row)] - heights[latticeIndex(left, row)]) / (cell.x * (right - left));
      const double slopeZ = (heights[latticeIndex(column, above)] - heights[latticeIndex(column, below)]) /
                            (cell.y * (above - below));
      const dvec3 normal = glm::normalize(dvec3(-slopeX, 1, -slopeZ));
      const dvec2 place = latticePoint(column, row);
      const dvec3 local(place.x, kWaterLevel + heights[latticeIndex(column, row)], place.y);
      const dvec3 position = local + dvec3(kPoolCenter.x, 0, kPoolCenter.y);
      const dvec3 view = glm::normalize(position - eye);
      const Refracted bent = refracted(local, normal, view);
      Vertex& v = vertices_[latticeIndex(column, row)];
      v.position = position;
      v.normal = normal;
      v.uv = bent.texCoord;
      v.color =
          glm::vec4(bent.left * (0.5 * caustics.at(bent.place)), reflectedShare(-glm::dot(view, normal)));
    }
  }
}

Sheet::Point Sheet::at(dvec2 place) const {
  const double level =
      onLattice(place, [this](std::size_t i) { return static_cast<double>(vertices_[i].position.y); });
  const dvec3 normal = onLattice(place, [this](std::size_t i) { return dvec3(vertices_[i].normal); });
  return {level - kWaterLevel, glm::normalize(normal)};
}

void Sheet::bindPositions() const {
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), &vertices_.front().position);
}

void Sheet::bindNormals() const {
  glNormalPointer(GL_FLOAT, sizeof(Vertex), &vertices_.front().normal);
}

void Sheet::bindColors() const {
  glColorPointer(4, GL_FLOAT, sizeof(Vertex), &vertices_.front().color);
}

void Sheet::bindTexCoords() const {
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertices_.front().uv);
}

void Sheet::draw() const {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_SHORT, indices_.data());
}

}  // namespace water
