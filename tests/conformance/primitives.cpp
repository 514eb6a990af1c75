// Sections 2.6, 2.12.6, 3.4, 3.5: lines and triangles, their order, flat shading, culling, polygon offset,
// coverage.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "harness.h"

namespace conformance {
namespace {

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};

class Primitives : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    // One unit a pixel, origin at the lower left.
    glMatrixMode(GL_PROJECTION);
    glOrthof(0, 64, 0, 64, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColor4f(0, 1, 0, 1);
  }
  static void draw(GLenum mode, const std::vector<GLfloat>& positions) {
    glVertexPointer(2, GL_FLOAT, 0, positions.data());
    glDrawArrays(mode, 0, static_cast<GLsizei>(positions.size() / 2));
  }
  // The number of pixels that are not black.
  static int covered(const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) count += !near(image.at(x, y), kBlack, 0.01);
    }
    return count;
  }
  static void clear() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }
};

// 2.6.1: which triangles every mode makes of seven vertices; left-over vertices make nothing.
TEST_F(Primitives, TriangleModes) {
  // Unit squares' corners at the places of a strip.
  const std::vector<GLfloat> strip = {0, 0, 0, 16, 16, 0, 16, 16, 32, 0, 32, 16, 48, 0};
  draw(GL_TRIANGLE_STRIP, strip);
  EXPECT_EQ(covered(readAll()), 32 * 16 + 16 * 16 / 2 - 8)
      << "five triangles; the slanted edge keeps 120 of 256";
  clear();
  draw(GL_TRIANGLES, strip);
  const Image triangles = readAll();
  EXPECT_TRUE(near(triangles.at(2, 2), kGreen));
  EXPECT_TRUE(near(triangles.at(30, 2), kGreen));
  EXPECT_TRUE(near(triangles.at(13, 13), kBlack, 0));
  EXPECT_TRUE(near(triangles.at(40, 2), kBlack, 0));
  clear();
  draw(GL_TRIANGLE_FAN, {32, 32, 60, 32, 60, 60, 32, 60, 4, 60, 4, 32});
  const Image fan = readAll();
  EXPECT_TRUE(near(fan.at(50, 40), kGreen));
  EXPECT_TRUE(near(fan.at(40, 50), kGreen));
  EXPECT_TRUE(near(fan.at(20, 40), kGreen));
  EXPECT_TRUE(near(fan.at(20, 20), kBlack, 0));
  clear();
  draw(GL_TRIANGLES, {0, 0, 64, 0});
  draw(GL_TRIANGLE_STRIP, {0, 0, 64, 0});
  draw(GL_TRIANGLE_FAN, {0, 0, 64, 0});
  draw(GL_LINES, {0, 10});
  draw(GL_LINE_STRIP, {0, 10});
  EXPECT_EQ(covered(readAll()), 0);
}

// 3.5.1: fragments whose centres lie inside; adjacent triangles cover every pixel exactly once.
TEST_F(Primitives, SharedEdgesCoverOnce) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4ub(1, 1, 1, 1);
  std::mt19937 random(21);
  std::uniform_real_distribution<float> inside(8, 56);
  for (int round = 0; round < 10; ++round) {
    clear();
    // A fan around a random point, its outer vertices on the border.
    std::vector<GLfloat> fan = {inside(random), inside(random), 0, 0};
    for (float x : {9.3f, 20.0f, 32.5f, 50.1f, 64.0f}) fan.insert(fan.end(), {x, 0.0f});
    for (float y : {13.7f, 32.0f, 64.0f}) fan.insert(fan.end(), {64.0f, y});
    fan.insert(fan.end(), {0.0f, 64.0f, 0.0f, 0.0f});
    draw(GL_TRIANGLE_FAN, fan);
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x)
        wrong += !near(image.at(x, y), {1 / 255.0, 1 / 255.0, 1 / 255.0, 1 / 255.0}, 0);
    }
    EXPECT_EQ(wrong, 0) << round;
  }
}

// 3.5.1: point sampling at the centres of the pixels.
TEST_F(Primitives, PixelCentres) {
  draw(GL_TRIANGLE_STRIP, {10.4f, 10.4f, 20.6f, 10.4f, 10.4f, 20.6f, 20.6f, 20.6f});
  const Image image = readAll();
  EXPECT_EQ(covered(image), 11 * 11);
  EXPECT_TRUE(near(image.at(10, 10), kGreen));
  EXPECT_TRUE(near(image.at(20, 20), kGreen));
  clear();
  draw(GL_TRIANGLE_STRIP, {10.6f, 10.6f, 20.4f, 10.6f, 10.6f, 20.4f, 20.4f, 20.4f});
  EXPECT_EQ(covered(readAll()), 9 * 9);
}

// 3.5.1 (3.6): colours are interpolated in eye space, weighted by 1 / w.
TEST_F(Primitives, PerspectiveColors) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  const GLfloat positions[] = {-1, -1, 0, 1, 3, -3, 0, 3, -1, 1, 0, 1, 3, 3, 0, 3};
  const GLfloat colors[] = {0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1};
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(4, GL_FLOAT, 0, positions);
  glColorPointer(4, GL_FLOAT, 0, colors);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  for (int x : {0, 10, 31, 50, 63}) {
    const double a = (x + 0.5) / 64;
    EXPECT_PIXEL(x, 32, {(a / 3) / (1 - a + a / 3), 0, 0, 1}) << x;
  }
}

// 2.12.6: the last vertex gives a flat primitive its colour: 3i, i + 2, i + 2; of lines the second; of a
// loop's last line the first vertex.
TEST_F(Primitives, FlatShading) {
  glShadeModel(GL_FLAT);
  glEnableClientState(GL_COLOR_ARRAY);
  std::vector<GLubyte> colors;
  for (int i = 0; i < 8; ++i) {
    for (GLubyte c : {GLubyte(i * 30 + 10), GLubyte(255 - i * 20), GLubyte(0), GLubyte(255)})
      colors.push_back(c);
  }
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
  const auto colorOf = [](int vertex) {
    return Vec4{(vertex * 30 + 10) / 255.0, (255 - vertex * 20) / 255.0, 0, 1};
  };
  draw(GL_TRIANGLE_STRIP, {0, 0, 0, 16, 16, 0, 16, 16, 32, 0, 32, 16});
  EXPECT_PIXEL(4, 4, colorOf(2));
  EXPECT_PIXEL(12, 12, colorOf(3));
  EXPECT_PIXEL(20, 4, colorOf(4));
  EXPECT_PIXEL(28, 12, colorOf(5));
  clear();
  draw(GL_TRIANGLES, {0, 0, 16, 0, 0, 16, 32, 0, 48, 0, 32, 16});
  EXPECT_PIXEL(4, 4, colorOf(2));
  EXPECT_PIXEL(36, 4, colorOf(5));
  clear();
  draw(GL_TRIANGLE_FAN, {32, 32, 60, 32, 60, 60, 32, 60, 4, 60});
  EXPECT_PIXEL(50, 40, colorOf(2));
  EXPECT_PIXEL(40, 50, colorOf(3));
  EXPECT_PIXEL(25, 50, colorOf(4));
  clear();
  draw(GL_LINES, {0, 10.5f, 30, 10.5f, 32, 10.5f, 62, 10.5f});
  EXPECT_PIXEL(15, 10, colorOf(1));
  EXPECT_PIXEL(47, 10, colorOf(3));
  clear();
  draw(GL_LINE_STRIP, {0, 10.5f, 30, 10.5f, 60, 10.5f});
  EXPECT_PIXEL(15, 10, colorOf(1));
  EXPECT_PIXEL(45, 10, colorOf(2));
  clear();
  draw(GL_LINE_LOOP, {10.5f, 10.5f, 50.5f, 10.5f, 50.5f, 50.5f, 10.5f, 50.5f});
  EXPECT_PIXEL(30, 10, colorOf(1));
  EXPECT_PIXEL(50, 30, colorOf(2));
  EXPECT_PIXEL(30, 50, colorOf(3));
  EXPECT_PIXEL(10, 30, colorOf(0));
  clear();
  const GLubyte indices[] = {5, 1, 4, 0, 3, 2};
  const std::vector<GLfloat> positions = {0, 0, 0, 16, 16, 0, 16, 16, 32, 0, 32, 16};
  glVertexPointer(2, GL_FLOAT, 0, positions.data());
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
  EXPECT_PIXEL(20, 8, colorOf(4));
}

// 2.12.6 under lighting: the flat colour is the last vertex' lit colour.
TEST_F(Primitives, FlatLit) {
  glShadeModel(GL_FLAT);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  const GLfloat black[] = {0, 0, 0, 1}, white[] = {1, 1, 1, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
  glEnableClientState(GL_NORMAL_ARRAY);
  const GLfloat normals[] = {0, 0, 1, 0, 0, 0.25f, 0, 0, 0.5f};
  glNormalPointer(GL_FLOAT, 0, normals);
  draw(GL_TRIANGLES, {0, 0, 64, 0, 0, 64});
  EXPECT_PIXEL(10, 10, {0.5, 0.5, 0.5, 1});
}

// 3.5.1: culling by face, mode and winding; both strips' and fans' triangles keep their winding.
TEST_F(Primitives, Culling) {
  const std::vector<GLfloat> ccw = {0, 0, 16, 0, 0, 16}, cw = {0, 0, 0, 16, 16, 0};
  for (GLenum front : {GLenum{GL_CCW}, GLenum{GL_CW}}) {
    for (GLenum face : {GLenum{GL_FRONT}, GLenum{GL_BACK}, GLenum{GL_FRONT_AND_BACK}, GLenum{0}}) {
      for (bool clockwise : {false, true}) {
        const bool isFront = clockwise == (front == GL_CW);
        const bool culled =
            face == GL_FRONT_AND_BACK || (face == GL_FRONT && isFront) || (face == GL_BACK && !isFront);
        clear();
        (face ? glEnable : glDisable)(GL_CULL_FACE);
        if (face) glCullFace(face);
        glFrontFace(front);
        draw(GL_TRIANGLES, clockwise ? cw : ccw);
        EXPECT_PIXEL(4, 4, culled ? kBlack : kGreen) << front << " " << face << " " << clockwise;
      }
    }
  }
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  clear();
  draw(GL_TRIANGLE_STRIP, {0, 0, 16, 0, 0, 16, 16, 16, 0, 32, 16, 32});
  EXPECT_EQ(covered(readAll()), 16 * 32);
  // A mirroring viewport transform cannot be had, a mirroring modelview can.
  clear();
  glTranslatef(64, 0, 0);
  glScalef(-1, 1, 1);
  draw(GL_TRIANGLES, ccw);
  EXPECT_EQ(covered(readAll()), 0);
  // Lines and points have no face.
  glLoadIdentity();
  glCullFace(GL_FRONT_AND_BACK);
  draw(GL_LINES, {0, 10.5f, 64, 10.5f});
  EXPECT_PIXEL(30, 10, kGreen);
}

// 3.4.1: the half-open line; joined segments cover their common end once.
TEST_F(Primitives, ThinLines) {
  draw(GL_LINES, {4.5f, 10.5f, 40.5f, 10.5f});
  Image image = readAll();
  EXPECT_NEAR(covered(image), 36, 1);
  EXPECT_TRUE(near(image.at(20, 10), kGreen));
  EXPECT_TRUE(near(image.at(20, 11), kBlack, 0));
  EXPECT_TRUE(near(image.at(20, 9), kBlack, 0));
  clear();
  draw(GL_LINES, {10.5f, 4.5f, 10.5f, 40.5f});
  image = readAll();
  EXPECT_NEAR(covered(image), 36, 1);
  EXPECT_TRUE(near(image.at(10, 20), kGreen));
  clear();
  draw(GL_LINES, {4.5f, 4.5f, 40.5f, 40.5f});
  EXPECT_NEAR(covered(readAll()), 36, 1);
  clear();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4ub(100, 0, 0, 100);
  draw(GL_LINE_STRIP, {4.5f, 30.5f, 20.5f, 30.5f, 40.5f, 30.5f});
  image = readAll();
  for (int x = 6; x < 39; ++x) EXPECT_TRUE(near(image.at(x, 30), {100 / 255.0, 0, 0, 100 / 255.0}, 0)) << x;
}

// 3.4.1, rule 3: one fragment a column of an x-major line, one a row of a y-major one, whatever the slope.
TEST_F(Primitives, SlopedLines) {
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 15.0 * 3.14159265358979 / 180 + 0.01;
    const double dx = std::cos(angle) * 25, dy = std::sin(angle) * 25;
    clear();
    draw(GL_LINES, {32.3f, 32.2f, static_cast<GLfloat>(32.3 + dx), static_cast<GLfloat>(32.2 + dy)});
    const Image image = readAll();
    const bool xMajor = std::abs(dx) >= std::abs(dy);
    const int expected = static_cast<int>(std::lround(std::max(std::abs(dx), std::abs(dy))));
    EXPECT_NEAR(covered(image), expected, 1) << i;
    for (int a = 0; a < 64; ++a) {
      int count = 0;
      for (int b = 0; b < 64; ++b) {
        const int x = xMajor ? a : b, y = xMajor ? b : a;
        if (near(image.at(x, y), kBlack, 0)) continue;
        ++count;
        // Within one pixel of the ideal line.
        const double along = xMajor ? (x + 0.5 - 32.3) / dx : (y + 0.5 - 32.2) / dy;
        const double off = xMajor ? y + 0.5 - (32.2 + along * dy) : x + 0.5 - (32.3 + along * dx);
        EXPECT_LE(std::abs(off), 1.0) << i;
      }
      EXPECT_LE(count, 1) << "line " << i << ", " << a;
    }
  }
}

// 3.4.1, rule 4: joined segments have no hole and no pixel twice at the joint, on pixel centres and off them, in every
// direction.
TEST_F(Primitives, JoinedLines) {
  MESA_DISAGREES("3.4.1", "lines that meet on pixel centres lose a pixel");
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4ub(100, 0, 0, 100);
  constexpr int kSteps[][2] = {{20, 0},   {20, 10},  {20, 20},  {10, 20},  {0, 20},  {-10, 20},
                               {-20, 20}, {-20, 10}, {20, -10}, {20, -20}, {10, -20}};
  for (const auto& [dx, dy] : kSteps) {
    for (int sign : {1, -1}) {
      for (float fx : {0.0f, 0.25f, 0.5f, 0.75f}) {
        for (float fy : {0.0f, 0.25f, 0.5f, 0.75f}) {
          const float x = 32 + fx, y = 32 + fy;
          const auto stepX = static_cast<float>(dx * sign), stepY = static_cast<float>(dy * sign);
          clear();
          draw(GL_LINE_STRIP, {x - stepX, y - stepY, x, y, x + stepX, y + stepY});
          const Image image = readAll();
          const bool xMajor = std::abs(dx) >= std::abs(dy);
          // Once along the major axis in all columns but those of the two free ends.
          for (int a = 14; a < 51; ++a) {
            double sum = 0;
            for (int b = 0; b < 64; ++b) sum += xMajor ? image.at(a, b)[0] : image.at(b, a)[0];
            EXPECT_NEAR(sum, 100 / 255.0, kOneStep)
                << "steps of " << stepX << ", " << stepY << " joined at " << x << ", " << y << "; at " << a;
          }
        }
      }
    }
  }
}

// 3.4.2: wide lines are as many fragments wide as the width rounds to.
TEST_F(Primitives, WideLines) {
  GLfloat range[2] = {};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  for (double width : {1.0, 1.4, 1.6, 2.0, 3.0, 4.4, 5.0, 7.0, 8.0}) {
    const int expected =
        std::max(1, std::min(static_cast<int>(std::lround(width)), static_cast<int>(range[1])));
    for (bool vertical : {false, true}) {
      clear();
      glLineWidth(static_cast<GLfloat>(width));
      draw(GL_LINES, vertical ? std::vector<GLfloat>{32.5f, 10, 32.5f, 50}
                              : std::vector<GLfloat>{10, 32.5f, 50, 32.5f});
      const Image image = readAll();
      int across = 0;
      for (int i = 0; i < 64; ++i) across += !near(vertical ? image.at(i, 30) : image.at(30, i), kBlack, 0);
      EXPECT_EQ(across, expected) << width << (vertical ? " vertical" : " horizontal");
      EXPECT_NEAR(covered(image), expected * 40, expected) << width;
    }
  }
  // Wider than there is: clamped, not refused.
  glLineWidth(100000);
  draw(GL_LINES, {10, 32.5f, 50, 32.5f});
  EXPECT_PIXEL(30, 32, kGreen);
}

// 3.4.2: a smooth line covers its rectangle; the sum of the coverages is its area.
TEST_F(Primitives, SmoothLines) {
  glEnable(GL_LINE_SMOOTH);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 1, 1, 1);
  GLfloat range[2] = {};
  glGetFloatv(GL_SMOOTH_LINE_WIDTH_RANGE, range);
  for (double width : {1.0, 3.0}) {
    if (width > range[1]) continue;
    for (const auto& [dx, dy] : {std::array{40.0, 0.0}, std::array{30.0, 20.0}}) {
      clear();
      glLineWidth(static_cast<GLfloat>(width));
      draw(GL_LINES, {10, 20.5f, static_cast<GLfloat>(10 + dx), static_cast<GLfloat>(20.5 + dy)});
      const Image image = readAll();
      double sum = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) sum += image.at(x, y)[0];
      }
      const double area = width * std::hypot(dx, dy);
      EXPECT_NEAR(sum, area, area * 0.15 + 1) << width << " " << dx << " " << dy;
    }
  }
}

// 2.6.1: line loops close; a loop of two vertices is drawn there and back.
TEST_F(Primitives, LineLoops) {
  draw(GL_LINE_LOOP, {10.5f, 10.5f, 50.5f, 10.5f, 50.5f, 50.5f, 10.5f, 50.5f});
  const Image image = readAll();
  for (const auto& [x, y] :
       {std::array{30, 10}, std::array{50, 30}, std::array{30, 50}, std::array{10, 30}}) {
    EXPECT_TRUE(near(image.at(x, y), kGreen)) << x << " " << y;
  }
  EXPECT_TRUE(near(image.at(30, 30), kBlack, 0));
  EXPECT_NEAR(covered(image), 160, 3);
  clear();
  const GLushort indices[] = {3, 0, 1};
  const std::vector<GLfloat> positions = {10.5f, 10.5f, 50.5f, 10.5f, 0, 0, 10.5f, 50.5f};
  glVertexPointer(2, GL_FLOAT, 0, positions.data());
  glDrawElements(GL_LINE_LOOP, 3, GL_UNSIGNED_SHORT, indices);
  EXPECT_PIXEL(30, 10, kGreen);
  EXPECT_PIXEL(10, 30, kGreen);
  EXPECT_PIXEL(30, 30, kGreen);
}

// 3.5.2: the offset is m * factor + r * units, added and clamped; only for polygons, only when enabled.
TEST_F(Primitives, PolygonOffset) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  const auto visible = [&](GLfloat factor, GLfloat units, bool enabled, double slope) {
    glClearDepthf(1);
    clear();
    const GLfloat z = static_cast<GLfloat>(slope);
    const GLfloat corners[] = {-1, -1, -z, 1, -1, z, -1, 1, -z, 1, 1, z};
    glVertexPointer(3, GL_FLOAT, 0, corners);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColor4f(1, 0, 0, 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    (enabled ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(factor, units);
    glColor4f(0, 1, 0, 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return static_cast<bool>(near(readPixel(32, 32), kGreen));
  };
  EXPECT_FALSE(visible(0, 0, true, 0));
  EXPECT_TRUE(visible(0, -2, true, 0)) << "units bring it nearer";
  EXPECT_FALSE(visible(0, 2, true, 0));
  EXPECT_FALSE(visible(0, -2, false, 0)) << "not enabled";
  EXPECT_FALSE(visible(-1, 0, true, 0)) << "no slope, no factor";
  EXPECT_TRUE(visible(-1, 0, true, 0.5)) << "the factor takes the slope";
  EXPECT_FALSE(visible(1, 0, true, 0.5));
  EXPECT_TRUE(visible(-1, 100, true, 0.5)) << "the slope outweighs the units";
  // m = dz/dx = 0.5 / 64 in window coordinates: half of it stays in front of a plane that is that near.
  glClearDepthf(1);
  clear();
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(8, 0);
  const GLfloat slanted[] = {-1, -1, -0.5f, 1, -1, 0.5f, -1, 1, -0.5f, 1, 1, 0.5f};
  glVertexPointer(3, GL_FLOAT, 0, slanted);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  // At x = 32 the depth is about 0.5 + 8 * 0.5 / 64 = 0.5625, or 0.125 in NDC.
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_FALSE);
  const auto passes = [&](double z) {
    glColor4f(0, 0, 1, 1);
    drawRect({-1, -1, 1, 1, z});
    return static_cast<bool>(near(readPixel(32, 32), {0, 0, 1, 1}));
  };
  EXPECT_FALSE(passes(0.145));
  EXPECT_TRUE(passes(0.115));
}

}  // namespace
}  // namespace conformance
