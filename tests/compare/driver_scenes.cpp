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

// A floor: in perspective the derivatives are differences across 2x2 pixels, which is one more approximation.
void levelOfDetailOfFloor() {
  texture(1, 1, black);
  blackAndWhiteLevels();
  drawFloor();
}

// Where the grey turns at a whole level an error is folded back, so the same once more, half a level on.
void levelOfDetailHalfOn() {
  const auto half = static_cast<GLfloat>(std::sqrt(2.0));
  glMatrixMode(GL_TEXTURE);
  glScalef(half, half, 1);
  glMatrixMode(GL_MODELVIEW);
  levelOfDetailOfFloor();
}

// Two passes of colours that 8 bits hold exactly, without interpolation, onto such a colour: only the
// blending rounds.
void blending() {
  clear(51 / 255.0f, 102 / 255.0f, 153 / 255.0f, 204 / 255.0f);
  texture(16, 16, noise);
  environment(GL_REPLACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  textured(0, 0, 1, 1).draw();
  textured(0.5, 0.25, 1.5, 1.25).draw();
}

// Black at one end and white at the other: an error is where along the line a fragment takes its colour from
// (equation 3.5), in 1/255 of the line. Every tenth degree, since the error depends on the direction.
Mesh rays(float from, float to) {
  Mesh mesh;
  for (int i = 0; i < 36; ++i) {
    const double a = 6.283185307 * i / 36 + 0.05, c = std::cos(a), s = std::sin(a);
    mesh.positions.insert(mesh.positions.end(),
                          {static_cast<GLfloat>(0.1 * c), static_cast<GLfloat>(0.1 * s), 0,
                           static_cast<GLfloat>(0.9 * c), static_cast<GLfloat>(0.9 * s), 0});
    mesh.colors.insert(mesh.colors.end(), {from, from, from, 1, to, to, to, 1});
  }
  return mesh;
}
void lineColors() {
  rays(0, 1).draw(GL_LINES);
}

// White on black: the coverage itself.
void smoothLines() {
  glLineWidth(2.5f);
  glEnable(GL_LINE_SMOOTH);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  rays(1, 1).draw(GL_LINES);
}

}  // namespace

void addDriverScenes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, const char* section, void (*draw)(), int size, Driver driver) {
    scenes.push_back({name, section, draw, {size, size}, 0, driver});
  };
  add("driver/filter weights", "Vulkan 1.1, 15.6", filterWeights, 128, Driver::kFilter);
  add("driver/level of detail", "Vulkan 1.1, 15.6.7", levelOfDetail, kRows, Driver::kLevelOfDetail);
  add("driver/level of detail of a floor", "Vulkan 1.1, 15.6.7", levelOfDetailOfFloor, kRows,
      Driver::kLevelOfDetail);
  add("driver/level of detail half on", "Vulkan 1.1, 15.6.7", levelOfDetailHalfOn, kRows,
      Driver::kLevelOfDetail);
  add("driver/blending", "Vulkan 1.1, 26.1", blending, 64, Driver::kBlend);
  add("driver/line colors", "Vulkan 1.1, 24.6", lineColors, 64, Driver::kLine);
  add("driver/smooth lines", "Vulkan 1.1, 24.6", smoothLines, 64, Driver::kSmoothLine);
}

}  // namespace comparison
