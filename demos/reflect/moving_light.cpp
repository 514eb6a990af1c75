#include "moving_light.h"

#include <GLES/gl.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "reflect.h"
#include "room/passes.h"
#include "room/transform.h"

namespace reflect {
namespace {

// Goes around the room, never low.
glm::vec4 lightDirection(double time) {
  const double turn = glm::two_pi<double>() * time / 9.0 + 0.6;
  return {std::cos(turn), 0.85, std::sin(turn), 0};
}

}  // namespace

void beginLit(const room::Camera& camera, double time) {
  room::resetPasses(kUnits);
  room::useCamera(camera);
  constexpr glm::vec4 kDiffuse(1.10F, 1.0F, 0.84F, 1);
  constexpr glm::vec4 kAmbient(0.40F, 0.38F, 0.40F, 1);
  constexpr glm::vec4 kSpecular(0.55F, 0.52F, 0.46F, 1);
  constexpr glm::vec4 kBlack(0, 0, 0, 1);
  glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(lightDirection(time)));
  glLightfv(GL_LIGHT0, GL_DIFFUSE, glm::value_ptr(kDiffuse));
  glLightfv(GL_LIGHT0, GL_SPECULAR, glm::value_ptr(kDiffuse));
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(kAmbient));
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(kSpecular));
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, glm::value_ptr(kBlack));
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
}

void drawThing(const room::Camera& camera, const Thing& thing, Version version) {
  const room::Mesh& mesh = version == Version::Fine ? *thing.mesh : *thing.proxy;
  room::loadMatrix(camera.view * thing.model);
  if (thing.vertexLit) {
    glEnable(GL_LIGHTING);
    glEnableClientState(GL_NORMAL_ARRAY);
    mesh.bindNormals();
  } else {
    glDisable(GL_LIGHTING);
    glDisableClientState(GL_NORMAL_ARRAY);
  }
  room::useTexture(0, *thing.texture);
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, thing.scale);
  room::useTexCoords(0, mesh);
  glEnableClientState(GL_COLOR_ARRAY);
  mesh.bindColors();
  mesh.bindPositions();
  if (thing.shadow) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDepthMask(GL_FALSE);
  }
  mesh.draw();
  if (thing.shadow) {
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
  }
}

}  // namespace reflect
