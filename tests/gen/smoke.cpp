#include <gtest/gtest.h>
#include <iostream>
#include "gen/gen.h"
using namespace anteroom::gen;
TEST(Smoke, All) {
  State s; s.attributes[kPosition].array = true; s.attributes[kNormal].array = true;
  s.attributes[kTexCoord0].array = true; s.attributes[kTexCoord0].size = 2;
  s.attributes[kTexCoord0+1].array = true; s.attributes[kTexCoord0+1].size = 3;s.attributes[kTexCoord0+1].type = GL_FIXED;
  s.lighting.enabled = true; s.lighting.lights[3].enabled = true; s.lighting.lights[5].enabled = true; s.lighting.lights[5].position = {1,2,3,1};
  s.lighting.lights[5].spotCutoff=30; s.lighting.lights[5].attenuation={1,1,0}; s.lighting.material.specular={1,1,1,1}; s.lighting.material.shininess=3;
  s.lighting.twoSided = true; s.lighting.colorMaterial = true;
  s.units[0].target = TextureTarget::Texture2D; s.units[1].target = TextureTarget::CubeMap; s.units[1].texGen = true;
  s.units[1].env.mode = GL_COMBINE; s.units[1].env.combineRgb = GL_DOT3_RGB; s.units[1].env.srcRgb = {GL_TEXTURE, GL_PRIMARY_COLOR, GL_CONSTANT};
  s.units[1].matrix[0][0] = 2;
  s.fog.enabled = true; s.alphaTest = true; s.alphaFunc = GL_GREATER; s.clipPlanes[2].enabled = true;
  FragmentKey f = canonicaliseFragment(s, {}); VertexKey v = canonicaliseVertex(s, f, {});
  auto vt = emitVertex(v), ft = emitFragment(f);
  std::cout << vt << ft;
  auto a = compile(Stage::Vertex, vt); EXPECT_EQ(a.log, ""); EXPECT_FALSE(a.spirv.empty());
  auto b = compile(Stage::Fragment, ft); EXPECT_EQ(b.log, ""); EXPECT_FALSE(b.spirv.empty());
  FragmentKey f2; EXPECT_TRUE(parse(describe(f), f2)); EXPECT_TRUE(f2 == f);
  VertexKey v2; EXPECT_TRUE(parse(describe(v), v2)); EXPECT_TRUE(v2 == v);
}
