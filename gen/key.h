// What a shader is made from: the least that the picture depends on, as plain bytes. Two states with equal
// keys share their shaders. Keys are made by canonicalise* (gen/gen.h), compared whole, and durable: they are
// what the shader cache stores. `Last` is the last value of an enumeration: it tells how many words it has as
// text (gen/describe.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "gen/state.h"

namespace anteroom::gen {

// ---- Fragment ----
// Texturing, fog, point shape, alpha test (chapters 3 and 4).

// What a combiner argument is taken from. Previous: the result so far; before the first unit, the primary
// color. Fog: the fog factor. Output: the result of an earlier unit that is no longer the previous one.
enum class Source : uint8_t {
  Previous,
  Primary,
  Constant,
  Zero,
  One,
  Texture0,
  TextureLast = Texture0 + kMaxTextureUnits - 1,
  Fog,
  Output0,
  OutputLast = Output0 + kMaxTextureUnits - 1,
  Last = OutputLast
};
constexpr Source textureSource(int unit) {
  return static_cast<Source>(static_cast<int>(Source::Texture0) + unit);
}
constexpr Source outputSource(int unit) {
  return static_cast<Source>(static_cast<int>(Source::Output0) + unit);
}

enum class Operand : uint8_t { Color, OneMinusColor, Alpha, OneMinusAlpha };

struct Argument {
  Source source;
  Operand operand;
};

// Keep leaves the previous color as it is. Every environment mode is one of these (tables 3.15-3.17 and
// ATI_texture_env_combine3).
enum class Function : uint8_t {
  Keep,
  Replace,
  Modulate,
  Add,
  AddSigned,
  Interpolate,
  Subtract,
  Dot3,
  ModulateAdd,
  ModulateSignedAdd,
  ModulateSubtract,
  Last = ModulateSubtract
};

// Unused arguments are zero. In an alpha combiner, Dot3 stands for DOT3_RGBA and has the arguments of the
// color.
struct Combiner {
  Function function;
  uint8_t scaleLog2;  // 0, 1, 2: the result is scaled by 1, 2, 4
  std::array<Argument, 3> arguments;
};

// What a unit's coordinates are made of. Without q it is 1; Point: the point sprite's own.
enum class Coordinate : uint8_t { None, St, Stq, Str, Strq, Point, Last = Point };

struct FragmentUnit {
  TextureTarget target;  // None: not sampled
  Coordinate coordinate;
  std::array<MirroredEdge, 3> edges;  // along s, t and r
  Combiner rgb, alpha;
};

enum class FogMode : uint8_t { None, Linear, Exp, Exp2, Last = Exp2 };
enum class AlphaTest : uint8_t {
  Always,
  Never,
  Less,
  Equal,
  LessEqual,
  Greater,
  NotEqual,
  GreaterEqual,
  Last = GreaterEqual
};
// Square: all that is rasterised. Smooth: a circle whose coverage goes into alpha (section 3.3.1).
// RoundSamples: a circle by samples (multisampling).
enum class PointShape : uint8_t { Square, Smooth, RoundSamples, Last = RoundSamples };

struct FragmentKey {
  std::array<FragmentUnit, kMaxTextureUnits> units;
  FogMode fog;        // the color is fogged
  FogMode fogSource;  // some combiner reads the fog factor
  AlphaTest alphaTest;
  PointShape pointShape;
  uint8_t pointFade;      // 0, 1: alpha is scaled by equation 3.2
  uint8_t flatColor;      // 0, 1: the color of the provoking vertex
  uint8_t twoSided;       // 0, 1: a back color, chosen by gl_FrontFacing
  uint8_t pointYUp;       // 0, 1: gl_PointCoord runs in GL's direction of y: t is turned
  uint8_t discardPlanes;  // 0-8: clip planes that the fragment stage must do
  uint8_t switchOver;     // bit u: unit u is minified only from a level of detail of 0.5 (section 3.7.8)
};

// ---- Vertex ----
// Transformation, lighting, texture coordinates, point size (chapter 2).

// How the shader gets an attribute. Constant: from the constants, as no array is enabled. W1 says that the
// array has no fourth component (it is 1); floats need not say it, vertex input fills them. Normed:
// Table 2.7.
enum class Fetch : uint8_t {
  Unread,
  Constant,
  Float,
  Fixed,
  FixedW1,
  Int,
  IntW1,
  Uint,
  NormedByte,
  NormedShort,
  Last = NormedShort
};

enum class VertexColor : uint8_t { None, Unlit, Lit, Last = Lit };

enum class TexGen : uint8_t { None, Reflection, Normal, Last = Normal };

struct VertexUnit {
  Coordinate output;  // None, St, Stq, Str or Strq: what the fragment stage reads
  TexGen texGen;
  uint8_t matrix;  // 0, 1: a texture matrix other than the identity
  uint8_t q1;      // 0, 1: q is 1 before the matrix
};

// One: gl_PointSize is 1. Constant: the derived size, from the constants. Varying: by vertex.
enum class PointSize : uint8_t { None, One, Constant, Varying, Last = Varying };

struct VertexKey {
  std::array<Fetch, kAttributeCount> fetch;
  VertexColor color;
  uint8_t twoSided;       // 0, 1
  uint8_t colorMaterial;  // 0, 1
  uint8_t normalize;      // 0, 1
  uint8_t specular;       // 0, 1: the material's specular color is not black
  uint8_t shininess;      // 0, 1: it is not 0
  uint8_t lights;         // 0-8: enabled lights, in order, without gaps
  // Bit i: light i (of the enabled ones) ...
  uint8_t positional;    // ... is not at infinity
  uint8_t attenuated;    // ... is attenuated by other than (1, 0, 0)
  uint8_t spot;          // ... has a cone
  uint8_t spotExponent;  // ... whose exponent is not 0
  uint8_t fog;           // 0, 1: the distance is written
  uint8_t fogW;          // 0, 1: and divided by the eye's w, as positions have one
  uint8_t clipPlanes;    // 0-8
  uint8_t clipVaryings;  // 0, 1: clip distances go to the fragment stage instead of the clipper
  PointSize pointSize;
  uint8_t pointAttenuation;  // 0, 1
  uint8_t pointRound;        // 0, 1: size and place, to whole pixels (section 3.3.1)
  PointShape pointShape;     // not Square: the fragment stage gets the diameter
  uint8_t pointFade;         // 0, 1: points are no smaller than the fade threshold, and fade instead
  uint8_t palette;           // 0-4: the weights of a vertex; 0: no matrix palette
  uint8_t paletteW;          // 0, 1: its matrices have a last row other than (0, 0, 0, 1)
  uint8_t paletteNormals;    // 0, 1: it has matrices for normals; otherwise its own, which are orthogonal, do
  // 0, 1: what would be push constants comes with each vertex. Canonicalise never says so: it is the
  // renderer's choice.
  uint8_t ownValues;
  std::array<VertexUnit, kMaxTextureUnits> units;
};

static_assert(std::is_trivially_copyable_v<FragmentKey> && std::is_trivially_copyable_v<VertexKey>);
static_assert(std::has_unique_object_representations_v<FragmentKey>);
static_assert(std::has_unique_object_representations_v<VertexKey>);
static_assert(sizeof(FragmentKey) == 21 * kMaxTextureUnits + 10);
static_assert(sizeof(VertexKey) == kAttributeCount + 24 + 4 * kMaxTextureUnits);

inline bool operator==(const FragmentKey& a, const FragmentKey& b) {
  return !std::memcmp(&a, &b, sizeof a);
}
inline bool operator==(const VertexKey& a, const VertexKey& b) {
  return !std::memcmp(&a, &b, sizeof a);
}

}  // namespace anteroom::gen
