// PVRTC, as the Khronos Data Format Specification describes it ("PVRTC Compressed Texture Image Formats",
// PVRTC1). One difference: there, the two bits a texel of the 2 bpp modes weigh 0, 4, 4 and 8 with punch
// through; Imagination's own published decoder, for which files are made, has 0, 3, 5 and 8 without.
//
// A block of 8 bytes has a texel of each of two images of low resolution, A and B, and the weights by which
// they are mixed.
#include <algorithm>
#include <bit>
#include <cstring>

#include "layer/gl/textures/compressed.h"

namespace anteroom::gl {
namespace {

using Color = std::array<int, 4>;  // red, green, blue of 5 bits, alpha of 4

int widen3(unsigned value) {
  return static_cast<int>(value << 2 | value >> 1);
}
int widen4(unsigned value) {
  return static_cast<int>(value << 1 | value >> 3);
}

// A color of 16 bits. The place of color A's last bit of blue is taken by a flag.
Color unpack(unsigned bits, bool lacksLast) {
  if ((bits & 0x8000) != 0) {
    const unsigned blue = bits & 31;
    return {static_cast<int>(bits >> 10 & 31), static_cast<int>(bits >> 5 & 31),
            lacksLast ? widen4(blue >> 1) : static_cast<int>(blue), 15};
  }
  return {widen4(bits >> 8 & 15), widen4(bits >> 4 & 15),
          lacksLast ? widen3(bits >> 1 & 7) : widen4(bits & 15), static_cast<int>((bits >> 12 & 7) << 1)};
}

class Pvrtc {
 public:
  Pvrtc(const uint8_t* data, int blockWidth, int width, int height)
      : data_(data), blockWidth_(blockWidth), across_(width / blockWidth), down_(height / 4) {}

  // The texels between the centers of four blocks, of which (column, row) is the one with the lowest
  // coordinates: put(x, y, color).
  template <class Put>
  void decodeCell(int column, int row, Put put) const {
    const std::array<const uint8_t*, 4> blocks{block(column, row), block(column + 1, row),
                                               block(column, row + 1), block(column + 1, row + 1)};
    Corners a, b;
    for (size_t i = 0; i < 4; ++i) {
      a[i] = unpack(word(blocks[i] + 4), true);
      b[i] = unpack(word(blocks[i] + 6), false);
    }
    const int half = blockWidth_ / 2;
    for (int up = 0; up < 4; ++up) {
      for (int right = 0; right < blockWidth_; ++right) {
        const int x = column * blockWidth_ + half + right, y = row * 4 + 2 + up;
        const uint8_t* own = blocks[(up >= 2 ? 2u : 0u) + (right >= half ? 1u : 0u)];
        put(x, y, mix(interpolate(a, right, up), interpolate(b, right, up), weightAt(own, x, y)));
      }
    }
  }

 private:
  using Corners = std::array<Color, 4>;
  struct Weight {
    int eighths = 0;  // of image B
    bool punchThrough = false;
  };

  static std::array<uint8_t, 4> mix(const Color& a, const Color& b, const Weight& weight) {
    std::array<uint8_t, 4> result;
    for (size_t i = 0; i < 4; ++i) {
      result[i] = static_cast<uint8_t>((a[i] * (8 - weight.eighths) + b[i] * weight.eighths) / 8);
    }
    if (weight.punchThrough) result[3] = 0;
    return result;
  }

  // Blocks lie in Morton order, y in the lower bit of each pair; what is left of the longer side follows. The
  // image repeats.
  const uint8_t* block(int column, int row) const {
    const auto x = static_cast<unsigned>(column) & (across_ - 1),
               y = static_cast<unsigned>(row) & (down_ - 1);
    const int pairs = std::countr_zero(std::min(across_, down_));
    unsigned index = (x | y) >> pairs << 2 * pairs;
    for (int bit = 0; bit < pairs; ++bit) {
      index |= (y >> bit & 1) << 2 * bit | (x >> bit & 1) << (2 * bit + 1);
    }
    return data_ + size_t{8} * index;
  }

  static unsigned word(const uint8_t* bytes) { return bytes[0] | bytes[1] * 256u; }

  // One of the images, 8 bits.
  Color interpolate(const Corners& corners, int right, int up) const {
    const int weights[4] = {(blockWidth_ - right) * (4 - up), right * (4 - up), (blockWidth_ - right) * up,
                            right * up};
    Color sum{};
    for (size_t i = 0; i < 4; ++i) {
      for (size_t c = 0; c < 4; ++c) sum[c] += corners[i][c] * weights[i];
    }
    const int doubled = blockWidth_ == 8 ? 1 : 0;
    for (size_t c = 0; c < 3; ++c) sum[c] = (sum[c] >> (1 + doubled)) + (sum[c] >> (6 + doubled));
    sum[3] = (sum[3] >> doubled) + (sum[3] >> (4 + doubled));
    return sum;
  }

  // `from`: the texel's block.
  Weight weightAt(const uint8_t* from, int x, int y) const {
    if (blockWidth_ == 8) return {interpolatedWeight(from, x, y)};
    constexpr int kPlain[4] = {0, 3, 5, 8}, kPunched[4] = {0, 4, 4, 8};
    const unsigned code = from[y & 3] >> 2 * (x & 3) & 3;
    const bool punches = (from[4] & 1) != 0;
    return {punches ? kPunched[code] : kPlain[code], punches && code == 2};
  }

  // 2 bits a texel: one bit for each, or two for every second texel of a checkerboard.
  int interpolatedWeight(const uint8_t* from, int x, int y) const {
    if ((from[4] & 1) == 0 || (x + y) % 2 == 0) return storedWeight(from, x, y);
    const bool oneAxis = (from[0] & 1) != 0, vertical = (from[2] & 0x10) != 0;
    const int across = !oneAxis || !vertical ? storedWeight(x - 1, y) + storedWeight(x + 1, y) : 0;
    const int up = !oneAxis || vertical ? storedWeight(x, y - 1) + storedWeight(x, y + 1) : 0;
    return oneAxis ? (across + up + 1) / 2 : (across + up + 2) / 4;
  }

  // Of a texel that its block has bits for.
  int storedWeight(int x, int y) const { return storedWeight(block(x >> 3, y >> 2), x, y); }
  static int storedWeight(const uint8_t* from, int x, int y) {
    const int column = x & 7, row = y & 3;
    if ((from[4] & 1) == 0) return (from[row] >> column & 1) * 8;
    // The lower bits of texel (0, 0) and, where it is set, of texel (4, 2) are flags.
    const unsigned code = from[row] >> column / 2 * 2 & 3;
    const bool center = column == 4 && row == 2 && (from[0] & 1) != 0;
    if ((column == 0 && row == 0) || center) return code >= 2 ? 8 : 0;
    constexpr int kWeights[4] = {0, 3, 5, 8};
    return kWeights[code];
  }

  const uint8_t* data_;
  int blockWidth_;
  unsigned across_, down_;  // blocks, powers of two
};

}  // namespace

int pvrtcWidth(const CompressedFormat& format, int width) {
  return std::max(width, 2 * format.blockWidth);
}
int pvrtcHeight(int height) {
  return std::max(height, 8);
}

void decodePvrtc(const CompressedFormat& format, const uint8_t* data, int width, int height, uint8_t* out) {
  const Pvrtc image(data, format.blockWidth, pvrtcWidth(format, width), pvrtcHeight(height));
  const size_t bytes = render::info(format.decoded).bytes;
  const auto put = [&](int x, int y, const std::array<uint8_t, 4>& texel) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    std::memcpy(out + at * bytes, texel.data(), bytes);
  };
  for (int row = -1; row * 4 + 2 < height; ++row) {
    for (int column = -1; column * format.blockWidth + format.blockWidth / 2 < width; ++column) {
      image.decodeCell(column, row, put);
    }
  }
}

}  // namespace anteroom::gl
