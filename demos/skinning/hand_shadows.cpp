#include "hand_shadows.h"

#include <array>

#include "room/passes.h"
#include "room/transform.h"
#include "set/parlour.h"
#include "skinning.h"

namespace skinning {
namespace {

// The lamp's flame as a few places that throw a shadow each.
constexpr std::array<glm::dvec3, 4> kFlames = {
    glm::dvec3(-0.022, 0.004, 0.0), glm::dvec3(0.018, 0.020, 0.010), glm::dvec3(0.004, -0.022, -0.012),
    glm::dvec3(0.002, 0.002, 0.024)};

// Where `receiver` is marked in the stencil and `mark` is not yet; marks it.
void drawShadow(const Skin& skin, const glm::dmat4& view, glm::dvec4 plane, GLuint receiver,
                const glm::dvec3& light, GLuint mark) {
  glStencilFunc(GL_EQUAL, static_cast<GLint>(receiver), receiver | mark);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  glStencilMask(mark);
  skin.look(view * room::planarShadow(plane, light));
  skin.draw();
}

}  // namespace

void drawShadows(const Skin& skin, const glm::dmat4& view) {
  glEnable(GL_STENCIL_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  // Each takes its share of the lamp's light.
  room::setColor(glm::dvec3(0.80, 0.815, 0.84));
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2, -4);
  GLuint mark = 1;
  skin.begin(view);
  for (const glm::dvec3& flame : kFlames) {
    drawShadow(skin, view, {0, 1, 0, -kTableTop - 0.001}, kTableBit, kLamp + flame, mark);
    drawShadow(skin, view, {0, 0, 1, -kRoomMin.z - 0.002}, kWallBit, kLamp + flame, mark);
    mark <<= 1;
  }
  skin.end();
  room::loadMatrix(view);
  glStencilMask(~0U);
  glDisable(GL_POLYGON_OFFSET_FILL);
  room::resetPasses(kUnits);
}

}  // namespace skinning
