#include "spotlight.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "room/transform.h"

namespace lighting {

glm::dmat4 Spotlight::projection() const {
  return room::biasMatrix() * glm::perspective(2 * halfAngle, 1.0, near, range) *
         glm::lookAt(position, position + direction, up);
}

glm::dmat4 Spotlight::nearPlane() const {
  const double scale = 1.0 / (range - near);
  glm::dmat4 m(0.0);
  for (int i = 0; i < 3; ++i) m[i][0] = direction[i] * scale;
  m[3][0] = -(glm::dot(direction, position) + near) * scale;
  m[3][1] = 0.5;
  m[3][3] = 1.0;
  return m;
}

bool Spotlight::reaches(glm::dvec3 center, double radius) const {
  const glm::dvec3 offset = center - position;
  const double along = glm::dot(offset, direction);
  const double aside = glm::length(offset - along * direction);
  // Distance to the cone's side; in front of the apex region this is exact, elsewhere it errs towards true.
  const double outside = aside * std::cos(halfAngle) - along * std::sin(halfAngle);
  return along + radius > near && along - radius < range && outside < radius;
}

double Spotlight::attenuation(double distance) const {
  const double d = distance / reach;
  return 1.0 / (1.0 + d * d);
}

}  // namespace lighting
