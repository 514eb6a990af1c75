// Constants: they fit the blocks that the shader declares, and hold what the specification says, also in
// extreme cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <regex>

#include "gen/values.h"
#include "tests/gen/states.h"

namespace anteroom::gen {
namespace {

constexpr std::byte kGuard{0xa5};
constexpr size_t kGuardBytes = 64;

template <class Pack, class Key>
void expectExactWrite(Pack pack, const Key& key, const State& state, uint32_t size) {
  std::vector<std::byte> bytes(size + 2 * kGuardBytes, kGuard);
  pack(key, state, bytes.data() + kGuardBytes);
  for (size_t i = 0; i < kGuardBytes; ++i) {
    ASSERT_EQ(bytes[i], kGuard);
    ASSERT_EQ(bytes[size + kGuardBytes + i], kGuard);
  }
  // Every byte is written: packing over other contents gives the same.
  std::vector<std::byte> zeros(size);
  pack(key, state, zeros.data());
  ASSERT_TRUE(std::equal(zeros.begin(), zeros.end(), bytes.begin() + kGuardBytes)) << describe(key);
}

TEST(Constants, PackWritesExactlyItsSize) {
  RandomStates random(20);
  for (int i = 0; i < 1000; ++i) {
    const State state = random.next();
    const Keys keys = keysOf(state, {!random.coin(4), !random.coin(4)});
    const Blocks b = blocks(keys.vertex, keys.fragment);
    ASSERT_LE(b.pushSize, 128u);
    ASSERT_GE(b.pushSize, 64u);
    ASSERT_LE(b.vertexSize, 16384u);  // every Vulkan device has that
    expectExactWrite(packPush, keys.vertex, state, b.pushSize);
    expectExactWrite(packVertex, keys.vertex, state, b.vertexSize);
    expectExactWrite(packFragment, keys.fragment, state, b.fragmentSize);
    ASSERT_LE(b.paletteSize, 16384u);
    expectExactWrite(packPalette, keys.vertex, state, b.paletteSize);
    ASSERT_EQ(b.paletteSize != 0, emitVertex(keys.vertex).find("uniform Palette") != std::string::npos);
    ASSERT_EQ(b.vertexSize != 0, emitVertex(keys.vertex).find("uniform Vertex") != std::string::npos);
    ASSERT_EQ(b.fragmentSize != 0, emitFragment(keys.fragment).find("uniform Fragment") != std::string::npos);
  }
}

// The offset of a member, found in the SPIR-V by its debug name: what the shader really reads.
int offsetInSpirv(const std::vector<uint32_t>& spirv, const std::string& member) {
  constexpr uint32_t kMemberName = 6, kMemberDecorate = 72, kOffset = 35;
  uint32_t type = 0, index = 0;
  bool found = false;
  for (size_t i = 5; i < spirv.size(); i += spirv[i] >> 16) {
    const uint32_t op = spirv[i] & 0xffff;
    if (op == kMemberName && member == reinterpret_cast<const char*>(&spirv[i + 3]))
      type = spirv[i + 1], index = spirv[i + 2], found = true;
    if (found && op == kMemberDecorate && spirv[i + 1] == type && spirv[i + 2] == index &&
        spirv[i + 3] == kOffset)
      return static_cast<int>(spirv[i + 4]);
  }
  return -1;
}

class PackedState {
 public:
  explicit PackedState(const State& state, const Profile& profile = {}) : keys_(keysOf(state, profile)) {
    const Blocks b = blocks(keys_.vertex, keys_.fragment);
    push_.resize(b.pushSize / 4), vertex_.resize(b.vertexSize / 4), fragment_.resize(b.fragmentSize / 4);
    packPush(keys_.vertex, state, reinterpret_cast<std::byte*>(push_.data()));
    packVertex(keys_.vertex, state, reinterpret_cast<std::byte*>(vertex_.data()));
    packFragment(keys_.fragment, state, reinterpret_cast<std::byte*>(fragment_.data()));
    vertexSpirv_ = compile(Stage::Vertex, emitVertex(keys_.vertex)).spirv;
    fragmentSpirv_ = compile(Stage::Fragment, emitFragment(keys_.fragment)).spirv;
  }

  // `count` floats of a member of the block that has it.
  std::vector<float> get(const std::string& member, int count) const {
    const std::string glsl = emitVertex(keys_.vertex);
    const bool inPush = glsl.substr(0, glsl.find("};")).find(' ' + member + ';') != std::string::npos;
    int offset = offsetInSpirv(vertexSpirv_, member);
    const std::vector<float>* block = inPush ? &push_ : &vertex_;
    if (offset < 0) offset = offsetInSpirv(fragmentSpirv_, member), block = &fragment_;
    EXPECT_GE(offset, 0) << member << '\n' << glsl;
    if (offset < 0) return std::vector<float>(static_cast<size_t>(count));
    return {block->begin() + offset / 4, block->begin() + offset / 4 + count};
  }

 private:
  Keys keys_;
  std::vector<float> push_, vertex_, fragment_;
  std::vector<uint32_t> vertexSpirv_, fragmentSpirv_;
};

using Floats = std::vector<float>;

State crowdedState() {
  State s = litState(3);
  s.lighting.material.specular = {0.5f, 0.25f, 1, 1};
  s.lighting.material.shininess = 12;
  s.lighting.lights[1].position = {2, 4, 6, 2};
  s.lighting.lights[1].spotCutoff = 60;
  s.lighting.lights[1].spotExponent = 5;
  s.lighting.lights[1].attenuation = {1, 2, 3};
  s.lighting.lights[1].ambient = {0.5f, 0.5f, 0.5f, 1};
  s.lighting.lights[2].diffuse = {1, 0.5f, 0.25f, 1};
  s.lighting.lights[2].position = {0, 3, 4, 0};
  for (int u = 0; u < 2; ++u) {
    enableArray(s, texCoord(u), 2);
    s.units[u].target = TextureTarget::Texture2D;
    s.units[u].matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(u + 1, 5, 0));
  }
  s.units[1].env.mode = GL_BLEND;
  s.units[1].env.color = {0.25f, 0.5f, 2, 1};
  s.clipPlanes[4] = {true, {0, 2, 0, 1}};
  s.fog = {true, GL_LINEAR, 1, 2, 6, {0.5f, 1, 0, 0}};
  s.alphaTest = true, s.alphaFunc = GL_GEQUAL, s.alphaRef = 0.5f;
  return s;
}

TEST(Constants, MembersLieWhereTheShaderReadsThem) {
  const PackedState p(crowdedState());
  EXPECT_EQ(p.get("light1Position", 3), (Floats{1, 2, 3}));
  EXPECT_NEAR(p.get("light1CosCutoff", 1)[0], 0.5, 1e-7);
  EXPECT_EQ(p.get("light1SpotExponent", 1), (Floats{5}));
  EXPECT_EQ(p.get("light1Attenuation", 3), (Floats{1, 2, 3}));
  EXPECT_EQ(p.get("light1Ambient", 3), (Floats{0.1f, 0.1f, 0.1f}));
  EXPECT_EQ(p.get("light2Direction", 3), (Floats{0, 0.6f, 0.8f}));
  EXPECT_EQ(p.get("light2Diffuse", 3), (Floats{0.8f, 0.4f, 0.2f}));
  EXPECT_EQ(p.get("shininess", 1), (Floats{12}));
  EXPECT_EQ(p.get("textureMatrix1", 8), (Floats{1, 0, 0, 2, 0, 1, 0, 5}));
  EXPECT_EQ(p.get("clipPlane0", 4), (Floats{0, 1, 0, 0.5f}));
  EXPECT_EQ(p.get("constant1", 4), (Floats{0.25f, 0.5f, 1, 1}));
  EXPECT_EQ(p.get("fogColor", 3), (Floats{0.5f, 1, 0}));
  EXPECT_EQ(p.get("fogEnd", 1), (Floats{6}));
  EXPECT_EQ(p.get("fogScale", 1), (Floats{0.25f}));
  EXPECT_EQ(p.get("alphaReference", 1), (Floats{128}));
}

TEST(Constants, AmbientTermsAddUp) {
  State s = litState(2);
  s.lighting.modelAmbient = {0.5f, 0, 0, 1};
  s.lighting.lights[0].ambient = {0.25f, 1, 0, 1};
  s.lighting.lights[1].ambient = {9, 9, 9, 1};  // a cone: not constant
  s.lighting.lights[1].position.w = 1, s.lighting.lights[1].spotCutoff = 10;
  s.lighting.material.ambient = {1, 0.5f, 1, 1};
  s.lighting.material.emission = {0, 0.25f, 0.125f, 1};
  s.lighting.material.diffuse.a = 0.75f;
  EXPECT_EQ(PackedState(s).get("sceneColor", 4), (Floats{0.75f, 0.75f, 0.125f, 0.75f}));
  s.lighting.colorMaterial = true;
  EXPECT_EQ(PackedState(s).get("sceneAmbient", 3), (Floats{0.75f, 1, 0}));
}

// The directional light's cone is applied to its colors.
TEST(Constants, ConeOfALightAtInfinity) {
  State s = litState();
  Light& light = s.lighting.lights[0];
  light.position = {0, 0, 1, 0};  // shines along -z
  light.spotCutoff = 45, light.spotExponent = 2;
  light.spotDirection = {0, std::sin(0.5), -std::cos(0.5)};
  EXPECT_NEAR(PackedState(s).get("light0Diffuse", 1)[0], 0.8 * std::cos(0.5) * std::cos(0.5), 1e-6);
  light.spotDirection = {0, 1, 0};
  EXPECT_EQ(PackedState(s).get("light0Diffuse", 1)[0], 0);
  light.spotCutoff = 90, light.spotExponent = 0;  // the literal text: max(., 0) >= cos 90 = 0 everywhere
  EXPECT_EQ(PackedState(s).get("light0Diffuse", 1)[0], 0.8f);
}

TEST(Constants, DepthRangeIsVulkans) {
  State s = plainState();
  s.projection = glm::dmat4(1.0);
  const auto m = PackedState(s).get("modelviewProjection", 16);
  const auto z = [&](float in) { return m[2] * 0 + m[6] * 0 + m[10] * in + m[14]; };
  EXPECT_EQ(z(-1), 0);
  EXPECT_EQ(z(0), 0.5f);
  EXPECT_EQ(z(1), 1);
}

// Products are made in float64: a camera and an object a million units out still meet at the right place.
TEST(Constants, ProductsAreMadeInDouble) {
  State s = plainState();
  s.projection = glm::translate(glm::dmat4(1.0), glm::dvec3(-1e6 - 0.125, 0, 0));
  s.modelview = glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, 0, 0));
  EXPECT_EQ(PackedState(s).get("modelviewProjection", 16)[12], -0.125f);
  s.modelview[3][0] = 1e6, s.clipPlanes[0] = {true, {1, 0, 0, -1e6 - 0.5}};
  EXPECT_EQ(PackedState(s).get("clipPlane0", 4), (Floats{1, 0, 0, -0.5f}));
}

// Matrices lie by rows, three each, matrices for normals behind them, where the shader reads them.
TEST(Constants, PaletteLiesWhereTheShaderReadsIt) {
  const auto packed = [](const State& s, const std::string& member, int& offset) {
    const VertexKey key = keysOf(s).vertex;
    Floats bytes(blocks(key, keysOf(s).fragment).paletteSize / 4);
    packPalette(key, s, reinterpret_cast<std::byte*>(bytes.data()));
    offset = offsetInSpirv(compile(Stage::Vertex, emitVertex(key)).spirv, member);
    return bytes;
  };
  const auto at = [](const Floats& all, int bytes, size_t count) {
    return Floats(all.begin() + bytes / 4, all.begin() + bytes / 4 + static_cast<int>(count));
  };
  int offset = -1;
  Floats all = packed(skinnedState(), "palette", offset);
  EXPECT_EQ(all.size(), 64u * 12);
  EXPECT_EQ(offset, 0);
  EXPECT_EQ(at(all, 3 * 48, 12), (Floats{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}));
  all = packed(skinnedState(true), "paletteNormals", offset);
  EXPECT_EQ(all.size(), 64u * 24);
  EXPECT_EQ(offset, 64 * 48);
  // The inverse transpose of (2 0.5 0), (0 1 0), (0 0 1), by columns.
  EXPECT_EQ(at(all, offset + 48, 12), (Floats{0.5f, 0, 0, 0, -0.25f, 1, 0, 0, 0, 0, 1, 0}));
  all = packed(skinnedState(false, true), "palette", offset);
  EXPECT_EQ(all.size(), 64u * 16);
  EXPECT_EQ(at(all, 2 * 64, 16), (Floats{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.25f, 1}));
}

// Rounding of float matrices that rotate is no reason for a second palette; a stretch is.
TEST(Constants, OrthogonalPalettes) {
  State s = skinnedState();
  Palette palette;
  s.palette = &palette;
  for (size_t i = 0; i < palette.matrices.size(); ++i) {
    const double angle = 0.1 * static_cast<double>(i);
    const glm::mat4 rounded(glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(1, 2, angle)));
    palette.matrices[i] = glm::dmat4(rounded);
  }
  EXPECT_EQ(keysOf(s).vertex.paletteNormals, 0);
  palette.matrices[9][0] *= -1;  // a mirror is as good
  EXPECT_EQ(keysOf(s).vertex.paletteNormals, 0);
  palette.matrices[9] *= 1.0001;
  EXPECT_EQ(keysOf(s).vertex.paletteNormals, 1);
  palette.matrices[9] = glm::dmat4(NAN);
  EXPECT_EQ(keysOf(s).vertex.paletteNormals, 1);
}

// ---- Where the specification is silent

glm::dvec3 eyeNormal(const State& s, const glm::dvec3& n) {
  return normalMatrix(s) * n;
}

bool finite(const glm::dmat3& m) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!std::isfinite(static_cast<float>(m[c][r]))) return false;
  return true;
}

TEST(NormalMatrix, IsTheInverseTranspose) {
  State s;
  s.modelview = glm::scale(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3)), glm::dvec3(2, -3, 0.5));
  const glm::dmat3 expected = glm::transpose(glm::inverse(glm::dmat3(s.modelview)));
  for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(normalMatrix(s)[c] - expected[c]), 1e-12);
}

TEST(NormalMatrix, RescaleUndoesAUniformScale) {
  State s;
  s.lighting.rescaleNormal = true;
  for (double scale : {1e-12, 0.5, 3.0, 1e12, -2.0}) {
    s.modelview = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
    const double sign = scale < 0 ? -1 : 1;
    EXPECT_LT(glm::length(eyeNormal(s, {0, 0, 1}) - glm::dvec3(0, 0, sign)), 1e-12) << scale;
  }
  s.modelview = glm::scale(glm::dmat4(1.0), glm::dvec3(2, 3, 4));  // f = 1 / |third row of the inverse| = 4
  EXPECT_LT(glm::length(eyeNormal(s, {1, 1, 1}) - glm::dvec3(2, 4.0 / 3, 1)), 1e-12);
}

TEST(NormalMatrix, SingularMatricesGiveFiniteNormals) {
  for (bool normalize : {false, true})
    for (bool rescale : {false, true})
      for (const glm::dvec3& scale :
           {glm::dvec3(1, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0), glm::dvec3(1e-30, 1, 1),
            glm::dvec3(1e-300), glm::dvec3(1e300, 1, 1e-300), glm::dvec3(1e30)}) {
        State s;
        s.lighting.normalize = normalize, s.lighting.rescaleNormal = rescale;
        s.modelview = glm::scale(glm::dmat4(1.0), scale);
        EXPECT_TRUE(finite(normalMatrix(s))) << scale.x << ' ' << scale.y << ' ' << scale.z;
      }
  State s;  // flattened along z: the surface faces along z
  s.lighting.normalize = true;
  s.modelview = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 0));
  EXPECT_EQ(glm::normalize(eyeNormal(s, {0.6, 0, 0.8})), glm::dvec3(0, 0, 1));
}

TEST(Values, ZeroVectorsStayZero) {
  Light light;
  light.position = {0, 0, 0, 0};
  EXPECT_EQ(lightDirection(light), glm::dvec3(0));
  light.position = {0, 0, -1, 0};  // opposite to the viewer
  EXPECT_EQ(halfVector(light), glm::dvec3(0));
  State s;
  s.lighting.normalize = true;
  s.attributes[kNormal].current = {0, 0, 0, 1};
  EXPECT_EQ(currentEyeNormal(s), glm::dvec3(0));
}

TEST(Values, LinearFogWithStartAtEndIsAStep) {
  State s = plainState();
  s.fog = {true, GL_LINEAR, 1, 5, 5, {0, 0, 0, 0}};
  for (float at : {5.0f, 0.0f, 1e-20f, 1e9f}) {
    s.fog.start = s.fog.end = at;
    const PackedState p(s);
    const float end = p.get("fogEnd", 1)[0], scale = p.get("fogScale", 1)[0];
    const auto f = [&](float depth) { return std::clamp((end - depth) * scale, 0.0f, 1.0f); };
    EXPECT_EQ(f(at * 0.999f), 1);
    EXPECT_EQ(f(at), 1);
    EXPECT_EQ(f(at * 1.001f + 1e-25f), 0);
  }
}

TEST(Values, PointSizes) {
  State s = pointState();
  const auto size = [&](float requested) {
    s.points.size = requested;
    return constantPointSize(s);
  };
  EXPECT_EQ(size(0.2f), 1);
  EXPECT_EQ(size(2.4f), 2);
  EXPECT_EQ(size(2.5f), 3);
  EXPECT_EQ(size(1e9f), 64);
  s.points.smooth = true;
  EXPECT_EQ(size(2.4f), 2.4f);
  s.points.sizeMin = 10, s.points.sizeMax = 4;  // undefined: the maximum wins
  EXPECT_EQ(size(7), 4);
}

TEST(Values, AlphaReferenceAtTheFramebuffersPrecision) {
  State s = plainState();
  s.alphaTest = true, s.alphaFunc = GL_LESS, s.alphaRef = 0.5f;
  const auto scaleAndReference = [&](uint8_t bits) {
    s.alphaBits = bits;
    const PackedState p(s);
    return Floats{p.get("alphaScale", 1)[0], p.get("alphaReference", 1)[0]};
  };
  EXPECT_EQ(scaleAndReference(8), (Floats{255, 128}));
  EXPECT_EQ(scaleAndReference(0), (Floats{255, 128}));
  EXPECT_EQ(scaleAndReference(4), (Floats{15, 8}));
  EXPECT_EQ(scaleAndReference(1), (Floats{3, 2}));
}

TEST(Values, ProjectedConstantCoordinates) {
  State s = texturedState();
  s.attributes[kTexCoord0] = {false, 4, GL_FLOAT, {2, 4, 0, 2}};
  EXPECT_EQ(PackedState(s).get("coord0", 4), (Floats{1, 2, 0, 1}));
  s.attributes[kTexCoord0].current.w = 0;
  EXPECT_EQ(PackedState(s).get("coord0", 4), (Floats{2, 4, 0, 0}));
}

TEST(Values, CurrentColorIsClampedOnlyWithoutLighting) {
  State s = plainState();
  s.attributes[kColor].current = {2, -1, NAN, 0.5f};
  EXPECT_EQ(PackedState(s).get("color", 4), (Floats{1, 0, 0, 0.5f}));
  s = litState();
  s.lighting.colorMaterial = true;
  s.attributes[kColor].current = {2, -1, 0, 0.5f};
  EXPECT_EQ(PackedState(s).get("color", 4), (Floats{2, -1, 0, 0.5f}));
}

}  // namespace
}  // namespace anteroom::gen
