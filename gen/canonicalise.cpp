// State to keys (DESIGN: dead state never reaches a key). Each key is first written down as the state says,
// then reduced.
#include <algorithm>

#include "gen/combiner.h"
#include "gen/gen.h"
#include "gen/palette.h"
#include "gen/reduce.h"
#include "gen/values.h"

namespace anteroom::gen {
namespace {

bool isOne(const glm::dvec4& lastRow) {
  return lastRow == glm::dvec4(0, 0, 0, 1);
}
glm::dvec4 lastRow(const glm::dmat4& m) {
  return {m[0][3], m[1][3], m[2][3], m[3][3]};
}

bool unitIsSprite(const State& state, int unit) {
  return state.primitive == PrimitiveClass::Points && state.points.sprite &&
         state.units[unit].env.coordReplace;
}

// Whether q is known to be 1 before the texture matrix.
bool qIsOne(const AttributeState& coord) {
  return coord.array ? coord.size < 4 : coord.current.w == 1;
}

// A constant coordinate is transformed and divided when constants are packed.
bool isConstant(const State& state, int unit) {
  return !state.attributes[texCoord(unit)].array && !state.units[unit].texGen;
}

Coordinate coordinateOf(const State& state, int unit) {
  const TextureUnit& in = state.units[unit];
  if (unitIsSprite(state, unit)) return Coordinate::Point;
  if (in.target == TextureTarget::CubeMap) return Coordinate::Str;  // a direction: q only scales it
  const bool divided =
      isConstant(state, unit) || (qIsOne(state.attributes[texCoord(unit)]) && isOne(lastRow(in.matrix)));
  if (in.target == TextureTarget::Texture3D) return divided ? Coordinate::Str : Coordinate::Strq;
  return divided ? Coordinate::St : Coordinate::Stq;
}

// Where coordinates do not change over a primitive there is no minification.
bool switchesLate(const State& state, int unit) {
  return state.units[unit].lateSwitchOver && state.primitive != PrimitiveClass::Points &&
         !isConstant(state, unit);
}

FogMode fogMode(const Fog& fog) {
  return fog.mode == GL_LINEAR ? FogMode::Linear : fog.mode == GL_EXP2 ? FogMode::Exp2 : FogMode::Exp;
}

AlphaTest alphaTest(const State& state) {
  if (!state.alphaTest) return AlphaTest::Always;
  switch (state.alphaFunc) {
    case GL_NEVER:
      return AlphaTest::Never;
    case GL_LESS:
      return AlphaTest::Less;
    case GL_EQUAL:
      return AlphaTest::Equal;
    case GL_LEQUAL:
      return AlphaTest::LessEqual;
    case GL_GREATER:
      return AlphaTest::Greater;
    case GL_NOTEQUAL:
      return AlphaTest::NotEqual;
    case GL_GEQUAL:
      return AlphaTest::GreaterEqual;
    default:
      return AlphaTest::Always;
  }
}

bool isAttenuated(const Points& points) {
  return points.distanceAttenuation != glm::vec3(1, 0, 0);
}
bool sizeVaries(const State& state) {
  return isAttenuated(state.points) || state.attributes[kPointSize].array;
}

PointShape pointShape(const State& state, const Profile& profile) {
  if (!profile.largePoints) return PointShape::Square;
  if (state.primitive != PrimitiveClass::Points || state.points.sprite) return PointShape::Square;
  if (state.multisample) return PointShape::RoundSamples;
  return state.points.smooth ? PointShape::Smooth : PointShape::Square;
}

// Section 3.3: whether a point can be smaller than the fade threshold.
bool pointFade(const State& state, const Profile& profile) {
  if (state.primitive != PrimitiveClass::Points || !state.multisample || !profile.largePoints) return false;
  return (sizeVaries(state) ? smallestPointSize(state) : constantPointSize(state)) <
         state.points.fadeThreshold;
}

uint8_t enabledPlanes(const State& state) {
  uint8_t count = 0;
  for (const ClipPlane& plane : state.clipPlanes) count += plane.enabled;
  return count;
}

bool isCoordinate(Attribute attribute) {
  return attribute == kPosition || (attribute >= kTexCoord0 && attribute <= kTexCoordLast);
}

Fetch fetchOf(const State& state, Attribute attribute) {
  const AttributeState& in = state.attributes[attribute];
  if (!in.array) return Fetch::Constant;
  const bool w1 = isCoordinate(attribute) && in.size < 4;
  const bool normal = attribute == kNormal;
  switch (in.type) {
    case GL_FIXED:
      return w1 ? Fetch::FixedW1 : Fetch::Fixed;
    case GL_BYTE:
      return normal ? Fetch::NormedByte : w1 ? Fetch::IntW1 : Fetch::Int;
    case GL_SHORT:
      return normal ? Fetch::NormedShort : w1 ? Fetch::IntW1 : Fetch::Int;
    // Of colors: a UNORM format.
    case GL_UNSIGNED_BYTE:
      return attribute == kMatrixIndex ? Fetch::Uint : Fetch::Float;
    default:
      return Fetch::Float;
  }
}

bool isBlack(const glm::vec4& color) {
  return color.r == 0 && color.g == 0 && color.b == 0;
}

void translateLights(const Lighting& lighting, VertexKey& key) {
  for (const Light& light : lighting.lights) {
    if (!light.enabled) continue;
    const uint8_t bit = static_cast<uint8_t>(1u << key.lights++);
    // The cone of a light at infinity holds all vertices or none: that is a matter of its constants.
    if (light.position.w == 0) continue;
    key.positional |= bit;
    if (light.attenuation != glm::vec3(1, 0, 0)) key.attenuated |= bit;
    if (light.spotCutoff == 180) continue;
    key.spot |= bit;
    if (light.spotExponent != 0) key.spotExponent |= bit;
  }
}

void translateLighting(const State& state, VertexKey& key) {
  const Lighting& lighting = state.lighting;
  key.color = VertexColor::Lit;
  key.colorMaterial = lighting.colorMaterial;
  key.specular = !isBlack(lighting.material.specular);
  key.shininess = lighting.material.shininess != 0;
  translateLights(lighting, key);
}

void translatePoints(const State& state, const FragmentKey& fragment, const Profile& profile,
                     VertexKey& key) {
  if (state.primitive != PrimitiveClass::Points) return;
  const Points& points = state.points;
  key.pointShape = fragment.pointShape;
  key.pointFade = fragment.pointFade;
  key.pointRound = !points.sprite && !state.multisample && fragment.pointShape == PointShape::Square;
  if (!profile.largePoints) {
    key.pointSize = PointSize::One;
    return;
  }
  key.pointAttenuation = isAttenuated(points);
  if (sizeVaries(state))
    key.pointSize = PointSize::Varying;
  else
    key.pointSize = constantPointSize(state) == 1 ? PointSize::One : PointSize::Constant;
}

void translateUnit(const State& state, int unit, Coordinate read, VertexUnit& out) {
  if (read == Coordinate::None || read == Coordinate::Point) return;
  const TextureUnit& in = state.units[unit];
  out.output = read;
  if (in.texGen) out.texGen = in.texGenMode == GL_NORMAL_MAP_OES ? TexGen::Normal : TexGen::Reflection;
  out.matrix = in.matrix != glm::dmat4(1.0);
  out.q1 = qIsOne(state.attributes[texCoord(unit)]);
}

// OES_matrix_palette: the size of the indices counts; weights that the array has not are 0.
void translatePalette(const State& state, VertexKey& key) {
  const AttributeState& index = state.attributes[kMatrixIndex];
  const AttributeState& weight = state.attributes[kWeight];
  if (!state.palette || !index.array || !weight.array) return;
  key.palette = std::min(index.size, weight.size);
  key.paletteW = !isAffine(*state.palette);
  key.paletteNormals = needsNormal(key) && !isOrthogonal(*state.palette);
}

}  // namespace

Groups keyGroups() {
  return kGroupTextureMatrix | kGroupCurrentOther | kGroupArrays | kGroupLighting | kGroupTextures |
         kGroupFog | kGroupPoints | kGroupClipPlanes | kGroupAlphaTest | kGroupFramebuffer |
         kGroupFragmentOps | kGroupPrimitive | kGroupPalette;
}

FragmentKey canonicaliseFragment(const State& state, const Profile& profile) {
  FragmentKey key{};
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    key.units[u].target = state.units[u].target;
    key.units[u].coordinate = coordinateOf(state, u);
    key.units[u].edges = state.units[u].edges;
    for (MirroredEdge& edge : key.units[u].edges)
      if (edge == MirroredEdge::Texel && profile.mirrorClampToEdge) edge = MirroredEdge::None;
    if (switchesLate(state, u)) key.switchOver |= static_cast<uint8_t>(1u << u);
    translateEnvironment(state, u, key.units[u]);
  }
  key.fogSource = fogMode(state.fog);
  if (state.fog.enabled) key.fog = key.fogSource;
  key.alphaTest = alphaTest(state);
  key.pointShape = pointShape(state, profile);
  key.pointFade = pointFade(state, profile);
  key.flatColor = state.shadeModel == GL_FLAT && state.primitive != PrimitiveClass::Points;
  bool lit = false;
  for (const Light& light : state.lighting.lights) lit |= light.enabled;
  key.twoSided = lit && state.lighting.enabled && state.lighting.twoSided &&
                 state.primitive == PrimitiveClass::Triangles;
  key.pointYUp = !state.framebufferYDown;
  if (!profile.clipDistance) key.discardPlanes = enabledPlanes(state);
  reduce(key);
  return key;
}

VertexKey canonicaliseVertex(const State& state, const FragmentKey& fragment, const Profile& profile,
                             CurrentColor color) {
  VertexKey key{};
  for (int a = 0; a < kAttributeCount; ++a) key.fetch[a] = fetchOf(state, static_cast<Attribute>(a));
  if (color == CurrentColor::OfVertices && !state.attributes[kColor].array) key.fetch[kColor] = Fetch::Float;
  if (readsPrimaryColor(fragment)) {
    key.color = VertexColor::Unlit;
    if (state.lighting.enabled) translateLighting(state, key);
    key.twoSided = fragment.twoSided;
  }
  key.normalize = state.lighting.normalize;  // of normals, whoever reads them
  key.fog = fragment.fog != FogMode::None || fragment.fogSource != FogMode::None;
  key.fogW = state.attributes[kPosition].array && state.attributes[kPosition].size == 4;
  key.clipPlanes = profile.clipDistance ? enabledPlanes(state) : fragment.discardPlanes;
  key.clipVaryings = !profile.clipDistance;
  translatePoints(state, fragment, profile, key);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    translateUnit(state, u, fragment.units[u].coordinate, key.units[u]);
  translatePalette(state, key);
  reduce(key);
  return key;
}

}  // namespace anteroom::gen
