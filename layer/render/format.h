// Texel formats as GL programs hand them in: the layout in client memory, which is also what a renderer is
// asked to store without loss. A renderer keeps them in whatever its device supports.
#pragma once

#include <cstdint>

namespace anteroom::render {

enum class Format : uint8_t {
  None,
  A8,        // GL_ALPHA
  L8,        // GL_LUMINANCE
  LA8,       // GL_LUMINANCE_ALPHA
  RGB8,      // three bytes
  RGBA8,     // four bytes
  RGB565,    // one native-endian uint16, red in the high bits (GL_UNSIGNED_SHORT_5_6_5)
  RGBA4444,  // red in the high nibble (GL_UNSIGNED_SHORT_4_4_4_4)
  RGBA5551,  // red in the high bits, alpha in bit 0 (GL_UNSIGNED_SHORT_5_5_5_1)
  SRGB8,     // like RGB8 and RGBA8, colors encoded: sampling and blending see them linear (EXT_sRGB)
  SRGB8Alpha8,
  BGRA8,  // only in client memory: no image has it
  Depth16,
  Depth24,
  Depth32,
  Depth24Stencil8,
  Stencil8,
};
inline constexpr int kFormatCount = static_cast<int>(Format::Stencil8) + 1;

struct FormatInfo {
  uint8_t bytes;  // a texel in client memory; 0 for depth and stencil
  uint8_t red, green, blue, alpha, luminance, depth, stencil;  // bits
};

// Indexed by Format.
inline constexpr FormatInfo kFormatInfo[kFormatCount] = {
    {0, 0, 0, 0, 0, 0, 0, 0},  {1, 0, 0, 0, 8, 0, 0, 0},  {1, 0, 0, 0, 0, 8, 0, 0},
    {2, 0, 0, 0, 8, 8, 0, 0},  {3, 8, 8, 8, 0, 0, 0, 0},  {4, 8, 8, 8, 8, 0, 0, 0},
    {2, 5, 6, 5, 0, 0, 0, 0},  {2, 4, 4, 4, 4, 0, 0, 0},  {2, 5, 5, 5, 1, 0, 0, 0},
    {3, 8, 8, 8, 0, 0, 0, 0},  {4, 8, 8, 8, 8, 0, 0, 0},  {4, 8, 8, 8, 8, 0, 0, 0},
    {0, 0, 0, 0, 0, 0, 16, 0}, {0, 0, 0, 0, 0, 0, 24, 0}, {0, 0, 0, 0, 0, 0, 32, 0},
    {0, 0, 0, 0, 0, 0, 24, 8}, {0, 0, 0, 0, 0, 0, 0, 8},
};
constexpr const FormatInfo& info(Format format) {
  return kFormatInfo[static_cast<int>(format)];
}

// As GL calls them.
inline constexpr const char* kFormatNames[kFormatCount] = {
    "none",    "ALPHA8",           "LUMINANCE8", "LUMINANCE8_ALPHA8", "RGB8",  "RGBA8",   "RGB565",
    "RGBA4",   "RGB5_A1",          "SRGB8",      "SRGB8_ALPHA8",      "BGRA8", "DEPTH16", "DEPTH24",
    "DEPTH32", "DEPTH24_STENCIL8", "STENCIL8"};
constexpr const char* nameOf(Format format) {
  return kFormatNames[static_cast<int>(format)];
}

constexpr bool isDepthOrStencil(Format format) {
  return info(format).depth != 0 || info(format).stencil != 0;
}

constexpr bool isSrgb(Format format) {
  return format == Format::SRGB8 || format == Format::SRGB8Alpha8;
}

}  // namespace anteroom::render
