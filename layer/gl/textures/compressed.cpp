#include "layer/gl/textures/compressed.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "registry/gl.h"

namespace anteroom::gl {

using render::Format;

namespace {

constexpr CompressionErrors kEtc1{GL_INVALID_OPERATION};
constexpr CompressionErrors kS3tc{GL_INVALID_OPERATION, GL_INVALID_OPERATION, GL_INVALID_OPERATION};
constexpr CompressionErrors k3dc{GL_INVALID_VALUE, GL_INVALID_OPERATION};
constexpr CompressionErrors kPvrtc{};

constexpr CompressedFormat kFormats[] = {
    {GL_ETC1_RGB8_OES, GL_RGB, Format::RGB8, 8, decodeEtc1, SubImages::Blocks, kEtc1},
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_RGB, Format::RGB8, 8, decodeDxt1, SubImages::BlocksOrSide, kS3tc},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_RGBA, Format::RGBA8, 8, decodeDxt1, SubImages::BlocksOrSide, kS3tc},
    {GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE, GL_RGBA, Format::RGBA8, 16, decodeDxt3, SubImages::BlocksOrSide,
     kS3tc, 4, true},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE, GL_RGBA, Format::RGBA8, 16, decodeDxt5, SubImages::BlocksOrSide,
     kS3tc, 4, true},
    {GL_3DC_X_AMD, GL_RGB, Format::RGB8, 8, decode3dcX, SubImages::Blocks, k3dc},
    {GL_3DC_XY_AMD, GL_RGB, Format::RGB8, 16, decode3dcXy, SubImages::Blocks, k3dc},
    {GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG, GL_RGB, Format::RGB8, 8, nullptr, SubImages::Whole, kPvrtc, 4},
    {GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG, GL_RGB, Format::RGB8, 8, nullptr, SubImages::Whole, kPvrtc, 8},
    {GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, GL_RGBA, Format::RGBA8, 8, nullptr, SubImages::Whole, kPvrtc, 4},
    {GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG, GL_RGBA, Format::RGBA8, 8, nullptr, SubImages::Whole, kPvrtc, 8},
};

bool isPvrtc(const CompressedFormat& format) {
  return format.decodeBlock == nullptr;
}

}  // namespace

std::span<const CompressedFormat> compressedFormats() {
  return kFormats;
}

const CompressedFormat* compressedFormat(GLenum internalFormat) {
  for (const CompressedFormat& format : kFormats) {
    if (format.name == internalFormat) return &format;
  }
  return nullptr;
}

int64_t compressedSize(const CompressedFormat& format, int width, int height) {
  if (isPvrtc(format)) {
    width = pvrtcWidth(format, width);
    height = pvrtcHeight(height);
  }
  const int64_t across = (int64_t{width} + format.blockWidth - 1) / format.blockWidth;
  return across * ((int64_t{height} + 3) / 4) * format.blockBytes;
}

bool compressible(const CompressedFormat& format, int width, int height) {
  if (isPvrtc(format)) {
    const auto powerOfTwo = [](int size) {
      return size == 0 || std::has_single_bit(static_cast<unsigned>(size));
    };
    return powerOfTwo(width) && powerOfTwo(height);
  }
  const auto wholeBlocks = [](int size) { return size % 4 == 0 || size == 1 || size == 2; };
  return !format.wholeBlocks || (wholeBlocks(width) && wholeBlocks(height));
}

void decodeCompressed(const CompressedFormat& format, const void* data, int width, int height, void* out) {
  const auto* block = static_cast<const uint8_t*>(data);
  auto* texels = static_cast<uint8_t*>(out);
  if (isPvrtc(format)) return decodePvrtc(format, block, width, height, texels);
  const size_t bytes = render::info(format.decoded).bytes;
  for (int y = 0; y < height; y += 4) {
    for (int x = 0; x < width; x += 4, block += format.blockBytes) {
      const TexelBlock decoded = format.decodeBlock(block);
      const int columns = std::min(4, width - x), rows = std::min(4, height - y);
      for (int row = 0; row < rows; ++row) {
        const size_t first =
            static_cast<size_t>(y + row) * static_cast<size_t>(width) + static_cast<size_t>(x);
        uint8_t* to = texels + first * bytes;
        for (int column = 0; column < columns; ++column, to += bytes) {
          std::memcpy(to, decoded[static_cast<size_t>(row * 4 + column)].data(), bytes);
        }
      }
    }
  }
}

}  // namespace anteroom::gl
