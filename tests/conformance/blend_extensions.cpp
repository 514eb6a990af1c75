// OES_blend_subtract, OES_blend_func_separate, OES_blend_equation_separate, EXT_blend_minmax,
// OES_stencil_wrap.
#include <fmt/format.h>

#include <algorithm>

#include "extension_commands.h"

namespace conformance {
namespace {

class BlendExtensions : public GlTest {};

constexpr GLenum kDestinationFactors[] = {GL_ZERO,      GL_ONE,
                                          GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
                                          GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR,
                                          GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
                                          GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};
constexpr GLenum kEquations[] = {GL_FUNC_ADD_OES, GL_FUNC_SUBTRACT_OES, GL_FUNC_REVERSE_SUBTRACT_OES,
                                 GL_MIN_EXT, GL_MAX_EXT};
constexpr Vec4 kSource = {0.2, 0.6, 1, 0.4}, kDestination = {0.8, 0.4, 0.2, 0.6};

double factor(GLenum name, std::size_t i) {
  const Vec4 &s = kSource, &d = kDestination;
  switch (name) {
    case GL_ZERO:
      return 0;
    case GL_ONE:
      return 1;
    case GL_SRC_COLOR:
      return s[i];
    case GL_ONE_MINUS_SRC_COLOR:
      return 1 - s[i];
    case GL_DST_COLOR:
      return d[i];
    case GL_ONE_MINUS_DST_COLOR:
      return 1 - d[i];
    case GL_SRC_ALPHA:
      return s[3];
    case GL_ONE_MINUS_SRC_ALPHA:
      return 1 - s[3];
    case GL_DST_ALPHA:
      return d[3];
    case GL_ONE_MINUS_DST_ALPHA:
      return 1 - d[3];
    default:
      return i == 3 ? 1 : std::min(s[3], 1 - d[3]);
  }
}

double blended(GLenum equation, GLenum source, GLenum destination, std::size_t i) {
  const double s = kSource[i], d = kDestination[i];
  const double ws = s * factor(source, i), wd = d * factor(destination, i);
  switch (equation) {
    case GL_FUNC_SUBTRACT_OES:
      return ws - wd;
    case GL_FUNC_REVERSE_SUBTRACT_OES:
      return wd - ws;
    case GL_MIN_EXT:
      return std::min(s, d);
    case GL_MAX_EXT:
      return std::max(s, d);
    default:
      return ws + wd;
  }
}

void setColor(const Vec4& c) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
}

void drawBlended() {
  glDisable(GL_BLEND);
  setColor(kDestination);
  drawRect();
  glEnable(GL_BLEND);
  setColor(kSource);
  drawRect();
}

GLint get(GLenum name) {
  GLint value = -1;
  glGetIntegerv(name, &value);
  return value;
}

// Every pair of equations, under factors that differ between color and alpha and between source and
// destination.
TEST_F(BlendExtensions, Equations) {
  NEEDS_EXTENSION("GL_OES_blend_subtract");
  NEEDS_EXTENSION("GL_OES_blend_func_separate");
  NEEDS_EXTENSION("GL_OES_blend_equation_separate");
  NEEDS_EXTENSION("GL_EXT_blend_minmax");
  COMMAND(PFNGLBLENDFUNCSEPARATEOESPROC, BlendFuncSeparateOES);
  COMMAND(PFNGLBLENDEQUATIONSEPARATEOESPROC, BlendEquationSeparateOES);
  BlendFuncSeparateOES(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_DST_ALPHA);
  Cells cells;
  for (const GLenum rgb : kEquations) {
    for (const GLenum alpha : kEquations) {
      Vec4 expected{};
      for (std::size_t i = 0; i < 3; ++i) {
        expected[i] = blended(rgb, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, i);
      }
      expected[3] = blended(alpha, GL_ONE, GL_DST_ALPHA, 3);
      cells.add(
          fmt::format("{:#x} {:#x}", rgb, alpha), clamp01(expected),
          [&] {
            BlendEquationSeparateOES(rgb, alpha);
            drawBlended();
          },
          std::max(kOneStep, driverError("blending")));
    }
  }
  cells.check();
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// One command sets both equations.
TEST_F(BlendExtensions, OneEquationForBoth) {
  NEEDS_EXTENSION("GL_OES_blend_subtract");
  COMMAND(PFNGLBLENDEQUATIONOESPROC, BlendEquationOES);
  glBlendFunc(GL_ONE, GL_ONE);
  Cells cells;
  for (const GLenum equation : kEquations) {
    Vec4 expected{};
    for (std::size_t i = 0; i < 4; ++i) expected[i] = blended(equation, GL_ONE, GL_ONE, i);
    cells.add(fmt::format("{:#x}", equation), clamp01(expected), [&] {
      BlendEquationOES(equation);
      EXPECT_EQ(static_cast<GLenum>(get(GL_BLEND_EQUATION_OES)), equation);
      EXPECT_EQ(static_cast<GLenum>(get(GL_BLEND_EQUATION_ALPHA_OES)), equation);
      drawBlended();
    });
  }
  cells.check();
}

TEST_F(BlendExtensions, SeparateFactors) {
  MESA_DISAGREES("OES_blend_func_separate", "SRC_COLOR and DST_COLOR stay legal on one side only");
  NEEDS_EXTENSION("GL_OES_blend_func_separate");
  COMMAND(PFNGLBLENDFUNCSEPARATEOESPROC, BlendFuncSeparateOES);
  Cells cells;
  const auto row = [&](GLenum srcRgb, GLenum dstRgb, GLenum srcAlpha, GLenum dstAlpha) {
    Vec4 expected{};
    for (std::size_t i = 0; i < 3; ++i) expected[i] = blended(GL_FUNC_ADD_OES, srcRgb, dstRgb, i);
    expected[3] = blended(GL_FUNC_ADD_OES, srcAlpha, dstAlpha, 3);
    cells.add(
        fmt::format("{:#x} {:#x} {:#x} {:#x}", srcRgb, dstRgb, srcAlpha, dstAlpha), clamp01(expected),
        [&] {
          BlendFuncSeparateOES(srcRgb, dstRgb, srcAlpha, dstAlpha);
          drawBlended();
        },
        std::max(kOneStep, driverError("blending")));
  };
  for (const GLenum source : kDestinationFactors) {
    for (const GLenum destination : kDestinationFactors) {
      row(source, destination, GL_ONE, GL_ZERO);
      row(GL_ZERO, GL_ONE, source, destination);
    }
    row(GL_SRC_ALPHA_SATURATE, source, GL_SRC_ALPHA_SATURATE, source);
  }
  cells.check();
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// OES_blend_func_separate replaces the text of 4.1.7 for BlendFunc, too: the same factors are taken.
TEST_F(BlendExtensions, FactorsOfBothForColorAndAlpha) {
  MESA_DISAGREES("OES_blend_func_separate", "SRC_COLOR and DST_COLOR stay legal on one side only");
  NEEDS_EXTENSION("GL_OES_blend_func_separate");
  Cells cells;
  const auto row = [&](GLenum source, GLenum destination) {
    Vec4 expected{};
    for (std::size_t i = 0; i < 4; ++i) expected[i] = blended(GL_FUNC_ADD_OES, source, destination, i);
    cells.add(
        fmt::format("{:#x} {:#x}", source, destination), clamp01(expected),
        [&] {
          glBlendFunc(source, destination);
          drawBlended();
        },
        std::max(kOneStep, driverError("blending")));
  };
  for (const GLenum destination : kDestinationFactors) {
    for (const GLenum source : kDestinationFactors) row(source, destination);
    row(GL_SRC_ALPHA_SATURATE, destination);
  }
  cells.check();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glBlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

TEST_F(BlendExtensions, StateAndErrors) {
  NEEDS_EXTENSION("GL_OES_blend_func_separate");
  NEEDS_EXTENSION("GL_OES_blend_equation_separate");
  COMMAND(PFNGLBLENDFUNCSEPARATEOESPROC, BlendFuncSeparateOES);
  COMMAND(PFNGLBLENDEQUATIONSEPARATEOESPROC, BlendEquationSeparateOES);
  EXPECT_EQ(get(GL_BLEND_SRC_RGB_OES), GL_ONE);
  EXPECT_EQ(get(GL_BLEND_DST_ALPHA_OES), GL_ZERO);
  EXPECT_EQ(get(GL_BLEND_EQUATION_RGB_OES), GL_FUNC_ADD_OES);
  EXPECT_EQ(get(GL_BLEND_EQUATION_ALPHA_OES), GL_FUNC_ADD_OES);

  BlendFuncSeparateOES(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  BlendEquationSeparateOES(GL_FUNC_SUBTRACT_OES, GL_FUNC_REVERSE_SUBTRACT_OES);
  EXPECT_EQ(get(GL_BLEND_SRC_RGB_OES), GL_DST_ALPHA);
  EXPECT_EQ(get(GL_BLEND_DST_RGB_OES), GL_ONE_MINUS_DST_ALPHA);
  EXPECT_EQ(get(GL_BLEND_SRC_ALPHA_OES), GL_SRC_ALPHA);
  EXPECT_EQ(get(GL_BLEND_DST_ALPHA_OES), GL_ONE_MINUS_SRC_ALPHA);
  EXPECT_EQ(get(GL_BLEND_SRC), GL_DST_ALPHA);
  EXPECT_EQ(get(GL_BLEND_DST), GL_ONE_MINUS_DST_ALPHA);
  EXPECT_EQ(get(GL_BLEND_EQUATION_RGB_OES), GL_FUNC_SUBTRACT_OES);
  EXPECT_EQ(get(GL_BLEND_EQUATION_ALPHA_OES), GL_FUNC_REVERSE_SUBTRACT_OES);
  EXPECT_GL_ERROR(GL_NO_ERROR);

  // An error changes nothing, whichever argument it is in.
  for (const GLenum bad : {GLenum{GL_SRC_ALPHA_SATURATE}, GLenum{0x8001}}) {
    BlendFuncSeparateOES(GL_ONE, bad, GL_ONE, GL_ONE);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    BlendFuncSeparateOES(GL_ONE, GL_ONE, GL_ONE, bad);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
  }
  BlendEquationSeparateOES(GL_FUNC_ADD_OES, GL_ADD);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  BlendEquationSeparateOES(GL_LOGIC_OP_MODE, GL_FUNC_ADD_OES);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(get(GL_BLEND_DST_RGB_OES), GL_ONE_MINUS_DST_ALPHA);
  EXPECT_EQ(get(GL_BLEND_EQUATION_RGB_OES), GL_FUNC_SUBTRACT_OES);

  // BlendFunc sets all four.
  glBlendFunc(GL_ONE, GL_ZERO);
  EXPECT_EQ(get(GL_BLEND_SRC_ALPHA_OES), GL_ONE);
  EXPECT_EQ(get(GL_BLEND_DST_ALPHA_OES), GL_ZERO);
}

// Values wrap at both ends instead of being held there; found with EQUAL tests.
TEST_F(BlendExtensions, StencilWrap) {
  NEEDS_EXTENSION("GL_OES_stencil_wrap");
  const struct {
    GLenum op;
    int from, to;
  } rows[] = {{GL_INCR, 255, 255}, {GL_INCR_WRAP_OES, 255, 0}, {GL_INCR_WRAP_OES, 7, 8},
              {GL_DECR, 0, 0},     {GL_DECR_WRAP_OES, 0, 255}, {GL_DECR_WRAP_OES, 8, 7}};
  glEnable(GL_STENCIL_TEST);
  for (const auto& row : rows) {
    glClearStencil(row.from);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOp(row.op, row.op, row.op);
    EXPECT_EQ(static_cast<GLenum>(get(GL_STENCIL_FAIL)), row.op);
    drawRect();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_EQUAL, row.to, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glColor4f(0, 1, 0, 1);
    drawRect();
    EXPECT_PIXEL(32, 32, {0, 1, 0, 1}) << fmt::format("{:#x} {}", row.op, row.from);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
