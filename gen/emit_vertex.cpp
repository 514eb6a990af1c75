// Chapter 2 as GLSL: transformation, lighting, texture coordinates, point size, clip planes.
#include "gen/emit.h"
#include "gen/gen.h"
#include "gen/layout.h"
#include "gen/palette.h"
#include "gen/reduce.h"

namespace anteroom::gen {
namespace {

struct AttributeNames {
  std::string name;  // as the shader's code knows it
  std::string_view swizzle, type;
};

AttributeNames attributeNames(int attribute) {
  switch (attribute) {
    case kPosition:
      return {"position", "", "vec4"};
    case kNormal:
      return {"normal", ".xyz", "vec3"};
    case kColor:
      return {"color", "", "vec4"};
    case kPointSize:
      return {"size", ".x", "float"};
    case kMatrixIndex:
      return {"index", "", "uvec4"};
    case kWeight:
      return {"weight", "", "vec4"};
    default:
      return {fmt::format("coord{}", attribute - kTexCoord0), "", "vec4"};
  }
}

std::string_view conversion(Fetch fetch) {
  switch (fetch) {
    case Fetch::Fixed:
      return "fromFixed";
    case Fetch::FixedW1:
      return "fromFixedW1";
    case Fetch::IntW1:
      return "fromIntW1";
    case Fetch::NormedByte:
      return "fromNormedByte";
    case Fetch::NormedShort:
      return "fromNormedShort";
    default:
      return "vec4";
  }
}

bool isArray(Fetch fetch) {
  return fetch != Fetch::Unread && fetch != Fetch::Constant;
}

// Declares what arrays supply and converts it, so that the rest knows attributes by their names only.
void fetchAttributes(const VertexKey& key, Shader& shader) {
  for (int a = 0; a < kAttributeCount; ++a) {
    const Fetch fetch = key.fetch[a];
    if (!isArray(fetch)) continue;
    const auto [name, swizzle, type] = attributeNames(a);
    if (fetch == Fetch::Float || fetch == Fetch::Uint) {
      shader.declareLine("layout(location = {}) in {} {};", a, type, name);
      continue;
    }
    shader.declareLine("layout(location = {}) in ivec4 {}Array;", a, name);
    const std::string_view convert = conversion(fetch);
    if (convert != "vec4") shader.call(convert);
    shader.line("{} {} = {}({}Array){};", type, name, convert, name, swizzle);
  }
}

// One light's share of the sums `matte` (without the material under color material) and `shiny`.
class LightText {
 public:
  LightText(const VertexKey& key, int light, Shader& shader) : key_(key), i_(light), shader_(shader) {}

  std::string lines() {
    if (has(key_.positional)) writeVector();
    if (has(key_.attenuated))
      scaleBy(fmt::format("{}(light{}Attenuation, length(offset{}))", call("attenuation"), i_, i_));
    if (has(key_.spot)) scaleBy(cone());
    const std::string diffuse = fmt::format("{}(normal, {}) * light{}Diffuse", call("facing"), toLight_, i_);
    if (factor_.empty())
      line("matte += {};", diffuse);
    else
      line("matte += {} * (light{}Ambient + {});", factor_, i_, diffuse);
    if (key_.specular) writeSpecular();
    return text_;
  }

 private:
  bool has(uint8_t mask) const { return (mask >> i_ & 1) != 0; }
  std::string_view call(std::string_view function) { return shader_.call(function); }
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += "  " + fmt::format(format, std::forward<Args>(args)...) + '\n';
  }

  void writeVector() {
    line("vec3 offset{} = light{}Position - point;", i_, i_);
    toLight_ = fmt::format("toLight{}", i_);
    line("vec3 {} = {}(offset{});", toLight_, call("safeNormalize"), i_);
  }

  void scaleBy(const std::string& value) {
    if (factor_.empty())
      line("float factor{} = {};", i_, value);
    else
      line("{} *= {};", factor_, value);
    factor_ = fmt::format("factor{}", i_);
  }

  std::string cone() {
    const std::string common = fmt::format("{}, light{}SpotDirection, light{}CosCutoff", toLight_, i_, i_);
    if (!has(key_.spotExponent)) return fmt::format("{}({})", call("spotCone"), common);
    return fmt::format("{}({}, light{}SpotExponent)", call("spot"), common, i_);
  }

  void writeSpecular() {
    std::string factor;
    if (!key_.shininess) {
      factor = fmt::format("{}(normal, {})", call("flatHighlight"), toLight_);
    } else {
      const std::string half = has(key_.positional) ? fmt::format("{}({})", call("halfway"), toLight_)
                                                    : fmt::format("light{}Half", i_);
      factor = fmt::format("{}(normal, {}, {}, shininess)", call("highlight"), toLight_, half);
    }
    line("shiny += {}{}{} * light{}Specular;", factor_, factor_.empty() ? "" : " * ", factor, i_);
  }

  const VertexKey& key_;
  int i_;
  Shader& shader_;
  std::string text_, factor_, toLight_ = fmt::format("light{}Direction", i_);
};

// Section 2.12.1 as a function of the normal, for one side.
void defineIlluminate(const VertexKey& key, Shader& shader) {
  std::string text = "vec4 illuminate(";
  std::string parameters = key.lights ? "vec3 normal" : "";
  if (key.positional) parameters += ", vec3 point";
  if (key.colorMaterial) parameters += parameters.empty() ? "vec4 color" : ", vec4 color";
  text += parameters + ") {\n";
  text += key.colorMaterial ? "  vec3 matte = sceneAmbient;\n" : "  vec3 matte = sceneColor.rgb;\n";
  if (key.specular) text += "  vec3 shiny = vec3(0.0);\n";
  for (int i = 0; i < key.lights; ++i) text += LightText(key, i, shader).lines();
  std::string sum = key.colorMaterial ? "emission + color.rgb * matte" : "matte";
  if (key.specular) sum += " + shiny";
  const char* alpha = key.colorMaterial ? "color.a" : "sceneColor.a";
  text += fmt::format("  return {}(vec4({}, {}));\n}}\n\n", shader.call("saturate"), sum, alpha);
  shader.define(text);
}

void writeColor(const VertexKey& key, Shader& shader) {
  if (key.color == VertexColor::None) return;
  shader.declareLine("layout(location = {}) out vec4 frontColor;", kFrontColorLocation);
  if (key.color == VertexColor::Unlit) {
    if (key.fetch[kColor] == Fetch::Constant)
      shader.line("frontColor = color;");
    else
      shader.line("frontColor = {}(color);", shader.call("saturate"));
    return;
  }
  defineIlluminate(key, shader);
  std::string moreArguments = key.positional ? ", point" : "";
  if (key.colorMaterial) moreArguments += key.lights ? ", color" : "color";
  shader.line("frontColor = illuminate({}{});", key.lights ? "eyeNormal" : "", moreArguments);
  if (!key.twoSided) return;
  shader.declareLine("layout(location = {}) out vec4 backColor;", kBackColorLocation);
  shader.line("backColor = illuminate(-eyeNormal{});", moreArguments);
}

std::string_view swizzle(Coordinate coordinate) {
  switch (coordinate) {
    case Coordinate::St:
      return ".st";
    case Coordinate::Stq:
      return ".stq";
    case Coordinate::Str:
      return ".stp";
    default:
      return "";
  }
}

void writeTexCoord(const VertexKey& key, int u, Shader& shader) {
  const VertexUnit& unit = key.units[u];
  std::string coord = fmt::format("coord{}", u);
  if (unit.texGen != TexGen::None) {
    const std::string q = unit.q1 ? "1.0" : coord + ".q";
    const std::string direction = unit.texGen == TexGen::Normal
                                      ? "eyeNormal"
                                      : fmt::format("{}(point, eyeNormal)", shader.call("reflection"));
    coord = fmt::format("vec4({}, {})", direction, q);
  }
  shader.declareLine("layout(location = {}) out {} texCoord{};", kTexCoordLocation + u,
                     coordinateType(unit.output), u);
  if (unit.matrix)
    shader.line("texCoord{} = {} * textureMatrix{};", u, coord, u);
  else
    shader.line("texCoord{} = {}{};", u, coord, swizzle(unit.output));
}

void writePoint(const VertexKey& key, Shader& shader) {
  if (key.pointSize == PointSize::None) return;
  shader.line("gl_Position = {}(gl_Position);", shader.call("clippedByCenter"));
  std::string diameter = key.pointSize == PointSize::One ? "1.0" : "size";
  if (key.pointSize == PointSize::Varying) {
    if (key.pointAttenuation)
      diameter = fmt::format("{}(size, sizeAttenuation, length(point))", shader.call("attenuatedSize"));
    diameter = fmt::format("clamp({}, sizeRange.x, sizeRange.y)", diameter);
    if (key.pointRound) diameter = fmt::format("{}({})", shader.call("wholeSize"), diameter);
  }
  if (key.pointRound) {
    shader.line("float width = {};", diameter);
    shader.line("gl_Position = {}(gl_Position, viewport, width);", shader.call("onWholePixels"));
    diameter = "width";
  }
  if (key.pointFade) {
    shader.declareLine("layout(location = {}) flat out float fade;", kFadeLocation);
    shader.line("float derived = {};", diameter);
    shader.line("fade = {}(derived, fadeThreshold);", shader.call("pointFade"));
    diameter = "max(derived, fadeThreshold)";
  }
  if (key.pointShape == PointShape::Square) {
    shader.line("gl_PointSize = {};", diameter);
    return;
  }
  shader.declareLine("layout(location = {}) flat out float diameter;", kDiameterLocation);
  shader.line("diameter = {};", diameter);
  // A smooth point also covers parts of the pixels around its square.
  shader.line("gl_PointSize = diameter{};", key.pointShape == PointShape::Smooth ? " + 1.0" : "");
}

void writeClipDistances(const VertexKey& key, Shader& shader) {
  const char* point = key.palette ? "eye" : "position";
  const auto distance = [&](int i) { return fmt::format("dot(clipPlane{}, {})", i, point); };
  if (!key.clipVaryings) {
    for (int i = 0; i < key.clipPlanes; ++i) shader.line("gl_ClipDistance[{}] = {};", i, distance(i));
    return;
  }
  for (int first = 0; first < key.clipPlanes; first += 4) {
    shader.declareLine("layout(location = {}) out vec4 clipDistances{};", kClipLocation + first / 4,
                       first / 4);
    std::string parts;
    for (int i = first; i < first + 4; ++i)
      parts += (i == first ? "" : ", ") + (i < key.clipPlanes ? distance(i) : std::string("0.0"));
    shader.line("clipDistances{} = vec4({});", first / 4, parts);
  }
}

// Every shader computes the position by the same expression: passes of one scene must agree on depth.
void declarePosition(const VertexKey& key, Shader& shader) {
  std::string members = "  vec4 gl_Position;\n";
  if (key.pointSize != PointSize::None) members += "  float gl_PointSize;\n";
  if (key.clipPlanes && !key.clipVaryings)
    members += fmt::format("  float gl_ClipDistance[{}];\n", key.clipPlanes);
  shader.declareLine("out gl_PerVertex {{\n{}}};\ninvariant gl_Position;", members);
}

// "weight.x * matrices[slot.x] + ...": a term for each weight.
std::string blended(const VertexKey& key, std::string_view matrices) {
  std::string sum;
  for (int i = 0; i < key.palette; ++i)
    sum += fmt::format("{}weight.{} * {}[slot.{}]", i ? " + " : "", "xyzw"[i], matrices, "xyzw"[i]);
  return sum;
}

// OES_matrix_palette. Indices beyond the palette name its last matrix.
void writeSkin(const VertexKey& key, Shader& shader) {
  shader.line("uvec4 slot = min(index, {}u);", kPaletteMatrices - 1);
  shader.line("{} skin = {};", paletteType(key), blended(key, "palette"));
  if (key.paletteW) {
    shader.line("vec4 eye = position * skin;");
  } else {
    std::string sum = "weight.x";
    for (int i = 1; i < key.palette; ++i) sum += fmt::format(" + weight.{}", "xyzw"[i]);
    if (key.palette > 1) sum = '(' + sum + ')';
    shader.line("vec4 eye = vec4(position * skin, position.w * {});", sum);
  }
}

void writePosition(const VertexKey& key, Shader& shader) {
  if (key.palette) writeSkin(key, shader);
  shader.line("gl_Position = {};", key.palette ? "projection * eye" : "modelviewProjection * position");
}

void writeEye(const VertexKey& key, Shader& shader) {
  if (needsEye(key)) {
    if (!key.palette) shader.line("vec4 eye = modelview * position;");
    shader.line("vec3 point = {}(eye);", shader.call("eyePoint"));
  }
  if (!needsNormal(key) || (key.fetch[kNormal] == Fetch::Constant && !key.palette)) return;
  std::string normal = "normalMatrix * normal";
  if (key.paletteNormals)
    normal = fmt::format("({}) * normal", blended(key, "paletteNormals"));
  else if (key.palette)
    normal = "normal * mat3(skin)";
  if (key.normalize) normal = fmt::format("{}({})", shader.call("safeNormalize"), normal);
  shader.line("vec3 eyeNormal = {};", normal);
}

void writeFogDepth(const VertexKey& key, Shader& shader) {
  if (!key.fog) return;
  shader.declareLine("layout(location = {}) out float fogDepth;", kFogDepthLocation);
  if (needsEye(key))
    shader.line("fogDepth = point.z;");
  else if (key.palette)
    shader.line("fogDepth = {}(eye.zw);", shader.call("dividedDepth"));
  else if (key.fogW)
    shader.line("fogDepth = {}(position * eyeDepth);", shader.call("dividedDepth"));
  else
    shader.line("fogDepth = dot(eyeDepth, position);");
}

}  // namespace

std::string emitVertex(const VertexKey& key) {
  Shader shader(describe(key));
  shader.declare(declarePush(key));
  shader.declare(declareVertexConstants(key));
  shader.declare(declarePalette(key));
  fetchAttributes(key, shader);
  declarePosition(key, shader);
  writePosition(key, shader);
  writeEye(key, shader);
  writeColor(key, shader);
  writeFogDepth(key, shader);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (key.units[u].output != Coordinate::None) writeTexCoord(key, u, shader);
  writeClipDistances(key, shader);
  writePoint(key, shader);
  return shader.text();
}

uint32_t attributesRead(const VertexKey& key) {
  uint32_t mask = 0;
  for (int a = 0; a < kAttributeCount; ++a)
    if (isArray(key.fetch[a])) mask |= 1u << a;
  return mask;
}

InputClass inputClass(const VertexKey& key, Attribute attribute) {
  switch (key.fetch[attribute]) {
    case Fetch::Unread:
    case Fetch::Constant:
    case Fetch::Float:
      return InputClass::Float;
    case Fetch::Uint:
      return InputClass::Uint;
    default:
      return InputClass::Int;
  }
}

}  // namespace anteroom::gen
