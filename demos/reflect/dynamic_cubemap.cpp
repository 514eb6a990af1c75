#include "dynamic_cubemap.h"

#include <GLES/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "moving_light.h"
#include "reflect.h"
#include "room/passes.h"
#include "room/transform.h"

namespace reflect {
namespace {

constexpr int kCubeSize = 256;
constexpr float kMirror = 0.82F;  // the reflection's share in the ball's color

}  // namespace

DynamicCubemap::DynamicCubemap(const room::FramebufferFunctions& gl)
    : mapping_("reflect"), surroundings_(gl, kCubeSize), ball_(room::sphere(kBallRadius, 160, 100)) {}

void DynamicCubemap::render(const Playroom& playroom, double time) {
  for (int face = 0; face < 6; ++face) {
    surroundings_.bind(face);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    culled_[static_cast<std::size_t>(face)] = drawFace(playroom, face, time);
  }
  surroundings_.unbind();
}

int drawFace(const Playroom& playroom, int face, double time, bool upright) {
  room::Camera camera{kBallCenter, room::cubeFaceCamera(face, kBallCenter),
                      room::cubeFaceProjection(0.25, 15.0)};
  if (upright) camera.projection = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, -1, 1)) * camera.projection;
  beginLit(camera, time);
  int culled = 0;
  for (const Thing& thing : playroom.things()) {
    if (room::isOutside(thing.bounds, camera.projection * camera.view * thing.model)) {
      ++culled;
    } else {
      drawThing(camera, thing, Version::Proxy);
    }
  }
  return culled;
}

// One pass: lit as the train is, and over it, by a constant share, the cube map.
void DynamicCubemap::drawBall(const room::Camera& camera, bool reflection) const {
  room::resetPasses(kUnits);
  room::loadMatrix(glm::translate(camera.view, kBallCenter));
  glEnable(GL_LIGHTING);
  glEnableClientState(GL_NORMAL_ARRAY);
  room::setColor({0.80, 0.72, 0.62});
  if (reflection) {
    mapping_.enable(0, surroundings_, camera.view);
    room::combine(GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
    const glm::vec4 share(kMirror);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(share));
  }
  ball_.bindPositions();
  ball_.bindNormals();
  ball_.draw();
  if (reflection) mapping_.disable(0);
}

}  // namespace reflect
