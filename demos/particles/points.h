// Point sprites that shrink with distance, section 6.2 of the paper: sizes come from an array and are
// attenuated by glPointParameter.
#pragma once

#include <GLES/gl.h>

#include <array>
#include <glm/glm.hpp>

#include "fire.h"
#include "room/demo.h"

namespace particles {

// size' = size / sqrt(a + b d + c d^2), section 3.3 of the specification.
struct Attenuation {
  double a;
  double b;
  double c;
  double at(double distance) const;
};
// Of points that are meant for a VGA screen.
Attenuation attenuationFor(const room::View& view);

// The attenuation makes points smaller where the screen is larger. The sizes in the array make up for that,
// so that the fire, where it stands, covers the same part of any screen.
double sizeScaleFor(const room::View& view, double distance);

class Points {
 public:
  // Draws into the corner of the surface. Throws std::runtime_error without point sprites or point size
  // arrays.
  Points();
  // May change the sizes.
  void draw(ParticleArrays& particles, const Attenuation& attenuation, const glm::dmat4& view) const;

 private:
  std::array<GLfloat, 2> sizeRange_{1, 1};  // pixels
  bool attenuatesArray_ = true;             // some implementations attenuate only the current size
};

// The sizes of points that the implementation has, pixels.
std::array<GLfloat, 2> pointSizeRange();

}  // namespace particles
