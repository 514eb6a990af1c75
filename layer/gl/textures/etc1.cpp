// Blocks of OES_compressed_ETC1_RGB8_texture (tables 3.17.1 to 3.17.3).
#include <algorithm>

#include "layer/gl/textures/compressed.h"

namespace anteroom::gl {
namespace {

// By codeword: the small and the large modifier.
constexpr int kModifiers[8][2] = {{2, 8},   {5, 17},  {9, 29},   {13, 42},
                                  {18, 60}, {24, 80}, {33, 106}, {47, 183}};

int extend4(int value) {
  return value << 4 | value;
}
int extend5(int value) {
  return value << 3 | value >> 2;
}

// A component of the base colors of both halves, from its byte. Sums that leave the five bits, which the text
// leaves undefined, saturate.
std::array<int, 2> baseColors(uint8_t byte, bool differential) {
  if (!differential) return {extend4(byte >> 4), extend4(byte & 15)};
  const int first = byte >> 3, difference = (byte & 7) - ((byte & 4) != 0 ? 8 : 0);
  return {extend5(first), extend5(std::clamp(first + difference, 0, 31))};
}

}  // namespace

TexelBlock decodeEtc1(const uint8_t* block) {
  const bool flipped = (block[3] & 1) != 0, differential = (block[3] & 2) != 0;
  const int codewords[2] = {block[3] >> 5, block[3] >> 2 & 7};
  const std::array<int, 2> base[3] = {baseColors(block[0], differential), baseColors(block[1], differential),
                                      baseColors(block[2], differential)};
  const int most = block[4] << 8 | block[5], least = block[6] << 8 | block[7];
  TexelBlock texels;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      const int bit = x * 4 + y;
      const size_t half = (flipped ? y : x) >= 2 ? 1 : 0;
      const int magnitude = kModifiers[codewords[half]][least >> bit & 1];
      const int modifier = (most >> bit & 1) != 0 ? -magnitude : magnitude;
      auto& texel = texels[static_cast<size_t>(y * 4 + x)];
      for (size_t i = 0; i < 3; ++i) {
        texel[i] = static_cast<uint8_t>(std::clamp(base[i][half] + modifier, 0, 255));
      }
      texel[3] = 255;
    }
  }
  return texels;
}

}  // namespace anteroom::gl
