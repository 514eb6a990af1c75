// A frame that is drawn again costs no heap allocation and no Vulkan object.
#include <cstdlib>
#include <new>

#include "layer/render/hud.h"
#include "tests/vulkan/scene.h"

namespace {
thread_local uint64_t allocations = 0;
}

[[gnu::noinline]] void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace anteroom::test {
namespace {

class Steady : public testing::TestWithParam<bool> {};

TEST_P(Steady, FramesAllocateNothing) {
  // Without the validation layer, which allocates as it likes.
  Scene scene(device(GetParam(), false), 64, 64, render::Format::RGBA8, render::Format::Depth24Stencil8, 1);
  const float triangle[] = {-0.1f, -0.1f, 0, 0.1f, -0.1f, 0, 0, 0.1f, 0};
  const auto buffer = scene.device.createBuffer(sizeof triangle, triangle);
  const uint16_t indices[] = {0, 1, 2};
  scene.state.ops.depthTest = true;
  const auto frame = [&] {
    scene.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 200; ++i) {
      scene.color(static_cast<float>(i) / 200, 0, 1);
      scene.state.fixed.modelview[3] = {i % 20 / 10.0 - 1, i / 20 / 5.0 - 1, 0, 1};
      scene.changed |= gen::kGroupModelview;
      scene.array(gen::kPosition, triangle, 3);
      if (i % 2) scene.state.arrays[gen::kPosition] = {buffer.get(), nullptr, 12};
      render::DrawCall call;
      call.count = 3;
      if (i % 3 == 0) call.indexType = GL_UNSIGNED_SHORT, call.indices = indices;
      scene.draw(call);
    }
    scene.context->flush();
  };
  for (int i = 0; i < 20; ++i) frame();
  scene.read();
  const render::Stats before = scene.context->stats();
  const uint64_t allocationsBefore = allocations;
  for (int i = 0; i < 100; ++i) frame();
  const uint64_t made = allocations - allocationsBefore;
  const render::Stats after = scene.context->stats();
  EXPECT_EQ(made, 0u);
  EXPECT_EQ(after.vulkanObjectsCreated, before.vulkanObjectsCreated);
  EXPECT_EQ(after.memoryAllocations, before.memoryAllocations);
  EXPECT_EQ(after.pipelinesCreated, before.pipelinesCreated);
  EXPECT_EQ(after.draws - before.draws, 100u * 200u);
  EXPECT_EQ(after.submits - before.submits, 100u);
  EXPECT_EQ(after.renderPasses - before.renderPasses, 100u);
}

// Nor does the HUD; and of its pass and its pipeline no number tells.
TEST_P(Steady, HudAllocatesNothingAndCountsAsNothing) {
  Scene scene(device(GetParam(), false), 256, 64, render::Format::RGBA8, render::Format::None, 1);
  Scene other(device(GetParam(), false), 256, 64, render::Format::RGBA8, render::Format::None, 1);
  render::Hud hud;
  hud.lines = 2;
  hud.graphLine = 1;
  for (render::Hud::Line& line : hud.text) line.fill('8');
  const auto frame = [&](bool withHud) {
    scene.clear(GL_COLOR_BUFFER_BIT, 0.5f, 0.5f, 0.5f);
    scene.cover();
    // A pass of its own.
    if (withHud) scene.context->drawHud(other.state.framebuffer, hud);
    scene.context->flush();
  };
  frame(false);
  const render::Stats first = scene.context->stats();
  for (int i = 0; i < 300; ++i) frame(true);  // until the streams are as large as they need to be
  scene.context->finish();
  const render::Stats before = scene.context->stats();
  const uint64_t allocationsBefore = allocations;
  for (int i = 0; i < 100; ++i) frame(true);
  EXPECT_EQ(allocations - allocationsBefore, 0u);
  const render::Stats after = scene.context->stats();
  EXPECT_EQ(after.vulkanObjectsCreated, before.vulkanObjectsCreated);
  EXPECT_EQ(after.renderPasses - before.renderPasses, 100u);
  EXPECT_EQ(after.draws - before.draws, 100u);
  EXPECT_EQ(after.pipelinesCreated, first.pipelinesCreated);
  EXPECT_EQ(after.shadersCompiled + after.shadersFromCache, first.shadersCompiled + first.shadersFromCache);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Steady, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
