// Section 4.1: scissor, alpha, stencil and depth tests, blending, dithering, logic operations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fragment_reference.h"
#include "harness.h"

namespace conformance {
namespace {

class FragmentOperations : public GlTest {};

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1}, kRed = {1, 0, 0, 1};

void setColor(const Vec4& c) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
}

void clearTo(const Vec4& c) {
  glClearColor(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
               static_cast<GLfloat>(c[3]));
  glClear(GL_COLOR_BUFFER_BIT);
}

// 4.1.2
TEST_F(FragmentOperations, Scissor) {
  const struct {
    int x, y, w, h;
  } boxes[] = {{10, 20, 5, 7},     {0, 0, 64, 64}, {-10, -10, 20, 20},
               {50, 50, 100, 100}, {30, 30, 0, 5}, {30, 30, 5, 0},
               {100, 0, 10, 10},   {0, 0, 1, 1},   {-2000000000, -2000000000, 2147483647, 2147483647}};
  glEnable(GL_SCISSOR_TEST);
  setColor(kGreen);
  for (const auto& box : boxes) {
    glDisable(GL_SCISSOR_TEST);
    clearTo(kBlack);
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.x, box.y, box.w, box.h);
    drawRect();
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        const bool inside = x >= box.x && x < static_cast<long long>(box.x) + box.w && y >= box.y &&
                            y < static_cast<long long>(box.y) + box.h;
        wrong += !near(image.at(x, y), inside ? kGreen : kBlack);
      }
    }
    EXPECT_EQ(wrong, 0) << box.x << " " << box.y << " " << box.w << " " << box.h;
  }
}

// 4.1.4: every function over alphas below, at and above references that 8 bits hold exactly.
TEST_F(FragmentOperations, AlphaTest) {
  glEnable(GL_ALPHA_TEST);
  Cells cells;
  for (GLenum function : kComparisons) {
    for (int reference : {0, 1, 51, 128, 254, 255}) {
      for (int alpha : {0, 50, 51, 52, 128, 255}) {
        const Vec4 color = {0, 1, 0, alpha / 255.0};
        cells.add(fmt::format("{:#x} alpha {} reference {}", function, alpha, reference),
                  compare(function, alpha, reference) ? color : kBlack, [&] {
                    glAlphaFunc(function, static_cast<GLfloat>(reference) / 255);
                    setColor(color);
                    drawRect();
                  });
      }
      cells.check();
      clearTo(kBlack);
    }
  }
}

// 4.1.4, 2.12.8: both sides are compared at the framebuffer's alpha precision.
TEST_F(FragmentOperations, AlphaTestIsQuantised) {
  MESA_DISAGREES("4.1.4", "the comparison is made in floating point");
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_EQUAL, 0.5001f);
  setColor({0, 1, 0, 0.5019});
  drawRect();
  EXPECT_PIXEL(32, 32, {0, 1, 0, 128 / 255.0});
}

// 4.1.6
TEST_F(FragmentOperations, DepthTest) {
  glEnable(GL_DEPTH_TEST);
  Cells cells;
  for (GLenum function : kComparisons) {
    for (double z : {-0.5, 0.0, 0.5}) {
      cells.add(fmt::format("{:#x} z {}", function, z), compare(function, z, 0) ? kGreen : kRed, [&] {
        setColor(kRed);
        glDepthFunc(GL_ALWAYS);
        drawRect({-1, -1, 1, 1, 0});
        setColor(kGreen);
        glDepthFunc(function);
        drawRect({-1, -1, 1, 1, z});
      });
    }
  }
}

// 4.1.6: a disabled depth test neither tests nor writes; DepthMask keeps what is there; failing writes
// nothing.
TEST_F(FragmentOperations, DepthWrites) {
  const auto depthIs = [&](double ndc) {
    // Drawn between the two sides of the stored depth.
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    setColor(kRed);
    drawRect({-1, -1, 1, 1, ndc + 1e-3});
    setColor(kGreen);
    drawRect({-1, -1, 1, 1, ndc - 1e-3});
    return near(readPixel(32, 32), kGreen);
  };
  const auto clear = [] {
    glDepthMask(GL_TRUE);
    glClearDepthf(0.5f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  };
  clear();
  EXPECT_TRUE(depthIs(0));
  clear();
  glDisable(GL_DEPTH_TEST);
  drawRect({-1, -1, 1, 1, -0.5});
  EXPECT_TRUE(depthIs(0)) << "written with the test disabled";
  clear();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_FALSE);
  drawRect({-1, -1, 1, 1, -0.5});
  EXPECT_TRUE(depthIs(0)) << "written through the mask";
  clear();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  drawRect({-1, -1, 1, 1, -0.5});
  EXPECT_TRUE(depthIs(0)) << "written by a fragment that failed";
  clear();
  glDepthFunc(GL_ALWAYS);
  drawRect({-1, -1, 1, 1, -0.5});
  EXPECT_TRUE(depthIs(-0.5));
  // 4.2.3: the depth mask holds for Clear.
  glDepthMask(GL_FALSE);
  glClearDepthf(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  EXPECT_TRUE(depthIs(-0.5)) << "cleared through the mask";
}

// Reads the stencil buffer of the cell by drawing where it equals `value`.
void showStencil(GLint value) {
  glStencilFunc(GL_EQUAL, value, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_DEPTH_TEST);
  setColor(kGreen);
  drawRect();
}

void putStencil(GLint value) {
  glStencilFunc(GL_ALWAYS, value, 0xff);
  glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  setColor(kBlack);
  drawRect();
}

// 4.1.5: (ref & mask) op (stencil & mask), ref clamped to the bits.
TEST_F(FragmentOperations, StencilFunctions) {
  glEnable(GL_STENCIL_TEST);
  Cells cells;
  for (GLenum function : kComparisons) {
    for (GLuint mask : {0xffu, 0x0fu, 0u}) {
      for (GLint reference : {0, 5, 0x15, 255, 300, -3}) {
        const GLint stored = 0x25;
        const GLint clamped = std::clamp(reference, 0, 255);
        const bool passes =
            compare(function, clamped & static_cast<GLint>(mask), stored & static_cast<GLint>(mask));
        cells.add(fmt::format("{:#x} reference {} mask {:#x}", function, reference, mask),
                  passes ? kRed : kBlack, [&] {
                    putStencil(stored);
                    glStencilFunc(function, reference, mask);
                    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
                    setColor(kRed);
                    drawRect();
                  });
      }
    }
  }
}

GLint operated(GLenum operation, GLint stored, GLint reference) {
  switch (operation) {
    case GL_KEEP:
      return stored;
    case GL_ZERO:
      return 0;
    case GL_REPLACE:
      return reference;
    case GL_INCR:
      return std::min(stored + 1, 255);
    case GL_DECR:
      return std::max(stored - 1, 0);
    default:
      return ~stored & 0xff;
  }
}

// 4.1.5: each operation on stencil fail, depth fail and pass; increments and decrements stop at the ends.
TEST_F(FragmentOperations, StencilOperations) {
  glEnable(GL_STENCIL_TEST);
  glDepthFunc(GL_LESS);
  Cells cells;
  for (GLenum operation : {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT}) {
    for (int outcome = 0; outcome < 3; ++outcome) {
      for (GLint stored : {0, 1, 0x5a, 254, 255}) {
        const GLint expected = operated(static_cast<GLenum>(operation), stored, 0x33);
        cells.add(fmt::format("{:#x} outcome {} on {}", operation, outcome, stored), kGreen, [&] {
          glDisable(GL_DEPTH_TEST);
          putStencil(stored);
          glStencilFunc(outcome == 0 ? GL_NEVER : GL_ALWAYS, 0x33, 0xff);
          const GLenum op = static_cast<GLenum>(operation);
          // The two outcomes that must not happen would leave a telling value.
          const GLenum other = operation == GL_ZERO ? GL_INVERT : GL_ZERO;
          glStencilOp(outcome == 0 ? op : other, outcome == 1 ? op : other, outcome == 2 ? op : other);
          glEnable(GL_DEPTH_TEST);
          glDepthFunc(outcome == 1 ? GL_NEVER : GL_ALWAYS);
          setColor(kBlack);
          drawRect();
          showStencil(expected);
        });
      }
    }
  }
}

// 4.1.5: with the depth test disabled its failure never happens.
TEST_F(FragmentOperations, StencilWithoutDepthTest) {
  glEnable(GL_STENCIL_TEST);
  putStencil(7);
  glStencilFunc(GL_ALWAYS, 9, 0xff);
  glStencilOp(GL_ZERO, GL_ZERO, GL_REPLACE);
  glDepthFunc(GL_NEVER);
  setColor(kBlack);
  drawRect();
  showStencil(9);
  EXPECT_PIXEL(32, 32, kGreen);
}

// 4.2.2: only the bits of the mask are written, by draws and by Clear.
TEST_F(FragmentOperations, StencilMask) {
  glEnable(GL_STENCIL_TEST);
  putStencil(0xf0);
  glStencilMask(0x3c);
  glStencilFunc(GL_ALWAYS, 0x0f, 0xff);
  glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  setColor(kBlack);
  drawRect();
  showStencil(0xcc);
  EXPECT_PIXEL(32, 32, kGreen);
  clearTo(kBlack);
  glClearStencil(0xaa);
  glClear(GL_STENCIL_BUFFER_BIT);
  showStencil((0xcc & ~0x3c) | (0xaa & 0x3c));
  EXPECT_PIXEL(32, 32, kGreen);
}

// 4.1.3-4.1.6: a fragment that fails an early test changes nothing that comes after it.
TEST_F(FragmentOperations, OrderOfTests) {
  glEnable(GL_STENCIL_TEST);
  glEnable(GL_ALPHA_TEST);
  glEnable(GL_DEPTH_TEST);
  glAlphaFunc(GL_GREATER, 0.5f);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  setColor({1, 0, 0, 0.25});
  drawRect({-1, -1, 1, 1, -0.5});
  glDisable(GL_ALPHA_TEST);
  // Neither the stencil nor the depth buffer may have been written.
  glStencilFunc(GL_EQUAL, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  setColor(kGreen);
  drawRect({-1, -1, 1, 1, 0.5});
  EXPECT_PIXEL(32, 32, kGreen);
}

// 4.1.7, Tables 4.1 and 4.2: every pair of factors.
TEST_F(FragmentOperations, EveryBlendPair) {
  Cells cells;
  const std::pair<Vec4, Vec4> colors[] = {
      {{204 / 255.0, 51 / 255.0, 153 / 255.0, 0.4}, {51 / 255.0, 0.6, 0.2, 0.8}},
      {{1, 1, 0, 1}, {0, 1, 1, 0}},
      {{0.2, 0.4, 0.6, 0}, {1, 0.2, 0, 1}}};
  for (GLenum source : kSourceFactors) {
    for (GLenum destination : kDestinationFactors) {
      for (const auto& [s, d] : colors) {
        Vec4 expected{};
        const Vec4 fs = blendFactor(source, s, d), fd = blendFactor(destination, s, d);
        for (std::size_t i = 0; i < 4; ++i) expected[i] = s[i] * fs[i] + d[i] * fd[i];
        cells.add(fmt::format("{:#x} {:#x} of {} over {}", source, destination, toString(s), toString(d)),
                  clamp01(expected), [&] {
                    glDisable(GL_BLEND);
                    setColor(d);
                    drawRect();
                    glEnable(GL_BLEND);
                    glBlendFunc(source, destination);
                    setColor(s);
                    drawRect();
                  });
      }
    }
  }
}

GLubyte logic(GLenum operation, GLubyte s, GLubyte d) {
  int result = 0;
  switch (operation) {
    case GL_CLEAR:
      result = 0;
      break;
    case GL_AND:
      result = s & d;
      break;
    case GL_AND_REVERSE:
      result = s & ~d;
      break;
    case GL_COPY:
      result = s;
      break;
    case GL_AND_INVERTED:
      result = ~s & d;
      break;
    case GL_NOOP:
      result = d;
      break;
    case GL_XOR:
      result = s ^ d;
      break;
    case GL_OR:
      result = s | d;
      break;
    case GL_NOR:
      result = ~(s | d);
      break;
    case GL_EQUIV:
      result = ~(s ^ d);
      break;
    case GL_INVERT:
      result = ~d;
      break;
    case GL_OR_REVERSE:
      result = s | ~d;
      break;
    case GL_COPY_INVERTED:
      result = ~s;
      break;
    case GL_OR_INVERTED:
      result = ~s | d;
      break;
    case GL_NAND:
      result = ~(s & d);
      break;
    default:
      result = 255;
      break;
  }
  return static_cast<GLubyte>(result);
}

// 4.1.9: all sixteen, exact; the logic operation disables blending (4.1.7).
TEST_F(FragmentOperations, EveryLogicOperation) {
  Cells cells;
  const GLubyte s[4] = {0xc5, 0x3a, 0xff, 0x81}, d[4] = {0x5c, 0xf0, 0x0f, 0x7e};
  for (GLenum operation = GL_CLEAR; operation <= GL_SET; ++operation) {
    for (bool blend : {false, true}) {
      Vec4 expected{};
      for (std::size_t i = 0; i < 4; ++i) expected[i] = logic(operation, s[i], d[i]) / 255.0;
      cells.add(
          fmt::format("{:#x} blend {}", operation, blend), expected,
          [&] {
            glDisable(GL_BLEND);
            glDisable(GL_COLOR_LOGIC_OP);
            glColor4ub(d[0], d[1], d[2], d[3]);
            drawRect();
            glEnable(GL_COLOR_LOGIC_OP);
            (blend ? glEnable : glDisable)(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glLogicOp(operation);
            glColor4ub(s[0], s[1], s[2], s[3]);
            drawRect();
          },
          0);
    }
  }
}

// 4.1.9: nothing but the operation changes between two draws.
TEST_F(FragmentOperations, LogicOperationsInTurn) {
  glEnable(GL_COLOR_LOGIC_OP);
  setColor({1, 1, 1, 1});
  const std::pair<GLenum, double> operations[] = {{GL_CLEAR, 0}, {GL_INVERT, 0}, {GL_XOR, 0}, {GL_OR, 1}};
  for (const auto& [operation, value] : operations) {
    clearTo({0, 0, 0, 0});
    glLogicOp(GL_SET);
    drawRect();
    glLogicOp(operation);
    drawRect();
    EXPECT_PIXEL(32, 32, (Vec4{value, value, value, value})) << operation;
  }
}

// 4.2.2: every colour mask, for draws and for Clear.
TEST_F(FragmentOperations, ColorMask) {
  for (int bits = 0; bits < 16; ++bits) {
    const auto on = [&](int i) { return static_cast<GLboolean>(bits >> i & 1); };
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    clearTo({0.2, 0.4, 0.6, 0.8});
    glColorMask(on(0), on(1), on(2), on(3));
    setColor({1, 1, 0, 0});
    drawRect({-1, -1, 0, 1});
    glEnable(GL_SCISSOR_TEST);
    glScissor(32, 0, 32, 64);
    clearTo({1, 1, 0, 0});
    glDisable(GL_SCISSOR_TEST);
    const Vec4 expected = {on(0) ? 1 : 0.2, on(1) ? 1 : 0.4, on(2) ? 0 : 0.6, on(3) ? 0 : 0.8};
    EXPECT_PIXEL(16, 32, expected) << "draw, mask " << bits;
    EXPECT_PIXEL(48, 32, expected) << "clear, mask " << bits;
  }
}

// 4.2.2 with blending and a logic operation: the mask is applied last.
TEST_F(FragmentOperations, ColorMaskAndBlending) {
  clearTo({0.2, 0.4, 0.6, 0.8});
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  setColor({0.2, 0.2, 0.2, 0.2});
  drawRect();
  EXPECT_PIXEL(32, 32, {0.2, 0.6, 0.6, 1});
  glDisable(GL_BLEND);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_INVERT);
  drawRect();
  EXPECT_PIXEL(32, 32, {0.2, 0.4, 0.6, 0});
}

// 4.1.8: without dithering a colour is the nearest of the framebuffer.
TEST_F(FragmentOperations, DitherOff) {
  glDisable(GL_DITHER);
  Cells cells;
  for (int i = 0; i < 256; ++i) {
    const double c = (i + 0.3) / 255;
    cells.add(
        fmt::format("{}.3", i), clamp01({i / 255.0, i / 255.0, i / 255.0, 1}),
        [&] {
          setColor({c, c, c, 1});
          drawRect();
        },
        0);
  }
}

class FragmentOperationsOn565 : public GlTest {
 protected:
  FragmentOperationsOn565() : GlTest({64, 64, 5, 6, 5, 0, 24, 8, 0}) {}
};

// 4.1.7: without alpha planes the destination alpha is 1, for reads (4.3.1) too.
TEST_F(FragmentOperationsOn565, DestinationAlphaIsOne) {
  glDisable(GL_DITHER);
  setColor({1, 1, 1, 0.25});
  drawRect();
  EXPECT_PIXEL(32, 32, {1, 1, 1, 1});
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ZERO);
  setColor({0, 1, 0, 0.5});
  drawRect();
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
  glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  setColor({1, 0, 0, 1});
  drawRect();
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
}

// 2.12.8, 4.3.1: colours are rounded to 5 and 6 bits and read back as c / 31 and c / 63.
TEST_F(FragmentOperationsOn565, Quantisation) {
  glDisable(GL_DITHER);
  Cells cells;
  for (int i = 0; i <= 64; ++i) {
    const double c = i / 64.0;
    if (std::abs(c * 31 - std::floor(c * 31) - 0.5) < 0.02 ||
        std::abs(c * 63 - std::floor(c * 63) - 0.5) < 0.02)
      continue;
    const Vec4 expected = {std::round(c * 31) / 31, std::round(c * 63) / 63, std::round(c * 31) / 31, 1};
    cells.add(fmt::format("{}", c), expected, [&] {
      setColor({c, c, c, 1});
      drawRect();
    });
  }
}

// 4.1.8: with dithering a colour is one of the two nearest.
TEST_F(FragmentOperationsOn565, Dither) {
  glEnable(GL_DITHER);
  setColor({0.49, 0.49, 0.49, 1});
  drawRect();
  const Image image = readAll();
  for (int i = 0; i < 64; ++i) {
    const Vec4 pixel = image.at(i, 63 - i);
    EXPECT_NEAR(pixel[0], 0.49, 1.0 / 31) << i;
    EXPECT_NEAR(pixel[1], 0.49, 1.0 / 63) << i;
  }
}

}  // namespace
}  // namespace conformance
