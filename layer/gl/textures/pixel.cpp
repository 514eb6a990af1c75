#include "layer/gl/textures/pixel.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "layer/render/renderer.h"

namespace anteroom::gl {

using render::Format;

namespace {

struct Pair {
  GLenum format, type;
  Format stored;
};

constexpr Pair kPairs[] = {
    // Table 3.4
    {GL_RGBA, GL_UNSIGNED_BYTE, Format::RGBA8},
    {GL_RGB, GL_UNSIGNED_BYTE, Format::RGB8},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, Format::RGBA4444},
    {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, Format::RGBA5551},
    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, Format::RGB565},
    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, Format::LA8},
    {GL_LUMINANCE, GL_UNSIGNED_BYTE, Format::L8},
    {GL_ALPHA, GL_UNSIGNED_BYTE, Format::A8},
    // EXT_texture_format_BGRA8888, EXT_sRGB
    {GL_BGRA_EXT, GL_UNSIGNED_BYTE, Format::BGRA8},
    {GL_SRGB_EXT, GL_UNSIGNED_BYTE, Format::SRGB8},
    {GL_SRGB_ALPHA_EXT, GL_UNSIGNED_BYTE, Format::SRGB8Alpha8},
};

using Components = std::array<uint32_t, 4>;

Components unpack(Format format, const uint8_t* texel) {
  uint16_t packed = 0;
  switch (format) {
    case Format::RGB8:
      return {texel[0], texel[1], texel[2], 255};
    case Format::RGBA8:
      return {texel[0], texel[1], texel[2], texel[3]};
    case Format::BGRA8:
      return {texel[2], texel[1], texel[0], texel[3]};
    default:
      std::memcpy(&packed, texel, sizeof packed);
  }
  const uint32_t p = packed;
  switch (format) {
    case Format::RGB565:
      return {p >> 11, p >> 5 & 63, p & 31, 0};
    case Format::RGBA4444:
      return {p >> 12, p >> 8 & 15, p >> 4 & 15, p & 15};
    case Format::RGBA5551:
      return {p >> 11, p >> 6 & 31, p >> 1 & 31, p & 1};
    default:
      return {};
  }
}

void pack(Format format, const Components& c, uint8_t* texel) {
  uint32_t packed = 0;
  switch (format) {
    case Format::RGBA8:
      texel[3] = static_cast<uint8_t>(c[3]);
      [[fallthrough]];
    case Format::RGB8:
      for (int i = 0; i < 3; ++i) texel[i] = static_cast<uint8_t>(c[i]);
      return;
    case Format::RGB565:
      packed = c[0] << 11 | c[1] << 5 | c[2];
      break;
    case Format::RGBA4444:
      packed = c[0] << 12 | c[1] << 8 | c[2] << 4 | c[3];
      break;
    case Format::RGBA5551:
      packed = c[0] << 11 | c[1] << 6 | c[2] << 1 | c[3];
      break;
    default:
      return;
  }
  const uint16_t value = static_cast<uint16_t>(packed);
  std::memcpy(texel, &value, sizeof value);
}

// For every value of an n-bit component the nearest m-bit one.
using Rescale = std::array<uint8_t, 256>;

Rescale makeRescale(int fromBits, int toBits) {
  Rescale table{};
  const uint32_t from = (1u << fromBits) - 1, to = (1u << toBits) - 1;
  for (uint32_t v = 0; v <= from; ++v) {
    table[v] = static_cast<uint8_t>(from ? (2 * v * to + from) / (2 * from) : 0);
  }
  return table;
}

// BGRA8 to RGBA8.
void swapRow(const uint8_t* in, int width, uint8_t* out) {
  for (int x = 0; x < width; ++x, in += 4, out += 4) {
    out[0] = in[2];
    out[1] = in[1];
    out[2] = in[0];
    out[3] = in[3];
  }
}

void copyRows(const PixelRows& rows, size_t bytes, int height, void* out, size_t outPitch) {
  if (rows.pitch == bytes && outPitch == bytes) {
    std::memcpy(out, rows.data, bytes * static_cast<size_t>(height));
    return;
  }
  for (int y = 0; y < height; ++y) {
    std::memcpy(static_cast<uint8_t*>(out) + static_cast<size_t>(y) * outPitch,
                static_cast<const uint8_t*>(rows.data) + static_cast<size_t>(y) * rows.pitch, bytes);
  }
}

}  // namespace

bool isPixelFormat(GLenum format) {
  for (const Pair& pair : kPairs) {
    if (pair.format == format) return true;
  }
  return false;
}

bool isPixelType(GLenum type) {
  for (const Pair& pair : kPairs) {
    if (pair.type == type) return true;
  }
  return false;
}

Format formatOf(GLenum format, GLenum type) {
  for (const Pair& pair : kPairs) {
    if (pair.format == format && pair.type == type) return pair.stored;
  }
  return Format::None;
}

PixelFormat pixelFormatOf(Format format) {
  for (const Pair& pair : kPairs) {
    if (pair.stored == format) return {pair.format, pair.type};
  }
  return {};
}

void convertRows(const PixelRows& rows, int width, int height, Format format, void* out, size_t outPitch) {
  if (width <= 0 || height <= 0) return;
  const render::FormatInfo& from = render::info(rows.format);
  const render::FormatInfo& to = render::info(format);
  if (rows.format == format) {
    copyRows(rows, static_cast<size_t>(width) * to.bytes, height, out, outPitch);
    return;
  }
  if (rows.format == Format::BGRA8 && format == Format::RGBA8) {
    for (int y = 0; y < height; ++y) {
      swapRow(static_cast<const uint8_t*>(rows.data) + static_cast<size_t>(y) * rows.pitch, width,
              static_cast<uint8_t*>(out) + static_cast<size_t>(y) * outPitch);
    }
    return;
  }
  const std::array<Rescale, 4> rescale{makeRescale(from.red, to.red), makeRescale(from.green, to.green),
                                       makeRescale(from.blue, to.blue), makeRescale(from.alpha, to.alpha)};
  for (int y = 0; y < height; ++y) {
    const uint8_t* in = static_cast<const uint8_t*>(rows.data) + static_cast<size_t>(y) * rows.pitch;
    uint8_t* texel = static_cast<uint8_t*>(out) + static_cast<size_t>(y) * outPitch;
    for (int x = 0; x < width; ++x, in += from.bytes, texel += to.bytes) {
      Components components = unpack(rows.format, in);
      for (size_t i = 0; i < 4; ++i) components[i] = rescale[i][components[i]];
      pack(format, components, texel);
    }
  }
}

PixelFormat implementationReadFormat(const render::Framebuffer& framebuffer) {
  if (framebuffer.color.image) {
    const Format format = framebuffer.color.image->desc().format;
    const PixelFormat own = pixelFormatOf(format);
    if (own.format && !render::isSrgb(format)) return own;
  }
  return {GL_RGBA, GL_UNSIGNED_BYTE};
}

}  // namespace anteroom::gl
