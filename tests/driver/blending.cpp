// Blending in an RGBA8 target.
#include <algorithm>
#include <array>
#include <cmath>

#include "measurements.h"
#include "noise_frag.h"

namespace driver {

namespace {

constexpr int kSize = 64;
constexpr std::uint32_t kSourceBits = 16, kStoredBits = 8;

// The same numbers as in noise.frag.
std::uint32_t scramble(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

using Color = std::array<double, 4>;

Color noise(std::uint32_t pixel, std::uint32_t seed, std::uint32_t bits) {
  const std::uint32_t most = (1u << bits) - 1;
  Color color;
  for (std::uint32_t i = 0; i < 4; ++i)
    color[i] = static_cast<double>(scramble((pixel * 4 + i) * 2 + seed) & most) / most;
  return color;
}

Draw noiseDraw(std::uint32_t seed, std::uint32_t bits) {
  const auto s = static_cast<float>(seed), b = static_cast<float>(bits);
  return {noise_frag, rectangle(-1, -1, 1, 1, s, b, s, b)};
}

double factor(VkBlendFactor which, const Color& source, const Color& stored, std::size_t i) {
  switch (which) {
    case VK_BLEND_FACTOR_ZERO:
      return 0;
    case VK_BLEND_FACTOR_SRC_COLOR:
      return source[i];
    case VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR:
      return 1 - source[i];
    case VK_BLEND_FACTOR_DST_COLOR:
      return stored[i];
    case VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR:
      return 1 - stored[i];
    case VK_BLEND_FACTOR_SRC_ALPHA:
      return source[3];
    case VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA:
      return 1 - source[3];
    case VK_BLEND_FACTOR_DST_ALPHA:
      return stored[3];
    case VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA:
      return 1 - stored[3];
    case VK_BLEND_FACTOR_SRC_ALPHA_SATURATE:
      return i == 3 ? 1 : std::min(source[3], 1 - stored[3]);
    default:
      return 1;
  }
}

struct Blend {
  VkBlendFactor source, stored;
  VkBlendOp equation = VK_BLEND_OP_ADD;
};

double blended(const Blend& blend, const Color& source, const Color& stored, std::size_t i) {
  const double s = source[i] * factor(blend.source, source, stored, i);
  const double d = stored[i] * factor(blend.stored, source, stored, i);
  const double sum = blend.equation == VK_BLEND_OP_ADD        ? s + d
                     : blend.equation == VK_BLEND_OP_SUBTRACT ? s - d
                                                              : d - s;
  return std::clamp(sum, 0.0, 1.0);
}

// Every factor on either side with three on the other, and the other equations.
std::vector<Blend> blends() {
  constexpr VkBlendFactor kFactors[] = {VK_BLEND_FACTOR_ZERO,      VK_BLEND_FACTOR_ONE,
                                        VK_BLEND_FACTOR_SRC_COLOR, VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
                                        VK_BLEND_FACTOR_DST_COLOR, VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
                                        VK_BLEND_FACTOR_SRC_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                                        VK_BLEND_FACTOR_DST_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA};
  std::vector<Blend> result;
  constexpr std::size_t kCount = std::size(kFactors);
  for (std::size_t i = 0; i < kCount; ++i)
    for (std::size_t j : {i, i ^ 1, i + 3}) result.push_back({kFactors[i], kFactors[j % kCount]});
  result.push_back({VK_BLEND_FACTOR_SRC_ALPHA_SATURATE, VK_BLEND_FACTOR_ONE});
  for (VkBlendOp equation : {VK_BLEND_OP_SUBTRACT, VK_BLEND_OP_REVERSE_SUBTRACT}) {
    result.push_back({VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_DST_ALPHA, equation});
    result.push_back({VK_BLEND_FACTOR_SRC_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA, equation});
  }
  return result;
}

}  // namespace

double blending(Device& device) {
  double worst = 0;
  for (const Blend& blend : blends()) {
    Draw draw = noiseDraw(1, kSourceBits);
    draw.blend = {1, blend.source, blend.stored, blend.equation, blend.source, blend.stored, blend.equation,
                  0};
    const std::vector<float> pixels =
        device.render(VK_FORMAT_R8G8B8A8_UNORM, kSize, kSize, {noiseDraw(0, kStoredBits), draw});
    for (std::uint32_t pixel = 0; pixel < kSize * kSize; ++pixel) {
      const Color source = noise(pixel, 1, kSourceBits), stored = noise(pixel, 0, kStoredBits);
      for (std::size_t i = 0; i < 4; ++i)
        worst = std::max(worst, std::abs(double(pixels[4 * pixel + i]) - blended(blend, source, stored, i)));
    }
  }
  return worst;
}

}  // namespace driver
