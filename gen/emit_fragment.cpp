// Chapters 3.7-3.9 and the alpha test as GLSL.
#include "gen/combiner.h"
#include "gen/emit.h"
#include "gen/gen.h"
#include "gen/layout.h"
#include "gen/reduce.h"
#include "gen/words.h"

namespace anteroom::gen {
namespace {

enum class Channel { Rgb, Alpha };

std::string sourceName(Source source, int unit) {
  switch (source) {
    case Source::Previous:
      return "color";
    case Source::Primary:
      return "primary";
    case Source::Constant:
      return fmt::format("constant{}", unit);
    case Source::Zero:
      return "vec4(0.0)";
    case Source::One:
      return "vec4(1.0)";
    case Source::Fog:
      return "vec4(fogFactor)";
    default:
      if (const int from = outputUnit(source); from >= 0) return fmt::format("output{}", from);
      return fmt::format("texel{}", sampledUnit(source));
  }
}

// As a vec4 of which the channel's components count; an alpha combiner reads alpha anyway.
std::string argumentText(Argument argument, int unit, bool replicateAlpha) {
  std::string text = sourceName(argument.source, unit);
  if (readsAlpha(argument.operand) && replicateAlpha) text += ".aaaa";
  return complements(argument.operand) ? fmt::format("(1.0 - {})", text) : text;
}

struct Expression {
  std::string text;
  bool atom;  // needs no brackets before a component is taken
  std::string component(std::string_view which) const {
    return atom ? fmt::format("{}.{}", text, which) : fmt::format("({}).{}", text, which);
  }
};

// Table 3.17, before scale and clamp.
Expression functionText(const Combiner& combiner, Channel channel, int unit, Shader& shader) {
  const bool replicate = channel == Channel::Rgb || combiner.function == Function::Dot3;
  std::array<std::string, 3> text;
  for (int i = 0; i < argumentCount(combiner.function); ++i)
    text[i] = argumentText(combiner.arguments[i], unit, replicate);
  const auto& [a, b, c] = text;
  switch (combiner.function) {
    case Function::Replace:
      return {a, true};
    case Function::Modulate:
      return {fmt::format("{} * {}", a, b), false};
    case Function::Add:
      return {fmt::format("{} + {}", a, b), false};
    case Function::AddSigned:
      return {fmt::format("{} + {} - 0.5", a, b), false};
    case Function::Interpolate:
      return {fmt::format("mix({}, {}, {})", b, a, c), true};
    case Function::Subtract:
      return {fmt::format("{} - {}", a, b), false};
    case Function::Dot3:
      return {fmt::format("{}({}, {})", shader.call("dot3"), a, b), true};
    case Function::ModulateAdd:
      return {fmt::format("{} * {} + {}", a, c, b), false};
    case Function::ModulateSignedAdd:
      return {fmt::format("{} * {} + {} - 0.5", a, c, b), false};
    case Function::ModulateSubtract:
      return {fmt::format("{} * {} - {}", a, c, b), false};
    default:
      return {"color", true};
  }
}

// Arguments are in [0, 1]: only these can leave it.
bool leavesRange(const Combiner& combiner) {
  const Function f = combiner.function;
  return combiner.scaleLog2 || f == Function::Add || f == Function::AddSigned || f >= Function::Subtract;
}

Expression combinerText(const Combiner& combiner, Channel channel, int unit, Shader& shader) {
  const Expression result = functionText(combiner, channel, unit, shader);
  if (!leavesRange(combiner)) return result;
  const std::string scale = combiner.scaleLog2 ? fmt::format("{}.0 * ", 1 << combiner.scaleLog2) : "";
  const bool brackets = combiner.scaleLog2 && !result.atom;
  return {fmt::format("{}({}{}{}{})", shader.call("saturate"), scale, brackets ? "(" : "", result.text,
                      brackets ? ")" : ""),
          true};
}

void combine(const FragmentUnit& unit, int u, Shader& shader) {
  const bool rgb = unit.rgb.function != Function::Keep;
  const bool alpha = unit.alpha.function != Function::Keep;
  if (!rgb && !alpha) return;
  const Expression rgbText = combinerText(unit.rgb, Channel::Rgb, u, shader);
  const Expression alphaText = combinerText(unit.alpha, Channel::Alpha, u, shader);
  if (rgbText.text == alphaText.text)
    shader.line("color = {};", rgbText.text);
  else if (!alpha)
    shader.line("color.rgb = {};", rgbText.component("rgb"));
  else if (!rgb)
    shader.line("color.a = {};", alphaText.component("a"));
  else
    shader.line("color = vec4({}, {});", rgbText.component("rgb"), alphaText.component("a"));
}

// Samples within [-1, 1], by gradients that do not know of the clamp; then takes away what the border covers.
void sampleMirroredEdges(const FragmentUnit& unit, int u, bool lateSwitchOver, std::string_view coord,
                         Shader& shader) {
  const bool volume = unit.target == TextureTarget::Texture3D;
  const std::string_view type = volume ? "vec3" : "vec2";
  shader.line("{} coord{} = {};", type, u, coord);
  shader.line("{} inside{} = coord{};", type, u, u);
  constexpr std::string_view kAxes[] = {"x", "y", "z"};
  bool border = false;
  for (size_t axis = 0; axis < 3; ++axis) {
    if (unit.edges[axis] == MirroredEdge::None) continue;
    border |= unit.edges[axis] != MirroredEdge::Texel;
    shader.line("inside{0}.{1} = clamp(coord{0}.{1}, -1.0, 1.0);", u, kAxes[axis]);
  }
  const bool point = unit.coordinate == Coordinate::Point;
  std::string closer;
  if (lateSwitchOver)
    closer = fmt::format(" * exp2({}(textureQueryLod(unit{}, coord{}).y))", shader.call("switchOver"), u, u);
  if (point)  // section 3.7.7: rho is 1
    shader.line("vec4 texel{0} = textureLod(unit{0}, inside{0}, 0.0);", u);
  else
    shader.line("vec4 texel{0} = textureGrad(unit{0}, inside{0}, dFdx(coord{0}){1}, dFdy(coord{0}){1});", u,
                closer);
  if (!border) return;
  const std::string level = point ? "0" : fmt::format("level{}", u);
  if (!point) shader.line("int level{0} = int(textureQueryLod(unit{0}, coord{0}).x + 0.5);", u);
  for (size_t axis = 0; axis < 3; ++axis) {
    if (unit.edges[axis] < MirroredEdge::Half) continue;
    const std::string value = fmt::format("coord{}.{}", u, kAxes[axis]);
    const std::string size = fmt::format("float(textureSize(unit{}, {}).{})", u, level, kAxes[axis]);
    if (unit.edges[axis] == MirroredEdge::Hard)
      shader.line("if (abs({}) >= 1.0) texel{} = vec4(0.0);", value, u);
    else
      shader.line("texel{} *= {}({}, {});", u,
                  shader.call(unit.edges[axis] == MirroredEdge::Half ? "halfInside" : "inside"), value, size);
  }
}

void sampleTexture(const FragmentUnit& unit, int u, bool lateSwitchOver, Shader& shader) {
  constexpr auto kSamplers = wordsTo<TextureTarget::Last>("", "sampler2D", "samplerCube", "sampler3D");
  shader.declareLine("layout(set = 1, binding = {}) uniform {} unit{};", u,
                     kSamplers[static_cast<int>(unit.target)], u);
  constexpr std::array<MirroredEdge, 3> kNoEdges{};
  if (unit.coordinate == Coordinate::Point) {  // section 3.7.7: rho is 1
    const char* coord = unit.target == TextureTarget::Texture2D ? "pointCoord" : "vec3(pointCoord, 0.0)";
    if (unit.edges != kNoEdges) return sampleMirroredEdges(unit, u, false, coord, shader);
    shader.line("vec4 texel{} = textureLod(unit{}, {}, 0.0);", u, u, coord);
    return;
  }
  shader.declareLine("layout(location = {}) in {} texCoord{};", kTexCoordLocation + u,
                     coordinateType(unit.coordinate), u);
  std::string coord = fmt::format("texCoord{}", u);
  if (unit.coordinate == Coordinate::Stq) coord = fmt::format("{}({})", shader.call("divideSt"), coord);
  if (unit.coordinate == Coordinate::Strq) coord = fmt::format("{}({})", shader.call("divideStr"), coord);
  if (unit.edges != kNoEdges) return sampleMirroredEdges(unit, u, lateSwitchOver, coord, shader);
  if (lateSwitchOver)
    shader.line("vec4 texel{} = texture(unit{}, {}, {}(textureQueryLod(unit{}, {}).y));", u, u, coord,
                shader.call("switchOver"), u, coord);
  else
    shader.line("vec4 texel{} = texture(unit{}, {});", u, u, coord);
}

void readPrimary(const FragmentKey& key, Shader& shader) {
  if (!readsPrimaryColor(key)) {
    shader.line("vec4 color = vec4(0.0);");
    return;
  }
  const std::string_view flat = key.flatColor ? "flat " : "";
  shader.declareLine("layout(location = {}) {}in vec4 frontColor;", kFrontColorLocation, flat);
  if (key.twoSided)
    shader.declareLine("layout(location = {}) {}in vec4 backColor;", kBackColorLocation, flat);
  const std::string_view value = key.twoSided ? "gl_FrontFacing ? frontColor : backColor" : "frontColor";
  const bool primary = reads(key.units, Source::Primary);
  if (primary) shader.line("vec4 primary = {};", value);
  shader.line("vec4 color = {};", primary ? "primary" : value);
}

std::string fogFactor(FogMode mode, Shader& shader) {
  shader.declareLine("layout(location = {}) in float fogDepth;", kFogDepthLocation);
  const std::string_view function = shader.call(mode == FogMode::Linear ? "fogLinear"
                                                : mode == FogMode::Exp  ? "fogExp"
                                                                        : "fogExp2");
  const std::string_view parameters = mode == FogMode::Linear ? "fogEnd, fogScale" : "fogDensity";
  return fmt::format("{}(fogDepth, {})", function, parameters);
}

void fog(const FragmentKey& key, Shader& shader) {
  if (key.fog == FogMode::None) return;
  const std::string factor = key.fogSource == FogMode::None ? fogFactor(key.fog, shader) : "fogFactor";
  shader.line("color.rgb = mix(fogColor, color.rgb, {});", factor);
}

// A result that a later unit reads, though it is not the previous one any more.
bool isOutput(const FragmentKey& key, int unit) {
  return reads(key.units, outputSource(unit));
}

void shapePoint(const FragmentKey& key, Shader& shader) {
  if (key.pointShape != PointShape::Square)
    shader.declareLine("layout(location = {}) flat in float diameter;", kDiameterLocation);
  if (key.pointShape == PointShape::Smooth)
    shader.line("color.a *= {}(gl_PointCoord, diameter);", shader.call("pointCoverage"));
  if (key.pointShape == PointShape::RoundSamples)
    shader.line("gl_SampleMask[0] = {}(gl_PointCoord, diameter);", shader.call("samplesInCircle"));
  if (!key.pointFade) return;
  shader.declareLine("layout(location = {}) flat in float fade;", kFadeLocation);
  shader.line("color.a *= fade;");
}

void alphaTest(AlphaTest test, Shader& shader) {
  if (test == AlphaTest::Always) return;
  constexpr auto kOperators = wordsTo<AlphaTest::Last>("", "", "<", "==", "<=", ">", "!=", ">=");
  shader.line("if (!({}(color.a, alphaScale) {} alphaReference)) discard;", shader.call("roundedAlpha"),
              kOperators[static_cast<int>(test)]);
}

void discardClipped(int planes, Shader& shader) {
  for (int i = 0; i < (planes + 3) / 4; ++i) {
    shader.declareLine("layout(location = {}) in vec4 clipDistances{};", kClipLocation + i, i);
    shader.line("if (any(lessThan(clipDistances{}, vec4(0.0)))) discard;", i);
  }
}

}  // namespace

std::string emitFragment(const FragmentKey& key) {
  Shader shader(describe(key));
  shader.declare(declareFragmentConstants(key));
  shader.declareLine("layout(location = 0) out vec4 fragment;");
  if (key.alphaTest == AlphaTest::Never) {
    shader.line("fragment = vec4(0.0);");
    shader.line("discard;");
    return shader.text();
  }
  bool sprite = false;
  for (const FragmentUnit& unit : key.units) sprite |= unit.coordinate == Coordinate::Point;
  if (sprite)
    shader.line("vec2 pointCoord = {};",
                key.pointYUp ? "vec2(gl_PointCoord.x, 1.0 - gl_PointCoord.y)" : "gl_PointCoord");
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (key.units[u].target != TextureTarget::None)
      sampleTexture(key.units[u], u, (key.switchOver >> u & 1) != 0, shader);
  readPrimary(key, shader);
  if (key.fogSource != FogMode::None) shader.line("float fogFactor = {};", fogFactor(key.fogSource, shader));
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    combine(key.units[u], u, shader);
    if (isOutput(key, u)) shader.line("vec4 output{} = color;", u);
  }
  fog(key, shader);
  shapePoint(key, shader);
  discardClipped(key.discardPlanes, shader);
  alphaTest(key.alphaTest, shader);
  shader.line("fragment = color;");
  return shader.text();
}

uint32_t unitsSampled(const FragmentKey& key) {
  uint32_t mask = 0;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (key.units[u].target != TextureTarget::None) mask |= 1u << u;
  return mask;
}

}  // namespace anteroom::gen
