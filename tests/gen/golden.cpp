// The text of typical shaders, kept in golden/. ANTEROOM_UPDATE_GOLDEN=1 writes the files anew: read the
// difference.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/gen/states.h"
#include "tests/gen/validated.h"

namespace anteroom::gen {
namespace {

const std::string kFolder = ANTEROOM_SOURCE_DIR "/tests/gen/golden/";

std::string read(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void expectGolden(const std::string& name, const std::string& glsl) {
  const std::string path = kFolder + name;
  if (std::getenv("ANTEROOM_UPDATE_GOLDEN")) {
    std::ofstream file(path);
    file << glsl;
    ASSERT_TRUE(file.good()) << path;
  }
  EXPECT_EQ(read(path), glsl) << path;
}

void expectGolden(const std::string& name, const State& state, const Profile& profile = {}) {
  const Keys keys = keysOf(state, profile);
  const std::string vertex = emitVertex(keys.vertex), fragment = emitFragment(keys.fragment);
  expectGolden(name + ".vert", vertex);
  expectGolden(name + ".frag", fragment);
  expectCompiles(Stage::Vertex, vertex);
  expectCompiles(Stage::Fragment, fragment);
}

TEST(Golden, Plain) {
  expectGolden("plain", plainState());
}

TEST(Golden, Textured) {
  State s = texturedState();
  enableArray(s, kColor, 4, GL_UNSIGNED_BYTE);
  expectGolden("textured", s);
}

TEST(Golden, LateSwitchOver) {
  State s = texturedState(GL_RGBA, 2);
  s.units[0].lateSwitchOver = true;
  expectGolden("late_switch_over", s);
}

TEST(Golden, FixedPoint) {
  State s = texturedState();
  enableArray(s, kPosition, 3, GL_FIXED);
  enableArray(s, kColor, 4, GL_FIXED);
  enableArray(s, kTexCoord0, 2, GL_FIXED);
  expectGolden("fixed_point", s);
}

TEST(Golden, ProjectiveTexture) {
  State s = texturedState(GL_LUMINANCE);
  s.attributes[kTexCoord0].size = 4;
  s.units[0].matrix[2][3] = -1;
  expectGolden("projective_texture", s);
}

TEST(Golden, DirectionalLight) {
  State s = litState();
  s.lighting.normalize = true;
  expectGolden("directional_light", s);
}

TEST(Golden, SpotLightsTwoSided) {
  State s = litState(2);
  enableArray(s, kColor, 4, GL_UNSIGNED_BYTE);
  s.shadeModel = GL_FLAT;
  s.lighting.colorMaterial = s.lighting.twoSided = true;
  s.lighting.material.specular = {1, 1, 1, 1};
  s.lighting.material.shininess = 30;
  Light& light = s.lighting.lights[1];
  light.position.w = 1, light.spotCutoff = 30, light.spotExponent = 4, light.attenuation = {1, 0.1f, 0};
  expectGolden("spot_lights_two_sided", s);
}

TEST(Golden, BumpMap) {
  State s = texturedState(GL_RGB, 2);
  enableArray(s, kColor, 4, GL_UNSIGNED_BYTE);
  s.units[0].env.mode = GL_COMBINE;
  s.units[0].env.combineRgb = GL_DOT3_RGB;
  s.units[0].env.srcRgb[1] = GL_PRIMARY_COLOR;
  expectGolden("bump_map", s);
}

TEST(Golden, Combiners) {
  State s = texturedState(GL_RGBA, 3);
  TextureEnv& first = s.units[0].env;
  first.mode = GL_COMBINE, first.combineRgb = GL_INTERPOLATE, first.srcRgb[2] = GL_TEXTURE2;
  first.combineAlpha = GL_SUBTRACT, first.operandAlpha[1] = GL_ONE_MINUS_SRC_ALPHA;
  TextureEnv& second = s.units[1].env;
  second.mode = GL_COMBINE, second.combineRgb = GL_ADD_SIGNED, second.rgbScale = 2;
  second.srcRgb = {GL_PREVIOUS, GL_PRIMARY_COLOR, GL_CONSTANT};
  s.units[2].env.mode = GL_BLEND;
  expectGolden("combiners", s);
}

TEST(Golden, Reflection) {
  State s = litState();
  s.units[0].target = TextureTarget::CubeMap;
  s.units[0].texGen = true;
  s.units[0].matrix[0][0] = 0.5;
  s.units[0].env.mode = GL_ADD;
  expectGolden("reflection", s);
}

TEST(Golden, FogAndAlphaTest) {
  State s = texturedState();
  s.fog.enabled = true, s.fog.mode = GL_LINEAR;
  s.alphaTest = true, s.alphaFunc = GL_GREATER;
  expectGolden("fog_and_alpha_test", s);
}

TEST(Golden, OwnValues) {
  State s = litState();
  s.fog.enabled = true;
  Keys keys = keysOf(s, {});
  keys.vertex.ownValues = 1;
  const std::string vertex = emitVertex(keys.vertex);
  expectGolden("own_values.vert", vertex);
  expectCompiles(Stage::Vertex, vertex);
}

TEST(Golden, FogOfPositionsWithW) {
  State s = plainState();
  enableArray(s, kPosition, 4);
  s.fog.enabled = true, s.fog.mode = GL_EXP2;
  expectGolden("fog_of_positions_with_w", s);
}

TEST(Golden, ClipPlanes) {
  State s = plainState();
  s.clipPlanes[0].enabled = s.clipPlanes[3].enabled = true;
  expectGolden("clip_planes", s);
  expectGolden("clip_planes_by_discard", s, {.clipDistance = false});
}

TEST(Golden, PointSprites) {
  State s = texturedState();
  s.primitive = PrimitiveClass::Points;
  s.points.sprite = s.units[0].env.coordReplace = true;
  s.points.distanceAttenuation = {0, 0, 1};
  enableArray(s, kPointSize, 1);
  expectGolden("point_sprites", s);
}

TEST(Golden, SmoothPoints) {
  State s = pointState();
  s.points.smooth = true;
  expectGolden("smooth_points", s);
}

TEST(Golden, MultisampledPoints) {
  State s = pointState();
  s.multisample = true;
  s.points.fadeThreshold = 10;
  expectGolden("multisampled_points", s);
}

TEST(Golden, SkinnedPlain) {
  State s = plainState();
  s.palette = skinnedState().palette;
  enableArray(s, kMatrixIndex, 1, GL_UNSIGNED_BYTE);
  enableArray(s, kWeight, 1);
  expectGolden("skinned_plain", s);
}

TEST(Golden, SkinnedLit) {
  State s = skinnedState();
  s.attributes[kMatrixIndex].size = s.attributes[kWeight].size = 4;
  s.lighting.normalize = true;
  expectGolden("skinned_lit", s);
}

TEST(Golden, SkinnedEverything) {
  State s = skinnedState(true, true);
  s.attributes[kWeight].type = GL_FIXED;
  s.lighting.lights[0].position.w = 1;
  s.fog.enabled = true;
  s.clipPlanes[0].enabled = true;
  s.units[0].target = TextureTarget::CubeMap;
  s.units[0].texGen = true;
  expectGolden("skinned_everything", s);
}

TEST(Golden, SkinnedFog) {
  State s = skinnedState();
  s.lighting.enabled = false;
  s.fog.enabled = true;
  expectGolden("skinned_fog", s);
}

TEST(Golden, AlphaTestNever) {
  State s = litState();
  s.alphaTest = true, s.alphaFunc = GL_NEVER;
  expectGolden("alpha_test_never", s);
}

}  // namespace
}  // namespace anteroom::gen
