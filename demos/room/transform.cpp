#include "transform.h"

#include <GLES/gl.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace room {

glm::dmat4 biasMatrix() {
  return glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)), glm::dvec3(0.5));
}

glm::dmat4 planarShadow(glm::dvec4 plane, glm::dvec3 light) {
  const glm::dvec4 l(light, 1.0);
  // dot(plane, l) I - l plane^T; outerProduct(c, r) has c as its columns' direction.
  return glm::dmat4(glm::dot(plane, l)) - glm::outerProduct(l, plane);
}

glm::dmat4 rotationBetween(glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  const double cosine = glm::dot(from, to);
  if (sine > 1e-9) return glm::rotate(glm::dmat4(1.0), std::atan2(sine, cosine), axis / sine);
  if (cosine > 0) return glm::dmat4(1.0);
  const glm::dvec3 other = std::abs(from.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::rotate(glm::dmat4(1.0), std::acos(-1.0), glm::normalize(glm::cross(from, other)));
}

void loadMatrix(const glm::dmat4& m) {
  const glm::mat4 rounded(m);
  glLoadMatrixf(glm::value_ptr(rounded));
}

}  // namespace room
