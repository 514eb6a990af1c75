// ATI_texture_env_combine3, ATIX_texture_env_combine3, ATIX_texture_env_route, EXT_texture_env_dot3,
// IMG_texture_env_enhanced_fixed_function, IMG_user_clip_plane.
#include <fmt/format.h>

#include <cmath>

#include "ati.h"
#include "environment_reference.h"
#include "extension_commands.h"

namespace conformance {
namespace {

class CombinerExtensions : public GlTest {};

const Vec4 kFragment = {0.7, 0.45, 0.2, 0.6}, kConstant = {0.3, 0.85, 0.55, 0.35};
const Texel kFirst = {90, 140, 190, 120}, kSecond = {180, 60, 110, 200}, kThird = {40, 220, 130, 250};

void setColor(const Vec4& c) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
}

// Unit `unit`, on, with one texel of RGBA, and kConstant.
void texture(GLenum unit, const Texel& texel, GLenum format = GL_RGBA) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glEnable(GL_TEXTURE_2D);
  solidTexture(format, texel);
  const GLfloat constant[] = {0.3f, 0.85f, 0.55f, 0.35f};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
}

// The combiner that replaces color and alpha by `source`.
Combiner replaceBy(GLenum source) {
  Combiner c;
  for (std::size_t half : {0u, 1u}) {
    c.function[half] = GL_REPLACE;
    c.source[half][0] = source;
  }
  return c;
}

GLint environmentValue(GLenum name) {
  GLint value = -1;
  glGetTexEnviv(GL_TEXTURE_ENV, name, &value);
  return value;
}

// Two units: the first replaces the fragment, the second has the combiner under test.
class TwoUnits {
 public:
  TwoUnits() {
    texture(0, kFirst);
    setEnvironment(GL_TEXTURE_ENV_MODE, GL_REPLACE);
    texture(1, kSecond);
    setColor(kFragment);
    inputs_ = {sourceColor(GL_RGBA, kSecond), kConstant, kFragment, sourceColor(GL_RGBA, kFirst)};
  }
  void add(const std::string& name, const Combiner& combiner) {
    cells_.add(name, combine(combiner, inputs_), [&] {
      apply(combiner);
      drawRect();
    });
  }

 private:
  Inputs inputs_;
  Cells cells_;
};

constexpr GLenum kSources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_ZERO, GL_ONE};
constexpr GLenum kColorOperands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                                     GL_ONE_MINUS_SRC_ALPHA};

// ATI_texture_env_combine3, table 3.20: each new function, with every source and operand at every argument.
TEST_F(CombinerExtensions, EveryArgumentOfTheNewFunctions) {
  NEEDS_EXTENSION("GL_ATI_texture_env_combine3");
  NEEDS_EXTENSION("GL_ATIX_texture_env_combine3");
  TwoUnits bench;
  int row = 0;
  for (GLenum function : {GL_MODULATE_ADD_ATI, GL_MODULATE_SIGNED_ADD_ATI, GL_MODULATE_SUBTRACT_ATI})
    for (std::size_t argument = 0; argument < 3; ++argument)
      for (GLenum source : kSources)
        for (std::size_t operand = 0; operand < 4; ++operand) {
          Combiner c;
          c.function[0] = c.function[1] = static_cast<GLenum>(function);
          c.source[0][argument] = c.source[1][argument] = source;
          c.operand[0][argument] = kColorOperands[operand];
          c.operand[1][argument] = operand % 2 == 0 ? GL_SRC_ALPHA : GL_ONE_MINUS_SRC_ALPHA;
          c.scale[0] = 1 << row % 3;
          c.scale[1] = 1 << row / 3 % 3;
          ++row;
          bench.add(
              fmt::format("{:#x} argument {} source {:#x} operand {}", function, argument, source, operand),
              c);
        }
}

// ATI_texture_env_combine3, tables 3.21 and 3.22: ZERO and ONE under the functions of the core.
TEST_F(CombinerExtensions, ZeroAndOneAsSources) {
  NEEDS_EXTENSION("GL_ATI_texture_env_combine3");
  TwoUnits bench;
  for (GLenum function : {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT})
    for (std::size_t argument = 0; argument < 3; ++argument)
      for (GLenum source : {GL_ZERO, GL_ONE})
        for (std::size_t operand : {0u, 1u}) {
          Combiner c;
          c.function[0] = c.function[1] = static_cast<GLenum>(function);
          c.source[0][argument] = c.source[1][argument] = static_cast<GLenum>(source);
          c.operand[0][argument] = kColorOperands[operand];
          c.operand[1][argument] = kColorOperands[operand + 2];
          bench.add(
              fmt::format("{:#x} argument {} source {} operand {}", function, argument, source, operand), c);
        }
}

// EXT_texture_env_dot3: 4 times the dot product, whatever the scales; the alpha combiner's own scale stays.
TEST_F(CombinerExtensions, Dot3IsNotScaled) {
  NEEDS_EXTENSION("GL_EXT_texture_env_dot3");
  const Texel texel = {170, 110, 150, 200};
  texture(0, texel);
  setColor(kFragment);
  const Vec4 t = sourceColor(GL_RGBA, texel);
  double dot = 0;
  for (std::size_t i = 0; i < 3; ++i) dot += 4 * (t[i] - 0.5) * (kFragment[i] - 0.5);
  Cells cells;
  for (double scale : {1.0, 2.0, 4.0})
    for (GLenum function : {GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT}) {
      Combiner c;
      c.function[0] = static_cast<GLenum>(function);
      c.scale[0] = c.scale[1] = scale;
      const double alpha = function == GL_DOT3_RGBA_EXT ? dot : t[3] * kFragment[3] * scale;
      cells.add(fmt::format("{:#x} scale {}", function, scale), clamp01({dot, dot, dot, alpha}), [&] {
        apply(c);
        drawRect();
      });
    }
}

// IMG_texture_env_enhanced_fixed_function, Table 3.24: every mode with every base format.
TEST_F(CombinerExtensions, EnhancedModesOfEveryFormat) {
  NEEDS_EXTENSION("GL_IMG_texture_env_enhanced_fixed_function");
  const Texel texel = {170, 110, 150, 200};
  const Vec4 f = kFragment;
  setColor(f);
  Cells cells;
  for (GLenum format : {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA}) {
    texture(0, texel, static_cast<GLenum>(format));
    const Vec4 s = sourceColor(static_cast<GLenum>(format), texel);
    const bool alphaOnly = format == GL_ALPHA, hasAlpha = format != GL_LUMINANCE && format != GL_RGB;
    const auto add = [&](GLenum mode, const auto& color, double alpha) {
      Vec4 expected{};
      for (std::size_t i = 0; i < 3; ++i) expected[i] = color(i);
      expected[3] = alpha;
      cells.add(fmt::format("mode {:#x} format {:#x}", mode, format), clamp01(expected), [&] {
        setEnvironment(GL_TEXTURE_ENV_MODE, mode);
        EXPECT_EQ(environmentValue(GL_TEXTURE_ENV_MODE), static_cast<GLint>(mode));
        drawRect();
      });
    };
    add(
        GL_MODULATE_COLOR_IMG, [&](std::size_t i) { return alphaOnly ? f[i] : f[i] * s[i]; },
        hasAlpha ? s[3] : f[3]);
    add(
        GL_RECIP_ADD_SIGNED_ALPHA_IMG, [&](std::size_t i) { return f[i]; },
        hasAlpha ? 1 - s[3] + f[3] - 0.5 : f[3] - 0.5);
    add(
        GL_TEXTURE_ALPHA_MODULATE_IMG,
        [&](std::size_t i) { return alphaOnly  ? 0
                                    : hasAlpha ? s[3] * s[i]
                                               : s[i]; }, hasAlpha ? s[3] : 1);
    add(
        GL_FACTOR_ALPHA_MODULATE_IMG, [&](std::size_t i) { return alphaOnly ? 0 : kConstant[3] * s[i]; },
        kConstant[3]);
    add(
        GL_FRAGMENT_ALPHA_MODULATE_IMG, [&](std::size_t i) { return alphaOnly ? 0 : f[3] * s[i]; }, f[3]);
    add(
        GL_ADD_BLEND_IMG, [&](std::size_t i) { return alphaOnly ? f[i] : f[i] + (1 - f[3]) * s[i]; },
        hasAlpha ? f[3] * s[3] : f[3]);
    if (format != GL_RGB && format != GL_RGBA) continue;
    double dot = 0;
    for (std::size_t i = 0; i < 3; ++i) dot += 4 * (f[i] - 0.5) * (s[i] - 0.5);
    add(
        GL_DOT3_RGBA_IMG, [&](std::size_t) { return dot; }, dot);
  }
}

// ATIX_texture_env_route: unit 0's result in the place of unit 2's texture, color and alpha apart.
TEST_F(CombinerExtensions, RoutedResults) {
  NEEDS_EXTENSION("GL_ATIX_texture_env_route");
  setColor(kFragment);
  texture(0, kFirst);
  apply(replaceBy(GL_TEXTURE));
  texture(1, kSecond);
  apply(replaceBy(GL_TEXTURE));
  texture(2, kThird);
  apply(replaceBy(GL_TEXTURE2));
  const Vec4 first = sourceColor(GL_RGBA, kFirst), third = sourceColor(GL_RGBA, kThird);
  Cells cells;
  const auto expect = [&](const char* name, const Vec4& expected) {
    cells.add(name, expected, [] { drawRect(); });
  };
  const auto route = [](GLenum rgb, GLenum alpha) {
    glActiveTexture(GL_TEXTURE0);
    setEnvironment(GL_TEXTURE_OUTPUT_RGB_ATIX, rgb);
    setEnvironment(GL_TEXTURE_OUTPUT_ALPHA_ATIX, alpha);
  };
  expect("nothing routed", third);
  route(GL_TEXTURE2, GL_TEXTURE0);
  expect("color", {first[0], first[1], first[2], third[3]});
  route(GL_TEXTURE0, GL_TEXTURE2);
  expect("alpha", {third[0], third[1], third[2], first[3]});
  route(GL_TEXTURE2, GL_TEXTURE2);
  expect("both", first);
  route(GL_TEXTURE5, GL_TEXTURE5);
  expect("to another unit", third);
  glActiveTexture(GL_TEXTURE2);
  apply(replaceBy(GL_TEXTURE5));
  expect("a unit without a texture", first);
  setEnvironment(GL_TEXTURE_ENV_MODE, GL_REPLACE);
  route(GL_TEXTURE2, GL_TEXTURE2);
  expect("a fixed mode reads the texture", third);
  glActiveTexture(GL_TEXTURE2);
  Combiner c = replaceBy(GL_TEXTURE);
  apply(c);
  expect("TEXTURE on the unit itself", first);
  glActiveTexture(GL_TEXTURE1);
  setEnvironment(GL_TEXTURE_OUTPUT_RGB_ATIX, GL_TEXTURE2);
  const Vec4 second = sourceColor(GL_RGBA, kSecond);
  expect("the last of two", {second[0], second[1], second[2], first[3]});
  glDisable(GL_TEXTURE_2D);
  expect("a unit that is off routes nothing", first);
}

TEST_F(CombinerExtensions, RoutesAreQueriedAndChecked) {
  NEEDS_EXTENSION("GL_ATIX_texture_env_route");
  for (GLenum unit = 0; unit < 3; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (GLenum name : {GL_TEXTURE_OUTPUT_RGB_ATIX, GL_TEXTURE_OUTPUT_ALPHA_ATIX}) {
      EXPECT_EQ(environmentValue(name), static_cast<GLint>(GL_TEXTURE0 + unit));
      setEnvironment(name, GL_TEXTURE3);
      EXPECT_EQ(environmentValue(name), GL_TEXTURE3);
      EXPECT_GL_ERROR(GL_NO_ERROR);
      for (GLenum wrong : {GL_TEXTURE, GL_PREVIOUS, GL_TEXTURE0 + 8, GL_TEXTURE0 - 1}) {
        setEnvironment(name, static_cast<GLenum>(wrong));
        EXPECT_GL_ERROR(GL_INVALID_ENUM);
      }
      EXPECT_EQ(environmentValue(name), GL_TEXTURE3);
    }
  }
}

// The fog factor as an alpha, with FOG on and off; the secondary color, which ES 1.1 has not.
TEST_F(CombinerExtensions, FogAndSecondaryColorAsSources) {
  NEEDS_EXTENSION("GL_ATIX_texture_env_route");
  texture(0, kFirst);
  setColor(kFragment);
  glFogx(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 2);
  const GLfloat fogColor[] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, fogColor);
  Combiner c;
  c.function[0] = c.function[1] = GL_REPLACE;
  c.source[0][0] = GL_SECONDARY_COLOR_ATIX;
  c.source[1][0] = GL_FOG;
  constexpr GLfloat kDeep[] = {-1, -1, -0.5f, 1, -1, -0.5f, -1, 1, -0.5f, 1, 1, -0.5f};
  const auto draw = [&] {
    apply(c);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kDeep);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  Cells cells;
  cells.add("fog off", {0, 0, 0, 0.75}, draw);
  glFogx(GL_FOG_MODE, GL_EXP);
  glFogf(GL_FOG_DENSITY, 1.5f);
  cells.add("exponential", {0, 0, 0, std::exp(-0.75)}, draw);
  glFogx(GL_FOG_MODE, GL_EXP2);
  cells.add("squared", {0, 0, 0, std::exp(-0.5625)}, draw);
  glEnable(GL_FOG);
  cells.add("fog on", {0, 1 - std::exp(-0.5625), 0, std::exp(-0.5625)}, draw);
  c.operand[0][0] = GL_ONE_MINUS_SRC_COLOR;
  c.operand[1][0] = GL_ONE_MINUS_SRC_ALPHA;
  glDisable(GL_FOG);
  cells.add("complements", {1, 1, 1, 1 - std::exp(-0.5625)}, draw);
}

// Each of the new names only where its text allows it.
TEST_F(CombinerExtensions, NamesInTheWrongPlace) {
  const struct {
    GLenum name, value;
  } kWrong[] = {{GL_COMBINE_ALPHA, GL_DOT3_RGB_EXT},
                {GL_COMBINE_ALPHA, GL_DOT3_RGBA_EXT},
                {GL_SRC0_ALPHA, GL_SECONDARY_COLOR_ATIX},
                {GL_SRC0_RGB, GL_FOG},
                {GL_TEXTURE_ENV_MODE, GL_MODULATE_ADD_ATI},
                {GL_COMBINE_RGB, GL_ADD_BLEND_IMG},
                {GL_OPERAND0_RGB, GL_ZERO},
                {GL_COMBINE_RGB, GL_MODULATE_SUBTRACT_ATI + 1}};
  for (const auto& wrong : kWrong) {
    const GLint before = environmentValue(wrong.name);
    setEnvironment(wrong.name, wrong.value);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    EXPECT_EQ(environmentValue(wrong.name), before);
  }
}

// IMG_user_clip_plane: the same planes under their first names.
TEST_F(CombinerExtensions, ClipPlanesByTheirFirstNames) {
  NEEDS_EXTENSION("GL_IMG_user_clip_plane");
  COMMAND(PFNGLCLIPPLANEFIMGPROC, ClipPlanefIMG);
  COMMAND(PFNGLCLIPPLANEXIMGPROC, ClipPlanexIMG);
  GLint planes = 0;
  glGetIntegerv(GL_MAX_CLIP_PLANES_IMG, &planes);
  EXPECT_GE(planes, 6);
  const GLfloat right[] = {1, 0, 0, 0};
  const GLfixed upper[] = {0, 65536, 0, 0};
  ClipPlanefIMG(GL_CLIP_PLANE0_IMG, right);
  ClipPlanexIMG(GL_CLIP_PLANE5_IMG, upper);
  glEnable(GL_CLIP_PLANE0_IMG);
  glEnable(GL_CLIP_PLANE5_IMG);
  GLfloat stored[4];
  glGetClipPlanef(GL_CLIP_PLANE5_IMG, stored);
  EXPECT_EQ(stored[1], 1);
  glColor4f(0, 1, 0, 1);
  drawRect();
  EXPECT_PIXEL(48, 48, (Vec4{0, 1, 0, 1}));
  EXPECT_PIXEL(16, 48, (Vec4{0, 0, 0, 0}));
  EXPECT_PIXEL(48, 16, (Vec4{0, 0, 0, 0}));
  ClipPlanefIMG(GL_CLIP_PLANE0_IMG + static_cast<GLenum>(planes), right);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  ClipPlanexIMG(GL_CLIP_PLANE0_IMG - 1, upper);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

}  // namespace
}  // namespace conformance
