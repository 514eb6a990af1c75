// Draws a few states at the renderer's seam and says what that took: "compiled N cached N picture HASH".
#include <cstdio>

#include "tests/render/scene.h"

int main() {
  using namespace anteroom;
  test::Scene scene(test::device(false, false), 32, 32, render::Format::RGBA8,
                    render::Format::Depth24Stencil8, 1);
  const float triangle[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.array(gen::kPosition, triangle, 3);
  for (int i = 0; i < 4; ++i) {
    scene.color(1, 0.25f * static_cast<float>(i), 0);
    scene.state.fixed.alphaTest = i & 1;
    scene.state.fixed.alphaFunc = GL_GREATER;
    scene.state.fixed.fog.enabled = i & 2;
    scene.state.dirty = gen::kAllGroups;
    scene.draw(GL_TRIANGLES, 3);
  }
  // A quad by the renderer's own shaders.
  scene.state.ops.colorMask = {false, false, true, false};
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 1);
  uint32_t picture = 2166136261u;
  for (const test::Pixel& pixel : scene.read())
    for (uint8_t value : pixel) picture = (picture ^ value) * 16777619u;
  const render::Stats& stats = scene.context->stats();
  std::printf("compiled %llu cached %llu picture %08x\n",
              static_cast<unsigned long long>(stats.shadersCompiled),
              static_cast<unsigned long long>(stats.shadersFromCache), picture);
  return testing::Test::HasFailure() ? 1 : 0;
}
