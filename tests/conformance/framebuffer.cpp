// Sections 4.2.3 and 4.3: clearing and reading pixels.
#include <fmt/format.h>

#include <cmath>

#include "harness.h"

namespace conformance {
namespace {

class Framebuffer : public GlTest {};

constexpr Vec4 kBlack = {0, 0, 0, 0};

void clearTo(double r, double g, double b, double a) {
  glClearColor(static_cast<GLfloat>(r), static_cast<GLfloat>(g), static_cast<GLfloat>(b),
               static_cast<GLfloat>(a));
  glClear(GL_COLOR_BUFFER_BIT);
}

// 4.2.3, 2.12.8: every value of 8 bits.
TEST_F(Framebuffer, ClearColors) {
  for (int i = 0; i < 256; i += 5) {
    const double c = i / 255.0;
    clearTo(c, 1 - c, c, 1 - c);
    EXPECT_PIXEL(17, 40, {c, 1 - c, c, 1 - c}, 0) << i;
  }
}

// 4.2.3: only scissor, dithering and the masks apply to Clear.
TEST_F(Framebuffer, ClearIgnoresTheOtherTests) {
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_NEVER, 0);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_NEVER);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NEVER, 0, 0);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ONE);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_NOOP);
  glViewport(0, 0, 3, 3);
  clearTo(0.2, 0.4, 0.6, 0.8);
  EXPECT_PIXEL(50, 50, {0.2, 0.4, 0.6, 0.8});
}

TEST_F(Framebuffer, ClearInTheScissor) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(10, 20, 30, 5);
  clearTo(1, 1, 1, 1);
  const Image image = readAll();
  int wrong = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = x >= 10 && x < 40 && y >= 20 && y < 25;
      wrong += !near(image.at(x, y), inside ? Vec4{1, 1, 1, 1} : kBlack, 0);
    }
  }
  EXPECT_EQ(wrong, 0);
  glScissor(0, 0, 0, 0);
  clearTo(1, 0, 0, 1);
  EXPECT_PIXEL(20, 22, {1, 1, 1, 1});
}

// 4.2.3: each buffer alone, in the order of the commands, before and between draws.
TEST_F(Framebuffer, ClearEachBuffer) {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glDepthFunc(GL_LESS);
  glStencilFunc(GL_EQUAL, 3, 0xff);
  glColor4f(0, 1, 0, 1);
  glClearDepthf(0.25f);
  glClearStencil(3);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  drawRect({-1, -1, 1, 1, 0});
  EXPECT_PIXEL(32, 32, kBlack) << "the depth is 0.25";
  glClearDepthf(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  drawRect({-1, -1, 0, 1, 0});
  EXPECT_PIXEL(16, 32, {0, 1, 0, 1});
  glClearStencil(4);
  glClear(GL_STENCIL_BUFFER_BIT);
  drawRect({0, -1, 1, 1, 0});
  EXPECT_PIXEL(48, 32, kBlack) << "the stencil is 4";
  glClear(0);
  EXPECT_PIXEL(16, 32, {0, 1, 0, 1});
  // ClearStencil is masked to the bits there are.
  glClearStencil(0x103);
  glClear(GL_STENCIL_BUFFER_BIT);
  drawRect({0, -1, 1, 1, 0});
  EXPECT_PIXEL(48, 32, {0, 1, 0, 1});
}

// 4.3.1: rectangles at any place and PACK_ALIGNMENT; nothing is written outside of the rows.
TEST_F(Framebuffer, ReadRectangles) {
  for (int y = 0; y < 64; y += 8) {
    for (int x = 0; x < 64; x += 8) {
      glColor4ub(static_cast<GLubyte>(x * 4), static_cast<GLubyte>(y * 4), 100, 200);
      const double x0 = x / 32.0 - 1, y0 = y / 32.0 - 1;
      drawRect({x0, y0, x0 + 0.25, y0 + 0.25});
    }
  }
  for (int alignment : {1, 2, 4, 8}) {
    glPixelStorei(GL_PACK_ALIGNMENT, alignment);
    for (const auto& [x, y, w, h] :
         {std::array{0, 0, 64, 64}, std::array{5, 7, 3, 9}, std::array{63, 63, 1, 1}, std::array{8, 0, 1, 64},
          std::array{0, 31, 33, 2}}) {
      const int stride = (w * 4 + alignment - 1) / alignment * alignment;
      std::vector<GLubyte> data(static_cast<std::size_t>(stride * h), 0xcd);
      glReadPixels(x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
      int wrong = 0;
      for (int j = 0; j < h; ++j) {
        const GLubyte* row = data.data() + j * stride;
        for (int i = 0; i < w; ++i) {
          const GLubyte* p = row + i * 4;
          wrong += p[0] != (x + i) / 8 * 32 || p[1] != (y + j) / 8 * 32 || p[2] != 100 || p[3] != 200;
        }
        for (int i = w * 4; i < stride; ++i) wrong += row[i] != 0xcd;
      }
      EXPECT_EQ(wrong, 0) << alignment << ": " << x << " " << y << " " << w << " " << h;
    }
  }
}

// 4.3.1: pixels outside are undefined, the ones inside are not, and the memory around stays whole.
TEST_F(Framebuffer, ReadPartlyOutside) {
  clearTo(0, 1, 0, 1);
  for (const auto& [x, y] : {std::array{-4, -4}, std::array{60, 60}, std::array{-4, 30}, std::array{30, 60},
                             std::array{-1000000, 5}, std::array{2147483640, 2147483640}}) {
    std::vector<GLubyte> data(8 * 8 * 4 + 64, 0xcd);
    glReadPixels(x, y, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i) {
        const long long px = static_cast<long long>(x) + i, py = static_cast<long long>(y) + j;
        if (px < 0 || px >= 64 || py < 0 || py >= 64) continue;
        EXPECT_EQ(data[static_cast<std::size_t>((j * 8 + i) * 4 + 1)], 255) << x << " " << y;
      }
    }
    for (std::size_t i = 8 * 8 * 4; i < data.size(); ++i) ASSERT_EQ(data[i], 0xcd);
  }
}

// 2.1: draws and reads in turn, each read complete up to its place.
TEST_F(Framebuffer, DrawAndReadInTurn) {
  for (int i = 0; i < 64; ++i) {
    glColor4ub(static_cast<GLubyte>(i * 4), 0, static_cast<GLubyte>(255 - i), 255);
    drawRect();
    EXPECT_PIXEL(i, 63 - i, {i * 4 / 255.0, 0, (255 - i) / 255.0, 1}, 0);
  }
}

TEST_F(Framebuffer, FlushAndFinish) {
  for (int i = 0; i < 10; ++i) {
    clearTo(i / 10.0, 0, 0, 1);
    i % 2 ? glFlush() : glFinish();
  }
  EXPECT_PIXEL(0, 0, {0.9, 0, 0, 1});
}

// 2.12.8: the formats that a config may have, written and read.
class FramebufferFormats : public testing::TestWithParam<SurfaceRequest> {};

TEST_P(FramebufferFormats, ClearAndDraw) {
  const SurfaceRequest request = GetParam();
  Session session(request);
  if (onMesa() && !session.valid()) GTEST_SKIP() << "Mesa has no such config";
  ASSERT_TRUE(session.valid());
  ASSERT_TRUE(session.makeCurrent());
  glDisable(GL_DITHER);
  const auto quantised = [](double value, int bits) {
    const double most = (1 << bits) - 1;
    return bits ? std::round(value * most) / most : 1.0;
  };
  for (double c : {0.0, 0.22, 0.52, 0.75, 1.0}) {
    const Vec4 expected = {quantised(c, request.red), quantised(1 - c, request.green),
                           quantised(c, request.blue), quantised(1 - c, request.alpha)};
    clearTo(c, 1 - c, c, 1 - c);
    EXPECT_TRUE(near(readImage(0, 0, 1, 1).at(0, 0), expected)) << "clear " << c;
    clearTo(0, 0, 0, 0);
    glColor4f(static_cast<GLfloat>(c), static_cast<GLfloat>(1 - c), static_cast<GLfloat>(c),
              static_cast<GLfloat>(1 - c));
    drawRect();
    EXPECT_TRUE(near(readImage(0, 0, 1, 1).at(0, 0), expected)) << "draw " << c;
  }
  GLint bits = 0;
  glGetIntegerv(GL_RED_BITS, &bits);
  EXPECT_EQ(bits, request.red);
  glGetIntegerv(GL_ALPHA_BITS, &bits);
  EXPECT_EQ(bits, request.alpha);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

INSTANTIATE_TEST_SUITE_P(
    FramebufferOn, FramebufferFormats,
    testing::Values(SurfaceRequest{64, 64, 8, 8, 8, 8, 0, 0, 0}, SurfaceRequest{64, 64, 8, 8, 8, 0, 16, 0, 0},
                    SurfaceRequest{64, 64, 5, 6, 5, 0, 24, 8, 0}, SurfaceRequest{64, 64, 5, 5, 5, 1, 0, 0, 0},
                    SurfaceRequest{64, 64, 4, 4, 4, 4, 24, 8, 0}, SurfaceRequest{1, 1, 8, 8, 8, 8, 24, 8, 0},
                    SurfaceRequest{64, 64, 8, 8, 8, 8, 24, 8, 4}),
    [](const auto& instance) {
      const SurfaceRequest& r = instance.param;
      return fmt::format("{}{}{}{}_depth{}_samples{}_{}x{}", r.red, r.green, r.blue, r.alpha, r.depth,
                         r.samples, r.width, r.height);
    });

}  // namespace
}  // namespace conformance
