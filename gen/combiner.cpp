#include "gen/combiner.h"

#include <algorithm>
#include <utility>

#include "gen/ati.h"

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

// IMG_texture_env_enhanced_fixed_function, Table 3.24; what a base format has not is 0, and its alpha 1, but
// for the entries that leave the previous color or alpha.
void translateImgMode(GLenum mode, GLenum baseFormat, Source texture, FragmentUnit& out) {
  const Argument textureColor = hasColor(baseFormat) ? Argument{texture, Operand::Color} : kZero;
  const Argument textureAlpha = hasAlpha(baseFormat) ? Argument{texture, Operand::Alpha} : kOne;
  const Argument previousColor{Source::Previous, Operand::Color};
  const Argument previousAlpha{Source::Previous, Operand::Alpha};
  switch (mode) {
    case GL_MODULATE_COLOR_IMG:
      if (hasColor(baseFormat)) out.rgb = {Function::Modulate, 0, {previousColor, textureColor}};
      if (hasAlpha(baseFormat)) out.alpha = {Function::Replace, 0, {textureAlpha}};
      break;
    case GL_RECIP_ADD_SIGNED_ALPHA_IMG:
      out.alpha = {Function::AddSigned,
                   0,
                   {previousAlpha, hasAlpha(baseFormat) ? Argument{texture, Operand::OneMinusAlpha} : kZero}};
      break;
    case GL_TEXTURE_ALPHA_MODULATE_IMG:
      out.rgb = {Function::Modulate, 0, {textureColor, textureAlpha}};
      out.alpha = {Function::Replace, 0, {textureAlpha}};
      break;
    case GL_FACTOR_ALPHA_MODULATE_IMG:
      out.rgb = {Function::Modulate, 0, {textureColor, {Source::Constant, Operand::Alpha}}};
      out.alpha = {Function::Replace, 0, {{Source::Constant, Operand::Alpha}}};
      break;
    case GL_FRAGMENT_ALPHA_MODULATE_IMG:
      out.rgb = {Function::Modulate, 0, {textureColor, previousAlpha}};
      break;
    case GL_ADD_BLEND_IMG:
      out.rgb = {Function::ModulateAdd,
                 0,
                 {textureColor, previousColor, {Source::Previous, Operand::OneMinusAlpha}}};
      out.alpha = {Function::Modulate, 0, {previousAlpha, textureAlpha}};
      break;
    default:  // DOT3_RGBA_IMG: defined for RGB and RGBA; elsewhere the fragment passes
      if (baseFormat != GL_RGB && baseFormat != GL_RGBA) break;
      out.rgb = out.alpha = {Function::Dot3, 0, {previousColor, textureColor}};
      break;
  }
}

bool isImgMode(GLenum mode) {
  return (mode >= GL_MODULATE_COLOR_IMG && mode <= GL_ADD_BLEND_IMG) || mode == GL_DOT3_RGBA_IMG;
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
    case kDot3RgbExt:
    case kDot3RgbaExt:
      return Function::Dot3;
    case kModulateAdd:
      return Function::ModulateAdd;
    case kModulateSignedAdd:
      return Function::ModulateSignedAdd;
    case kModulateSubtract:
      return Function::ModulateSubtract;
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

// The last unit before `unit` that is on and whose result stands for the texture of unit `texture`; -1: none.
int routed(const State& state, int unit, int texture, bool alpha) {
  while (--unit >= 0) {
    const TextureEnv& env = state.units[unit].env;
    if (state.units[unit].target != TextureTarget::None &&
        (alpha ? env.outputAlpha : env.outputRgb) == texture)
      return unit;
  }
  return -1;
}

// Tables 3.18 and 3.19, ATI_texture_env_combine3 and gen/ati.h. False: the source is a unit without a
// texture.
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
    case GL_ZERO:
    case kSecondaryColor:
      out.source = Source::Zero;
      return true;
    case GL_ONE:
      out.source = Source::One;
      return true;
    case GL_FOG:
      out.source = Source::Fog;
      return true;
    default:
      break;
  }
  const int sampled = source == GL_TEXTURE ? unit : static_cast<int>(source) - GL_TEXTURE0;
  if (sampled < 0 || sampled >= kMaxTextureUnits) return false;
  if (const int from = routed(state, unit, sampled, readsAlpha(out.operand)); from >= 0) {
    out.source = outputSource(from);
    return true;
  }
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
  const bool scaled = env.combineRgb != kDot3RgbExt && env.combineRgb != kDot3RgbaExt;
  if (scaled) out.rgb.scaleLog2 = translateScale(env.rgbScale);
  for (int i = 0; i < argumentCount(out.rgb.function); ++i)
    if (!translateArgument(state, unit, env.srcRgb[i], env.operandRgb[i], out.rgb.arguments[i])) return false;
  if (env.combineRgb == GL_DOT3_RGBA || env.combineRgb == kDot3RgbaExt) {
    out.alpha = {Function::Dot3, scaled ? translateScale(env.alphaScale) : uint8_t{0}, out.rgb.arguments};
    return true;
  }
  out.alpha.scaleLog2 = translateScale(env.alphaScale);
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

enum class Channel { Rgb, Alpha };

// The last unit so far that wrote the color, and the alpha; -1: none, so that they are still the primary
// color's: then Previous is the one name for both.
class Writers {
 public:
  void pass(int unit, const FragmentUnit& combiners) {
    rgb_[unit] = combiners.rgb.function == Function::Keep ? last(false) : unit;
    alpha_[unit] = combiners.alpha.function == Function::Keep ? last(true) : unit;
    count_ = unit + 1;
  }
  int last(bool alpha) const { return count_ == 0 ? -1 : upTo(count_ - 1, alpha); }
  // The writer of what unit `unit` left; a unit that has not been passed leaves what came last.
  int upTo(int unit, bool alpha) const {
    if (count_ == 0) return -1;
    return (alpha ? alpha_ : rgb_)[std::min(unit, count_ - 1)];
  }

 private:
  std::array<int, kMaxTextureUnits> rgb_{}, alpha_{};
  int count_ = 0;
};

void reduceSource(Argument& argument, const Writers& writers) {
  const bool alpha = readsAlpha(argument.operand);
  if (const int unit = outputUnit(argument.source); unit >= 0) {
    const int writer = writers.upTo(unit, alpha);
    if (writer == writers.last(alpha))
      argument.source = Source::Previous;
    else
      argument.source = writer < 0 ? Source::Primary : outputSource(writer);
  }
  if (argument.source == Source::Primary && writers.last(alpha) < 0) argument.source = Source::Previous;
}

void reduceArgument(Argument& argument, Channel channel, Function function, const Writers& writers) {
  if (argument.source == Source::Zero || argument.source == Source::One) {
    if (complements(argument.operand))
      argument.source = argument.source == Source::Zero ? Source::One : Source::Zero;
    argument.operand = Operand::Color;
    return;
  }
  if (channel == Channel::Alpha && function != Function::Dot3)
    argument.operand = complements(argument.operand) ? Operand::OneMinusAlpha : Operand::Alpha;
  reduceSource(argument, writers);
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
    case Function::ModulateAdd:
      if (same(b, kOne)) return replaceBy(kOne, 0);
      if (same(b, kZero)) return fold({Function::Modulate, in.scaleLog2, {a, c}});
      if (same(a, kZero) || same(c, kZero)) return replaceBy(b, in.scaleLog2);
      if (same(a, kOne)) return fold({Function::Add, in.scaleLog2, {c, b}});
      if (same(c, kOne)) return fold({Function::Add, in.scaleLog2, {a, b}});
      break;
    case Function::ModulateSignedAdd:
      if (same(a, kOne)) return fold({Function::AddSigned, in.scaleLog2, {c, b}});
      if (same(c, kOne)) return fold({Function::AddSigned, in.scaleLog2, {a, b}});
      if (same(a, kZero) || same(c, kZero)) return fold({Function::AddSigned, in.scaleLog2, {b, kZero}});
      break;
    case Function::ModulateSubtract:
      if (same(a, kZero) || same(c, kZero) || same(b, kOne)) return replaceBy(kZero, 0);
      if (same(b, kZero)) return fold({Function::Modulate, in.scaleLog2, {a, c}});
      if (same(a, kOne)) return fold({Function::Subtract, in.scaleLog2, {c, b}});
      if (same(c, kOne)) return fold({Function::Subtract, in.scaleLog2, {a, b}});
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

// Whether the function is Arg0 * Arg2 with something added: the factors commute.
bool multiplies(Function function) {
  return function == Function::ModulateAdd || function == Function::ModulateSignedAdd ||
         function == Function::ModulateSubtract;
}

void reduceCombiner(Combiner& combiner, Channel channel, const Writers& writers) {
  if (combiner.function == Function::Keep) {
    combiner = {};
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (i < argumentCount(combiner.function))
      reduceArgument(combiner.arguments[i], channel, combiner.function, writers);
    else
      combiner.arguments[i] = {};
  }
  combiner = fold(combiner);
  if (commutes(combiner.function) && order(combiner.arguments[1]) < order(combiner.arguments[0]))
    std::swap(combiner.arguments[0], combiner.arguments[1]);
  if (multiplies(combiner.function) && order(combiner.arguments[2]) < order(combiner.arguments[0]))
    std::swap(combiner.arguments[0], combiner.arguments[2]);
  const Argument unchanged{Source::Previous, channel == Channel::Rgb ? Operand::Color : Operand::Alpha};
  if (combiner.function == Function::Replace && combiner.scaleLog2 == 0 &&
      same(combiner.arguments[0], unchanged))
    combiner = {};
}

// From the first unit to the last: each combiner by itself.
void reduceForward(std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Writers writers;
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    reduceCombiner(units[u].rgb, Channel::Rgb, writers);
    reduceCombiner(units[u].alpha, Channel::Alpha, writers);
    writers.pass(u, units[u]);
  }
}

// What later units read, going from the last unit to the first.
class Live {
 public:
  // Of what unit `unit` leaves: whether its color, or its alpha, is read.
  bool rgbAfter(int unit) const { return rgb_ || (outputsRgb_ >> unit & 1); }
  bool alphaAfter(int unit) const { return alpha_ || (outputsAlpha_ >> unit & 1); }
  void pass(int unit, const FragmentUnit& combiners) {
    rgb_ = rgbAfter(unit) && combiners.rgb.function == Function::Keep;
    alpha_ = alphaAfter(unit) && combiners.alpha.function == Function::Keep;
    forEachArgument(combiners, [&](Argument argument) {
      const bool alpha = readsAlpha(argument.operand);
      if (argument.source == Source::Previous) (alpha ? alpha_ : rgb_) = true;
      if (const int from = outputUnit(argument.source); from >= 0)
        (alpha ? outputsAlpha_ : outputsRgb_) |= 1u << from;
    });
  }
  // Whether the primary color reaches the first unit that reads what is previous.
  bool atStart() const { return rgb_ || alpha_; }

 private:
  bool rgb_ = true, alpha_ = true;
  uint32_t outputsRgb_ = 0, outputsAlpha_ = 0;
};

// From the last unit to the first: results that nobody reads are not computed.
void reduceBackward(std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Live live;
  for (int u = kMaxTextureUnits - 1; u >= 0; --u) {
    if (!live.rgbAfter(u)) units[u].rgb = {};
    if (!live.alphaAfter(u)) units[u].alpha = {};
    live.pass(u, units[u]);
  }
}

}  // namespace

void translateEnvironment(const State& state, int unit, FragmentUnit& out) {
  const TextureUnit& in = state.units[unit];
  if (in.target == TextureTarget::None) return;
  if (isImgMode(in.env.mode)) return translateImgMode(in.env.mode, in.baseFormat, textureSource(unit), out);
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

bool reads(const std::array<FragmentUnit, kMaxTextureUnits>& units, Source source) {
  bool found = false;
  for (const FragmentUnit& unit : units)
    forEachArgument(unit, [&](Argument argument) { found |= argument.source == source; });
  return found;
}

bool readsPrimaryColor(const std::array<FragmentUnit, kMaxTextureUnits>& units) {
  Live live;
  for (int u = kMaxTextureUnits - 1; u >= 0; --u) live.pass(u, units[u]);
  return live.atStart() || reads(units, Source::Primary);
}

}  // namespace anteroom::gen
