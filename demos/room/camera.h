// Where a picture is seen from.
#pragma once

#include <glm/glm.hpp>

#include "demo.h"

namespace room {

struct Camera {
  glm::dvec3 eye{0};  // in the world, metres
  glm::dmat4 view{1.0};
  glm::dmat4 projection{1.0};
};

// Looks from the demo's own eye at the target, as the view turns and moves it (transform.h: orbited).
// fieldOfView: degrees, from below to above.
Camera cameraAt(const View& view, const glm::dvec3& eye, const glm::dvec3& target, double fieldOfView,
                double near, double far);

// Loads both matrices; leaves the matrix mode at GL_MODELVIEW.
void useCamera(const Camera& camera);

// A textured square that faces the camera, in the current color: unit 0's texture, whole. size: metres;
// nearer: metres from the center towards the camera.
void drawBillboard(const Camera& camera, const glm::dvec3& center, double size, double nearer = 0);

}  // namespace room
