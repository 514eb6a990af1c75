#include "layer/gl/textures/paletted.h"

#include <cstring>

namespace anteroom::gl {

using render::Format;

PalettedFormat palettedFormat(GLenum internalFormat) {
  switch (internalFormat) {
    case GL_PALETTE4_RGB8_OES:
      return {4, Format::RGB8};
    case GL_PALETTE4_RGBA8_OES:
      return {4, Format::RGBA8};
    case GL_PALETTE4_R5_G6_B5_OES:
      return {4, Format::RGB565};
    case GL_PALETTE4_RGBA4_OES:
      return {4, Format::RGBA4444};
    case GL_PALETTE4_RGB5_A1_OES:
      return {4, Format::RGBA5551};
    case GL_PALETTE8_RGB8_OES:
      return {8, Format::RGB8};
    case GL_PALETTE8_RGBA8_OES:
      return {8, Format::RGBA8};
    case GL_PALETTE8_R5_G6_B5_OES:
      return {8, Format::RGB565};
    case GL_PALETTE8_RGBA4_OES:
      return {8, Format::RGBA4444};
    case GL_PALETTE8_RGB5_A1_OES:
      return {8, Format::RGBA5551};
    default:
      return {};
  }
}

int64_t palettedSize(const PalettedFormat& format, int width, int height, int levels) {
  int64_t bytes = static_cast<int64_t>(format.paletteBytes());
  for (int level = 0; level < levels; ++level) {
    bytes += format.levelBytes(width, height);
    width = width > 1 ? width / 2 : width;
    height = height > 1 ? height / 2 : height;
  }
  return bytes;
}

namespace {

// The texel size as a constant: the copies become single moves.
template <size_t Bytes>
void decode(int indexBits, const uint8_t* palette, const uint8_t* indices, size_t count, uint8_t* out) {
  for (size_t i = 0; i < count; ++i, out += Bytes) {
    const uint8_t byte = indexBits == 4 ? indices[i / 2] : indices[i];
    const size_t index = indexBits == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15;
    std::memcpy(out, palette + index * Bytes, Bytes);
  }
}

}  // namespace

void decodePaletted(const PalettedFormat& format, const void* palette, const void* indices, size_t count,
                    void* out) {
  const uint8_t* p = static_cast<const uint8_t*>(palette);
  const uint8_t* i = static_cast<const uint8_t*>(indices);
  uint8_t* o = static_cast<uint8_t*>(out);
  switch (render::info(format.entry).bytes) {
    case 2:
      return decode<2>(format.indexBits, p, i, count, o);
    case 3:
      return decode<3>(format.indexBits, p, i, count, o);
    default:
      return decode<4>(format.indexBits, p, i, count, o);
  }
}

}  // namespace anteroom::gl
