// Every texture environment that a program can set compiles.
#include <gtest/gtest.h>

#include <set>

#include "tests/gen/states.h"
#include "tests/gen/validated.h"

namespace anteroom::gen {
namespace {

constexpr GLenum kFormats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
constexpr GLenum kSources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_TEXTURE5,
                               GL_ZERO,    GL_ONE};
constexpr GLenum kOperands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr GLenum kAlphaOperands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr GLenum kFunctions[] = {GL_REPLACE,     GL_MODULATE,        GL_ADD,           GL_ADD_SIGNED,
                                 GL_INTERPOLATE, GL_SUBTRACT,        GL_DOT3_RGB,      GL_DOT3_RGBA,
                                 kModulateAdd,   kModulateSignedAdd, kModulateSubtract};

int argumentsOf(GLenum function) {
  return function == GL_REPLACE ? 1 : function == GL_INTERPOLATE || function >= kModulateAdd ? 3 : 2;
}

class Compiled {
 public:
  void expect(const State& state) {
    const std::string glsl = emitFragment(canonicaliseFragment(state, {}));
    if (!seen_.insert(glsl).second) return;
    expectCompiles(Stage::Fragment, glsl);
  }
  size_t count() const { return seen_.size(); }

 private:
  std::set<std::string> seen_;
};

TEST(Combiners, EveryModeWithEveryBaseFormat) {
  Compiled compiled;
  for (GLenum mode :
       {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE, GL_MODULATE_COLOR_IMG,
        GL_RECIP_ADD_SIGNED_ALPHA_IMG, GL_TEXTURE_ALPHA_MODULATE_IMG, GL_FACTOR_ALPHA_MODULATE_IMG,
        GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_ADD_BLEND_IMG, GL_DOT3_RGBA_IMG})
    for (GLenum format : kFormats)
      for (TextureTarget target :
           {TextureTarget::Texture2D, TextureTarget::CubeMap, TextureTarget::Texture3D}) {
        State state = texturedState(format);
        state.units[0].env.mode = mode;
        state.units[0].target = target;
        compiled.expect(state);
      }
  EXPECT_GT(compiled.count(), 20u);
}

// Two units, so that PREVIOUS is not the primary color; the second has the combiner. Each function gets every
// source and operand at every argument; the other arguments walk along, so that combinations meet too.
void eachArgument(bool alpha, auto visit) {
  for (GLenum function : kFunctions) {
    if (alpha && (function == GL_DOT3_RGB || function == GL_DOT3_RGBA)) continue;
    for (float scale : {1.0f, 2.0f, 4.0f})
      for (int argument = 0; argument < argumentsOf(function); ++argument)
        for (size_t source = 0; source < std::size(kSources); ++source)
          for (size_t operand = 0; operand < (alpha ? std::size(kAlphaOperands) : std::size(kOperands));
               ++operand)
            visit(function, scale, argument, source, operand);
  }
}

State twoUnits() {
  State state = texturedState(GL_RGBA, 6);
  for (int u = 2; u < 5; ++u) state.units[u].target = TextureTarget::None;
  state.units[1].env.mode = GL_COMBINE;
  state.units[5].env.mode = GL_COMBINE;  // passes on
  state.units[5].env.combineRgb = state.units[5].env.combineAlpha = GL_REPLACE;
  state.units[5].env.srcRgb[0] = state.units[5].env.srcAlpha[0] = GL_PREVIOUS;
  return state;
}

TEST(Combiners, EveryColorFunctionSourceOperandAndScale) {
  Compiled compiled;
  eachArgument(false, [&](GLenum function, float scale, int argument, size_t source, size_t operand) {
    State state = twoUnits();
    TextureEnv& env = state.units[1].env;
    env.combineRgb = function;
    env.rgbScale = scale;
    env.alphaScale = function == GL_DOT3_RGBA ? 2 : 1;
    for (int i = 0; i < 3; ++i) {
      env.srcRgb[i] = kSources[(source + (i - argument + 3) * 2) % std::size(kSources)];
      env.operandRgb[i] = kOperands[(operand + (i - argument + 3) * 3) % std::size(kOperands)];
    }
    env.srcRgb[argument] = kSources[source];
    env.operandRgb[argument] = kOperands[operand];
    compiled.expect(state);
  });
  EXPECT_GT(compiled.count(), 400u);
}

TEST(Combiners, EveryAlphaFunctionSourceOperandAndScale) {
  Compiled compiled;
  eachArgument(true, [&](GLenum function, float scale, int argument, size_t source, size_t operand) {
    State state = twoUnits();
    TextureEnv& env = state.units[1].env;
    env.combineAlpha = function;
    env.alphaScale = scale;
    for (int i = 0; i < 3; ++i) {
      env.srcAlpha[i] = kSources[(source + (i - argument + 3) * 2) % std::size(kSources)];
      env.operandAlpha[i] = kAlphaOperands[(operand + i) % 2];
    }
    env.srcAlpha[argument] = kSources[source];
    env.operandAlpha[argument] = kAlphaOperands[operand];
    compiled.expect(state);
  });
  EXPECT_GT(compiled.count(), 150u);
}

// Textures that lack color or alpha turn arguments into 0 and 1, which fold.
TEST(Combiners, MissingComponentsFold) {
  const auto text = [](GLenum format, GLenum function, GLenum operand) {
    State state = texturedState(format);
    TextureEnv& env = state.units[0].env;
    env.mode = GL_COMBINE;
    env.combineRgb = function;
    env.operandRgb[0] = operand;
    env.combineAlpha = GL_REPLACE;
    env.srcAlpha[0] = GL_PREVIOUS;
    return describe(keysOf(state).fragment);
  };
  const std::string untouched = "fragment";
  EXPECT_EQ(text(GL_RGB, GL_MODULATE, GL_SRC_ALPHA), untouched);
  EXPECT_EQ(text(GL_ALPHA, GL_MODULATE, GL_ONE_MINUS_SRC_COLOR), untouched);
  EXPECT_EQ(text(GL_ALPHA, GL_ADD, GL_SRC_COLOR), untouched);
  EXPECT_EQ(text(GL_ALPHA, GL_REPLACE, GL_SRC_COLOR), "fragment rgb0=replace(0)");
  EXPECT_EQ(text(GL_LUMINANCE, GL_ADD, GL_SRC_ALPHA), "fragment rgb0=replace(1)");
  EXPECT_EQ(text(GL_LUMINANCE, GL_MODULATE, GL_ONE_MINUS_SRC_ALPHA), "fragment rgb0=replace(0)");
  EXPECT_EQ(text(GL_RGBA, GL_MODULATE, GL_SRC_ALPHA),
            "fragment unit0=2d read0=st rgb0=modulate(previous,texture0.a)");
}

}  // namespace
}  // namespace anteroom::gen
