// Filters, levels of detail, and the functions of shaders.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "functions_frag.h"
#include "measurements.h"
#include "texture_frag.h"

namespace driver {

std::vector<Vertex> rectangle(float x0, float y0, float x1, float y1, float s0, float t0, float s1,
                              float t1) {
  const Vertex a{{x0, y0, 0, 1}, {s0, t0, 0, 1}}, b{{x1, y0, 0, 1}, {s1, t0, 0, 1}};
  const Vertex c{{x1, y1, 0, 1}, {s1, t1, 0, 1}}, d{{x0, y1, 0, 1}, {s0, t1, 0, 1}};
  return {a, b, c, a, c, d};
}

namespace {

constexpr VkFormat kFloats = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr int kLevels = 8, kBase = 1 << (kLevels - 1);

// Levels are black and white in turn: a color is how far its level of detail is from an even number.
Texture blackAndWhiteLevels() {
  Texture texture;
  texture.size = kBase;
  texture.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  for (int i = 0; i < kLevels; ++i) {
    const auto side = static_cast<std::size_t>(kBase >> i);
    texture.levels.emplace_back(side * side * 4, static_cast<std::uint8_t>(i % 2 * 255));
  }
  return texture;
}

double levelError(double color, double exact) {
  const double nearest = std::round(exact / 2) * 2;
  return std::min({std::abs(nearest + color - exact), std::abs(nearest - color - exact),
                   std::abs(nearest + 2 - color - exact), std::abs(nearest - 2 + color - exact)});
}

// A plane before a camera of 60 degrees, with 8 repeats of the texture from end to end.
class Floor {
 public:
  Floor(double tilt, double turn) {
    const glm::dmat4 view =
        glm::frustum(-kHalf, kHalf, -kHalf, kHalf, 0.5, 60.0) * glm::translate(glm::dmat4(1), {0, -0.6, -8}) *
        glm::rotate(glm::dmat4(1), glm::radians(tilt), {1, 0, 0}) *
        glm::rotate(glm::dmat4(1), glm::radians(turn), {0, 0, 1}) * glm::scale(glm::dmat4(1), {8, 8, 1});
    toClip_ = {{view[0].x, view[0].y, view[0].w},
               {view[1].x, view[1].y, view[1].w},
               {view[3].x, view[3].y, view[3].w}};
    toFloor_ = glm::inverse(toClip_);
  }

  std::vector<Vertex> vertices() const {
    const Vertex a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
    return {a, b, c, a, c, d};
  }
  // The level of detail (3.14) at a place in [-1, 1], whose pixels are `pixel` wide; negative off the floor.
  double level(double x, double y, double pixel) const {
    const glm::dvec3 at = toFloor_ * glm::dvec3(x, y, 1);
    if (at.z <= 0 || std::abs(at.x / at.z) > 0.9 || std::abs(at.y / at.z) > 0.9) return -1;
    const double step = pixel * 1e-4;
    const glm::dvec2 dx = place(x + step, y) - place(x - step, y),
                     dy = place(x, y + step) - place(x, y - step);
    return std::log2(std::max(glm::length(dx), glm::length(dy)) * kBase / 2e-4);
  }

 private:
  static constexpr double kHalf = 0.28867513459481287;  // 0.5 tan 30
  Vertex corner(double x, double y) const {
    const glm::dvec3 p = toClip_ * glm::dvec3(x, y, 1);
    const auto w = static_cast<float>(p.z);
    return {{static_cast<float>(p.x), static_cast<float>(p.y), 0.5f * w, w},
            {static_cast<float>(4 * x + 4), static_cast<float>(4 * y + 4), 0, 1}};
  }
  glm::dvec2 place(double x, double y) const {
    const glm::dvec3 at = toFloor_ * glm::dvec3(x, y, 1);
    return glm::dvec2(at) / at.z * 4.0;
  }
  glm::dmat3 toClip_, toFloor_;
};

struct FunctionErrors {
  double power = 0, exponential = 0;
};
FunctionErrors functionErrors(Device& device) {
  constexpr int kSize = 256;
  const std::vector<float> pixels =
      device.render(kFloats, kSize, kSize, {{functions_frag, rectangle(-1, -1, 1, 1, 0, 0, 1, 128)}});
  FunctionErrors errors;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const double x = double(pixels[i + 2]), y = double(pixels[i + 3]);
    errors.power = std::max(errors.power, std::abs(double(pixels[i]) - std::pow(x, y)));
    errors.exponential = std::max(errors.exponential, std::abs(double(pixels[i + 1]) - std::exp(-0.125 * y)));
  }
  return errors;
}

}  // namespace

double filterWeights(Device& device) {
  constexpr int kSize = 256;
  Texture texture;
  texture.size = 2;
  texture.levels = {{0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0}};
  const std::vector<float> pixels =
      device.render(VK_FORMAT_R8G8B8A8_UNORM, kSize, kSize,
                    {{texture_frag, rectangle(-1, -1, 1, 1, 0.25f, 0.25f, 0.75f, 0.75f),
                      VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, &texture}});
  double worst = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double a = (x + 0.5) / kSize, b = (y + 0.5) / kSize, exact = a * (1 - b) + b * (1 - a);
      worst =
          std::max(worst, std::abs(double(pixels[static_cast<std::size_t>(4 * (y * kSize + x))]) - exact));
    }
  }
  return worst;
}

double levelOfDetail(Device& device) {
  constexpr int kRows = 192;
  const Texture texture = blackAndWhiteLevels();
  Draw draw{texture_frag, {}, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, &texture};
  const auto levelOf = [](int row) { return (row / 2) / 16.0; };  // both rows of a quad have one
  for (int row = 0; row < kRows; row += 2) {
    const double side = std::exp2(levelOf(row)) * kRows / kBase;
    const float low = 2.0f * static_cast<float>(row) / kRows - 1,
                high = 2.0f * static_cast<float>(row + 2) / kRows - 1;
    const std::vector<Vertex> strip =
        rectangle(-1, low, 1, high, 0, 0, static_cast<float>(side), static_cast<float>(side * 2 / kRows));
    draw.vertices.insert(draw.vertices.end(), strip.begin(), strip.end());
  }
  const std::vector<float> pixels = device.render(kFloats, kRows, kRows, {draw});
  double worst = 0;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kRows; ++x)
      worst = std::max(worst,
                       levelError(double(pixels[static_cast<std::size_t>(4 * (y * kRows + x))]), levelOf(y)));
  }
  return worst;
}

double levelOfDetailInPerspective(Device& device) {
  constexpr int kSize = 96;
  const Texture texture = blackAndWhiteLevels();
  double worst = 0;
  for (const auto& [tilt, turn] : {std::pair{-80.0, 0.0}, {-80.0, 30.0}, {-70.0, 0.0}, {-85.0, 0.0}}) {
    const Floor floor(tilt, turn);
    const std::vector<float> pixels =
        device.render(kFloats, kSize, kSize,
                      {{texture_frag, floor.vertices(), VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, &texture}});
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double level = floor.level((x + 0.5) * 2 / kSize - 1, (y + 0.5) * 2 / kSize - 1, 2.0 / kSize);
        if (level < 0 || level > kLevels - 1.5) continue;
        worst =
            std::max(worst, levelError(double(pixels[static_cast<std::size_t>(4 * (y * kSize + x))]), level));
      }
    }
  }
  return worst;
}

// A pixel is 4 texels high and 4 * 2^stretch wide: what N samples along the width leave is the level of
// detail.
double anisotropy(Device& device) {
  constexpr int kSize = 32;
  double worst = 0;
  for (float most = 2; most <= std::min(16.0f, device.maxAnisotropy()); most *= 2) {
    Texture texture = blackAndWhiteLevels();
    texture.anisotropy = most;
    for (int stretch = 0; stretch <= 4; ++stretch) {
      const float side = 4.0f * kSize / kBase, wide = side * static_cast<float>(1 << stretch);
      const std::vector<float> pixels =
          device.render(kFloats, kSize, kSize,
                        {{texture_frag, rectangle(-1, -1, 1, 1, 0, 0, wide, side),
                          VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, &texture}});
      const double level = 2 + stretch - std::log2(std::min(static_cast<double>(1 << stretch), double(most)));
      for (std::size_t i = 0; i < pixels.size(); i += 4)
        worst = std::max(worst, levelError(double(pixels[i]), level));
    }
  }
  return worst;
}

double power(Device& device) {
  return functionErrors(device).power;
}
double exponential(Device& device) {
  return functionErrors(device).exponential;
}

}  // namespace driver
