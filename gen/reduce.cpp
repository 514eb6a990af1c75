#include "gen/reduce.h"

#include "gen/combiner.h"

namespace anteroom::gen {
namespace {

// Combiners that read a texture which the key does not have.
void dropUnitsWithoutTexture(FragmentKey& key) {
  for (FragmentUnit& unit : key.units) {
    bool missing = false;
    forEachArgument(unit, [&](Argument argument) {
      const int sampled = sampledUnit(argument.source);
      missing |= sampled >= 0 && key.units[sampled].target == TextureTarget::None;
    });
    if (missing) unit.rgb = unit.alpha = {};
  }
}

bool fits(TextureTarget target, Coordinate coordinate) {
  switch (target) {
    case TextureTarget::Texture2D:
      return coordinate == Coordinate::St || coordinate == Coordinate::Stq || coordinate == Coordinate::Point;
    case TextureTarget::CubeMap:
      return coordinate == Coordinate::Str || coordinate == Coordinate::Point;
    case TextureTarget::Texture3D:
      return coordinate == Coordinate::Str || coordinate == Coordinate::Strq ||
             coordinate == Coordinate::Point;
    default:
      return coordinate == Coordinate::None;
  }
}

Coordinate simplest(TextureTarget target) {
  if (target == TextureTarget::None) return Coordinate::None;
  return target == TextureTarget::Texture2D ? Coordinate::St : Coordinate::Str;
}

void reduceLights(VertexKey& key) {
  const uint8_t enabled = static_cast<uint8_t>((1u << key.lights) - 1);
  key.positional &= enabled;
  key.attenuated &= key.positional;
  key.spot &= key.positional;
  key.spotExponent &= key.spot;
  if (key.lights == 0) key.twoSided = key.specular = 0;
  key.shininess &= key.specular;
}

void dropLighting(VertexKey& key) {
  key.twoSided = key.colorMaterial = key.specular = key.shininess = key.lights = 0;
  key.positional = key.attenuated = key.spot = key.spotExponent = 0;
}

Fetch withoutW(Fetch fetch) {
  return fetch == Fetch::Fixed ? Fetch::FixedW1 : fetch == Fetch::Int ? Fetch::IntW1 : fetch;
}

void reduceUnit(VertexUnit& unit, Fetch& fetch) {
  if (unit.output == Coordinate::None) {
    unit = {};
    fetch = Fetch::Unread;
    return;
  }
  const bool writesQ = unit.output == Coordinate::Stq || unit.output == Coordinate::Strq;
  if (fetch == Fetch::FixedW1 || fetch == Fetch::IntW1) unit.q1 = 1;
  if (unit.texGen != TexGen::None) {
    if (!unit.matrix && !writesQ) unit.q1 = 1;  // q is not read
    if (unit.q1) fetch = Fetch::Unread;
    return;
  }
  if (fetch == Fetch::Constant) {  // transformed and divided with the constants
    if (writesQ) unit.output = unit.output == Coordinate::Stq ? Coordinate::St : Coordinate::Str;
    unit.matrix = 0;
    unit.q1 = 1;
    return;
  }
  if (!unit.matrix && !writesQ) unit.q1 = 1;
  // An array without q, and one whose q is not read, are fetched alike. For floats vertex input supplies
  // the 1.
  if (unit.q1) fetch = withoutW(fetch);
  if (fetch == Fetch::Float) unit.q1 = 1;
}

// Without indices and weights there is no palette, and without a palette nobody reads them.
void reducePalette(VertexKey& key) {
  const Fetch weight = key.fetch[kWeight];
  if (key.fetch[kMatrixIndex] != Fetch::Uint || weight == Fetch::Unread || weight == Fetch::Constant)
    key.palette = 0;
  if (!key.palette) {
    key.fetch[kMatrixIndex] = key.fetch[kWeight] = Fetch::Unread;
    key.paletteW = key.paletteNormals = 0;
  }
  if (!needsNormal(key)) key.paletteNormals = 0;
}

}  // namespace

bool readsPrimaryColor(const FragmentKey& key) {
  return key.alphaTest != AlphaTest::Never && readsPrimaryColor(key.units);
}

void reduce(FragmentKey& key) {
  if (key.alphaTest == AlphaTest::Never) {
    key = {};
    key.alphaTest = AlphaTest::Never;
    return;
  }
  dropUnitsWithoutTexture(key);
  reduceCombiners(key.units);
  const uint32_t sampled = texturesRead(key.units);
  bool sprite = false;
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    FragmentUnit& unit = key.units[u];
    if (!(sampled >> u & 1)) {
      unit.target = TextureTarget::None;
      unit.coordinate = Coordinate::None;
    }
    if (!fits(unit.target, unit.coordinate)) unit.coordinate = simplest(unit.target);
    // Cube maps are not wrapped (OES_texture_cube_map).
    if (unit.target == TextureTarget::None || unit.target == TextureTarget::CubeMap) unit.edges = {};
    if (unit.target == TextureTarget::Texture2D) unit.edges[2] = MirroredEdge::None;
    if (unit.coordinate == Coordinate::None || unit.coordinate == Coordinate::Point)
      key.switchOver &= static_cast<uint8_t>(~(1u << u));
    sprite |= unit.coordinate == Coordinate::Point;
  }
  // One factor serves both.
  if (!reads(key.units, Source::Fog))
    key.fogSource = FogMode::None;
  else if (key.fog != FogMode::None)
    key.fogSource = key.fog;
  else if (key.fogSource == FogMode::None)
    key.fogSource = FogMode::Exp;
  if (!readsPrimaryColor(key.units)) key.flatColor = key.twoSided = 0;
  if (!sprite) key.pointYUp = 0;
}

bool needsNormal(const VertexKey& key) {
  if (key.color == VertexColor::Lit && key.lights > 0) return true;
  for (const VertexUnit& unit : key.units)
    if (unit.texGen != TexGen::None) return true;
  return false;
}

bool needsEye(const VertexKey& key) {
  if (key.color == VertexColor::Lit && key.positional != 0) return true;
  if (key.pointAttenuation) return true;
  for (const VertexUnit& unit : key.units)
    if (unit.texGen == TexGen::Reflection) return true;
  return false;
}

void reduce(VertexKey& key) {
  for (int u = 0; u < kMaxTextureUnits; ++u) reduceUnit(key.units[u], key.fetch[texCoord(u)]);

  if (key.color != VertexColor::Lit) dropLighting(key);
  reduceLights(key);
  if (key.color == VertexColor::None || (key.color == VertexColor::Lit && !key.colorMaterial))
    key.fetch[kColor] = Fetch::Unread;
  if (!needsNormal(key)) key.fetch[kNormal] = Fetch::Unread;
  reducePalette(key);
  // A constant normal is transformed, and normalised, with the constants, unless each vertex has its
  // matrices.
  const bool constant = key.fetch[kNormal] == Fetch::Constant && !key.palette;
  if (key.fetch[kNormal] == Fetch::Unread || constant) key.normalize = 0;

  if (key.pointSize == PointSize::None) {
    key.pointShape = PointShape::Square;
    key.pointFade = key.pointRound = 0;
  }
  if (key.pointSize != PointSize::Varying) {
    key.pointAttenuation = 0;
    key.fetch[kPointSize] = Fetch::Unread;
  }
  if (!key.fog || needsEye(key) || key.palette) key.fogW = 0;
  if (key.clipPlanes == 0) key.clipVaryings = 0;
}

}  // namespace anteroom::gen
