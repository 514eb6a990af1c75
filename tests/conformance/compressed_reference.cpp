#include "compressed_reference.h"

#include <algorithm>
#include <cmath>

namespace conformance {
namespace {

// Bits [high..low] of a 64-bit word.
unsigned bits(std::uint64_t word, int high, int low) {
  return static_cast<unsigned>(word >> low & ((std::uint64_t{1} << (high - low + 1)) - 1));
}

std::uint64_t bigEndian(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (int i = 0; i < 8; ++i) word = word * 256 + bytes[i];
  return word;
}
std::uint64_t littleEndian(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  for (int i = 7; i >= 0; --i) word = word * 256 + bytes[i];
  return word;
}

// --- OES_compressed_ETC1_RGB8_texture

// Bit positions of the components' codewords (tables 3.17.1a and b).
constexpr int kIndividual[3] = {60, 52, 44}, kDifferential[3] = {59, 51, 43};

int signed3(unsigned value) {
  return value < 4 ? static_cast<int>(value) : static_cast<int>(value) - 8;
}

// The five bits of the second half's base color, which may be out of range.
int secondBase(std::uint64_t word, int component) {
  const int low = kDifferential[component];
  return static_cast<int>(bits(word, low + 4, low)) + signed3(bits(word, low - 1, low - 3));
}

double etc1Base(std::uint64_t word, int component, bool second) {
  if (bits(word, 33, 33) == 0) {
    const int low = kIndividual[component] - (second ? 4 : 0);
    return bits(word, low + 3, low) * 17;
  }
  const int low = kDifferential[component];
  const int five = second ? secondBase(word, component) : static_cast<int>(bits(word, low + 4, low));
  return five * 8 + five / 4;
}

// --- EXT_texture_compression_s3tc

Vec3 from565(unsigned packed) {
  return {(packed >> 11) / 31.0, (packed >> 5 & 63) / 63.0, (packed & 31) / 31.0};
}

Vec3 mix(const Vec3& a, const Vec3& b, double ofB) {
  Vec3 result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] * (1 - ofB) + b[i] * ofB;
  return result;
}

double interpolatedAlpha(const std::uint8_t* block, int x, int y) {
  const double first = block[0] / 255.0, last = block[1] / 255.0;
  const int start = 3 * (4 * y + x);
  const unsigned code = bits(littleEndian(block) >> 16, start + 2, start);
  if (code == 0) return first;
  if (code == 1) return last;
  if (block[0] > block[1]) return ((8 - code) * first + (code - 1) * last) / 7;
  if (code == 6) return 0;
  return code == 7 ? 1 : ((6 - code) * first + (code - 1) * last) / 5;
}

// --- PVRTC of the Khronos Data Format Specification, with the 2 bpp weights of Imagination's decoder

class Pvrtc {
 public:
  Pvrtc(int bitsATexel, const std::uint8_t* data, int width, int height)
      : data_(data),
        wide_(bitsATexel == 2 ? 8 : 4),
        across_(std::max(width, 2 * wide_) / wide_),
        down_(std::max(height, 8) / 4) {}

  Vec4 texel(int x, int y) const {
    const int left = floorDivide(x - wide_ / 2, wide_), low = floorDivide(y - 2, 4);
    const int dx = x - wide_ / 2 - left * wide_, dy = y - 2 - low * 4;
    bool punched = false;
    const int weight = weightOf(x, y, punched);
    Vec4 color{};
    for (int c = 0; c < 4; ++c) {
      int image[2];
      for (int which = 0; which < 2; ++which) {
        const int sum = sample(which, c, left, low) * (wide_ - dx) * (4 - dy) +
                        sample(which, c, left + 1, low) * dx * (4 - dy) +
                        sample(which, c, left, low + 1) * (wide_ - dx) * dy +
                        sample(which, c, left + 1, low + 1) * dx * dy;
        const int unit = wide_ * 4;  // fraction of the fixed-point sum
        image[which] = c < 3 ? sum * 8 / unit + sum / (unit * 4) : sum * 16 / unit + sum / unit;
      }
      color[static_cast<std::size_t>(c)] = (image[0] * (8 - weight) + image[1] * weight) / 8 / 255.0;
    }
    if (punched) color[3] = 0;
    return color;
  }

 private:
  static int floorDivide(int a, int b) { return (a - ((a % b) + b) % b) / b; }

  std::uint64_t word(int column, int row) const {
    column = (column + across_) % across_;
    row = (row + down_) % down_;
    int offset = 0, shift = 0;
    for (int mask = 1; mask < across_ || mask < down_; mask *= 2) {
      if (mask < down_) offset |= ((row & mask) != 0 ? 1 : 0) << shift++;
      if (mask < across_) offset |= ((column & mask) != 0 ? 1 : 0) << shift++;
    }
    return littleEndian(data_ + 8 * offset);
  }

  // Component c of color A or B: 5 bits, alpha 4.
  int sample(int which, int c, int column, int row) const {
    const std::uint64_t w = word(column, row);
    const unsigned color = which == 0 ? bits(w, 47, 32) : bits(w, 63, 48);
    const bool opaque = color >> 15 != 0;
    if (c == 3) return opaque ? 15 : static_cast<int>(bits(color, 14, 12) * 2);
    unsigned value = 0;
    int size = 0;
    if (opaque) {
      size = c == 2 && which == 0 ? 4 : 5;
      value = c == 0 ? bits(color, 14, 10) : c == 1 ? bits(color, 9, 5) : bits(color, 4, 5 - size);
    } else {
      size = c == 2 && which == 0 ? 3 : 4;
      value = c == 0 ? bits(color, 11, 8) : c == 1 ? bits(color, 7, 4) : bits(color, 3, 4 - size);
    }
    return static_cast<int>((value << (10 - size) | value << (10 - 2 * size)) >> 5);  // its bits repeated
  }

  int weightOf(int x, int y, bool& punched) const {
    if (wide_ == 4) {
      const std::uint64_t w = word(x / 4, y / 4);
      const int start = 2 * (4 * (y % 4) + x % 4);
      const unsigned code = bits(w, start + 1, start);
      if (bits(w, 32, 32) == 0) return std::array{0, 3, 5, 8}[code];
      punched = code == 2;
      return std::array{0, 4, 4, 8}[code];
    }
    const std::uint64_t w = word(x / 8, y / 4);
    if (bits(w, 32, 32) == 0 || (x + y) % 2 == 0) return stored(x, y);
    if (bits(w, 0, 0) == 0)
      return (stored(x - 1, y) + stored(x + 1, y) + stored(x, y - 1) + stored(x, y + 1) + 2) / 4;
    if (bits(w, 20, 20) == 1) return (stored(x, y - 1) + stored(x, y + 1) + 1) / 2;
    return (stored(x - 1, y) + stored(x + 1, y) + 1) / 2;
  }

  int stored(int x, int y) const {
    const std::uint64_t w = word(floorDivide(x, 8), floorDivide(y, 4));
    const int column = ((x % 8) + 8) % 8, row = ((y % 4) + 4) % 4;
    if (bits(w, 32, 32) == 0) return bits(w, 8 * row + column, 8 * row + column) == 1 ? 8 : 0;
    if (column == 0 && row == 0) return bits(w, 1, 1) == 1 ? 8 : 0;
    if (column == 4 && row == 2 && bits(w, 0, 0) == 1) return bits(w, 21, 21) == 1 ? 8 : 0;
    const int start = 8 * row + 2 * (column / 2);
    return std::array{0, 3, 5, 8}[bits(w, start + 1, start)];
  }

  const std::uint8_t* data_;
  int wide_, across_, down_;
};

}  // namespace

bool etc1Overflows(const std::uint8_t* block) {
  const std::uint64_t word = bigEndian(block);
  if (bits(word, 33, 33) == 0) return false;
  for (int c = 0; c < 3; ++c) {
    if (secondBase(word, c) < 0 || secondBase(word, c) > 31) return true;
  }
  return false;
}

Vec4 etc1Texel(const std::uint8_t* block, int x, int y) {
  constexpr int kTables[8][4] = {{-8, -2, 2, 8},       {-17, -5, 5, 17},    {-29, -9, 9, 29},
                                 {-42, -13, 13, 42},   {-60, -18, 18, 60},  {-80, -24, 24, 80},
                                 {-106, -33, 33, 106}, {-183, -47, 47, 183}};
  constexpr int kColumns[4] = {2, 3, 1, 0};  // table 3.17.3, by pixel index
  const std::uint64_t word = bigEndian(block);
  const bool second = bits(word, 32, 32) == 1 ? y >= 2 : x >= 2;
  const int pixel = 4 * x + y;
  const unsigned index = bits(word, 16 + pixel, 16 + pixel) * 2 + bits(word, pixel, pixel);
  const int modifier = kTables[second ? bits(word, 36, 34) : bits(word, 39, 37)][kColumns[index]];
  Vec4 color{0, 0, 0, 1};
  for (int c = 0; c < 3; ++c) {
    color[static_cast<std::size_t>(c)] = std::clamp((etc1Base(word, c, second) + modifier) / 255.0, 0.0, 1.0);
  }
  return color;
}

Vec4 dxtTexel(Dxt kind, const std::uint8_t* block, int x, int y) {
  const bool alphaFirst = kind == Dxt::Rgba3 || kind == Dxt::Rgba5;
  const std::uint64_t word = littleEndian(alphaFirst ? block + 8 : block);
  const unsigned first = bits(word, 15, 0), last = bits(word, 31, 16);
  const int start = 32 + 2 * (4 * y + x);
  const unsigned code = bits(word, start + 1, start);
  const Vec3 a = from565(first), b = from565(last);
  Vec3 rgb = code == 0 ? a : b;
  double alpha = 1;
  if (alphaFirst || first > last) {
    if (code >= 2) rgb = mix(a, b, code == 2 ? 1.0 / 3 : 2.0 / 3);
  } else if (code >= 2) {
    rgb = code == 2 ? mix(a, b, 0.5) : Vec3{};
    if (code == 3 && kind == Dxt::Rgba1) alpha = 0;
  }
  if (kind == Dxt::Rgba3) alpha = bits(littleEndian(block), 4 * (4 * y + x) + 3, 4 * (4 * y + x)) / 15.0;
  if (kind == Dxt::Rgba5) alpha = interpolatedAlpha(block, x, y);
  return {rgb[0], rgb[1], rgb[2], alpha};
}

double threeDcValue(const std::uint8_t* block, int x, int y) {
  return interpolatedAlpha(block, x, y);
}

Vec4 pvrtcTexel(int bitsATexel, const std::uint8_t* data, int width, int height, int x, int y) {
  return Pvrtc(bitsATexel, data, width, height).texel(x, y);
}

}  // namespace conformance
