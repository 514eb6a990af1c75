// Specific compressed formats of extensions, of 4x4 or 8x4 texels a block. Images are decoded when they are
// given, so that a texture looks the same on every device:
//   ETC1   OES_compressed_ETC1_RGB8_texture
//   S3TC   EXT_texture_compression_dxt1, ANGLE_texture_compression_dxt3 and _dxt5
//          (the data format is in EXT_texture_compression_s3tc)
//   3DC    AMD_compressed_3DC_texture: red, or red and green, each stored like the alpha of DXT5
//   PVRTC  IMG_texture_compression_pvrtc: see pvrtc.cpp
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "layer/render/format.h"

namespace anteroom::gl {

// Red, green, blue, alpha of the texels of a 4x4 block, row by row.
using TexelBlock = std::array<std::array<uint8_t, 4>, 16>;
using BlockDecoder = TexelBlock (*)(const uint8_t* block);

// What CompressedTexSubImage2D may replace.
enum class SubImages : uint8_t {
  Blocks,        // whole blocks; the last one may hang over the image's edge
  BlocksOrSide,  // whole blocks, or a width or height that is the image's
  Whole,         // the whole image
};

// Errors that the texts state; the defaults are those of sections 3.7.1 and 3.7.2.
struct CompressionErrors {
  GLenum border = GL_INVALID_VALUE;    // that is not 0
  GLenum texImage = GL_INVALID_VALUE;  // the format given to TexImage2D
  GLenum copyTexImage = GL_INVALID_ENUM;
};

struct CompressedFormat {
  GLenum name;
  GLenum base;
  render::Format decoded;
  uint8_t blockBytes;
  BlockDecoder decodeBlock;  // null: PVRTC, whose blocks depend on their neighbours
  SubImages subImages;
  CompressionErrors errors;
  uint8_t blockWidth = 4;    // texels; the height is 4
  bool wholeBlocks = false;  // a width or height that is no multiple of 4 must be 1 or 2
};

// All of them, as COMPRESSED_TEXTURE_FORMATS lists them after the paletted ones.
std::span<const CompressedFormat> compressedFormats();

// Null: not one of them.
const CompressedFormat* compressedFormat(GLenum internalFormat);

// What imageSize must be, bytes.
int64_t compressedSize(const CompressedFormat& format, int width, int height);

// Whether an image can have such a size, apart from the limits of the device.
bool compressible(const CompressedFormat& format, int width, int height);

// Decodes compressedSize() bytes; `out` gets rows of format.decoded without gaps.
void decodeCompressed(const CompressedFormat& format, const void* data, int width, int height, void* out);

TexelBlock decodeEtc1(const uint8_t* block);
TexelBlock decodeDxt1(const uint8_t* block);
TexelBlock decodeDxt3(const uint8_t* block);
TexelBlock decodeDxt5(const uint8_t* block);
TexelBlock decode3dcX(const uint8_t* block);
TexelBlock decode3dcXy(const uint8_t* block);

// Blocks of 8 bytes; an image of at least 2x2 of them is always there.
void decodePvrtc(const CompressedFormat& format, const uint8_t* data, int width, int height, uint8_t* out);
// Size of the image that the blocks make, texels: powers of two.
int pvrtcWidth(const CompressedFormat& format, int width);
int pvrtcHeight(int height);

}  // namespace anteroom::gl
