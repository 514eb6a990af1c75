// Section 2.11: the view volume and user clip planes, at and across their boundaries and w = 0.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness.h"
#include "reference_math.h"

namespace conformance {
namespace {

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};

class Clipping : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnableClientState(GL_VERTEX_ARRAY);
    glColor4f(0, 1, 0, 1);
  }
  // Every pixel further than a pixel from the boundary is as `inside` says.
  template <class Inside>
  void expectRegion(const std::string& what, Inside&& inside) {
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        const auto at = [&](double dx, double dy) { return inside((x + dx) / 32 - 1, (y + dy) / 32 - 1); };
        const bool here = at(0.5, 0.5);
        if (at(0.4, 0.4) != here || at(0.6, 0.4) != here || at(0.4, 0.6) != here || at(0.6, 0.6) != here)
          continue;
        wrong += !near(image.at(x, y), here ? kGreen : kBlack);
      }
    }
    EXPECT_EQ(wrong, 0) << what;
  }
};

// 2.11: near and far.
TEST_F(Clipping, DepthOfTheViewVolume) {
  for (double z : {-1.5, -1.001, -0.999, 0.0, 0.999, 1.001, 1.5}) {
    glClear(GL_COLOR_BUFFER_BIT);
    drawRect({-1, -1, 1, 1, z});
    EXPECT_PIXEL(32, 32, std::abs(z) < 1 ? kGreen : kBlack) << z;
  }
  glClear(GL_COLOR_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLfloat corners[] = {-1, -1, -3, 1, -1, 3, -1, 1, -3, 1, 1, 3};
  glVertexPointer(3, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  expectRegion("slanted", [](double x, double) { return std::abs(3 * x) <= 1; });
}

// Triangles far bigger than the view volume keep their interpolation inside.
TEST_F(Clipping, HugeTriangles) {
  for (double size : {10.0, 1e3, 1e5}) {
    const auto s = static_cast<GLfloat>(size);
    const GLfloat positions[] = {-s, -s, s, -s, 0, s};
    glClear(GL_COLOR_BUFFER_BIT);
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    expectRegion(fmt::format("size {}", size),
                 [&](double x, double y) { return std::abs(x) < (size - y) / 2; });
  }
}

// 2.11: parts with w <= 0 are not drawn, the rest is right: a floor through the eye.
TEST_F(Clipping, ThroughTheEye) {
  glMatrixMode(GL_PROJECTION);
  glFrustumf(-1, 1, -1, 1, 1, 100);
  glMatrixMode(GL_MODELVIEW);
  const GLfloat floor[] = {-200, -1, 200, 200, -1, 200, -200, -1, -200, 200, -1, -200};
  glVertexPointer(3, GL_FLOAT, 0, floor);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  expectRegion("floor", [](double, double y) { return y < -0.01 && y > -1; });
}

// w = 0 at one vertex, and w < 0 at one.
TEST_F(Clipping, VanishingW) {
  const GLfloat positions[] = {-1, -1, 0, 1, 1, -1, 0, 1, 0, 1, 0, 0};
  glVertexPointer(4, GL_FLOAT, 0, positions);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  // The third vertex is at infinity upward: the strip |x| < 1 above y = -1.
  expectRegion("w = 0", [](double, double) { return true; });
  glClear(GL_COLOR_BUFFER_BIT);
  const GLfloat negative[] = {-0.5f, -0.5f, 0, 1, 0.5f, -0.5f, 0, 1, 0, 0.5f, 0, -1};
  glVertexPointer(4, GL_FLOAT, 0, negative);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  // a (-.5, -.5) + b (.5, -.5) + c (0, .5) with w = 1 - 2c has y w = -w / 2: the visible part is a line
  // without area.
  EXPECT_PIXEL(32, 40, kBlack);
  EXPECT_PIXEL(32, 50, kBlack);
}

// 2.11: every plane alone, in eye coordinates, given under a modelview.
TEST_F(Clipping, UserPlanes) {
  GLint planes = 0;
  glGetIntegerv(GL_MAX_CLIP_PLANES, &planes);
  for (GLint i = 0; i < planes; ++i) {
    const GLenum plane = GL_CLIP_PLANE0 + static_cast<GLenum>(i);
    const double angle = i * 0.7 + 0.2;
    const GLfloat equation[] = {static_cast<GLfloat>(std::cos(angle)), static_cast<GLfloat>(std::sin(angle)),
                                0, 0.3f};
    glClear(GL_COLOR_BUFFER_BIT);
    glClipPlanef(plane, equation);
    glEnable(plane);
    drawRect();
    expectRegion(fmt::format("plane {}", i),
                 [&](double x, double y) { return std::cos(angle) * x + std::sin(angle) * y + 0.3f >= 0; });
    glDisable(plane);
    // Specified under a translation, used without it.
    glClear(GL_COLOR_BUFFER_BIT);
    glTranslatef(0.25f, 0, 0);
    const GLfloat right[] = {1, 0, 0, 0};
    glClipPlanef(plane, right);
    glLoadIdentity();
    glEnable(plane);
    drawRect();
    expectRegion(fmt::format("translated plane {}", i), [](double x, double) { return x >= 0.25; });
    glDisable(plane);
  }
}

// 2.11: the clip volume is the intersection of all planes.
TEST_F(Clipping, AllPlanesTogether) {
  GLint planes = 0;
  glGetIntegerv(GL_MAX_CLIP_PLANES, &planes);
  for (GLint i = 0; i < planes; ++i) {
    const double angle = i * 2 * 3.14159265358979 / planes;
    const GLfixed equation[] = {static_cast<GLfixed>(std::lround(std::cos(angle) * 65536)),
                                static_cast<GLfixed>(std::lround(std::sin(angle) * 65536)), 0, 32768};
    glClipPlanex(GL_CLIP_PLANE0 + static_cast<GLenum>(i), equation);
    glEnable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
  }
  drawRect();
  expectRegion("polygon", [&](double x, double y) {
    for (GLint i = 0; i < planes; ++i) {
      const double angle = i * 2 * 3.14159265358979 / planes;
      if (std::cos(angle) * x + std::sin(angle) * y + 0.5 < 0) return false;
    }
    return true;
  });
}

// 2.11: complementary planes leave no gap and draw nothing twice.
TEST_F(Clipping, Complementarity) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4ub(60, 60, 60, 60);
  glEnable(GL_CLIP_PLANE0);
  for (double angle : {0.1, 0.9, 2.5}) {
    glClear(GL_COLOR_BUFFER_BIT);
    for (double sign : {1.0, -1.0}) {
      const GLfloat equation[] = {static_cast<GLfloat>(sign * std::cos(angle)),
                                  static_cast<GLfloat>(sign * std::sin(angle)), 0,
                                  static_cast<GLfloat>(sign * 0.123)};
      glClipPlanef(GL_CLIP_PLANE0, equation);
      drawRect();
    }
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x)
        wrong += !near(image.at(x, y), {60 / 255.0, 60 / 255.0, 60 / 255.0, 60 / 255.0}, 0);
    }
    EXPECT_EQ(wrong, 0) << angle;
  }
}

// 2.11: lines are cut, points are kept or dropped whole.
TEST_F(Clipping, LinesAndPoints) {
  const GLfloat right[] = {1, 0, 0, 0};
  glClipPlanef(GL_CLIP_PLANE0, right);
  glEnable(GL_CLIP_PLANE0);
  const GLfloat line[] = {-0.9f, 0.0156f, 0.9f, 0.0156f};
  glVertexPointer(2, GL_FLOAT, 0, line);
  glDrawArrays(GL_LINES, 0, 2);
  EXPECT_PIXEL(20, 32, kBlack);
  EXPECT_PIXEL(45, 32, kGreen);
  glClear(GL_COLOR_BUFFER_BIT);
  glPointSize(8);
  const GLfloat points[] = {-0.05f, -0.5f, 0.05f, 0.5f};
  glVertexPointer(2, GL_FLOAT, 0, points);
  glDrawArrays(GL_POINTS, 0, 2);
  EXPECT_PIXEL(31, 16, kBlack);
  EXPECT_PIXEL(33, 16, kBlack);
  EXPECT_PIXEL(34, 48, kGreen);
}

// 2.12.7: clipped colours and texture coordinates are those of the unclipped primitive.
TEST_F(Clipping, ColorsAreInterpolated) {
  const GLfloat positions[] = {-3, -1, 3, -1, -3, 1, 3, 1};
  const GLfloat colors[] = {0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1};
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glColorPointer(4, GL_FLOAT, 0, colors);
  const GLfloat plane[] = {-1, 0, 0, 0.5f};
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  for (int x : {0, 16, 32, 46}) EXPECT_PIXEL(x, 32, {((x + 0.5) / 32 - 1 + 3) / 6, 0, 0, 1}) << x;
  EXPECT_PIXEL(50, 32, kBlack);
}

}  // namespace
}  // namespace conformance
