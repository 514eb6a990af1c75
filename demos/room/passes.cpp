#include "passes.h"

#include "transform.h"

namespace room {

void resetPasses(int units) {
  for (int unit = units - 1; unit >= 0; --unit) {
    loadTextureMatrix(unit, glm::dmat4(1.0));
    modulate();
    glDisable(GL_TEXTURE_2D);
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glDisableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_LIGHTING);
  glDisable(GL_STENCIL_TEST);
  setColor(glm::dvec3(1));
}

void useTexture(int unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glEnable(GL_TEXTURE_2D);
  texture.bind();
}

void combine(GLenum mode, GLenum first, GLenum second, float scale) {
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(mode));
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, static_cast<GLint>(first));
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, static_cast<GLint>(second));
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
}

void modulate() {
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

void setColor(const glm::dvec3& rgb, double alpha) {
  const glm::vec4 color(glm::clamp(rgb, 0.0, 1.0), alpha);
  glColor4f(color.r, color.g, color.b, color.a);
}

void useTexCoords(int unit, const Mesh& mesh, bool positions) {
  glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  if (positions) {
    mesh.bindPositionsAsTexCoords();
  } else {
    mesh.bindTexCoords();
  }
}

void loadTextureMatrix(int unit, const glm::dmat4& m) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glMatrixMode(GL_TEXTURE);
  loadMatrix(m);
  glMatrixMode(GL_MODELVIEW);
}

}  // namespace room
