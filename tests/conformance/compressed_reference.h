// Texels of compressed images by the formulas of the texts, in double, a texel at a time.
#pragma once

#include "harness.h"

namespace conformance {

// Texel (x, y) of a 4x4 block.
Vec4 etc1Texel(const std::uint8_t* block, int x, int y);
// Whether the block's colors leave five bits, which leaves its texels undefined.
bool etc1Overflows(const std::uint8_t* block);
enum class Dxt { Rgb1, Rgba1, Rgba3, Rgba5 };
Vec4 dxtTexel(Dxt kind, const std::uint8_t* block, int x, int y);
// 3DC: one component.
double threeDcValue(const std::uint8_t* block, int x, int y);

// Texel (x, y) of a PVRTC image of `bits` (2 or 4) a texel. Width and height are powers of two.
Vec4 pvrtcTexel(int bits, const std::uint8_t* data, int width, int height, int x, int y);

}  // namespace conformance
