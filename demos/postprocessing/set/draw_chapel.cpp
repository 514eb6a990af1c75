#include "draw_chapel.h"

#include <GLES/gl.h>

#include "postprocessing/postprocessing.h"
#include "room/passes.h"
#include "room/transform.h"

namespace postprocessing {
namespace {

bool shines(const Part& part) {
  return part.surface == Surface::Glass || part.surface == Surface::Flame || part.surface == Surface::Dust;
}

void place(const Part& part, const room::Camera& camera, const glm::dmat4& lamp) {
  room::loadMatrix(part.swings ? camera.view * lamp : camera.view);
}

// Unit 0 adds the sun's light to that of the vertices, unit 1 brings the stone.
void useFloor(const Chapel& chapel, const Part& part) {
  room::useTexture(0, chapel.sunOnFloor());
  room::combine(GL_ADD, GL_TEXTURE, GL_PREVIOUS);
  room::useTexCoords(0, *part.mesh, true);
  room::loadTextureMatrix(0, Chapel::floorProjection());
  room::useTexture(1, *part.texture);
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
  room::useTexCoords(1, *part.mesh);
}

}  // namespace

void drawScene(const Chapel& chapel, const room::Camera& camera, const glm::dmat4& lamp) {
  const auto reset = [] {
    room::resetPasses(kUnits);
    glEnableClientState(GL_COLOR_ARRAY);
  };
  reset();
  room::useCamera(camera);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Part& part : chapel.parts()) {
    place(part, camera, lamp);
    if (part.texture == nullptr) reset();
    if (part.surface == Surface::Floor) {
      useFloor(chapel, part);
    } else if (part.texture != nullptr) {
      room::useTexture(0, *part.texture);
      room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, shines(part) ? 1 : kLightScale);
      room::useTexCoords(0, *part.mesh);
    }
    // From here on what is drawn is added to what lies behind it: the dust comes last.
    if (part.surface == Surface::Dust) {
      glEnable(GL_BLEND);
      glBlendFunc(GL_ONE, GL_ONE);
      glDepthMask(GL_FALSE);
    }
    part.mesh->bindPositions();
    part.mesh->bindColors();
    part.mesh->draw();
    if (part.surface == Surface::Floor) reset();
  }
  room::resetPasses(kUnits);
}

void drawMask(const Chapel& chapel, const room::Camera& camera, const glm::dmat4& lamp) {
  room::resetPasses(kUnits);
  room::useCamera(camera);
  for (const Part& part : chapel.parts()) {
    if (part.surface == Surface::Dust) continue;
    room::setColor(glm::dvec3(shines(part) ? 1 : 0));
    place(part, camera, lamp);
    part.mesh->bindPositions();
    part.mesh->draw();
  }
}

}  // namespace postprocessing
