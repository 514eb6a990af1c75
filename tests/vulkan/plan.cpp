// The plan of a draw alone: from a state to a plain struct. Nothing is recorded.
#include "layer/vulkan/plan/draw_planner.h"

#include <cstring>

#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/resources/sampler.h"
#include "tests/vulkan/parts.h"

namespace anteroom::test {
namespace {

using vulkan::Carried;

class Plan : public Part {
 protected:
  void SetUp() override {
    state_.framebuffer = picture_.framebuffer;
    state_.fixed.viewport = {0, 0, 8, 8};
    state_.fixed.alphaBits = 8;
    state_.fixed.attributes[gen::kPosition] = {true, 3, GL_FLOAT, {}};
  }
  bool update(gen::Groups changed, Carried carried = Carried::Nothing) {
    return planner_.update(state_, changed, carried);
  }

  Picture picture_{device()};
  render::State state_;
  vulkan::DrawPlanner planner_{device()};
  const vulkan::DrawPlan& plan_ = planner_.plan();
};

TEST_P(Plan, HoldsWhatAStateMeans) {
  state_.ops.blend = true;
  state_.ops.blendDstRgb = GL_ONE;
  state_.scissorTest = true;
  state_.scissor = {2, 2, 100, 3};
  ASSERT_TRUE(update(gen::kAllGroups));
  EXPECT_FALSE(plan_.nothing);
  EXPECT_EQ(plan_.target.color, &picture_.image());
  EXPECT_TRUE(plan_.vertexShader && plan_.fragmentShader);
  EXPECT_TRUE(gen::valid(plan_.vertexKey) && gen::valid(plan_.fragmentKey));
  EXPECT_EQ(plan_.units, 0u);
  EXPECT_EQ(plan_.state.fixed.blend, 1);
  EXPECT_EQ(plan_.state.fixed.dstRgb, VK_BLEND_FACTOR_ONE);
  EXPECT_EQ(plan_.state.scissor.extent.width, 6u);
  EXPECT_GE(plan_.push.size, 64u) << "a matrix at least";
  EXPECT_FALSE(plan_.usesDepth()) << "there is no depth buffer";
}

TEST_P(Plan, OfADrawThatNobodyCanSeeIsNothing) {
  state_.fixed.viewport.width = 0;
  ASSERT_TRUE(update(gen::kAllGroups));
  EXPECT_TRUE(plan_.nothing);
  state_.fixed.viewport.width = 8;
  ASSERT_TRUE(update(gen::kGroupViewport));
  EXPECT_FALSE(plan_.nothing);
  state_.raster.cullFace = true;
  state_.raster.cullFaceMode = GL_FRONT_AND_BACK;
  ASSERT_TRUE(update(gen::kGroupRaster));
  EXPECT_TRUE(plan_.nothing);
}

TEST_P(Plan, LooksAtWhatChangedOnly) {
  ASSERT_TRUE(update(gen::kAllGroups));
  const uint64_t version = plan_.push.version;
  const vulkan::Shader* const shader = plan_.fragmentShader;
  state_.fixed.modelview[3].x = 2;
  state_.ops.blend = true;
  ASSERT_TRUE(update(0));
  EXPECT_EQ(plan_.push.version, version);
  EXPECT_EQ(plan_.state.fixed.blend, 0);
  ASSERT_TRUE(update(gen::kGroupModelview | gen::kGroupFragmentOps));
  EXPECT_EQ(plan_.push.version, version + 1);
  EXPECT_EQ(plan_.state.fixed.blend, 1);
  EXPECT_EQ(plan_.fragmentShader, shader) << "neither changes a key";
  ASSERT_TRUE(update(gen::kGroupModelview));
  EXPECT_EQ(plan_.push.version, version + 1) << "packed again, to the same";
}

TEST_P(Plan, SamplesWhatIsBound) {
  Picture texture(device(), 4, 4, 3);
  state_.fixed.units[1].target = gen::TextureTarget::Texture2D;
  state_.textures[1] = {&texture.image(), {GL_LINEAR, GL_NEAREST}, 2, 0};
  ASSERT_TRUE(update(gen::kAllGroups));
  EXPECT_EQ(plan_.units, 2u);
  EXPECT_EQ(plan_.sampled[1].image, &texture.image());
  EXPECT_EQ(plan_.sampled[1].onlyLevel, 2);
  EXPECT_EQ(plan_.textures[1].sampler, device().samplers().get({GL_LINEAR, GL_NEAREST}, 1, 0));
  EXPECT_FALSE(texture.image().hasStore()) << "a plan touches no image";
}

TEST_P(Plan, KnowsWhatVerticesCarry) {
  ASSERT_TRUE(update(gen::kAllGroups));
  const gen::VertexKey alone = plan_.vertexKey;
  ASSERT_TRUE(update(gen::kGroupCurrentColor | gen::kGroupPrimitive, Carried::Values));
  EXPECT_TRUE(plan_.vertexKey.ownValues);
  EXPECT_FALSE(plan_.vertexKey == alone);
  const auto before = plan_.push.data;
  const uint64_t version = plan_.push.version;
  state_.fixed.modelview[3].x = 2;
  planner_.packCarried(state_);
  EXPECT_NE(plan_.push.data, before);
  EXPECT_EQ(plan_.push.version, version) << "nothing is pushed";
}

TEST_P(Plan, TellsArraysThatLieElsewhereFromArraysThatLookDifferent) {
  ASSERT_TRUE(update(gen::kAllGroups));
  state_.arrays[gen::kPosition].pointer = &state_;
  EXPECT_TRUE(planner_.sameArrays(state_.fixed));
  state_.fixed.attributes[gen::kPosition].size = 2;
  EXPECT_FALSE(planner_.sameArrays(state_.fixed));
}

INSTANTIATE_TEST_SUITE_P(Profiles, Plan, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
