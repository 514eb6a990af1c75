#include "camera.h"

#include <GLES/gl.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "transform.h"

namespace room {

Camera cameraAt(const View& view, const glm::dvec3& eye, const glm::dvec3& target, double fieldOfView,
                double near, double far) {
  Camera camera;
  camera.eye = orbited(view, eye, target);
  camera.view = glm::lookAt(camera.eye, target, glm::dvec3(0, 1, 0));
  camera.projection =
      glm::perspective(glm::radians(fieldOfView), static_cast<double>(view.width) / view.height, near, far);
  return camera;
}

void useCamera(const Camera& camera) {
  glMatrixMode(GL_PROJECTION);
  loadMatrix(camera.projection);
  glMatrixMode(GL_MODELVIEW);
  loadMatrix(camera.view);
}

void drawBillboard(const Camera& camera, const glm::dvec3& center, double size, double nearer) {
  constexpr std::array<GLfloat, 8> kCorners = {0, 0, 1, 0, 0, 1, 1, 1};
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera.view));
  std::array<glm::vec3, 4> square;
  for (std::size_t i = 0; i < square.size(); ++i) {
    const glm::dvec2 offset = size * glm::dvec2(kCorners[2 * i] - 0.5, kCorners[2 * i + 1] - 0.5);
    square[i] = center + toWorld * glm::dvec3(offset, nearer);
  }
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, kCorners.data());
  glVertexPointer(3, GL_FLOAT, 0, square.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

}  // namespace room
