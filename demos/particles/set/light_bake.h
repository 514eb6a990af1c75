// The light of the fire at a point of the room, with soft shadows: what lightmaps are made of.
#pragma once

#include <vector>

#include "room/image.h"
#include "room/set/obstacles.h"

namespace particles {

class LightBake {
 public:
  // The room's corners and the foot of the flames.
  LightBake(glm::dvec3 low, glm::dvec3 high, glm::dvec3 fire);
  void add(const room::UprightCylinder& cylinder) { obstacles_.add(cylinder); }
  void add(const room::Block& block) { obstacles_.add(block); }

  // Half the light (what is brighter than 0.5 is overbright) in [0,1], of the fire at its brightest and of
  // what little there is besides.
  glm::dvec3 halfLight(const glm::dvec3& point, const glm::dvec3& normal) const;
  // A texture over a rectangle; origin, a, b as in room::rectangle.
  room::Image lightmap(int width, int height, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b) const;

 private:
  double openness(const glm::dvec3& point, const glm::dvec3& normal) const;

  glm::dvec3 low_;
  glm::dvec3 high_;
  std::vector<glm::dvec3> flames_;  // where the light comes from
  room::Obstacles obstacles_;
};

}  // namespace particles
