// Caustics: waves gather the sun's light on the bottom of the pool, and spread it between. Not in the paper.
#pragma once

#include <vector>

#include "sheet.h"

namespace water {

class Caustics {
 public:
  // Works out for every vertex of the lattice how much the surface there gathers or spreads.
  void update(const Heights& heights);
  // How much light reaches a place on the bottom, 1 under a flat surface, in [0.5, 2]; x and z from the
  // middle of the pool.
  double at(glm::dvec2 place) const;

 private:
  std::vector<double> light_;
};

}  // namespace water
