#include "caustics.h"

#include <algorithm>

#include "set/measures.h"

namespace water {
namespace {

// Metres by which a slope of 1 moves a ray of light on its way to the bottom: more than in nature, for so
// calm a pool.
constexpr double kReach = 0.55;

// Of the lattice's heights, over its cells.
struct Curvature {
  double xx, zz, xz;
};
Curvature curvatureAt(const Heights& heights, int column, int row, glm::dvec2 cell) {
  const auto height = [&](int dx, int dz) {
    return heights[latticeIndex(std::clamp(column + dx, 0, kLattice - 1),
                                std::clamp(row + dz, 0, kLattice - 1))];
  };
  const double here = 2 * height(0, 0);
  return {(height(1, 0) + height(-1, 0) - here) / (cell.x * cell.x),
          (height(0, 1) + height(0, -1) - here) / (cell.y * cell.y),
          (height(1, 1) - height(1, -1) - height(-1, 1) + height(-1, -1)) / (4 * cell.x * cell.y)};
}

}  // namespace

// A beam of light of area 1 covers on the bottom the determinant of how rays move: its light is over that.
void Caustics::update(const Heights& heights) {
  const glm::dvec2 cell = 2.0 * kPoolHalf / double{kLattice - 1};
  light_.resize(heights.size());
  for (int row = 0; row < kLattice; ++row) {
    for (int column = 0; column < kLattice; ++column) {
      const Curvature c = curvatureAt(heights, column, row, cell);
      const double area = (1 + kReach * c.xx) * (1 + kReach * c.zz) - kReach * kReach * c.xz * c.xz;
      light_[latticeIndex(column, row)] = 1 / std::clamp(area, 0.5, 2.0);
    }
  }
}

double Caustics::at(glm::dvec2 place) const {
  return onLattice(place, [this](std::size_t vertex) { return light_[vertex]; });
}

}  // namespace water
