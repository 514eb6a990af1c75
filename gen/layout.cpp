#include "gen/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string_view>

#include "gen/combiner.h"
#include "gen/gen.h"
#include "gen/palette.h"
#include "gen/reduce.h"
#include "gen/values.h"

namespace anteroom::gen {
namespace {

// ---- Types

// mat2x4 ... mat4: columns of vec4; mat3: columns of vec3 that take 16 bytes. std140 and std430 agree on all
// these.
enum class Type : uint8_t { Float, Vec2, Vec3, Vec4, Mat3, Mat2x4, Mat3x4, Mat4 };

struct TypeInfo {
  std::string_view glsl;
  uint32_t size, align;
};
constexpr TypeInfo kTypes[] = {{"float", 4, 4},  {"vec2", 8, 8},     {"vec3", 12, 16},   {"vec4", 16, 16},
                               {"mat3", 48, 16}, {"mat2x4", 32, 16}, {"mat3x4", 48, 16}, {"mat4", 64, 16}};
constexpr const TypeInfo& info(Type type) {
  return kTypes[static_cast<int>(type)];
}

// A member named prefix + index + suffix; no index when it is negative. `value` writes the member's floats.
struct Member {
  Type type;
  std::string_view prefix;
  int index;
  std::string_view suffix;
  Groups groups;
  void (*value)(const State& state, int index, float* out);
};

void put(float* out, const glm::dvec3& v) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}
void put(float* out, const glm::dvec4& v) {
  for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(v[i]);
}
void put(float* out, const glm::dmat3& m) {
  for (int c = 0; c < 3; ++c) put(out + 4 * c, m[c]);
}
void put(float* out, const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c) put(out + 4 * c, m[c]);
}
glm::dvec4 row(const glm::dmat4& m, int r) {
  return {m[0][r], m[1][r], m[2][r], m[3][r]};
}
template <class... Rows>
void putRows(float* out, const glm::dmat4& m, Rows... rows) {
  ((put(out, row(m, rows)), out += 4), ...);
}
float clampUnit(float v) {
  return v > 0 ? std::min(v, 1.0f) : 0;
}  // NaN: 0
glm::dvec3 clampUnit(const glm::vec4& v) {
  return {clampUnit(v.r), clampUnit(v.g), clampUnit(v.b)};
}

// ---- Vertex stage

constexpr uint32_t kPushLimit = 128;  // bytes that every Vulkan device has

// What changes with each draw goes into push constants as far as they reach.
struct Placement {
  bool color, eyeDepth, modelviewInPush, modelviewInBlock, normalInPush, normalInBlock;
};

Placement place(const VertexKey& key) {
  Placement p{};
  uint32_t used = 64;
  const auto fits = [&](uint32_t size) {
    const bool yes = used + size <= kPushLimit;
    if (yes) used += size;
    return yes;
  };
  const bool eye = needsEye(key) && !key.palette;
  p.color = key.fetch[kColor] == Fetch::Constant && fits(16);
  p.eyeDepth = key.fog && !eye && !key.palette && fits(key.fogW ? 32 : 16);
  p.modelviewInPush = eye && fits(64);
  p.modelviewInBlock = eye && !p.modelviewInPush;
  const bool normal =
      key.fetch[kNormal] != Fetch::Unread && key.fetch[kNormal] != Fetch::Constant && !key.palette;
  p.normalInPush = normal && fits(48);
  p.normalInBlock = normal && !p.normalInPush;
  return p;
}

constexpr Member kModelview{
    Type::Mat4, "modelview",     -1,
    "",         kGroupModelview, [](const State& s, int, float* out) { put(out, s.modelview); }};
constexpr Member kNormalMatrix{Type::Mat3,
                               "normalMatrix",
                               -1,
                               "",
                               kGroupModelview | kGroupLighting,
                               [](const State& s, int, float* out) { put(out, normalMatrix(s)); }};

template <class Visit>
void visitPush(const VertexKey& key, Visit visit) {
  const Placement p = place(key);
  if (key.palette)
    visit({Type::Mat4, "projection", -1, "", kGroupProjection,
           [](const State& s, int, float* out) { put(out, clipProjection(s)); }});
  else
    visit({Type::Mat4, "modelviewProjection", -1, "", kGroupModelview | kGroupProjection,
           [](const State& s, int, float* out) { put(out, modelviewProjection(s)); }});
  if (p.color && key.color == VertexColor::Unlit)
    visit({Type::Vec4, "color", -1, "", kGroupCurrentColor, [](const State& s, int, float* out) {
             for (int i = 0; i < 4; ++i) out[i] = clampUnit(s.attributes[kColor].current[i]);
           }});
  else if (p.color)
    visit({Type::Vec4, "color", -1, "", kGroupCurrentColor,
           [](const State& s, int, float* out) { put(out, glm::dvec4(s.attributes[kColor].current)); }});
  if (p.eyeDepth && key.fogW)
    visit({Type::Mat2x4, "eyeDepth", -1, "", kGroupModelview,
           [](const State& s, int, float* out) { putRows(out, s.modelview, 2, 3); }});
  else if (p.eyeDepth)
    visit({Type::Vec4, "eyeDepth", -1, "", kGroupModelview,
           [](const State& s, int, float* out) { put(out, row(s.modelview, 2)); }});
  if (p.modelviewInPush) visit(kModelview);
  if (p.normalInPush) visit(kNormalMatrix);
}

// Material and light colors are multiplied here; under color material the current color takes the material's
// place in the shader.
glm::dvec3 diffuseProduct(const State& s, const Light& light) {
  const double cone = light.position.w == 0 ? constantSpot(light) : 1.0;
  const glm::dvec3 material =
      s.lighting.colorMaterial ? glm::dvec3(1) : glm::dvec3(s.lighting.material.diffuse);
  return material * glm::dvec3(light.diffuse) * cone;
}
glm::dvec3 ambientProduct(const State& s, const Light& light) {
  const glm::dvec3 material =
      s.lighting.colorMaterial ? glm::dvec3(1) : glm::dvec3(s.lighting.material.ambient);
  return material * glm::dvec3(light.ambient);
}
glm::dvec3 specularProduct(const State& s, const Light& light) {
  const double cone = light.position.w == 0 ? constantSpot(light) : 1.0;
  return glm::dvec3(s.lighting.material.specular) * glm::dvec3(light.specular) * cone;
}

template <class Visit>
void visitScene(const VertexKey& key, Visit visit) {
  if (key.colorMaterial) {
    visit({Type::Vec3, "sceneAmbient", -1, "", kGroupLighting,
           [](const State& s, int, float* out) { put(out, constantAmbient(s)); }});
    visit({Type::Vec3, "emission", -1, "", kGroupLighting,
           [](const State& s, int, float* out) { put(out, glm::dvec3(s.lighting.material.emission)); }});
  } else {
    visit({Type::Vec4, "sceneColor", -1, "", kGroupLighting, [](const State& s, int, float* out) {
             const Material& m = s.lighting.material;
             put(out, glm::dvec3(m.emission) + glm::dvec3(m.ambient) * constantAmbient(s));
             out[3] = m.diffuse.a;
           }});
  }
  if (key.shininess)
    visit({Type::Float, "shininess", -1, "", kGroupLighting,
           [](const State& s, int, float* out) { *out = s.lighting.material.shininess; }});
}

template <class Visit>
void visitLight(const VertexKey& key, int i, Visit visit) {
  const auto add = [&](Type type, std::string_view suffix, void (*value)(const State&, int, float*)) {
    visit({type, "light", i, suffix, kGroupLighting, value});
  };
  const auto has = [&](uint8_t mask) { return (mask >> i & 1) != 0; };
  if (has(key.positional)) {
    add(Type::Vec3, "Position",
        [](const State& s, int n, float* out) { put(out, lightPosition(enabledLight(s, n))); });
  } else {
    add(Type::Vec3, "Direction",
        [](const State& s, int n, float* out) { put(out, lightDirection(enabledLight(s, n))); });
    if (key.specular)
      add(Type::Vec3, "Half",
          [](const State& s, int n, float* out) { put(out, halfVector(enabledLight(s, n))); });
  }
  if (has(key.spot)) {
    add(Type::Float, "CosCutoff",
        [](const State& s, int n, float* out) { *out = static_cast<float>(cosCutoff(enabledLight(s, n))); });
    add(Type::Vec3, "SpotDirection",
        [](const State& s, int n, float* out) { put(out, spotDirection(enabledLight(s, n))); });
    if (has(key.spotExponent))
      add(Type::Float, "SpotExponent",
          [](const State& s, int n, float* out) { *out = enabledLight(s, n).spotExponent; });
  }
  if (has(key.attenuated))
    add(Type::Vec3, "Attenuation",
        [](const State& s, int n, float* out) { put(out, glm::dvec3(enabledLight(s, n).attenuation)); });
  if (has(key.attenuated) || has(key.spot))
    add(Type::Vec3, "Ambient",
        [](const State& s, int n, float* out) { put(out, ambientProduct(s, enabledLight(s, n))); });
  add(Type::Vec3, "Diffuse",
      [](const State& s, int n, float* out) { put(out, diffuseProduct(s, enabledLight(s, n))); });
  if (key.specular)
    add(Type::Vec3, "Specular",
        [](const State& s, int n, float* out) { put(out, specularProduct(s, enabledLight(s, n))); });
}

// Rows of the texture matrix, as many as the fragment stage reads coordinates.
Member textureMatrix(Coordinate output, int unit) {
  Member m{Type::Mat2x4, "textureMatrix", unit, "", kGroupTextureMatrix, nullptr};
  switch (output) {
    case Coordinate::Stq:
      m.type = Type::Mat3x4;
      m.value = [](const State& s, int u, float* out) { putRows(out, s.units[u].matrix, 0, 1, 3); };
      break;
    case Coordinate::Str:
      m.type = Type::Mat3x4;
      m.value = [](const State& s, int u, float* out) { putRows(out, s.units[u].matrix, 0, 1, 2); };
      break;
    case Coordinate::Strq:
      m.type = Type::Mat4;
      m.value = [](const State& s, int u, float* out) { putRows(out, s.units[u].matrix, 0, 1, 2, 3); };
      break;
    default:
      m.value = [](const State& s, int u, float* out) { putRows(out, s.units[u].matrix, 0, 1); };
      break;
  }
  return m;
}

template <class Visit>
void visitUnits(const VertexKey& key, Visit visit) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    const VertexUnit& unit = key.units[u];
    if (unit.output == Coordinate::None) continue;
    if (key.fetch[texCoord(u)] == Fetch::Constant && unit.texGen == TexGen::None)
      visit({Type::Vec4, "coord", u, "", kGroupCurrentOther | kGroupTextureMatrix,
             [](const State& s, int n, float* out) { put(out, currentTexCoord(s, n)); }});
    else if (key.fetch[texCoord(u)] == Fetch::Constant)
      visit({Type::Vec4, "coord", u, "", kGroupCurrentOther, [](const State& s, int n, float* out) {
               put(out, glm::dvec4(s.attributes[texCoord(n)].current));
             }});
    if (unit.matrix) visit(textureMatrix(unit.output, u));
  }
}

template <class Visit>
void visitPoints(const VertexKey& key, Visit visit) {
  if (key.pointSize == PointSize::Constant)
    visit({Type::Float, "size", -1, "", kGroupPoints | kGroupFragmentOps | kGroupFramebuffer,
           [](const State& s, int, float* out) { *out = constantPointSize(s); }});
  if (key.pointRound)
    visit({Type::Vec4, "viewport", -1, "", kGroupViewport,
           [](const State& s, int, float* out) { put(out, viewportTransform(s.viewport)); }});
  if (key.pointFade)
    visit({Type::Float, "fadeThreshold", -1, "", kGroupPoints,
           [](const State& s, int, float* out) { *out = s.points.fadeThreshold; }});
  if (key.pointSize != PointSize::Varying) return;
  if (key.fetch[kPointSize] == Fetch::Constant)
    visit({Type::Float, "size", -1, "", kGroupPoints,
           [](const State& s, int, float* out) { *out = s.points.size; }});
  visit({Type::Vec2, "sizeRange", -1, "", kGroupPoints, [](const State& s, int, float* out) {
           const glm::dvec2 range = pointSizeRange(s.points);
           out[0] = static_cast<float>(range.x);
           out[1] = static_cast<float>(range.y);
         }});
  if (key.pointAttenuation)
    visit({Type::Vec3, "sizeAttenuation", -1, "", kGroupPoints,
           [](const State& s, int, float* out) { put(out, glm::dvec3(s.points.distanceAttenuation)); }});
}

// The shader multiplies them with what it has: eye coordinates with a palette, those of the object without.
Member clipPlane(const VertexKey& key, int plane) {
  if (key.palette)
    return {Type::Vec4, "clipPlane", plane, "", kGroupClipPlanes, [](const State& s, int n, float* out) {
              put(out, eyePlane(enabledPlane(s, n)));
            }};
  return {Type::Vec4,
          "clipPlane",
          plane,
          "",
          kGroupClipPlanes | kGroupModelview,
          [](const State& s, int n, float* out) { put(out, objectPlane(s, enabledPlane(s, n))); }};
}

template <class Visit>
void visitVertex(const VertexKey& key, Visit visit) {
  const Placement p = place(key);
  if (p.modelviewInBlock) visit(kModelview);
  if (p.normalInBlock) visit(kNormalMatrix);
  if (key.fetch[kPosition] == Fetch::Constant)
    visit({Type::Vec4, "position", -1, "", kGroupCurrentOther | kGroupArrays,
           [](const State& s, int, float* out) { put(out, glm::dvec4(s.attributes[kPosition].current)); }});
  if (key.fetch[kNormal] == Fetch::Constant && key.palette)
    visit({Type::Vec3, "normal", -1, "", kGroupCurrentOther,
           [](const State& s, int, float* out) { put(out, glm::dvec3(s.attributes[kNormal].current)); }});
  else if (key.fetch[kNormal] == Fetch::Constant)
    visit({Type::Vec3, "eyeNormal", -1, "", kGroupModelview | kGroupCurrentOther | kGroupLighting,
           [](const State& s, int, float* out) { put(out, currentEyeNormal(s)); }});
  if (key.color == VertexColor::Lit) visitScene(key, visit);
  for (int i = 0; i < key.lights; ++i) visitLight(key, i, visit);
  for (int i = 0; i < key.clipPlanes; ++i) visit(clipPlane(key, i));
  visitUnits(key, visit);
  visitPoints(key, visit);
}

// ---- Fragment stage

// Section 2.12.8: an alpha component has at least 2 bits.
float alphaScale(const State& s) {
  return std::exp2(static_cast<float>(s.alphaBits ? std::max<int>(s.alphaBits, 2) : 8)) - 1;
}

template <class Visit>
void visitFog(const FragmentKey& key, Visit visit) {
  if (key.fog != FogMode::None)
    visit({Type::Vec3, "fogColor", -1, "", kGroupFog,
           [](const State& s, int, float* out) { put(out, clampUnit(s.fog.color)); }});
  switch (key.fog != FogMode::None ? key.fog : key.fogSource) {
    case FogMode::Linear:
      visit({Type::Float, "fogEnd", -1, "", kGroupFog, [](const State& s, int, float* out) {
               const bool step = s.fog.start == s.fog.end;  // the distance itself is still clear
               *out = step ? std::max(std::nextafter(s.fog.end, HUGE_VALF), s.fog.end + 1e-30f) : s.fog.end;
             }});
      // start = end: so steep that it is a step.
      visit({Type::Float, "fogScale", -1, "", kGroupFog, [](const State& s, int, float* out) {
               const double width = static_cast<double>(s.fog.end) - s.fog.start;
               *out = static_cast<float>(std::clamp(width == 0 ? 1e37 : 1 / width, -1e37, 1e37));
             }});
      break;
    case FogMode::Exp:  // for exp2
      visit({Type::Float, "fogDensity", -1, "", kGroupFog, [](const State& s, int, float* out) {
               *out = static_cast<float>(s.fog.density * 1.4426950408889634);
             }});
      break;
    case FogMode::Exp2:
      visit({Type::Float, "fogDensity", -1, "", kGroupFog, [](const State& s, int, float* out) {
               *out = static_cast<float>(s.fog.density * 1.2011224087864498);  // sqrt(log2(e))
             }});
      break;
    default:
      break;
  }
}

template <class Visit>
void visitFragment(const FragmentKey& key, Visit visit) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    bool constant = false;
    forEachArgument(key.units[u], [&](Argument a) { constant |= a.source == Source::Constant; });
    if (constant)
      visit({Type::Vec4, "constant", u, "", kGroupTextures, [](const State& s, int n, float* out) {
               for (int i = 0; i < 4; ++i) out[i] = clampUnit(s.units[n].env.color[i]);
             }});
  }
  visitFog(key, visit);
  if (key.alphaTest != AlphaTest::Always && key.alphaTest != AlphaTest::Never) {
    visit({Type::Float, "alphaScale", -1, "", kGroupFramebuffer,
           [](const State& s, int, float* out) { *out = alphaScale(s); }});
    visit({Type::Float, "alphaReference", -1, "", kGroupAlphaTest | kGroupFramebuffer,
           [](const State& s, int, float* out) {
             *out = std::floor(clampUnit(s.alphaRef) * alphaScale(s) + 0.5f);
           }});
  }
}

// ---- Three readings of a block

constexpr uint32_t alignUp(uint32_t offset, uint32_t align) {
  return (offset + align - 1) / align * align;
}

struct Measure {
  uint32_t size = 0;
  Groups groups = 0;
  void operator()(const Member& m) {
    size = alignUp(size, info(m.type).align) + info(m.type).size;
    groups |= m.groups;
  }
  uint32_t total() const { return alignUp(size, 16); }
};

struct Pack {
  const State& state;
  std::byte* out;
  uint32_t offset = 0;
  void operator()(const Member& m) {
    float values[16] = {};
    m.value(state, m.index, values);
    const uint32_t at = alignUp(offset, info(m.type).align);
    std::fill_n(out + offset, at - offset, std::byte{});
    std::memcpy(out + at, values, info(m.type).size);
    offset = at + info(m.type).size;
  }
  void finish() const { std::fill_n(out + offset, alignUp(offset, 16) - offset, std::byte{}); }
};

// The same members as vertex inputs: each takes the locations of its columns.
struct DeclareInputs {
  std::string text;
  uint32_t location = kOwnValuesLocation;
  void operator()(const Member& m) {
    text += fmt::format("layout(location = {}) in {} {};\n", location, info(m.type).glsl, m.prefix);
    location += info(m.type).size / 16;
  }
};

struct Declare {
  std::string text;
  void operator()(const Member& m) {
    const std::string index = m.index < 0 ? "" : std::to_string(m.index);
    text += fmt::format("  {} {}{}{};\n", info(m.type).glsl, m.prefix, index, m.suffix);
  }
  std::string block(std::string_view head) const {
    return text.empty() ? "" : fmt::format("{} {{\n{}}};\n", head, text);
  }
};

}  // namespace

std::string declarePush(const VertexKey& key) {
  if (key.ownValues) {
    DeclareInputs inputs;
    visitPush(key, [&](const Member& m) { inputs(m); });
    return inputs.text;
  }
  Declare declare;
  visitPush(key, [&](const Member& m) { declare(m); });
  return declare.block("layout(push_constant) uniform Push");
}

std::string declareVertexConstants(const VertexKey& key) {
  Declare declare;
  visitVertex(key, [&](const Member& m) { declare(m); });
  return declare.block("layout(std140, set = 0, binding = 0) uniform Vertex");
}

std::string declareFragmentConstants(const FragmentKey& key) {
  Declare declare;
  visitFragment(key, [&](const Member& m) { declare(m); });
  return declare.block("layout(std140, set = 2, binding = 0) uniform Fragment");
}

Blocks blocks(const VertexKey& vertex, const FragmentKey& fragment) {
  Measure push, vertexBlock, fragmentBlock;
  visitPush(vertex, [&](const Member& m) { push(m); });
  visitVertex(vertex, [&](const Member& m) { vertexBlock(m); });
  visitFragment(fragment, [&](const Member& m) { fragmentBlock(m); });
  return {push.total(), vertexBlock.total(), fragmentBlock.total(), paletteSize(vertex),
          push.groups,  vertexBlock.groups,  fragmentBlock.groups,  paletteGroups(vertex)};
}

void packPush(const VertexKey& key, const State& state, std::byte* out) {
  Pack pack{state, out};
  visitPush(key, [&](const Member& m) { pack(m); });
  pack.finish();
}

void packVertex(const VertexKey& key, const State& state, std::byte* out) {
  Pack pack{state, out};
  visitVertex(key, [&](const Member& m) { pack(m); });
  pack.finish();
}

void packFragment(const FragmentKey& key, const State& state, std::byte* out) {
  Pack pack{state, out};
  visitFragment(key, [&](const Member& m) { pack(m); });
  pack.finish();
}

}  // namespace anteroom::gen
