// State that no pixel depends on never changes a key.
#include <gtest/gtest.h>

#include <functional>

#include "tests/gen/states.h"

namespace anteroom::gen {
namespace {

using Change = std::function<void(State&)>;

struct DeadState {
  const char* name;
  State base;
  Change change;
};

State with(State state, const Change& change) {
  change(state);
  return state;
}

State combineState() {
  return with(texturedState(), [](State& s) { s.units[0].env.mode = GL_COMBINE; });
}

void lightEverything(Light& light) {
  light.enabled = true;
  light.position = {1, 2, 3, 1};
  light.spotCutoff = 20;
  light.spotExponent = 3;
  light.attenuation = {1, 1, 1};
}

std::vector<DeadState> textureStates() {
  const State replaced = with(texturedState(GL_RGBA, 2), [](State& s) { s.units[1].env.mode = GL_REPLACE; });
  return {
      {"environment of a disabled unit", texturedState(),
       [](State& s) { s.units[3].env.mode = GL_ADD, s.units[3].env.rgbScale = 4; }},
      {"texture matrix of a disabled unit", texturedState(), [](State& s) { s.units[3].matrix[0][0] = 2; }},
      {"coordinates of a disabled unit", texturedState(), [](State& s) { enableArray(s, texCoord(3), 4); }},
      {"texgen of a disabled unit", texturedState(), [](State& s) { s.units[3].texGen = true; }},
      {"base format of a disabled unit", texturedState(), [](State& s) { s.units[3].baseFormat = GL_ALPHA; }},
      {"texgen mode without texgen", texturedState(),
       [](State& s) { s.units[0].texGenMode = GL_NORMAL_MAP_OES; }},
      {"combiner functions without COMBINE", texturedState(),
       [](State& s) { s.units[0].env.combineRgb = s.units[0].env.combineAlpha = GL_SUBTRACT; }},
      {"combiner sources without COMBINE", texturedState(),
       [](State& s) { s.units[0].env.srcRgb[0] = s.units[0].env.srcAlpha[1] = GL_CONSTANT; }},
      {"scales without COMBINE", texturedState(),
       [](State& s) { s.units[0].env.rgbScale = s.units[0].env.alphaScale = 4; }},
      {"third argument of MODULATE", combineState(),
       [](State& s) { s.units[0].env.srcRgb[2] = GL_PREVIOUS; }},
      {"third operand of MODULATE", combineState(),
       [](State& s) { s.units[0].env.operandRgb[2] = GL_ONE_MINUS_SRC_COLOR; }},
      {"third alpha argument of MODULATE", combineState(),
       [](State& s) { s.units[0].env.srcAlpha[2] = GL_TEXTURE; }},
      {"second argument of REPLACE",
       with(combineState(), [](State& s) { s.units[0].env.combineRgb = GL_REPLACE; }),
       [](State& s) { s.units[0].env.srcRgb[1] = GL_CONSTANT; }},
      {"alpha combiner under DOT3_RGBA",
       with(combineState(), [](State& s) { s.units[0].env.combineRgb = GL_DOT3_RGBA; }),
       [](State& s) { s.units[0].env.combineAlpha = GL_ADD, s.units[0].env.srcAlpha[0] = GL_CONSTANT; }},
      {"order of the arguments of MODULATE", combineState(),
       [](State& s) { std::swap(s.units[0].env.srcRgb[0], s.units[0].env.srcRgb[1]); }},
      {"COMBINE that says MODULATE", texturedState(), [](State& s) { s.units[0].env.mode = GL_COMBINE; }},
      {"PRIMARY_COLOR for PREVIOUS at the first unit", combineState(),
       [](State& s) { s.units[0].env.srcRgb[1] = s.units[0].env.srcAlpha[1] = GL_PRIMARY_COLOR; }},
      {"TEXTURE0 for TEXTURE at unit 0", combineState(),
       [](State& s) { s.units[0].env.srcRgb[0] = GL_TEXTURE0; }},
      {"mirrored edges of a cube map",
       with(texturedState(), [](State& s) { s.units[0].target = TextureTarget::CubeMap; }),
       [](State& s) {
         s.units[0].edges = {MirroredEdge::Whole, MirroredEdge::Half, MirroredEdge::Hard};
       }},
      {"the third edge of a 2D texture", texturedState(),
       [](State& s) { s.units[0].edges[2] = MirroredEdge::Whole; }},
      {"edges of a disabled unit", texturedState(),
       [](State& s) { s.units[3].edges[0] = MirroredEdge::Half; }},
      {"an edge that the sampler does", texturedState(),
       [](State& s) { s.units[0].edges[0] = MirroredEdge::Texel; }},
      {"the fog factor of a fog that no combiner reads", texturedState(),
       [](State& s) { s.fog.mode = GL_LINEAR, s.fog.density = 3; }},
      {"a result routed to a unit that nobody reads", texturedState(GL_RGBA, 2),
       [](State& s) { s.units[0].env.outputRgb = s.units[0].env.outputAlpha = 5; }},
      {"the previous result by its route",
       with(texturedState(GL_RGBA, 2),
            [](State& s) { s.units[1].env.mode = GL_COMBINE, s.units[0].env.outputRgb = 5; }),
       [](State& s) { s.units[1].env.srcRgb[1] = GL_TEXTURE5; }},
      {"SECONDARY_COLOR for ZERO", with(combineState(), [](State& s) { s.units[0].env.srcRgb[1] = GL_ZERO; }),
       [](State& s) { s.units[0].env.srcRgb[1] = kSecondaryColor; }},
      {"MODULATE_ADD of ZERO", with(combineState(), [](State& s) { s.units[0].env.srcRgb[1] = GL_CONSTANT; }),
       [](State& s) {
         s.units[0].env.combineRgb = kModulateAdd;
         s.units[0].env.srcRgb = {GL_TEXTURE, GL_ZERO, GL_CONSTANT};
         s.units[0].env.operandRgb[2] = GL_SRC_COLOR;
       }},
      {"a unit that REPLACE makes dead", replaced, [](State& s) { s.units[0].env.mode = GL_ADD; }},
      {"switching off a unit that REPLACE makes dead", replaced,
       [](State& s) { s.units[0].target = TextureTarget::None; }},
      {"color array under REPLACE", replaced, [](State& s) { enableArray(s, kColor, 4, GL_UNSIGNED_BYTE); }},
      {"lighting under REPLACE", replaced,
       [](State& s) { s.lighting.enabled = true, lightEverything(s.lighting.lights[2]); }},
      {"shade model under REPLACE", replaced, [](State& s) { s.shadeModel = GL_FLAT; }},
      {"an identity stage",
       with(texturedState(GL_RGBA, 2),
            [](State& s) {
              s.units[1].env.mode = GL_COMBINE;
              s.units[1].env.combineRgb = s.units[1].env.combineAlpha = GL_REPLACE;
              s.units[1].env.srcRgb[0] = s.units[1].env.srcAlpha[0] = GL_PREVIOUS;
            }),
       [](State& s) { s.units[1].target = TextureTarget::None; }},
      {"LUMINANCE for RGB", texturedState(GL_RGB), [](State& s) { s.units[0].baseFormat = GL_LUMINANCE; }},
      {"LUMINANCE_ALPHA for RGBA", texturedState(),
       [](State& s) { s.units[0].baseFormat = GL_LUMINANCE_ALPHA; }},
      {"REPLACE for DECAL with RGB",
       with(texturedState(GL_RGB), [](State& s) { s.units[0].env.mode = GL_REPLACE; }),
       [](State& s) { s.units[0].env.mode = GL_DECAL; }},
      {"MODULATE, BLEND and ADD of an ALPHA texture", texturedState(GL_ALPHA),
       [](State& s) { s.units[0].env.mode = GL_BLEND; }},
      {"the environment's color", texturedState(),
       [](State& s) {
         s.units[0].env.color = {1, 1, 0, 1};
       }},
      {"the switch-over of a disabled unit", texturedState(),
       [](State& s) { s.units[3].lateSwitchOver = true; }},
      {"the switch-over of a unit that REPLACE makes dead", replaced,
       [](State& s) { s.units[0].lateSwitchOver = true; }},
      {"the switch-over of constant coordinates",
       with(texturedState(), [](State& s) { s.attributes[kTexCoord0].array = false; }),
       [](State& s) { s.units[0].lateSwitchOver = true; }},
      {"the switch-over of points",
       with(texturedState(), [](State& s) { s.primitive = PrimitiveClass::Points; }),
       [](State& s) { s.units[0].lateSwitchOver = true; }},
      {"bias of the level of detail", texturedState(), [](State& s) { s.units[0].env.lodBias = 2; }},
      {"COORD_REPLACE for triangles", texturedState(), [](State& s) { s.units[0].env.coordReplace = true; }},
      {"COORD_REPLACE without sprites",
       with(texturedState(), [](State& s) { s.primitive = PrimitiveClass::Points; }),
       [](State& s) { s.units[0].env.coordReplace = true; }},
      {"r of a 2D texture: two or three coordinates", texturedState(),
       [](State& s) { s.attributes[kTexCoord0].size = 3; }},
      {"q of a cube map without a texture matrix",
       with(texturedState(), [](State& s) { s.units[0].target = TextureTarget::CubeMap; }),
       [](State& s) { s.attributes[kTexCoord0].size = 4; }},
      {"texture matrix of constant coordinates",
       with(texturedState(), [](State& s) { s.attributes[kTexCoord0].array = false; }),
       [](State& s) { s.units[0].matrix[3][0] = 0.5, s.units[0].matrix[0][3] = 1; }},
      {"coordinate array under texgen",
       with(texturedState(),
            [](State& s) { s.units[0].texGen = true, s.units[0].target = TextureTarget::CubeMap; }),
       [](State& s) { s.attributes[kTexCoord0].type = GL_SHORT; }},
  };
}

std::vector<DeadState> lightingStates() {
  const State positional = with(litState(), [](State& s) { s.lighting.lights[0].position = {0, 0, 2, 1}; });
  const State material = with(litState(), [](State& s) { s.lighting.colorMaterial = true; });
  return {
      {"lights without lighting", plainState(), [](State& s) { lightEverything(s.lighting.lights[0]); }},
      {"two-sided without lighting", plainState(), [](State& s) { s.lighting.twoSided = true; }},
      {"color material without lighting", plainState(), [](State& s) { s.lighting.colorMaterial = true; }},
      {"NORMALIZE without lighting", plainState(), [](State& s) { s.lighting.normalize = true; }},
      {"material without lighting", plainState(),
       [](State& s) {
         s.lighting.material.specular = {1, 1, 1, 1}, s.lighting.material.shininess = 9;
       }},
      {"normal array without lighting", plainState(), [](State& s) { enableArray(s, kNormal, 3, GL_BYTE); }},
      {"a light that is off", litState(),
       [](State& s) { lightEverything(s.lighting.lights[5]), s.lighting.lights[5].enabled = false; }},
      {"which light is on", litState(),
       [](State& s) { s.lighting.lights[0].enabled = false, s.lighting.lights[6].enabled = true; }},
      {"spot exponent with cutoff 180", positional, [](State& s) { s.lighting.lights[0].spotExponent = 3; }},
      {"spot direction with cutoff 180", positional,
       [](State& s) {
         s.lighting.lights[0].spotDirection = {1, 0, 0};
       }},
      {"attenuation of a light at infinity", litState(),
       [](State& s) {
         s.lighting.lights[0].attenuation = {0, 1, 1};
       }},
      {"cone of a light at infinity", litState(),
       [](State& s) { s.lighting.lights[0].spotCutoff = 30, s.lighting.lights[0].spotExponent = 2; }},
      {"colors of lights and material", litState(),
       [](State& s) {
         s.lighting.lights[0].diffuse = s.lighting.lights[0].ambient = {0.3f, 0, 0, 1};
         s.lighting.material.diffuse = s.lighting.material.ambient = {0, 0, 0, 0};
       }},
      {"where a light is", positional,
       [](State& s) {
         s.lighting.lights[0].position = {7, 7, 7, 2};
       }},
      {"shininess with black specular", litState(), [](State& s) { s.lighting.material.shininess = 20; }},
      {"color array under lighting", litState(), [](State& s) { enableArray(s, kColor, 4); }},
      {"material under color material", material,
       [](State& s) {
         s.lighting.material.diffuse = s.lighting.material.ambient = {1, 0, 0, 1};
       }},
      {"RESCALE_NORMAL", litState(), [](State& s) { s.lighting.rescaleNormal = true; }},
      {"NORMALIZE with the current normal",
       with(litState(), [](State& s) { s.attributes[kNormal].array = false; }),
       [](State& s) { s.lighting.normalize = true; }},
      {"two-sided lines", with(litState(), [](State& s) { s.primitive = PrimitiveClass::Lines; }),
       [](State& s) { s.lighting.twoSided = true; }},
      {"two-sided without lights", litState(0), [](State& s) { s.lighting.twoSided = true; }},
      {"normal array without lights", litState(0), [](State& s) { s.attributes[kNormal].type = GL_BYTE; }},
  };
}

// Everything about a palette is dead without it, and of a palette what its vertices do not need.
std::vector<DeadState> paletteStates() {
  const State unlit = with(skinnedState(), [](State& s) { s.lighting.enabled = false; });
  const auto enable = [](State& s) {
    enableArray(s, kMatrixIndex, 4, GL_UNSIGNED_BYTE);
    enableArray(s, kWeight, 4, GL_FIXED);
  };
  return {
      {"indices and weights without a palette", litState(), enable},
      {"a palette without arrays", litState(), [](State& s) { s.palette = skinnedState().palette; }},
      {"a palette without weights", litState(),
       [](State& s) {
         s.palette = skinnedState().palette;
         enableArray(s, kMatrixIndex, 4, GL_UNSIGNED_BYTE);
       }},
      {"a palette without indices", litState(),
       [](State& s) {
         s.palette = skinnedState().palette;
         enableArray(s, kWeight, 4);
       }},
      {"weights beyond the indices", skinnedState(), [](State& s) { s.attributes[kWeight].size = 4; }},
      {"indices beyond the weights", skinnedState(), [](State& s) { s.attributes[kMatrixIndex].size = 4; }},
      {"inverse transposes without normals", unlit, [](State& s) { s.palette = skinnedState(true).palette; }},
      {"normal array without lighting", unlit, [](State& s) { s.attributes[kNormal].type = GL_BYTE; }},
      {"the modelview matrix", skinnedState(), [](State& s) { s.modelview[0][3] = 2; }},
      {"w of positions under fog", with(skinnedState(), [](State& s) { s.fog.enabled = true; }),
       [](State& s) { s.attributes[kPosition].size = 4; }},
      {"values of matrices", skinnedState(true, true),
       [](State& s) {
         static const Palette other = [] {
           Palette p = *skinnedState(true, true).palette;
           p.matrices[60] = glm::dmat4(3.0);
           return p;
         }();
         s.palette = &other;
       }},
  };
}

std::vector<DeadState> otherStates() {
  const State fogged = with(plainState(), [](State& s) { s.fog.enabled = true; });
  const State never = with(texturedState(), [](State& s) { s.alphaTest = true, s.alphaFunc = GL_NEVER; });
  const State sprite = with(pointState(), [](State& s) { s.points.sprite = true; });
  return {
      {"fog mode without fog", plainState(), [](State& s) { s.fog.mode = GL_LINEAR; }},
      {"fog values", fogged,
       [](State& s) {
         s.fog.density = 7, s.fog.color = {1, 0, 0, 1};
       }},
      {"alpha function ALWAYS", plainState(), [](State& s) { s.alphaTest = true; }},
      {"alpha function without the test", plainState(),
       [](State& s) { s.alphaFunc = GL_LESS, s.alphaRef = 1; }},
      {"alpha reference and bits",
       with(plainState(), [](State& s) { s.alphaTest = true, s.alphaFunc = GL_LESS; }),
       [](State& s) { s.alphaRef = 0.5f, s.alphaBits = 4; }},
      {"textures under alpha function NEVER", never,
       [](State& s) { s.units[0].target = TextureTarget::None; }},
      {"fog under alpha function NEVER", never, [](State& s) { s.fog.enabled = true; }},
      {"equation of a disabled clip plane", plainState(), [](State& s) { s.clipPlanes[1].equation.x = 1; }},
      {"which clip plane is on", with(plainState(), [](State& s) { s.clipPlanes[0].enabled = true; }),
       [](State& s) { s.clipPlanes[0].enabled = false, s.clipPlanes[7].enabled = true; }},
      {"point state for triangles", plainState(),
       [](State& s) {
         s.points.size = 9, s.points.sizeMax = 64, s.points.smooth = s.points.sprite = true;
         s.points.distanceAttenuation = {0, 1, 0};
       }},
      {"point size array for triangles", plainState(), [](State& s) { enableArray(s, kPointSize, 1); }},
      {"point size", pointState(), [](State& s) { s.points.size = 17; }},
      {"point fade threshold without multisampling", pointState(),
       [](State& s) { s.points.fadeThreshold = 50; }},
      {"point fade threshold below the size", with(pointState(), [](State& s) { s.multisample = true; }),
       [](State& s) { s.points.fadeThreshold = 7; }},
      {"smoothing of sprites", sprite, [](State& s) { s.points.smooth = true; }},
      {"direction of y without sprite coordinates", sprite, [](State& s) { s.framebufferYDown = true; }},
      {"direction of y for triangles", texturedState(), [](State& s) { s.framebufferYDown = true; }},
      {"flat shading of points", pointState(), [](State& s) { s.shadeModel = GL_FLAT; }},
      {"multisampling of triangles", texturedState(), [](State& s) { s.multisample = true; }},
      {"line smoothing", plainState(), [](State& s) { s.lineSmooth = true; }},
      {"sample alpha to one", plainState(), [](State& s) { s.sampleAlphaToOne = true; }},
      {"matrices", texturedState(), [](State& s) { s.modelview[3][0] = 5, s.projection[2][3] = -1; }},
      {"current color", plainState(),
       [](State& s) {
         s.attributes[kColor].current = {0, 1, 0, 0};
       }},
      {"ubyte colors for float colors", with(plainState(), [](State& s) { enableArray(s, kColor, 4); }),
       [](State& s) { s.attributes[kColor].type = GL_UNSIGNED_BYTE; }},
      {"w of positions under fog that has the eye position",
       with(litState(), [](State& s) { s.fog.enabled = true, s.lighting.lights[0].position.w = 1; }),
       [](State& s) { s.attributes[kPosition].size = 4; }},
      {"size of float positions", plainState(), [](State& s) { s.attributes[kPosition].size = 4; }},
  };
}

void expectDead(const std::vector<DeadState>& table) {
  for (const DeadState& row : table) {
    const State changed = with(row.base, row.change);
    const Keys before = keysOf(row.base), after = keysOf(changed);
    EXPECT_TRUE(before.fragment == after.fragment) << row.name << "\n"
                                                   << describe(before.fragment) << "\n"
                                                   << describe(after.fragment);
    EXPECT_TRUE(before.vertex == after.vertex) << row.name << "\n"
                                               << describe(before.vertex) << "\n"
                                               << describe(after.vertex);
  }
}

TEST(DeadStates, Textures) {
  expectDead(textureStates());
}
TEST(DeadStates, Lighting) {
  expectDead(lightingStates());
}
TEST(DeadStates, Palettes) {
  expectDead(paletteStates());
  const Blocks without = blocks(keysOf(litState()).vertex, keysOf(litState()).fragment);
  EXPECT_EQ(without.paletteSize, 0u);
  EXPECT_EQ(without.paletteGroups, 0u);
}
TEST(DeadStates, Others) {
  expectDead(otherStates());
}

// The other direction: what the picture does depend on must change a key (or the table above proves nothing).
TEST(DeadStates, LiveStatesChangeKeys) {
  const std::vector<DeadState> table = {
      {"texture", plainState(), [](State& s) { s.units[0].target = TextureTarget::Texture2D; }},
      {"environment mode", texturedState(), [](State& s) { s.units[0].env.mode = GL_ADD; }},
      {"operand", combineState(), [](State& s) { s.units[0].env.operandRgb[0] = GL_ONE_MINUS_SRC_COLOR; }},
      {"scale", combineState(), [](State& s) { s.units[0].env.rgbScale = 2; }},
      {"alpha scale", combineState(), [](State& s) { s.units[0].env.alphaScale = 4; }},
      {"third argument of INTERPOLATE",
       with(combineState(), [](State& s) { s.units[0].env.combineRgb = GL_INTERPOLATE; }),
       [](State& s) { s.units[0].env.srcRgb[2] = GL_TEXTURE; }},
      {"texture matrix", texturedState(), [](State& s) { s.units[0].matrix[3][0] = 1; }},
      {"projective texture matrix", texturedState(), [](State& s) { s.units[0].matrix[3][3] = 2; }},
      {"q", texturedState(), [](State& s) { s.attributes[kTexCoord0].size = 4; }},
      {"lighting", plainState(), [](State& s) { s.lighting.enabled = true; }},
      {"second light", litState(), [](State& s) { s.lighting.lights[4].enabled = true; }},
      {"positional light", litState(), [](State& s) { s.lighting.lights[0].position.w = 1; }},
      {"specular", litState(),
       [](State& s) {
         s.lighting.material.specular = {1, 0, 0, 1};
       }},
      {"two-sided", litState(), [](State& s) { s.lighting.twoSided = true; }},
      {"color material", litState(), [](State& s) { s.lighting.colorMaterial = true; }},
      {"NORMALIZE", litState(), [](State& s) { s.lighting.normalize = true; }},
      {"NORMALIZE of normals that only texgen reads",
       with(texturedState(),
            [](State& s) {
              enableArray(s, kNormal, 3);
              s.units[0].target = TextureTarget::CubeMap;
              s.units[0].texGen = true;
              s.units[0].env.mode = GL_REPLACE;
            }),
       [](State& s) { s.lighting.normalize = true; }},
      {"w of positions under fog", with(plainState(), [](State& s) { s.fog.enabled = true; }),
       [](State& s) { s.attributes[kPosition].size = 4; }},
      {"fog", plainState(), [](State& s) { s.fog.enabled = true; }},
      {"flat", plainState(), [](State& s) { s.shadeModel = GL_FLAT; }},
      {"alpha test", plainState(), [](State& s) { s.alphaTest = true, s.alphaFunc = GL_LESS; }},
      {"clip plane", plainState(), [](State& s) { s.clipPlanes[3].enabled = true; }},
      {"points", plainState(), [](State& s) { s.primitive = PrimitiveClass::Points; }},
      {"smooth points", pointState(), [](State& s) { s.points.smooth = true; }},
      {"multisampled points", pointState(), [](State& s) { s.multisample = true; }},
      {"point fade threshold", with(pointState(), [](State& s) { s.multisample = true; }),
       [](State& s) { s.points.fadeThreshold = 9; }},
      {"attenuated points", pointState(), [](State& s) { s.points.distanceAttenuation.y = 1; }},
      {"fixed positions", plainState(), [](State& s) { s.attributes[kPosition].type = GL_FIXED; }},
      {"color array", plainState(), [](State& s) { enableArray(s, kColor, 4); }},
      {"palette", skinnedState(), [](State& s) { s.palette = nullptr; }},
      {"projective palette", skinnedState(), [](State& s) { s.palette = skinnedState(false, true).palette; }},
      {"bent palette", skinnedState(), [](State& s) { s.palette = skinnedState(true).palette; }},
      {"more weights", skinnedState(),
       [](State& s) { s.attributes[kMatrixIndex].size = s.attributes[kWeight].size = 3; }},
      {"fixed weights", skinnedState(), [](State& s) { s.attributes[kWeight].type = GL_FIXED; }},
      {"NORMALIZE of the current normal under a palette",
       with(skinnedState(), [](State& s) { s.attributes[kNormal].array = false; }),
       [](State& s) { s.lighting.normalize = true; }},
  };
  for (const DeadState& row : table) {
    const Keys before = keysOf(row.base), after = keysOf(with(row.base, row.change));
    EXPECT_FALSE(before.fragment == after.fragment && before.vertex == after.vertex) << row.name;
  }
}

TEST(DeadStates, CrossbarToADisabledUnitDisablesTheUnit) {
  State state = combineState();
  state.units[0].env.srcRgb[0] = GL_TEXTURE5;
  EXPECT_TRUE(keysOf(state).fragment == keysOf(plainState()).fragment);
  state.units[0].env.srcRgb[0] = GL_TEXTURE, state.units[0].env.srcRgb[2] = GL_TEXTURE5;  // not read
  EXPECT_TRUE(keysOf(state).fragment == keysOf(texturedState()).fragment);
}

TEST(DeadStates, ProfileWithoutClipDistances) {
  State state = plainState();
  state.clipPlanes[2].enabled = state.clipPlanes[5].enabled = true;
  const Keys keys = keysOf(state, {.clipDistance = false});
  EXPECT_EQ(keys.fragment.discardPlanes, 2);
  EXPECT_EQ(keys.vertex.clipVaryings, 1);
  EXPECT_EQ(keysOf(state).fragment.discardPlanes, 0);
}

TEST(DeadStates, ProfileWithoutLargePoints) {
  State state = pointState();
  state.points.smooth = true, state.points.distanceAttenuation = {0, 1, 0};
  const Keys keys = keysOf(state, {.largePoints = false});
  EXPECT_EQ(keys.vertex.pointSize, PointSize::One);
  EXPECT_EQ(keys.fragment.pointShape, PointShape::Square);
}

}  // namespace
}  // namespace anteroom::gen
