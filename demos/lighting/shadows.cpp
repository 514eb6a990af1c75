#include "shadows.h"

#include "lighting.h"
#include "room/passes.h"
#include "room/transform.h"

namespace lighting {
namespace {

// The stencil byte: one bit a light for "already darkened", and the receiver above them.
constexpr GLuint kShadowBits = (1U << kLights) - 1;

}  // namespace

GLuint stencilOf(Receiver receiver) {
  return static_cast<GLuint>(receiver) << kLights;
}

// The stencil lets only pixels of the receiver pass that this light has not darkened yet, so neither depth
// nor overlap matters.
void drawShadows(const Scene& scene, int lightIndex, const glm::dmat4& view, bool alone) {
  const Spotlight& light = scene.lights()[static_cast<std::size_t>(lightIndex)];
  const GLuint bit = 1U << lightIndex;
  beginPass();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(bit);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  if (alone) {
    room::setColor(glm::mix(glm::dvec3(0.30), 1.05 - light.color, 0.45));
  } else {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    room::setColor(glm::dvec3(1), 0.06);
  }
  for (Receiver receiver : kReceivers) {
    const glm::dvec4 plane = planeOf(receiver);
    if (glm::dot(plane, glm::dvec4(light.position, 1.0)) <= 0) continue;
    glStencilFunc(GL_EQUAL, static_cast<GLint>(stencilOf(receiver)), (~0U & ~kShadowBits) | bit);
    const glm::dmat4 flatten = view * room::planarShadow(plane, light.position);
    for (const Part& part : scene.parts()) {
      if ((part.castsFor & bit) == 0) continue;
      room::loadMatrix(flatten * part.model);
      part.outline().bindPositions();
      part.outline().draw();
    }
  }
  glStencilMask(~0U);
}

}  // namespace lighting
