// What the driver's own fixed functions do, with nothing of ours in between: one opaque rectangle that shows
// one texture as it is. The error of these pictures is the driver's, and bounds the scenes that name it.
#include <cmath>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

// Vulkan lets the weights of a linear filter have as few bits as subTexelPrecisionBits says, 4 at least and
// 8 on most devices. A weight that is off by e moves a pixel by e times the contrast of its texels, which
// here is the largest there is in both directions, so that no other picture can suffer more from the weights.
Texel contrast(int x, int y) {
  const std::uint8_t c = (x + y) % 2 != 0 ? 255 : 0;
  return {c, c, static_cast<std::uint8_t>(255 - c), c};
}

void filterWeights() {
  texture(2, 2, contrast);
  filter(GL_LINEAR, GL_LINEAR);
  wrap(GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  environment(GL_REPLACE);
  textured(0.25, 0.25, 0.75, 0.75).draw();
}

// The level of detail is log2 of a scale factor, and drivers approximate both (Vulkan has no bound for the
// logarithm but mipmapPrecisionBits, 4 at least). Neighbouring levels are black and white, so that a pixel's
// error is that of its level of detail, in 1/255. Each row has its own scale, 2^(1/16) from one to the next,
// and the two directions have the same one: rho is exact and leaves the logarithm alone.
Texel black(int, int) {
  return {0, 0, 0, 255};
}
Texel white(int, int) {
  return {255, 255, 255, 255};
}

constexpr int kLevels = 8, kRows = 96;

void blackAndWhiteLevels() {
  for (int i = 0; i < kLevels; ++i)
    level(i, 1 << (kLevels - 1 - i), 1 << (kLevels - 1 - i), i % 2 != 0 ? white : black);
  filter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
}

void levelOfDetail() {
  texture(1, 1, black);
  blackAndWhiteLevels();
  for (int row = 0; row < kRows; row += 2) {
    const double low = 2.0 * row / kRows - 1, high = 2.0 * (row + 2) / kRows - 1;
    const double texelsAPixel = std::exp2(row / 16.0), side = texelsAPixel * kRows / (1 << (kLevels - 1));
    Mesh mesh = rectangle(-1, low, 1, high);
    const auto s = static_cast<GLfloat>(side), t = static_cast<GLfloat>(side * 2 / kRows);
    mesh.texCoords = {0, 0, s, 0, s, t, 0, 0, s, t, 0, t};
    mesh.draw();
  }
}

}  // namespace

void addDriverScenes(Scenes& scenes) {
  scenes.push_back(
      {"driver/filter weights", "Vulkan 1.1, 15.6", filterWeights, {128, 128}, 0, Driver::kFilter});
  scenes.push_back({"driver/level of detail",
                    "Vulkan 1.1, 15.6.7",
                    levelOfDetail,
                    {kRows, kRows},
                    0,
                    Driver::kLevelOfDetail});
}

}  // namespace comparison
