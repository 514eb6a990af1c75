// The light of lamp, candles and moon at a point of the parlour, with soft shadows: what is baked into
// vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace skinning {

// An upright body that light does not pass, a little smaller than what it stands for.
struct Pillar {
  glm::dvec3 foot;  // metres
  double radius;
  double height;
};

struct Flame {
  glm::dvec3 position;  // metres
  glm::dvec3 color;     // light at a metre's distance
  double radius;        // metres: how soft its shadows are
};

class Candlelight {
 public:
  // The room's corners.
  Candlelight(glm::dvec3 low, glm::dvec3 high) : low_(low), high_(high) {}
  void add(const Pillar& pillar) { pillars_.push_back(pillar); }
  void add(const Flame& flame) { flames_.push_back(flame); }

  // Half the light (what is brighter than 0.5 is overbright) in [0,1].
  glm::dvec3 halfLight(const glm::dvec3& point, const glm::dvec3& normal) const;

 private:
  bool visible(const glm::dvec3& from, const glm::dvec3& to) const;
  double openness(const glm::dvec3& point, const glm::dvec3& normal) const;

  glm::dvec3 low_, high_;
  std::vector<Pillar> pillars_;
  std::vector<Flame> flames_;
};

}  // namespace skinning
