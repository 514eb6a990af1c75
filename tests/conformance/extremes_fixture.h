// What cases of bad and extreme input share: a witness that is drawn afterwards.
#pragma once

#include "harness.h"

namespace conformance {

class ExtremesFixture : public GlTest {
 protected:
  // Draws a witness afterwards in the same context and expects it whole.
  void expectUnharmed(const std::string& what) const {
    while (glGetError() != GL_NO_ERROR) {
    }
    glDisable(GL_LIGHTING);
    glDisable(GL_FOG);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_CLIP_PLANE0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    for (GLenum array : {GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_POINT_SIZE_ARRAY_OES}) {
      glDisableClientState(static_cast<GLenum>(array));
    }
    for (GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) {
      glMatrixMode(static_cast<GLenum>(mode));
      glLoadIdentity();
    }
    glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
    drawRect({-1, -1, -0.5, -0.5});
    EXPECT_PIXEL(8, 8, {0.2, 0.4, 0.6, 0.8}) << what;
  }
};

}  // namespace conformance
