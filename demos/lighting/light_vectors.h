// Which parts a light reaches, and its direction at every vertex of theirs: what bump mapping is lit by.
#pragma once

#include <vector>

#include "set/scene.h"

namespace lighting {

struct LitPart {
  const Part* part;
  // For each vertex the light vector in tangent space, scaled and biased, and in alpha how much light gets
  // there; only where the part's normal map is in tangent space.
  const std::vector<glm::vec4>* colors;
};

class LightVectors {
 public:
  // The scene outlives it.
  explicit LightVectors(const Scene& scene) : scene_(scene), colors_(scene.parts().size()) {}

  // For one light. inCone: only what its cone reaches. Parts that shine by themselves are not lit.
  void update(const Spotlight& light, bool inCone);
  const std::vector<LitPart>& parts() const { return parts_; }

 private:
  const Scene& scene_;
  std::vector<LitPart> parts_;
  std::vector<std::vector<glm::vec4>> colors_;
};

// The middle of a part in the world.
glm::dvec3 centerOf(const Part& part);
// Loads the part's modelview matrix.
void place(const Part& part, const glm::dmat4& view);

}  // namespace lighting
