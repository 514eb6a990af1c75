// Sections 3.7.12 and 3.7.13: every environment mode x base format, and the combiner, against
// tables 3.14-3.19.
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <span>

#include "environment_reference.h"
#include "harness.h"

namespace conformance {
namespace {

class TextureEnvironment : public GlTest {};

struct Named {
  const char* name;
  GLenum value;
};
#define NAMED(constant) \
  Named {               \
#constant, constant \
  }

constexpr Named kFormats[] = {NAMED(GL_ALPHA), NAMED(GL_LUMINANCE), NAMED(GL_LUMINANCE_ALPHA), NAMED(GL_RGB),
                              NAMED(GL_RGBA)};

void setColor(const Vec4& c) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
}

void setEnvironmentColor(const Vec4& c) {
  const GLfloat values[] = {static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]),
                            static_cast<GLfloat>(c[2]), static_cast<GLfloat>(c[3])};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values);
}

// Tables 3.15, 3.16
TEST_F(TextureEnvironment, EveryModeAndFormat) {
  const Vec4 fragments[] = {{0.8, 0.3, 0.6, 0.5}, {1, 1, 1, 1}, {0, 0, 0, 0}, {0.9, 0.1, 0.5, 0.25}};
  const Texel texels[] = {{200, 100, 50, 150}, {0, 0, 0, 0}, {255, 255, 255, 255}, {30, 220, 130, 90}};
  const Vec4 constant = {0.25, 0.5, 0.75, 0.9};
  glEnable(GL_TEXTURE_2D);
  setEnvironmentColor(constant);
  Cells cells;
  for (const Named& format : kFormats) {
    for (const Texel& texel : texels) {
      solidTexture(format.value, texel);
      for (const Named& mode :
           {NAMED(GL_REPLACE), NAMED(GL_MODULATE), NAMED(GL_DECAL), NAMED(GL_BLEND), NAMED(GL_ADD)}) {
        // Table 3.15: undefined.
        if (mode.value == GL_DECAL && format.value != GL_RGB && format.value != GL_RGBA) continue;
        setEnvironment(GL_TEXTURE_ENV_MODE, mode.value);
        for (const Vec4& fragment : fragments) {
          const Vec4 expected =
              environment(mode.value, format.value, fragment, sourceColor(format.value, texel), constant);
          cells.add(
              fmt::format("{} {} fragment {} texel {}", mode.name, format.name, toString(fragment), texel[0]),
              expected, [&] {
                setColor(fragment);
                drawRect();
              });
        }
      }
    }
  }
}

constexpr GLenum kSources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
constexpr GLenum kColorOperands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                                     GL_ONE_MINUS_SRC_ALPHA};
constexpr GLenum kAlphaOperands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr GLenum kColorFunctions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                      GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
constexpr GLenum kAlphaFunctions[] = {GL_REPLACE,    GL_MODULATE,    GL_ADD,
                                      GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};

int arity(GLenum function) {
  return function == GL_REPLACE ? 1 : function == GL_INTERPOLATE ? 3 : 2;
}

std::string describe(const Combiner& c) {
  std::string text =
      fmt::format("functions {:#x} {:#x} scales {} {}", c.function[0], c.function[1], c.scale[0], c.scale[1]);
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < 3; ++i) text += fmt::format(" {:#x}/{:#x}", c.source[half][i], c.operand[half][i]);
  }
  return text;
}

// Draws combiners on unit 1, below which unit 0 replaces the fragment's colour, so that PREVIOUS differs from
// PRIMARY.
class CombinerBench {
 public:
  CombinerBench() {
    const Texel previous = {90, 140, 190, 120}, texture = {180, 60, 110, 200};
    inputs_.primary = {0.7, 0.45, 0.2, 0.6};
    inputs_.constant = {0.3, 0.85, 0.55, 0.35};
    inputs_.previous = sourceColor(GL_RGBA, previous);
    inputs_.texture = sourceColor(GL_RGBA, texture);
    glEnable(GL_TEXTURE_2D);
    solidTexture(GL_RGBA, previous);
    setEnvironment(GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    solidTexture(GL_RGBA, texture);
    setEnvironmentColor(inputs_.constant);
    setColor(inputs_.primary);
  }
  void add(const Combiner& combiner) {
    cells_.add(describe(combiner), combine(combiner, inputs_), [&] {
      apply(combiner);
      drawRect();
    });
  }

 private:
  Inputs inputs_;
  Cells cells_;
};

struct Argument {
  GLenum function;
  int slot;
  GLenum source, operand;
};

std::vector<Argument> everyArgument(std::span<const GLenum> functions, std::span<const GLenum> operands) {
  std::vector<Argument> list;
  for (GLenum function : functions) {
    for (int slot = 0; slot < arity(function); ++slot) {
      for (GLenum name : kSources) {
        for (GLenum operand : operands) list.push_back({function, slot, name, operand});
      }
    }
  }
  return list;
}

// Tables 3.17 x 3.18 and 3.19: every argument of every function runs over every source, operand and scale. A
// row tests an RGB and an alpha argument at once, since each state mix is a program to compile.
TEST_F(TextureEnvironment, EveryArgument) {
  CombinerBench bench;
  constexpr double scales[] = {1, 2, 4};
  const std::vector<Argument> colors = everyArgument(kColorFunctions, kColorOperands);
  const std::vector<Argument> alphas = everyArgument(kAlphaFunctions, kAlphaOperands);
  ASSERT_GT(colors.size(), alphas.size());
  for (std::size_t row = 0; row < colors.size() * std::size(scales); ++row) {
    const std::size_t i = row / std::size(scales);
    Combiner c;
    for (std::size_t half = 0; half < 2; ++half) {
      const Argument& argument = half == 0 ? colors[i] : alphas[i % alphas.size()];
      c.function[half] = argument.function;
      c.source[half][argument.slot] = argument.source;
      c.operand[half][argument.slot] = argument.operand;
    }
    // DOT3_RGBA ignores the alpha combiner, which that row then leaves to another (the list wraps around).
    c.scale[0] = scales[row % 3];
    c.scale[1] = scales[(row + i) % 3];
    bench.add(c);
  }
}

// 3.7.12: every function with every pair of scales.
TEST_F(TextureEnvironment, EveryScale) {
  CombinerBench bench;
  for (GLenum function : kColorFunctions) {
    for (double rgb : {1.0, 2.0, 4.0}) {
      for (double alpha : {1.0, 2.0, 4.0}) {
        Combiner c;
        c.function[0] = function;
        c.function[1] = GL_REPLACE;
        c.source[1][0] = GL_CONSTANT;
        c.scale[0] = rgb;
        c.scale[1] = alpha;
        bench.add(c);
      }
    }
  }
}

// Whole combiners drawn at random from the full product.
TEST_F(TextureEnvironment, RandomCombiners) {
  CombinerBench bench;
  std::mt19937 random(5);
  const auto pick = [&](const auto& list) { return list[random() % std::size(list)]; };
  constexpr double scales[] = {1, 2, 4};
  for (int i = 0; i < 60; ++i) {
    Combiner c;
    c.function[0] = pick(kColorFunctions);
    c.function[1] = pick(kAlphaFunctions);
    for (int slot = 0; slot < 3; ++slot) {
      c.source[0][slot] = pick(kSources);
      c.source[1][slot] = pick(kSources);
      c.operand[0][slot] = pick(kColorOperands);
      c.operand[1][slot] = pick(kAlphaOperands);
    }
    c.scale[0] = pick(scales);
    c.scale[1] = pick(scales);
    bench.add(c);
  }
}

// Table 3.14 under the combiner: the source colour of every base format.
TEST_F(TextureEnvironment, CombinerBaseFormats) {
  const Vec4 fragment = {0.8, 0.3, 0.6, 0.5};
  const Texel texel = {200, 100, 50, 150};
  glEnable(GL_TEXTURE_2D);
  setColor(fragment);
  Cells cells;
  for (const Named& format : kFormats) {
    solidTexture(format.value, texel);
    const Inputs in = {sourceColor(format.value, texel), {}, fragment, fragment};
    for (GLenum function : {GL_REPLACE, GL_ADD, GL_SUBTRACT, GL_DOT3_RGB}) {
      Combiner c;
      c.function[0] = static_cast<GLenum>(function);
      c.function[1] = GL_REPLACE;
      cells.add(fmt::format("{} function {:#x}", format.name, function), combine(c, in), [&] {
        apply(c);
        drawRect();
      });
    }
  }
}

// DOT3 at the ends of its range (NOTES on 3.7.12: scaled, then clamped).
TEST_F(TextureEnvironment, Dot3Extremes) {
  glEnable(GL_TEXTURE_2D);
  Cells cells;
  const Texel texels[] = {{255, 255, 255, 255}, {0, 0, 0, 255}, {255, 128, 128, 255}, {128, 128, 128, 255}};
  for (const Texel& texel : texels) {
    solidTexture(GL_RGBA, texel);
    for (const Vec4& fragment :
         {Vec4{1, 1, 1, 1}, Vec4{0, 0, 0, 1}, Vec4{0.5, 0.5, 1, 1}, Vec4{1, 0.5, 0.5, 0}}) {
      for (GLenum function : {GL_DOT3_RGB, GL_DOT3_RGBA}) {
        for (double scale : {1.0, 4.0}) {
          Combiner c;
          c.function[0] = static_cast<GLenum>(function);
          c.function[1] = GL_REPLACE;
          c.scale[0] = c.scale[1] = scale;
          const Inputs in = {sourceColor(GL_RGBA, texel), {}, fragment, fragment};
          // A scale of 4 magnifies the rounding of the interpolated colour.
          cells.add(fmt::format("texel {} fragment {} {:#x} scale {}", texel[0], toString(fragment), function,
                                scale),
                    combine(c, in), [&] {
                      setColor(fragment);
                      apply(c);
                      drawRect();
                    });
        }
      }
    }
  }
}

// 3.7.13: units in order; a disabled unit passes the fragment on; the last of them all takes part.
TEST_F(TextureEnvironment, UnitsInOrder) {
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  Vec4 expected = {1, 1, 1, 1};
  for (GLint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    const Texel texel = {GLubyte(250 - unit * 7), GLubyte(190 + unit * 5), 225, 240};
    solidTexture(GL_RGBA, texel);
    setEnvironment(GL_TEXTURE_ENV_MODE, unit == 2 ? GL_ADD : GL_MODULATE);
    if (unit == 1) continue;
    glEnable(GL_TEXTURE_2D);
    expected =
        environment(unit == 2 ? GL_ADD : GL_MODULATE, GL_RGBA, expected, sourceColor(GL_RGBA, texel), {});
  }
  drawRect();
  EXPECT_PIXEL(32, 32, expected);
}

// 3.7.12: texture functions work on values in [0, 1]: an overflow in one unit does not reach the next.
TEST_F(TextureEnvironment, ClampBetweenUnits) {
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {200, 200, 200, 255});
  setEnvironment(GL_TEXTURE_ENV_MODE, GL_ADD);
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {128, 128, 128, 255});
  Combiner subtract;
  subtract.function[0] = GL_SUBTRACT;
  subtract.source[0][0] = GL_PREVIOUS;
  subtract.source[0][1] = GL_TEXTURE;
  apply(subtract);
  setColor({0.9, 0.9, 0.9, 1});
  drawRect();
  EXPECT_PIXEL(32, 32, {1 - 128 / 255.0, 1 - 128 / 255.0, 1 - 128 / 255.0, 1});
  Combiner signedAdd;
  signedAdd.function[0] = GL_ADD_SIGNED;
  signedAdd.source[0][0] = GL_PREVIOUS;
  signedAdd.source[0][1] = GL_CONSTANT;
  signedAdd.scale[0] = 4;
  setEnvironmentColor({0, 0, 0, 0});
  apply(signedAdd);
  glActiveTexture(GL_TEXTURE2);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {51, 51, 51, 255});
  setEnvironment(GL_TEXTURE_ENV_MODE, GL_MODULATE);
  drawRect();
  EXPECT_PIXEL(32, 32, {0.2, 0.2, 0.2, 1});
}

// Four stages with a scale of 4 (extremes of 3.7.12).
TEST_F(TextureEnvironment, ChainedScales) {
  Vec4 expected = {1 / 255.0, 2 / 255.0, 0, 1 / 255.0};
  setColor(expected);
  for (GLenum unit = 0; unit < 4; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glEnable(GL_TEXTURE_2D);
    solidTexture(GL_RGBA, {255, 255, 255, 255});
    Combiner c;
    c.scale[0] = c.scale[1] = 4;
    apply(c);
    expected = combine(c, {{1, 1, 1, 1}, {}, {}, expected});
  }
  drawRect();
  EXPECT_PIXEL(32, 32, expected);
}

}  // namespace
}  // namespace conformance
