// Section 3.8: the three fog equations against float64.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness.h"

namespace conformance {
namespace {

class Fog : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnable(GL_FOG);
    glMatrixMode(GL_PROJECTION);
    // Everything is in view whatever its eye z.
    glScalef(1, 1, 0);
    glMatrixMode(GL_MODELVIEW);
  }
};

constexpr Vec4 kFogColor = {0.9, 0.2, 0.4, 0.7}, kColor = {0.1, 0.8, 0.5, 0.6};

struct Row {
  GLenum mode;
  double density, start, end, distance;
};

double factor(const Row& row) {
  const double c = row.distance, d = row.density;
  const double f = row.mode == GL_EXP    ? std::exp(-d * c)
                   : row.mode == GL_EXP2 ? std::exp(-(d * c) * (d * c))
                                         : (row.end - c) / (row.end - row.start);
  return std::clamp(f, 0.0, 1.0);
}

Vec4 fogged(const Row& row) {
  const double f = factor(row);
  // 3.8: alpha is not changed.
  return {f * kColor[0] + (1 - f) * kFogColor[0], f * kColor[1] + (1 - f) * kFogColor[1],
          f * kColor[2] + (1 - f) * kFogColor[2], kColor[3]};
}

void setFog(const Row& row) {
  const GLfloat color[] = {0.9f, 0.2f, 0.4f, 0.7f};
  glFogfv(GL_FOG_COLOR, color);
  glFogf(GL_FOG_MODE, static_cast<GLfloat>(row.mode));
  glFogf(GL_FOG_DENSITY, static_cast<GLfloat>(row.density));
  glFogf(GL_FOG_START, static_cast<GLfloat>(row.start));
  glFogf(GL_FOG_END, static_cast<GLfloat>(row.end));
}

TEST_F(Fog, EveryMode) {
  Cells cells;
  glColor4f(0.1f, 0.8f, 0.5f, 0.6f);
  // 3.8: the distance to the eye and |z| are both allowed; near the axis they are one.
  for (double distance : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0, 1e6}) {
    for (double density : {0.0, 1e-6, 0.1, 0.5, 1.0, 10.0, 1e6}) {
      for (GLenum mode : {GLenum{GL_EXP}, GLenum{GL_EXP2}}) {
        const Row row = {mode, density, 0, 1, distance};
        cells.add(fmt::format("mode {:#x} density {} distance {}", mode, density, distance), fogged(row),
                  [&] {
                    setFog(row);
                    drawRect({-1, -1, 1, 1, -distance});
                  });
      }
    }
    for (const auto& [start, end] : {std::array{0.0, 1.0}, std::array{1.0, 10.0}, std::array{10.0, 1.0},
                                     std::array{-5.0, 5.0}, std::array{0.5, 0.75}, std::array{0.0, 1e6}}) {
      const Row row = {GL_LINEAR, 1, start, end, distance};
      cells.add(fmt::format("linear {}..{} distance {}", start, end, distance), fogged(row), [&] {
        setFog(row);
        // Corners close to the axis, so that the distance to the eye and |z| agree.
        drawRect({-1, -1, 1, 1, -distance});
      });
    }
  }
}

// 3.8: fog uses eye coordinates, so the modelview counts and the projection does not; behind the eye |z| is
// as far.
TEST_F(Fog, EyeDistance) {
  Cells cells;
  glColor4f(0.1f, 0.8f, 0.5f, 0.6f);
  const Row row = {GL_LINEAR, 1, 0, 8, 6};
  setFog(row);
  cells.add("translated", fogged(row), [] {
    glLoadIdentity();
    glTranslatef(0, 0, -5);
    drawRect({-1, -1, 1, 1, -1});
  });
  cells.add("behind the eye", fogged(row), [] {
    glLoadIdentity();
    glTranslatef(0, 0, 5);
    drawRect({-1, -1, 1, 1, 1});
  });
}

// 3.8: the post-texturing colour is fogged.
TEST_F(Fog, AfterTexturing) {
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGB, {0, 255, 0, 0});
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const GLfloat red[] = {1, 0, 0, 1};
  glFogfv(GL_FOG_COLOR, red);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_END, 4);
  glColor4f(1, 1, 1, 0.5f);
  drawRect({-1, -1, 1, 1, -1});
  EXPECT_PIXEL(32, 32, {0.25, 0.75, 0, 0.5});
}

// 3.8 across a primitive: a linear fog over a receding floor changes linearly in eye z.
TEST_F(Fog, AcrossAPrimitive) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-1, 1, -1, 1, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  const GLfloat white[] = {1, 1, 1, 1};
  glFogfv(GL_FOG_COLOR, white);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_END, 16);
  glColor4f(0, 0, 0, 1);
  // A floor one unit below a narrow view: the distance and |z| differ by less than the tolerance allows for.
  const GLfloat floor[] = {-9, -1, -1, 9, -1, -1, -9, -1, -16, 9, -1, -16};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, floor);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  for (int y = 4; y < 28; y += 4) {
    const double ndc = (y + 0.5) / 32 - 1, z = -1 / ndc, r = std::sqrt(z * z + 1);
    const Vec4 pixel = readPixel(32, y);
    const double least = std::min(z, r) / 16 - kOneStep, most = std::min(1.0, std::max(z, r) / 16 + kOneStep);
    EXPECT_GE(pixel[0], least) << y;
    EXPECT_LE(pixel[0], most) << y;
  }
}

}  // namespace
}  // namespace conformance
