// Draws a few states at the renderer's seam and says what that took: "compiled N cached N pipelines N ahead N
// picture HASH". cache_program [minimal] [fog]: on bare Vulkan 1.1; other states. CACHE_AWAIT: draws when so
// many pipelines are made.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "tests/vulkan/scene.h"

namespace {

struct Wishes {
  bool minimal = false, fog = false;
  uint64_t await = 0;
};

Wishes parse(int argc, char** argv) {
  Wishes wishes;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "minimal")) wishes.minimal = true;
    if (!std::strcmp(argv[i], "fog")) wishes.fog = true;
  }
  if (const char* await = std::getenv("CACHE_AWAIT")) wishes.await = std::strtoull(await, nullptr, 10);
  return wishes;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace anteroom;
  const Wishes wishes = parse(argc, argv);
  test::Scene scene(test::device(wishes.minimal, false), 32, 32, render::Format::RGBA8,
                    render::Format::Depth24Stencil8, 1);
  const vulkan::PipelineCache& pipelines = static_cast<vulkan::VulkanDevice&>(scene.device).pipelines();
  for (int i = 0; i < 30000 && pipelines.ahead() < wishes.await; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const float triangle[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.array(gen::kPosition, triangle, 3);
  for (int i = 0; i < 4; ++i) {
    scene.color(1, 0.25f * static_cast<float>(i), 0);
    scene.state.fixed.alphaTest = i & 1;
    scene.state.fixed.alphaFunc = GL_GREATER;
    scene.state.fixed.fog.enabled = wishes.fog || i & 2;
    scene.state.ops.blend = i == 3;
    scene.state.ops.blendDstRgb = scene.state.ops.blendDstAlpha = GL_ONE;
    scene.changed = gen::kAllGroups;
    scene.draw(GL_TRIANGLES, 3);
  }
  // A quad by the renderer's own shaders.
  scene.state.ops.colorMask = {false, false, true, false};
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 1);
  uint32_t picture = 2166136261u;
  for (const test::Pixel& pixel : scene.read())
    for (uint8_t value : pixel) picture = (picture ^ value) * 16777619u;
  const render::Stats& stats = scene.context->stats();
  const auto number = [](uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("compiled %llu cached %llu pipelines %llu ahead %llu picture %08x\n",
              number(stats.shadersCompiled), number(stats.shadersFromCache), number(stats.pipelinesCreated),
              number(pipelines.ahead()), picture);
  return testing::Test::HasFailure() ? 1 : 0;
}
