// The light of the fire at a point of the room, with soft shadows: what lightmaps are made of.
#pragma once

#include <vector>

#include "room/image.h"

namespace particles {

// What stands in the light. A shape is a little smaller than what it stands for, so that surfaces do not
// shadow themselves.
struct UprightCylinder {
  glm::dvec3 foot;  // metres
  double radius;
  double height;
};

struct Block {
  glm::dvec3 center;  // metres
  glm::dvec3 half;
  double turn = 0;  // radians about y
};

class LightBake {
 public:
  // The room's corners and the foot of the flames.
  LightBake(glm::dvec3 low, glm::dvec3 high, glm::dvec3 fire);
  void add(const UprightCylinder& cylinder) { cylinders_.push_back(cylinder); }
  void add(const Block& block);

  // Half the light (what is brighter than 0.5 is overbright) in [0,1], of the fire at its brightest and of
  // what little there is besides.
  glm::dvec3 halfLight(const glm::dvec3& point, const glm::dvec3& normal) const;
  // A texture over a rectangle; origin, a, b as in room::rectangle.
  room::Image lightmap(int width, int height, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b) const;

 private:
  struct PlacedBlock {
    glm::dvec3 center;
    glm::dvec3 half;
    double cosine;
    double sine;
  };
  bool visible(const glm::dvec3& from, const glm::dvec3& to) const;
  double openness(const glm::dvec3& point, const glm::dvec3& normal) const;

  glm::dvec3 low_;
  glm::dvec3 high_;
  std::vector<glm::dvec3> flames_;  // where the light comes from
  std::vector<UprightCylinder> cylinders_;
  std::vector<PlacedBlock> blocks_;
};

}  // namespace particles
