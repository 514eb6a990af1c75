#include "draw_parlour.h"

#include <GLES/gl.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "room/passes.h"
#include "skinning/hand_shadows.h"
#include "skinning/skinning.h"

namespace skinning {
namespace {

room::Image haloImage() {
  return room::generate(64, 64, 3, [](double u, double v, float* out) {
    const double r = std::min(std::hypot(2 * u - 1, 2 * v - 1), 1.0);
    const double glow = (1 - r) * (1 - r) * (0.25 + 0.75 * std::exp(-9 * r * r));
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(glow);
  });
}

}  // namespace

void drawParlour(const Parlour& parlour, double flicker) {
  glEnableClientState(GL_COLOR_ARRAY);
  // Unit 1 samples nothing that is used: a unit works only with a texture.
  const glm::vec4 strength(glm::vec3(static_cast<float>(glm::min(flicker, 1.0))), 1);
  for (const Part& part : parlour.parts()) {
    room::useTexture(0, *part.base);
    room::modulate();
    room::useTexCoords(0, *part.mesh);
    room::useTexture(1, *part.base);
    room::combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, part.surface == Surface::Glowing ? 1 : 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(strength));
    const GLuint mark = part.surface == Surface::Table  ? kTableBit
                        : part.surface == Surface::Wall ? kWallBit
                                                        : 0;
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(mark), ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    part.mesh->bindPositions();
    part.mesh->bindColors();
    part.mesh->draw();
  }
  room::resetPasses(kUnits);
}

Halos::Halos() : halo_(room::makeTexture(haloImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE)) {}

void Halos::draw(const Parlour& parlour, const room::Camera& camera, double flicker) const {
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  room::useTexture(0, halo_);
  room::setColor(glm::dvec3(0.62, 0.36, 0.13) * flicker);
  for (const glm::dvec3& candle : parlour.candles())
    room::drawBillboard(camera, candle, 0.34 * flicker, 0.03);
  room::resetPasses(kUnits);
}

}  // namespace skinning
