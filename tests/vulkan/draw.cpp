// Clears, draws and what the fragments go through, on the full and on the minimal profile.
#include <functional>
#include <thread>

#include "layer/vulkan/vulkan_device.h"
#include "tests/vulkan/scene.h"

namespace anteroom::test {
namespace {

constexpr Pixel kBlack{0, 0, 0, 255}, kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255};

class Draw : public testing::TestWithParam<bool> {
 protected:
  void TearDown() override { EXPECT_EQ(vulkan::validationMessages(), 0u); }
};

TEST_P(Draw, ClearIsRead) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 1, 0);
  EXPECT_EQ(scene.at(3, 4), kGreen);
}

TEST_P(Draw, TriangleCoversItsHalf) {
  Scene scene(GetParam());
  const float half[] = {-1, -1, 1, -1, -1, 1};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.color(1, 0, 0);
  scene.array(gen::kPosition, half, 2);
  scene.draw(GL_TRIANGLES, 3);
  EXPECT_EQ(scene.at(1, 1), kRed);
  EXPECT_EQ(scene.at(14, 14), kBlack);
  EXPECT_EQ(scene.at(1, 13), kRed);
}

TEST_P(Draw, WindowsAreUpsideDownInMemoryOnly) {
  Scene scene(GetParam());
  scene.state.framebuffer.yDown = true;
  const float low[] = {-1, -1, 1, -1, 1, 0, -1, -1, 1, 0, -1, 0};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.color(0, 0, 1);
  scene.array(gen::kPosition, low, 2);
  scene.draw(GL_TRIANGLES, 6);
  EXPECT_EQ(scene.at(8, 2), kBlue);
  EXPECT_EQ(scene.at(8, 12), kBlack);
}

TEST_P(Draw, CullingFollowsTheOrderOfVertices) {
  for (const bool yDown : {false, true}) {
    Scene scene(GetParam());
    scene.state.framebuffer.yDown = yDown;
    scene.state.raster.cullFace = true;
    const float ccw[] = {-1, -1, 3, -1, -1, 3}, cw[] = {-1, -1, -1, 3, 3, -1};
    scene.clear(GL_COLOR_BUFFER_BIT);
    scene.color(1, 0, 0);
    scene.array(gen::kPosition, cw, 2);
    scene.draw(GL_TRIANGLES, 3);
    EXPECT_EQ(scene.at(8, 8), kBlack);
    scene.array(gen::kPosition, ccw, 2);
    scene.draw(GL_TRIANGLES, 3);
    EXPECT_EQ(scene.at(8, 8), kRed);
  }
}

TEST_P(Draw, DepthTestHidesWhatIsBehind) {
  Scene scene(GetParam());
  scene.state.ops.depthTest = true;
  scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.color(0, 1, 0);
  scene.cover(0.2f);
  scene.color(1, 0, 0);
  scene.cover(0.5f);
  EXPECT_EQ(scene.at(8, 8), kGreen);
  scene.cover(-0.5f);
  EXPECT_EQ(scene.at(8, 8), kRed);
}

TEST_P(Draw, DepthIsKeptAcrossReads) {
  Scene scene(GetParam());
  scene.state.ops.depthTest = true;
  scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.color(0, 1, 0);
  scene.cover(0);
  scene.read();
  scene.color(1, 0, 0);
  scene.cover(0.5f);
  EXPECT_EQ(scene.at(8, 8), kGreen);
}

TEST_P(Draw, DepthAppearsInTheMiddleOfAFrame) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.color(0, 1, 0);
  scene.cover(0.9f);
  scene.state.ops.depthTest = true;
  scene.changed |= gen::kGroupFragmentOps;
  scene.color(1, 0, 0);
  scene.cover(0);
  EXPECT_EQ(scene.at(8, 8), kRed);
  scene.color(0, 0, 1);
  scene.cover(0.5f);
  EXPECT_EQ(scene.at(8, 8), kRed);
}

TEST_P(Draw, StencilMasksAndMaskedClears) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  scene.state.ops.stencilWriteMask = 0x0f;
  scene.state.clear.stencil = 0xff;
  scene.state.scissorTest = true;
  scene.state.scissor = {0, 0, 8, 16};
  scene.clear(GL_STENCIL_BUFFER_BIT);
  scene.state.scissorTest = false;
  scene.state.ops.stencilTest = true;
  scene.state.ops.stencilFunc = GL_EQUAL;
  scene.state.ops.stencilRef = 0x0f;
  scene.changed = gen::kAllGroups;
  scene.color(1, 0, 0);
  scene.cover();
  EXPECT_EQ(scene.at(2, 2), kRed);
  EXPECT_EQ(scene.at(12, 2), kBlack);
}

TEST_P(Draw, MaskedAndScissoredColorClears) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT, 1, 0, 0);
  scene.state.ops.colorMask = {false, true, false, true};
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 1, 1, 1);
  EXPECT_EQ(scene.at(5, 5), (Pixel{255, 255, 0, 255}));
  scene.state.ops.colorMask = {true, true, true, true};
  scene.state.scissorTest = true;
  scene.state.scissor = {4, 4, 4, 4};
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 1);
  EXPECT_EQ(scene.at(5, 5), kBlue);
  EXPECT_EQ(scene.at(3, 5), (Pixel{255, 255, 0, 255}));
}

TEST_P(Draw, BlendAndLogicOp) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT, 1, 0, 0);
  scene.state.ops.blend = true;
  scene.state.ops.blendSrcRgb = scene.state.ops.blendDstRgb = GL_ONE;
  scene.color(0, 1, 0);
  scene.cover();
  EXPECT_EQ(scene.at(5, 5), (Pixel{255, 255, 0, 255}));
  for (const auto& [op, blue] :
       {std::pair{GL_XOR, 0xf0}, std::pair{GL_COPY, 0x0f}, std::pair{GL_XOR, 0xf0}}) {
    scene.state.ops.logicOpEnabled = false;
    scene.changed |= gen::kGroupFragmentOps;
    scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 1);
    scene.state.ops.logicOpEnabled = true;
    scene.state.ops.logicOp = static_cast<GLenum>(op);
    scene.changed |= gen::kGroupFragmentOps;
    scene.color(0, 0, 15 / 255.0f, 0);
    scene.cover();
    EXPECT_EQ(scene.at(5, 5)[2], blue);
  }
}

TEST_P(Draw, FramebufferWithoutAlphaReadsAsOpaque) {
  for (const auto format : {render::Format::RGB8, render::Format::RGB565}) {
    Scene scene(GetParam(), 16, 16, format);
    scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 0, 0);
    scene.state.ops.blend = true;
    scene.state.ops.blendSrcRgb = GL_DST_ALPHA;
    scene.state.ops.blendDstRgb = GL_ZERO;
    scene.color(0, 1, 0, 0);
    scene.cover();
    scene.cover();
    EXPECT_EQ(scene.at(5, 5), kGreen);
  }
}

TEST_P(Draw, PolygonOffsetLiftsByTheSmallestDifference) {
  for (const auto depth :
       {render::Format::Depth16, render::Format::Depth24, render::Format::Depth24Stencil8}) {
    Scene scene(GetParam(), 16, 16, render::Format::RGBA8, depth);
    scene.state.ops.depthTest = true;
    scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    scene.color(0, 1, 0);
    scene.cover(0.25f);
    scene.color(1, 0, 0);
    scene.cover(0.25f);
    EXPECT_EQ(scene.at(8, 8), kGreen);
    scene.state.raster.polygonOffsetFill = true;
    scene.state.raster.polygonOffsetUnits = -1;
    scene.changed |= gen::kGroupRaster;
    scene.cover(0.25f);
    EXPECT_EQ(scene.at(8, 8), kRed);
  }
}

TEST_P(Draw, DepthRangeMayBeReversed) {
  Scene scene(GetParam());
  scene.state.depthNear = 1;
  scene.state.depthFar = 0;
  scene.state.ops.depthTest = true;
  scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.color(0, 1, 0);
  scene.cover(0);
  scene.color(1, 0, 0);
  scene.cover(-0.5f);
  EXPECT_EQ(scene.at(8, 8), kGreen);
  scene.cover(0.5f);
  EXPECT_EQ(scene.at(8, 8), kRed);
}

TEST_P(Draw, MultisampledEdgesAreResolved) {
  const int samples = device(GetParam()).caps().maxSamples;
  if (samples == 1) GTEST_SKIP() << "the device has no multisampling";
  Scene scene(GetParam(), 16, 16, render::Format::RGBA8, render::Format::Depth24Stencil8, samples);
  const float half[] = {-1, -1, 1, -1, -1, 1};
  scene.state.ops.depthTest = true;
  scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.array(gen::kPosition, half, 2);
  scene.draw(GL_TRIANGLES, 3);
  EXPECT_EQ(scene.at(1, 1), (Pixel{255, 255, 255, 255}));
  const Pixel edge = scene.at(8, 7);
  EXPECT_GT(edge[0], 0);
  EXPECT_LT(edge[0], 255);
}

TEST_P(Draw, FlatColorsComeFromTheLastVertex) {
  Scene scene(GetParam());
  scene.state.fixed.shadeModel = GL_FLAT;
  const float cover[] = {-1, -1, 3, -1, -1, 3};
  const float colors[] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  scene.array(gen::kPosition, cover, 2);
  scene.array(gen::kColor, colors, 4);
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLES, 3);
  EXPECT_EQ(scene.at(8, 8), kBlue);
  // A strip and a fan: 3.2.
  const float strip[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  const float four[] = {1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  scene.array(gen::kPosition, strip, 2);
  scene.array(gen::kColor, four, 4);
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLE_STRIP, 4);
  EXPECT_EQ(scene.at(2, 2), kGreen);
  EXPECT_EQ(scene.at(13, 13), kBlue);
}

TEST_P(Draw, LineLoopsAreClosed) {
  Scene scene(GetParam());
  const float square[] = {-0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.array(gen::kPosition, square, 2);
  scene.draw(GL_LINE_LOOP, 4);
  int lit = 0;
  for (const Pixel& pixel : scene.read()) lit += pixel[0] == 255;
  EXPECT_NEAR(lit, 32, 2);
}

TEST_P(Draw, ContextsOnTwoThreadsShareTheDevice) {
  device(GetParam());
  const auto paint = [&](float red, int& wrong) {
    Scene scene(GetParam());
    for (int i = 0; i < 100; ++i) {
      const float green = static_cast<float>(i) / 255;
      scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      scene.state.ops.depthTest = i % 2;
      scene.changed |= gen::kGroupFragmentOps;
      scene.color(red, green, 0);
      scene.cover();
      wrong += scene.at(8, 8) != Pixel{static_cast<uint8_t>(red * 255), static_cast<uint8_t>(i), 0, 255};
    }
  };
  int wrong[2] = {0, 0};
  std::thread other(paint, 1.0f, std::ref(wrong[1]));
  paint(0.0f, wrong[0]);
  other.join();
  EXPECT_EQ(wrong[0], 0);
  EXPECT_EQ(wrong[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Draw, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
