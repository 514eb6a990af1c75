// The fixed-function state that decides what a vertex or a fragment computes, as plain data and in GL's
// words.
//
// It is filled by the GL front end and read twice: `canonicalise*` (gen/gen.h) reduces it to keys,
// and `pack*` takes the values that a key's shader reads. A renderer without shaders
// evaluates it directly. Sections are those of the OpenGL ES 1.1.12 full specification.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace anteroom::gen {

inline constexpr int kMaxTextureUnits = 8;
inline constexpr int kMaxLights = 8;
inline constexpr int kMaxClipPlanes = 8;
inline constexpr int kPaletteMatrices = 64;
inline constexpr int kMaxVertexUnits = 4;

// Groups of state that change together. A command marks the groups that it changed; nobody looks at a group
// again until it is marked. The order is of no meaning.
enum Group : uint32_t {
  kGroupModelview = 1u << 0,      // modelview matrix: only values, never structure
  kGroupProjection = 1u << 1,     // projection matrix: only values
  kGroupTextureMatrix = 1u << 2,  // texture matrices: values, and whether one is the identity
  kGroupCurrentColor = 1u << 3,   // current color: only a value
  kGroupCurrentOther = 1u << 4,   // current normal and texture coordinates (q = 1 is structure)
  kGroupArrays = 1u << 5,         // which arrays are enabled, their sizes, types, strides, sources
  kGroupLighting = 1u << 6,  // lighting enables, light model, lights, material, color material, shade model
  kGroupTextures = 1u << 7,  // unit enables, bindings, completeness, environments, texgen, sampler state
  kGroupFog = 1u << 8,
  kGroupPoints = 1u << 9,  // size, parameters, sprites, smoothing
  kGroupClipPlanes = 1u << 10,
  kGroupAlphaTest = 1u << 11,
  kGroupRaster = 1u << 12,       // culling, front face, polygon offset, line width and smoothing
  kGroupFragmentOps = 1u << 13,  // depth, stencil, blend, logic op, masks, multisample state
  kGroupViewport = 1u << 14,     // viewport, depth range, scissor
  kGroupFramebuffer = 1u << 15,  // draw framebuffer: attachments, size, orientation, bits
  kGroupPrimitive = 1u << 16,    // points, lines or triangles: set by the draw itself
  kGroupPalette = 1u << 17,      // palette matrices and the matrix palette enable
  kAllGroups = (1u << 18) - 1,
};
using Groups = uint32_t;

// Vertex attributes, in the order of their shader locations.
enum Attribute : uint8_t {
  kPosition,
  kNormal,
  kColor,
  kPointSize,
  kTexCoord0,
  kTexCoordLast = kTexCoord0 + kMaxTextureUnits - 1,
  kMatrixIndex,
  kWeight,
  kAttributeCount,
};
constexpr Attribute texCoord(int unit) {
  return static_cast<Attribute>(kTexCoord0 + unit);
}

// One attribute: what an enabled array supplies, or the current value (sections 2.7, 2.8). How a type is read
// follows from attribute and type: colors and BYTE/SHORT normals are normalised by Table 2.7, all else is
// taken as it is, FIXED divided by 65536.
struct AttributeState {
  bool array = false;
  uint8_t size = 4;               // components in memory
  GLenum type = GL_FLOAT;         // GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT
  glm::vec4 current{0, 0, 0, 1};  // used when no array is enabled
};

// Section 2.12.1, Table 2.8. Position and direction are in eye coordinates, already transformed by the
// modelview matrix that was current when they were set.
struct Light {
  bool enabled = false;
  glm::vec4 ambient{0, 0, 0, 1};
  glm::vec4 diffuse{0, 0, 0, 1};
  glm::vec4 specular{0, 0, 0, 1};
  glm::dvec4 position{0, 0, 1, 0};
  glm::dvec3 spotDirection{0, 0, -1};
  float spotExponent = 0;
  float spotCutoff = 180;          // degrees: [0, 90] or 180
  glm::vec3 attenuation{1, 0, 0};  // constant, linear, quadratic
};

struct Material {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1};
  glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1};
  glm::vec4 specular{0, 0, 0, 1};
  glm::vec4 emission{0, 0, 0, 1};
  float shininess = 0;
};

struct Lighting {
  bool enabled = false;
  bool colorMaterial = false;  // ambient and diffuse follow the current color (section 2.12.3)
  bool twoSided = false;
  bool normalize = false;
  bool rescaleNormal = false;
  glm::vec4 modelAmbient{0.2f, 0.2f, 0.2f, 1};
  Material material;
  std::array<Light, kMaxLights> lights;
};

enum class TextureTarget : uint8_t { None, Texture2D, CubeMap, Texture3D, Last = Texture3D };

// EXT_texture_mirror_clamp: what becomes of a coordinate outside [-1, 1]; None: it is left to the sampler.
// The border is transparent black. Half: filtered linearly, up to half of it is border (MIRROR_CLAMP); Whole:
// all of it (MIRROR_CLAMP_TO_BORDER); Hard: the same, not filtered.
enum class MirroredEdge : uint8_t { None, Texel, Half, Whole, Hard, Last = Hard };

// Section 3.7.12.
struct TextureEnv {
  GLenum mode = GL_MODULATE;
  glm::vec4 color{0, 0, 0, 0};
  GLenum combineRgb = GL_MODULATE;
  GLenum combineAlpha = GL_MODULATE;
  std::array<GLenum, 3> srcRgb{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  std::array<GLenum, 3> srcAlpha{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  std::array<GLenum, 3> operandRgb{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA};
  std::array<GLenum, 3> operandAlpha{GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA};
  float rgbScale = 1;    // 1, 2 or 4
  float alphaScale = 1;  // 1, 2 or 4
  // ATIX_texture_env_route: the unit whose texture this unit's result stands for; -1: none (gen/ati.h).
  int8_t outputRgb = -1;
  int8_t outputAlpha = -1;
  bool coordReplace = false;  // section 3.3: point sprites
  float lodBias = 0;
};

struct TextureUnit {
  // What is sampled: the enabled target of highest priority whose texture is complete; None: the unit is off.
  TextureTarget target = TextureTarget::None;
  GLenum baseFormat = GL_RGBA;  // GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA
  bool lateSwitchOver = false;  // minified only from a level of detail of 0.5 (c in section 3.7.8)
  TextureEnv env;
  bool texGen = false;                        // OES_texture_cube_map: s, t and r together
  GLenum texGenMode = GL_REFLECTION_MAP_OES;  // or GL_NORMAL_MAP_OES
  glm::dmat4 matrix{1.0};
  std::array<MirroredEdge, 3> edges{};  // along s, t and r
};

struct Fog {
  bool enabled = false;
  GLenum mode = GL_EXP;
  float density = 1;
  float start = 0;
  float end = 1;
  glm::vec4 color{0, 0, 0, 0};
};

struct Points {
  float size = 1;  // pixels
  float sizeMin = 0;
  float sizeMax = 1;    // the initial value is the implementation's largest size: set by the front end
  float deviceMin = 1;  // what the device can rasterise, pixels: constant in a context
  float deviceMax = 1;
  float fadeThreshold = 1;
  glm::vec3 distanceAttenuation{1, 0, 0};
  bool smooth = false;
  bool sprite = false;
};

struct ClipPlane {
  bool enabled = false;
  glm::dvec4 equation{0, 0, 0, 0};  // eye coordinates (section 2.11)
};

// OES_matrix_palette: from object to eye coordinates, as the modelview matrix.
struct Palette {
  Palette() { matrices.fill(glm::dmat4(1.0)); }
  std::array<glm::dmat4, kPaletteMatrices> matrices;
};

struct Rect {
  int x = 0, y = 0, width = 0, height = 0;  // pixels, origin at GL's lower left
};

enum class PrimitiveClass : uint8_t { Points, Lines, Triangles };

struct State {
  PrimitiveClass primitive = PrimitiveClass::Triangles;
  std::array<AttributeState, kAttributeCount> attributes;
  glm::dmat4 modelview{1.0};
  glm::dmat4 projection{1.0};
  // MATRIX_PALETTE is enabled: what vertices choose from instead of the modelview matrix. Null: it is not.
  const Palette* palette = nullptr;
  Lighting lighting;
  GLenum shadeModel = GL_SMOOTH;
  std::array<TextureUnit, kMaxTextureUnits> units;
  Fog fog;
  Points points;
  Rect viewport;
  bool lineSmooth = false;
  std::array<ClipPlane, kMaxClipPlanes> clipPlanes;

  bool alphaTest = false;
  GLenum alphaFunc = GL_ALWAYS;
  float alphaRef = 0;

  // What the fragment stage must know of the framebuffer.
  uint8_t alphaBits = 8;  // the alpha test compares at this precision (section 4.1.4); 0 reads as 8
  bool multisample =
      false;  // MULTISAMPLE enabled and samples > 1: smoothing becomes coverage (section 3.2.1)
  bool sampleAlphaToOne = false;
  bool framebufferYDown =
      false;  // row 0 of memory is the top row: windows; points count their t the other way
};

}  // namespace anteroom::gen
