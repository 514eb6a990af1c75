// A projective spotlight: where it stands, what it projects, and the matrices that the passes need.
#pragma once

#include <glm/glm.hpp>

namespace lighting {

struct Spotlight {
  glm::dvec3 position{0};          // world, metres
  glm::dvec3 direction{0, -1, 0};  // unit
  glm::dvec3 up{0, 0, 1};          // turns the projected picture
  glm::dvec3 color{1};             // in [0, 2]
  double beam = 0;                 // how much of the light's cone the dust in the air shows
  double halfAngle = 0.5;          // radians, to the edge of the falloff texture
  double near = 0.1;               // metres along the direction: nothing nearer is lit
  double range = 9.0;              // metres along the direction: nothing farther is lit
  double reach = 2.5;              // metres at which attenuation halves the light

  // World to falloff texture: Bias * LP * LV; s/q and t/q in [0,1] inside the cone. Behind the light q < 0,
  // where the picture would appear again, upside down.
  glm::dmat4 projection() const;
  // World to the 256x1 texture that removes what is behind: s = 0 on the near plane, 1 at the range.
  glm::dmat4 nearPlane() const;
  // Whether any of a sphere can be inside the cone.
  bool reaches(glm::dvec3 center, double radius) const;
  // In [0,1].
  double attenuation(double distance) const;
};

}  // namespace lighting
