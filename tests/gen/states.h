// States that the tests of gen start from.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "gen/ati.h"
#include "gen/gen.h"

namespace anteroom::gen {

struct Keys {
  FragmentKey fragment;
  VertexKey vertex;
};

inline Keys keysOf(const State& state, const Profile& profile = {}) {
  Keys keys;
  keys.fragment = canonicaliseFragment(state, profile);
  keys.vertex = canonicaliseVertex(state, keys.fragment, profile);
  return keys;
}

inline void enableArray(State& state, Attribute attribute, uint8_t size, GLenum type = GL_FLOAT) {
  state.attributes[attribute] = {true, size, type, {0, 0, 0, 1}};
}

// A triangle list with a position array and the current color.
inline State plainState() {
  State state;
  enableArray(state, kPosition, 3);
  state.attributes[kNormal].current = {0, 0, 1, 1};
  state.attributes[kColor].current = {1, 1, 1, 1};
  return state;
}

inline State texturedState(GLenum baseFormat = GL_RGBA, int units = 1) {
  State state = plainState();
  for (int u = 0; u < units; ++u) {
    enableArray(state, texCoord(u), 2);
    state.units[u].target = TextureTarget::Texture2D;
    state.units[u].baseFormat = baseFormat;
  }
  return state;
}

inline State litState(int lights = 1) {
  State state = plainState();
  enableArray(state, kNormal, 3);
  state.lighting.enabled = true;
  for (int i = 0; i < lights; ++i) {
    state.lighting.lights[i].enabled = true;
    state.lighting.lights[i].diffuse = {1, 1, 1, 1};
  }
  return state;
}

// A lit state with two weights a vertex, and a palette that lives as long as the process. `bent`: its
// matrices need matrices of their own for normals; `projective`: last rows of their own.
inline State skinnedState(bool bent = false, bool projective = false) {
  static const std::array<Palette, 4> palettes = [] {
    std::array<Palette, 4> made;
    for (size_t i = 0; i < made.size(); ++i) {
      made[i].matrices[3][3] = {5, 6, 7, 1};
      if (i & 1) made[i].matrices[1][0] = {2, 0.5, 0, 0};
      if (i & 2) made[i].matrices[2][2] = {0, 0, 1, -0.25};
    }
    return made;
  }();
  State state = litState();
  state.palette = &palettes[static_cast<size_t>(bent + 2 * projective)];
  enableArray(state, kMatrixIndex, 2, GL_UNSIGNED_BYTE);
  enableArray(state, kWeight, 2);
  return state;
}

inline State pointState() {
  State state = plainState();
  state.primitive = PrimitiveClass::Points;
  state.points.size = 8;
  state.points.sizeMax = state.points.deviceMax = 64;
  return state;
}

// Any state that GL can be in, with values from small sets so that special cases meet.
class RandomStates {
 public:
  explicit RandomStates(uint32_t seed) : engine_(seed) {}

  State next() {
    State s;
    s.primitive = pick({PrimitiveClass::Points, PrimitiveClass::Lines, PrimitiveClass::Triangles});
    attributes(s);
    s.modelview = matrix();
    s.projection = matrix();
    lighting(s.lighting);
    s.shadeModel = pick({GL_SMOOTH, GL_FLAT});
    for (TextureUnit& unit : s.units) textureUnit(unit);
    s.fog = {coin(), pick<GLenum>({GL_LINEAR, GL_EXP, GL_EXP2}), number(), number(), number(), color()};
    points(s.points);
    s.lineSmooth = coin();
    for (ClipPlane& plane : s.clipPlanes) plane = {coin(4), glm::dvec4(color())};
    s.alphaTest = coin();
    s.alphaFunc = GL_NEVER + static_cast<GLenum>(index(8));
    s.alphaRef = number();
    s.alphaBits = pick<uint8_t>({0, 1, 4, 8});
    s.multisample = coin(4);
    s.framebufferYDown = coin();
    if (coin(3)) palette(s);
    return s;
  }

  bool coin(int oneIn = 2) { return index(oneIn) == 0; }
  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  uint8_t byte() { return static_cast<uint8_t>(index(256)); }

 private:
  template <class T>
  T pick(std::initializer_list<T> values) {
    return values.begin()[index(static_cast<int>(values.size()))];
  }
  float number() { return pick({0.0f, 1.0f, 0.5f, 2.0f, -1.0f, 1e-30f, 1e30f, 3.25f}); }
  glm::vec4 color() { return {number(), number(), number(), number()}; }
  glm::dmat4 matrix() {
    if (coin()) return glm::dmat4(1.0);
    glm::dmat4 m(1.0);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) m[c][r] = number();
    if (coin()) m[2][3] = -1, m[3][3] = 0;
    return m;
  }
  void attributes(State& s) {
    for (int a = 0; a < kAttributeCount; ++a) s.attributes[a] = {coin(), 4, GL_FLOAT, color()};
    s.attributes[kPosition] = {true, pick<uint8_t>({2, 3, 4}), coordinateArrayType(), {}};
    s.attributes[kNormal].type = pick<GLenum>({GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT});
    s.attributes[kNormal].size = 3;
    s.attributes[kColor].type = pick<GLenum>({GL_UNSIGNED_BYTE, GL_FIXED, GL_FLOAT});
    s.attributes[kPointSize].type = pick<GLenum>({GL_FIXED, GL_FLOAT});
    s.attributes[kPointSize].size = 1;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      s.attributes[texCoord(u)].type = coordinateArrayType();
      s.attributes[texCoord(u)].size = pick<uint8_t>({2, 3, 4});
    }
    s.attributes[kMatrixIndex].type = GL_UNSIGNED_BYTE;
    s.attributes[kMatrixIndex].size = static_cast<uint8_t>(1 + index(4));
    s.attributes[kWeight].type = pick<GLenum>({GL_FIXED, GL_FLOAT});
    s.attributes[kWeight].size = static_cast<uint8_t>(1 + index(4));
  }
  // Kept as long as this object.
  void palette(State& s) {
    palettes_.push_back(std::make_unique<Palette>());
    for (int i = index(4); i > 0; --i) palettes_.back()->matrices[index(kPaletteMatrices)] = matrix();
    s.palette = palettes_.back().get();
    s.attributes[kMatrixIndex].array = !coin(8);
    s.attributes[kWeight].array = !coin(8);
  }
  GLenum coordinateArrayType() { return pick<GLenum>({GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT}); }
  void lighting(Lighting& l) {
    l.enabled = coin();
    l.colorMaterial = coin();
    l.twoSided = coin();
    l.normalize = coin();
    l.rescaleNormal = coin();
    l.modelAmbient = color();
    l.material = {color(), color(), coin() ? glm::vec4(0, 0, 0, 1) : color(), color(), number()};
    for (Light& light : l.lights) {
      light = {coin(5),
               color(),
               color(),
               color(),
               glm::dvec4(color()),
               glm::dvec3(color()),
               number(),
               pick({180.0f, 90.0f, 30.0f, 0.0f}),
               coin() ? glm::vec3(1, 0, 0) : glm::vec3(color())};
    }
  }
  void textureUnit(TextureUnit& unit) {
    unit.target = !coin(3)
                      ? TextureTarget::None
                      : pick({TextureTarget::Texture2D, TextureTarget::CubeMap, TextureTarget::Texture3D});
    unit.baseFormat = pick<GLenum>({GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA});
    unit.lateSwitchOver = coin(4);
    unit.texGen = coin(4);
    unit.texGenMode = pick<GLenum>({GL_REFLECTION_MAP_OES, GL_NORMAL_MAP_OES});
    unit.matrix = matrix();
    for (MirroredEdge& edge : unit.edges)
      if (coin(6))
        edge = pick({MirroredEdge::Texel, MirroredEdge::Half, MirroredEdge::Whole, MirroredEdge::Hard});
    TextureEnv& env = unit.env;
    env.mode = pick<GLenum>({GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE, GL_COMBINE,
                             GL_COMBINE, GL_MODULATE_COLOR_IMG, GL_RECIP_ADD_SIGNED_ALPHA_IMG,
                             GL_TEXTURE_ALPHA_MODULATE_IMG, GL_FACTOR_ALPHA_MODULATE_IMG,
                             GL_FRAGMENT_ALPHA_MODULATE_IMG, GL_ADD_BLEND_IMG, GL_DOT3_RGBA_IMG});
    env.color = color();
    env.combineRgb = pick<GLenum>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                   GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA, kModulateAdd, kModulateSignedAdd,
                                   kModulateSubtract, kDot3RgbExt, kDot3RgbaExt});
    env.combineAlpha = pick<GLenum>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                     GL_SUBTRACT, kModulateAdd, kModulateSignedAdd, kModulateSubtract});
    for (int i = 0; i < 3; ++i) {
      env.srcRgb[i] = coin(12) ? kSecondaryColor : source();
      env.srcAlpha[i] = coin(12) ? GL_FOG : source();
      env.operandRgb[i] =
          pick<GLenum>({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
      env.operandAlpha[i] = pick<GLenum>({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
    }
    env.rgbScale = pick({1.0f, 2.0f, 4.0f});
    env.alphaScale = pick({1.0f, 2.0f, 4.0f});
    env.outputRgb = static_cast<int8_t>(coin(3) ? index(kMaxTextureUnits) : -1);
    env.outputAlpha = static_cast<int8_t>(coin(3) ? index(kMaxTextureUnits) : -1);
    env.coordReplace = coin();
  }
  GLenum source() {
    return coin(4) ? GL_TEXTURE0 + static_cast<GLenum>(index(kMaxTextureUnits))
                   : pick<GLenum>({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_ZERO, GL_ONE});
  }
  void points(Points& p) {
    p.size = pick({1.0f, 0.3f, 7.5f, 64.0f});
    p.sizeMin = pick({0.0f, 2.0f});
    p.sizeMax = pick({1.0f, 64.0f});
    p.deviceMax = pick({1.0f, 256.0f});
    p.fadeThreshold = pick({0.0f, 1.0f, 5.0f});
    p.distanceAttenuation = coin() ? glm::vec3(1, 0, 0) : glm::vec3(color());
    p.smooth = coin();
    p.sprite = coin();
  }

  std::mt19937 engine_;
  std::vector<std::unique_ptr<Palette>> palettes_;
};

}  // namespace anteroom::gen
