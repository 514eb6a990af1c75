// Blocks of the S3TC formats (appendix of EXT_texture_compression_s3tc), and of 3DC, whose components are
// stored like the alpha of DXT5. Interpolated values are rounded to nearest once.
#include "layer/gl/textures/compressed.h"

namespace anteroom::gl {
namespace {

unsigned word(const uint8_t* bytes) {
  return bytes[0] | bytes[1] * 256u;
}

// round(255 * sum / most)
uint8_t toByte(unsigned sum, unsigned most) {
  return static_cast<uint8_t>((sum * 510 + most) / (most * 2));
}

// A color field of 5 or 6 bits as the four codes have it.
struct Field {
  unsigned shift, most;
};
constexpr Field kFields[3] = {{11, 31}, {5, 63}, {0, 31}};

// The colors of a block of RGB data; `fourColors`: as if color0 > color1.
void decodeColors(const uint8_t* block, bool fourColors, TexelBlock& texels) {
  const unsigned color0 = word(block), color1 = word(block + 2);
  fourColors = fourColors || color0 > color1;
  std::array<std::array<uint8_t, 4>, 4> palette{};
  for (size_t i = 0; i < 3; ++i) {
    const Field field = kFields[i];
    const unsigned a = color0 >> field.shift & field.most, b = color1 >> field.shift & field.most;
    palette[0][i] = toByte(a, field.most);
    palette[1][i] = toByte(b, field.most);
    palette[2][i] = fourColors ? toByte(2 * a + b, 3 * field.most) : toByte(a + b, 2 * field.most);
    palette[3][i] = fourColors ? toByte(a + 2 * b, 3 * field.most) : uint8_t{0};
  }
  for (size_t code = 0; code < 4; ++code) palette[code][3] = fourColors || code != 3 ? 255 : 0;
  const unsigned bits = word(block + 4) | word(block + 6) << 16;
  for (size_t i = 0; i < 16; ++i) texels[i] = palette[bits >> 2 * i & 3];
}

// Sixteen values between two bytes.
std::array<uint8_t, 16> decodeValues(const uint8_t* block) {
  const unsigned first = block[0], last = block[1];
  std::array<uint8_t, 8> palette{block[0], block[1], 0, 0, 0, 0, 0, 255};
  const unsigned steps = first > last ? 7 : 5;
  for (unsigned code = 2; code <= steps; ++code) {
    const unsigned sum = (steps + 1 - code) * first + (code - 1) * last;
    palette[code] = static_cast<uint8_t>((2 * sum + steps) / (2 * steps));
  }
  uint64_t bits = 0;
  for (int i = 7; i >= 2; --i) bits = bits << 8 | block[i];
  std::array<uint8_t, 16> values{};
  for (size_t i = 0; i < 16; ++i) values[i] = palette[bits >> 3 * i & 7];
  return values;
}

}  // namespace

TexelBlock decodeDxt1(const uint8_t* block) {
  TexelBlock texels;
  decodeColors(block, false, texels);
  return texels;
}

TexelBlock decodeDxt3(const uint8_t* block) {
  TexelBlock texels;
  decodeColors(block + 8, true, texels);
  for (size_t i = 0; i < 16; ++i) texels[i][3] = static_cast<uint8_t>((block[i / 2] >> i % 2 * 4 & 15) * 17);
  return texels;
}

TexelBlock decodeDxt5(const uint8_t* block) {
  TexelBlock texels;
  decodeColors(block + 8, true, texels);
  const auto alphas = decodeValues(block);
  for (size_t i = 0; i < 16; ++i) texels[i][3] = alphas[i];
  return texels;
}

TexelBlock decode3dcX(const uint8_t* block) {
  TexelBlock texels;
  const auto reds = decodeValues(block);
  for (size_t i = 0; i < 16; ++i) texels[i] = {reds[i], 0, 0, 255};
  return texels;
}

TexelBlock decode3dcXy(const uint8_t* block) {
  TexelBlock texels = decode3dcX(block);
  const auto greens = decodeValues(block + 8);
  for (size_t i = 0; i < 16; ++i) texels[i][1] = greens[i];
  return texels;
}

}  // namespace anteroom::gl
