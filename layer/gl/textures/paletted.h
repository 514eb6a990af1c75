// Compressed paletted textures (section 3.7.4, OES_compressed_paletted_texture): a palette, then the indices
// of each level, lowest row first. Texels of a level follow one another without gaps; a level begins at a
// byte.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "layer/render/format.h"

namespace anteroom::gl {

// All of them: COMPRESSED_TEXTURE_FORMATS.
inline constexpr std::array<GLenum, 10> kPalettedFormats{
    GL_PALETTE4_RGB8_OES,    GL_PALETTE4_RGBA8_OES,   GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES,
    GL_PALETTE4_RGB5_A1_OES, GL_PALETTE8_RGB8_OES,    GL_PALETTE8_RGBA8_OES,    GL_PALETTE8_R5_G6_B5_OES,
    GL_PALETTE8_RGBA4_OES,   GL_PALETTE8_RGB5_A1_OES,
};

struct PalettedFormat {
  int indexBits = 0;  // 4 or 8; 0: not a paletted format
  render::Format entry = render::Format::None;

  size_t paletteBytes() const { return (size_t{1} << indexBits) * render::info(entry).bytes; }
  int64_t levelBytes(int width, int height) const { return (int64_t{width} * height * indexBits + 7) / 8; }
};

PalettedFormat palettedFormat(GLenum internalFormat);
inline bool isPaletted(GLenum internalFormat) {
  return palettedFormat(internalFormat).indexBits != 0;
}

// What imageSize must be for `levels` levels of which the first is width x height, bytes.
int64_t palettedSize(const PalettedFormat& format, int width, int height, int levels);

// Looks `count` texels up; `out` gets them one after the other in format.entry.
void decodePaletted(const PalettedFormat& format, const void* palette, const void* indices, size_t count,
                    void* out);

}  // namespace anteroom::gl
