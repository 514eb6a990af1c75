#include "transform.h"

#include <GLES/gl.h>

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

glm::dmat4 rotationToAxes(glm::dvec3 forward, glm::dvec3 up) {
  glm::dvec3 side = glm::cross(up, forward);
  if (glm::length(side) < 1e-9) side = glm::cross(glm::dvec3(forward.y, forward.z, forward.x), forward);
  side = glm::normalize(side);
  return glm::dmat4(glm::transpose(glm::dmat3(side, glm::cross(forward, side), forward)));
}

glm::dvec3 orbited(const View& view, const glm::dvec3& eye, const glm::dvec3& target) {
  if (view.yaw == 0 && view.zoom == 1) return eye;  // to the last bit
  const glm::dvec4 offset(eye - target, 0.0);
  return target +
         view.zoom * glm::dvec3(glm::rotate(glm::dmat4(1.0), view.yaw, glm::dvec3(0, 1, 0)) * offset);
}

void loadMatrix(const glm::dmat4& m) {
  const glm::mat4 rounded(m);
  glLoadMatrixf(glm::value_ptr(rounded));
}

}  // namespace room
