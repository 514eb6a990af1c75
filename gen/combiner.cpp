#include "gen/combiner.h"

#include <utility>

namespace anteroom::gen {
namespace {

bool hasColor(GLenum baseFormat) {
  return baseFormat != GL_ALPHA;
}
bool hasAlpha(GLenum baseFormat) {
  return baseFormat != GL_LUMINANCE && baseFormat != GL_RGB;
}

constexpr Argument kZero{Source::Zero, Operand::Color};
constexpr Argument kOne{Source::One, Operand::Color};

constexpr bool same(Argument a, Argument b) {
  return a.source == b.source && a.operand == b.operand;
}
constexpr int order(Argument a) {
  return static_cast<int>(a.source) * 4 + static_cast<int>(a.operand);
}

// ---- State to combiners
// -------------------------------------------------------------------------------------------

// Tables 3.15 and 3.16.
void translateFixedMode(GLenum mode, GLenum baseFormat, Source texture, FragmentUnit& out) {
  const Argument textureColor{texture, Operand::Color};
  const Argument textureAlpha{texture, Operand::Alpha};
  const Argument previousColor{Source::Previous, Operand::Color};
  const Argument previousAlpha{Source::Previous, Operand::Alpha};
  const Argument constantColor{Source::Constant, Operand::Color};

  if (mode == GL_DECAL) {  // undefined without red, green and blue: nothing is changed
    if (baseFormat == GL_RGB) out.rgb = {Function::Replace, 0, {textureColor}};
    if (baseFormat == GL_RGBA)
      out.rgb = {Function::Interpolate, 0, {textureColor, previousColor, textureAlpha}};
    return;
  }
  if (hasAlpha(baseFormat)) {
    if (mode == GL_REPLACE)
      out.alpha = {Function::Replace, 0, {textureAlpha}};
    else
      out.alpha = {Function::Modulate, 0, {previousAlpha, textureAlpha}};
  }
  if (!hasColor(baseFormat)) return;
  switch (mode) {
    case GL_REPLACE:
      out.rgb = {Function::Replace, 0, {textureColor}};
      break;
    case GL_BLEND:
      out.rgb = {Function::Interpolate, 0, {constantColor, previousColor, textureColor}};
      break;
    case GL_ADD:
      out.rgb = {Function::Add, 0, {previousColor, textureColor}};
      break;
    default:
      out.rgb = {Function::Modulate, 0, {previousColor, textureColor}};
      break;
  }
}

Function translateFunction(GLenum function) {
  switch (function) {
    case GL_REPLACE:
      return Function::Replace;
    case GL_ADD:
      return Function::Add;
    case GL_ADD_SIGNED:
      return Function::AddSigned;
    case GL_INTERPOLATE:
      return Function::Interpolate;
    case GL_SUBTRACT:
      return Function::Subtract;
    case GL_DOT3_RGB:
    case GL_DOT3_RGBA:
      return Function::Dot3;
    default:
      return Function::Modulate;
  }
}

Operand translateOperand(GLenum operand) {
  switch (operand) {
    case GL_ONE_MINUS_SRC_COLOR:
      return Operand::OneMinusColor;
    case GL_SRC_ALPHA:
      return Operand::Alpha;
    case GL_ONE_MINUS_SRC_ALPHA:
      return Operand::OneMinusAlpha;
    default:
      return Operand::Color;
  }
}

uint8_t translateScale(float scale) {
  return scale >= 4 ? 2 : scale >= 2 ? 1 : 0;
}

// Tables 3.18 and 3.19. False: the source is a unit without a texture.
bool translateArgument(const State& state, int unit, GLenum source, GLenum operand, Argument& out) {
  out.operand = translateOperand(operand);
  switch (source) {
    case GL_PREVIOUS:
      out.source = Source::Previous;
      return true;
    case GL_PRIMARY_COLOR:
      out.source = Source::Primary;
      return true;
    case GL_CONSTANT:
      out.source = Source::Constant;
      return true;
    default:
      break;
  }
  const int sampled = source == GL_TEXTURE ? unit : static_cast<int>(source) - GL_TEXTURE0;
  if (sampled < 0 || sampled >= kMaxTextureUnits) return false;
  if (state.units[sampled].target == TextureTarget::None) return false;
  // What a base format has not: color 0, alpha 1 (table 3.9).
  const GLenum format = state.units[sampled].baseFormat;
  if (readsAlpha(out.operand) ? !hasAlpha(format) : !hasColor(format)) {
    out = readsAlpha(out.operand) != complements(out.operand) ? kOne : kZero;
    return true;
  }
  out.source = textureSource(sampled);
  return true;
}

bool translateCombine(const State& state, int unit, FragmentUnit& out) {
  const TextureEnv& env = state.units[unit].env;
  out.rgb.function = translateFunction(env.combineRgb);
  out.rgb.scaleLog2 = translateScale(env.rgbScale);
  for (int i = 0; i < argumentCount(out.rgb.function); ++i)
    if (!translateArgument(state, unit, env.srcRgb[i], env.operandRgb[i], out.rgb.arguments[i])) return false;
  out.alpha.scaleLog2 = translateScale(env.alphaScale);
  if (env.combineRgb == GL_DOT3_RGBA) {
    out.alpha.function = Function::Dot3;
    out.alpha.arguments = out.rgb.arguments;
    return true;
  }
  out.alpha.function = translateFunction(env.combineAlpha);
  if (out.alpha.function == Function::Dot3)
    out.alpha.function = Function::Modulate;  // no alpha combiner of its own
  for (int i = 0; i < argumentCount(out.alpha.function); ++i) {
    const GLenum operand =
        env.operandAlpha[i] == GL_ONE_MINUS_SRC_ALPHA ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA;
    if (!translateArgument(state, unit, env.srcAlpha[i], operand, out.alpha.arguments[i])) return false;
  }
  return true;
}

// ---- Reduction
// ----------------------------------------------------------------------------------------------------

enum class Channel { Rgb, Alpha };

// Whether the previous color and alpha are still the primary color's: then Previous is the one name for both.
struct Untouched {
  bool rgb = true, alpha = true;
};

void reduceArgument(Argument& argument, Channel channel, Function function, Untouched untouched) {
  if (argument.source == Source::Zero || argument.source == Source::One) {
    if (complements(argument.operand))
      argument.source = argument.source == Source::Zero ? Source::One : Source::Zero;
    argument.operand = Operand::Color;
    return;
  }
  if (channel == Channel::Alpha && function != Function::Dot3)
    argument.operand = complements(argument.operand) ? Operand::OneMinusAlpha : Operand::Alpha;
  const bool unchanged = readsAlpha(argument.operand) ? untouched.alpha : untouched.rgb;
  if (argument.source == Source::Primary && unchanged) argument.source = Source::Previous;
}

Combiner replaceBy(Argument argument, uint8_t scaleLog2) {
  return {Function::Replace, scaleLog2, {argument}};
}

// Arithmetic with 0 and 1. All arguments lie in [0, 1], and results are clamped after the scale.
Combiner fold(const Combiner& in) {
  const auto [a, b, c] = in.arguments;
  switch (in.function) {
    case Function::Modulate:
      if (same(a, kZero) || same(b, kZero)) return replaceBy(kZero, 0);
      if (same(a, kOne)) return replaceBy(b, in.scaleLog2);
      if (same(b, kOne)) return replaceBy(a, in.scaleLog2);
      break;
    case Function::Add:
      if (same(a, kOne) || same(b, kOne)) return replaceBy(kOne, 0);
      if (same(a, kZero)) return replaceBy(b, in.scaleLog2);
      if (same(b, kZero)) return replaceBy(a, in.scaleLog2);
      break;
    case Function::Subtract:
      if (same(a, kZero) || same(b, kOne) || same(a, b)) return replaceBy(kZero, 0);
      if (same(b, kZero)) return replaceBy(a, in.scaleLog2);
      break;
    case Function::Interpolate:
      if (same(c, kOne) || same(a, b)) return replaceBy(a, in.scaleLog2);
      if (same(c, kZero)) return replaceBy(b, in.scaleLog2);
      if (same(b, kZero)) return fold({Function::Modulate, in.scaleLog2, {a, c}});
      break;
    case Function::Replace:
      if (same(a, kZero) || same(a, kOne)) return replaceBy(a, 0);
      break;
    default:
      break;
  }
  return in;
}

bool commutes(Function function) {
  return function == Function::Modulate || function == Function::Add || function == Function::AddSigned ||
         function == Function::Dot3;
}

void reduceCombiner(Combiner& combiner, Channel channel, Untouched untouched) {
  if (combiner.function == Function::Keep) {
    combiner = {};
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (i < argumentCount(combiner.function))
      reduceArgument(combiner.arguments[i], channel, combiner.function, untouched);
    else
      combiner.arguments[i] = {};
  }
  combiner = fold(combiner);
  if (commutes(combiner.function) && order(combiner.arguments[1]) < order(combiner.arguments[0]))
    std::swap(combiner.arguments[0], combiner.arguments[1]);
  const Argument unchanged{Source::Previous, channel == Channel::Rgb ? Operand::Color : Operand::Alpha};
  if (combiner.function == Function::Replace && combiner.scaleLog2 == 0 &&
      same(combiner.arguments[0], unchanged))
    combiner = {};
}

// From the first unit to the last: each combiner by itself.
void reduceForward(std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Untouched untouched;
  for (FragmentUnit& unit : units) {
    reduceCombiner(unit.rgb, Channel::Rgb, untouched);
    reduceCombiner(unit.alpha, Channel::Alpha, untouched);
    untouched.rgb = untouched.rgb && unit.rgb.function == Function::Keep;
    untouched.alpha = untouched.alpha && unit.alpha.function == Function::Keep;
  }
}

struct Live {
  bool rgb = true, alpha = true;
};

Live liveBefore(const FragmentUnit& unit, Live after) {
  Live before{after.rgb && unit.rgb.function == Function::Keep,
              after.alpha && unit.alpha.function == Function::Keep};
  forEachArgument(unit, [&](Argument argument) {
    if (argument.source != Source::Previous) return;
    (readsAlpha(argument.operand) ? before.alpha : before.rgb) = true;
  });
  return before;
}

// From the last unit to the first: results that nobody reads are not computed.
void reduceBackward(std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Live live;
  for (int u = kMaxTextureUnits - 1; u >= 0; --u) {
    if (!live.rgb) units[u].rgb = {};
    if (!live.alpha) units[u].alpha = {};
    live = liveBefore(units[u], live);
  }
}

}  // namespace

void translateEnvironment(const State& state, int unit, FragmentUnit& out) {
  const TextureUnit& in = state.units[unit];
  if (in.target == TextureTarget::None) return;
  if (in.env.mode != GL_COMBINE)
    return translateFixedMode(in.env.mode, in.baseFormat, textureSource(unit), out);
  // OES_texture_env_crossbar: a unit that refers to one without a texture does nothing.
  if (!translateCombine(state, unit, out)) out.rgb = out.alpha = {};
}

void reduceCombiners(std::array<FragmentUnit, kMaxTextureUnits>& units) {
  // Dropping a result can make an earlier color untouched, which gives later arguments their canonical name,
  // so twice is not always enough; each round removes a combiner or is the last.
  for (;;) {
    const auto before = units;
    reduceForward(units);
    reduceBackward(units);
    if (!std::memcmp(&before, &units, sizeof units)) return;
  }
}

uint32_t texturesRead(const std::array<FragmentUnit, kMaxTextureUnits>& units) {
  uint32_t mask = 0;
  for (const FragmentUnit& unit : units)
    forEachArgument(unit, [&](Argument argument) {
      if (const int sampled = sampledUnit(argument.source); sampled >= 0) mask |= 1u << sampled;
    });
  return mask;
}

bool readsPrimaryColor(const std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Live live;
  bool primary = false;
  for (int u = kMaxTextureUnits - 1; u >= 0; --u) {
    forEachArgument(units[u], [&](Argument argument) { primary |= argument.source == Source::Primary; });
    live = liveBefore(units[u], live);
  }
  return primary || live.rgb || live.alpha;
}

}  // namespace anteroom::gen
