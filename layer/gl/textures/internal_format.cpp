#include "layer/gl/textures/internal_format.h"

#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/paletted.h"
#include "layer/gl/textures/pixel.h"

namespace anteroom::gl {

using render::Format;

namespace {

struct Sized {
  GLenum name, base;
  GLenum type;    // of TexImage2D, beside UNSIGNED_BYTE
  Format stored;  // at least; also what TexStorage2DEXT stores
  bool inTexStorage = true;
};

constexpr Sized kSized[] = {
    {GL_ALPHA8_OES, GL_ALPHA, GL_UNSIGNED_BYTE, Format::A8},
    {GL_LUMINANCE8_OES, GL_LUMINANCE, GL_UNSIGNED_BYTE, Format::L8},
    {GL_LUMINANCE8_ALPHA8_OES, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, Format::LA8},
    {GL_LUMINANCE4_ALPHA4_OES, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, Format::LA8, false},
    {GL_RGB565_OES, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, Format::RGB565},
    {GL_RGB8_OES, GL_RGB, GL_UNSIGNED_BYTE, Format::RGB8},
    {GL_RGBA4_OES, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, Format::RGBA4444},
    {GL_RGB5_A1_OES, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, Format::RGBA5551},
    {GL_RGBA8_OES, GL_RGBA, GL_UNSIGNED_BYTE, Format::RGBA8},
};

const Sized* sized(GLenum internalFormat) {
  for (const Sized& format : kSized) {
    if (format.name == internalFormat) return &format;
  }
  return nullptr;
}

bool isBase(GLenum format) {
  return format >= GL_ALPHA && format <= GL_LUMINANCE_ALPHA;
}
static_assert(GL_ALPHA + 1 == GL_RGB && GL_RGB + 1 == GL_RGBA && GL_RGBA + 1 == GL_LUMINANCE &&
              GL_LUMINANCE + 1 == GL_LUMINANCE_ALPHA);

}  // namespace

GLenum baseFormatOf(GLenum internalFormat) {
  if (isBase(internalFormat)) return internalFormat;
  switch (internalFormat) {
    case GL_BGRA_EXT:
    case GL_BGRA8_EXT:
    case GL_SRGB_ALPHA_EXT:
      return GL_RGBA;
    case GL_SRGB_EXT:
      return GL_RGB;
    default:
      break;
  }
  if (const Sized* format = sized(internalFormat)) return format->base;
  if (const CompressedFormat* format = compressedFormat(internalFormat)) return format->base;
  return pixelFormatOf(palettedFormat(internalFormat).entry).format;
}

bool isSized(GLenum internalFormat) {
  return sized(internalFormat) != nullptr;
}

bool isSrgb(GLenum internalFormat) {
  return internalFormat == GL_SRGB_EXT || internalFormat == GL_SRGB_ALPHA_EXT;
}

bool isCompressed(GLenum internalFormat) {
  return compressedFormat(internalFormat) != nullptr || isPaletted(internalFormat);
}

bool isTexImageFormat(GLenum internalFormat) {
  return isPixelFormat(internalFormat) || isSized(internalFormat);
}

bool combines(GLenum internalFormat, GLenum format, GLenum type) {
  if (formatOf(format, type) == Format::None) return false;
  if (const Sized* size = sized(internalFormat)) {
    return size->base == format && (type == GL_UNSIGNED_BYTE || type == size->type);
  }
  // APPLE_texture_format_BGRA8888
  return internalFormat == format || (internalFormat == GL_RGBA && format == GL_BGRA_EXT);
}

bool takesTexels(GLenum internalFormat, GLenum format) {
  if (isCompressed(internalFormat)) return false;
  if (internalFormat == GL_BGRA_EXT || internalFormat == GL_BGRA8_EXT) return format == GL_BGRA_EXT;
  if (isSrgb(internalFormat)) return format == internalFormat;
  const GLenum base = baseFormatOf(internalFormat);
  return base != 0 && (base == format || (base == GL_RGBA && format == GL_BGRA_EXT));
}

bool isCopyFormat(GLenum internalFormat) {
  return isBase(internalFormat) || isSized(internalFormat);
}

Format storageFormat(GLenum internalFormat) {
  if (internalFormat == GL_BGRA8_EXT) return Format::RGBA8;
  if (const CompressedFormat* format = compressedFormat(internalFormat)) return format->decoded;
  const Sized* format = sized(internalFormat);
  return format && format->inTexStorage ? format->stored : Format::None;
}

Format sizedFormat(GLenum internalFormat) {
  const Sized* format = sized(internalFormat);
  return format ? format->stored : Format::None;
}

}  // namespace anteroom::gl
