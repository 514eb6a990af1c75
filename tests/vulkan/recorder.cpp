// The recorder alone: what it is told is what the device does, in order.
#include "layer/vulkan/recording/recorder.h"

#include <cstring>

#include "tests/vulkan/parts.h"

namespace anteroom::test {
namespace {

constexpr uint8_t kAll = 15;  // components
constexpr Pixel kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kClear{0, 0, 0, 0};

class RecorderAlone : public Part {
 protected:
  void SetUp() override { ASSERT_TRUE(recorder_.initialise()); }

  vulkan::Quad flat(Picture& picture, float r, float g) {
    vulkan::Quad quad(picture.target());
    quad.color = {r, g, 0, 1};
    quad.state.fixed.writeMask = kAll;
    return quad;
  }

  // Red primitives of triangles by GL's simplest state.
  vulkan::DrawPlan redPlan(Picture& picture) {
    gen::State state;
    state.alphaBits = 8;
    state.attributes[gen::kPosition].array = true;
    state.attributes[gen::kColor].current = {1, 0, 0, 1};
    vulkan::DrawPlan plan;
    plan.target = picture.target();
    plan.state = flat(picture, 0, 0).state;
    plan.fragmentKey = gen::canonicaliseFragment(state, device().caps().profile);
    plan.vertexKey = gen::canonicaliseVertex(state, plan.fragmentKey, device().caps().profile);
    plan.fragmentShader = device().shaders().get(plan.fragmentKey);
    plan.vertexShader = device().shaders().get(plan.vertexKey);
    plan.blocks = gen::blocks(plan.vertexKey, plan.fragmentKey);
    plan.push.size = plan.blocks.pushSize;
    plan.push.version = 1;
    gen::packPush(plan.vertexKey, state, plan.push.data.data());
    EXPECT_EQ(plan.blocks.vertexSize + plan.blocks.fragmentSize, 0u);
    return plan;
  }

  // The lower left half of the target, then the upper right one: three vertices each.
  vulkan::Geometry halves() {
    constexpr float kVertices[6][4] = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1},
                                       {1, 1, 0, 1},   {-1, 1, 0, 1}, {1, -1, 0, 1}};
    const vulkan::StreamPiece piece = recorder_.vertices().allocate(sizeof kVertices, 16);
    std::memcpy(piece.mapped, kVertices, sizeof kVertices);
    arrays_.layout.count = 1;
    arrays_.layout.arrays[0] = {gen::kPosition, VK_FORMAT_R32G32B32A32_SFLOAT, 16};
    arrays_.buffers[0] = piece.buffer;
    arrays_.offsets[0] = piece.offset;
    vulkan::Geometry geometry;
    geometry.arrays = &arrays_;
    geometry.range.count = 3;
    return geometry;
  }

  Pixel at(Picture& picture, int x, int y) {
    vulkan::VulkanImage& image = picture.image();
    const vulkan::StreamPiece piece = recorder_.readBack().allocate(4, 16);
    const VkCommandBuffer commands = recorder_.beginTransfer(&image.held(), nullptr);
    VkBufferImageCopy copy{};
    copy.bufferOffset = piece.offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageOffset = {x, y, 0};
    copy.imageExtent = {1, 1, 1};
    device().fn().vkCmdCopyImageToBuffer(commands, image.held()->image, VK_IMAGE_LAYOUT_GENERAL, piece.buffer,
                                         1, &copy);
    EXPECT_TRUE(recorder_.submit() && recorder_.waitForSubmitted());
    Pixel pixel;
    std::memcpy(pixel.data(), piece.mapped, 4);
    return pixel;
  }

  vulkan::Recorder recorder_{device()};
  vulkan::VertexArrays arrays_;
};

TEST_P(RecorderAlone, QuadsCoverTheirScissor) {
  Picture picture(device());
  vulkan::Quad quad = flat(picture, 1, 0);
  quad.state.scissor = {{2, 0}, {6, 8}};
  ASSERT_TRUE(recorder_.quad(picture.target(), quad));
  EXPECT_EQ(at(picture, 1, 4), kClear);
  EXPECT_EQ(at(picture, 2, 4), kRed);
}

TEST_P(RecorderAlone, DrawsWhatIsBound) {
  Picture picture(device());
  const vulkan::DrawPlan plan = redPlan(picture);
  const vulkan::Geometry geometry = halves();
  ASSERT_TRUE(recorder_.bind(plan, geometry));
  recorder_.draw(geometry.range);
  EXPECT_EQ(at(picture, 1, 1), kRed);
  EXPECT_EQ(at(picture, 6, 6), kClear);
}

// A quad binds other things: a draw after it must bind its own again.
TEST_P(RecorderAlone, QuadsBetweenDrawsDisturbNothing) {
  Picture picture(device());
  const vulkan::DrawPlan plan = redPlan(picture);
  vulkan::Geometry geometry = halves();
  ASSERT_TRUE(recorder_.bind(plan, geometry));
  recorder_.draw(geometry.range);
  ASSERT_TRUE(recorder_.quad(picture.target(), flat(picture, 0, 1)));
  geometry.range.first = 3;
  ASSERT_TRUE(recorder_.bind(plan, geometry));
  recorder_.draw(geometry.range);
  EXPECT_EQ(at(picture, 1, 1), kGreen);
  EXPECT_EQ(at(picture, 6, 6), kRed);
  EXPECT_EQ(recorder_.passes(), 1u);
}

TEST_P(RecorderAlone, WhatIsHeldBackGrowsAndComesFirst) {
  Picture picture(device());
  const vulkan::DrawPlan plan = redPlan(picture);
  const vulkan::Geometry geometry = halves();
  ASSERT_TRUE(recorder_.bind(plan, geometry));
  recorder_.holdBack(geometry.range);
  recorder_.growHeld(3);
  EXPECT_EQ(recorder_.held(), 6u);
  vulkan::Quad quad = flat(picture, 0, 1);
  quad.state.scissor = {{0, 0}, {4, 8}};
  ASSERT_TRUE(recorder_.quad(picture.target(), quad));
  EXPECT_EQ(recorder_.held(), 0u);
  EXPECT_EQ(at(picture, 1, 1), kGreen);
  EXPECT_EQ(at(picture, 6, 1), kRed);
  EXPECT_EQ(at(picture, 6, 6), kRed);
}

TEST_P(RecorderAlone, PassesEndWhenSomethingElseMustHappen) {
  Picture picture(device()), other(device());
  ASSERT_TRUE(recorder_.openPass(picture.target(), false));
  ASSERT_TRUE(recorder_.openPass(picture.target(), false));
  EXPECT_EQ(recorder_.passes(), 1u);
  EXPECT_TRUE(recorder_.passAttaches(*picture.image().store()));
  ASSERT_TRUE(other.image().store());
  ASSERT_TRUE(recorder_.beginSampling(other.image().held()));
  EXPECT_TRUE(recorder_.passIsOn(picture.target())) << "nothing was written to the other";
  ASSERT_TRUE(recorder_.beginTransfer(&other.image().held(), nullptr));
  EXPECT_FALSE(recorder_.passIsOn(picture.target()));
  ASSERT_TRUE(recorder_.openPass(other.target(), false));
  ASSERT_TRUE(recorder_.beginSampling(other.image().held()));
  EXPECT_FALSE(recorder_.passIsOn(other.target())) << "what is drawn to is not sampled";
  EXPECT_EQ(recorder_.passes(), 2u);
  vulkan::Quad hidden = flat(picture, 1, 0);
  hidden.counted = vulkan::Counted::No;
  ASSERT_TRUE(recorder_.quad(picture.target(), hidden));
  EXPECT_EQ(recorder_.passes(), 2u);
}

TEST_P(RecorderAlone, SubmissionsHoldWhatTheyUse) {
  Picture picture(device());
  EXPECT_TRUE(recorder_.submit()) << "of nothing";
  EXPECT_EQ(recorder_.submits(), 0u);
  ASSERT_TRUE(recorder_.quad(picture.target(), flat(picture, 1, 0)));
  const uint64_t recording = recorder_.recordingId();
  const auto& store = picture.image().held();
  EXPECT_GT(store.use_count(), 1);
  ASSERT_TRUE(recorder_.waitFor(*store)) << "which submits it first";
  EXPECT_EQ(recorder_.submits(), 1u);
  EXPECT_NE(recorder_.recordingId(), recording);
  recorder_.retire();
  EXPECT_EQ(store.use_count(), 1);
}

INSTANTIATE_TEST_SUITE_P(Profiles, RecorderAlone, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
