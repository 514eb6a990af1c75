// CompressedTexImage2D and CompressedTexSubImage2D (sections 3.7.3, 3.7.4).
#include <algorithm>
#include <array>

#include "layer/gl/compressed.h"
#include "layer/gl/paletted.h"
#include "layer/gl/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

// |level| + 1 levels, from level 0 on.
void specifyPaletted(Context& c, const ImageTarget& image, GLint level, GLenum internalFormat, GLsizei width,
                     GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  Texture& texture = boundTexture(c, image.slot);
  const PalettedFormat paletted = palettedFormat(internalFormat);
  if (level > 0 || level <= -texture.levels()) return c.setError(GL_INVALID_VALUE);
  if (!validSize(c, image.slot, 0, width, height) || border != 0) return c.setError(GL_INVALID_VALUE);
  const int levels = 1 - level;
  if (imageSize != palettedSize(paletted, width, height, levels)) return c.setError(GL_INVALID_VALUE);
  if (texture.immutable()) return c.setError(GL_INVALID_OPERATION);

  std::array<std::unique_ptr<std::byte[]>, 32> texels;
  const std::byte* indices = static_cast<const std::byte*>(data) + (data ? paletted.paletteBytes() : 0);
  const auto sizeAt = [](GLsizei size, int i) { return size > 0 ? std::max(size >> i, 1) : 0; };
  for (int i = 0; data && i < levels; ++i) {
    const int w = sizeAt(width, i), h = sizeAt(height, i);
    if (w == 0 || h == 0) break;
    std::unique_ptr<std::byte[]>& decoded = texels[static_cast<size_t>(i)];
    decoded = allocateTexels(w, h, paletted.entry, false);
    if (!decoded) return c.setError(GL_OUT_OF_MEMORY);
    decodePaletted(paletted, data, indices, static_cast<size_t>(w) * static_cast<size_t>(h), decoded.get());
    indices += paletted.levelBytes(w, h);
  }
  for (int i = 0; i < levels; ++i) {
    if (!texture.specify(c, image.face, i, sizeAt(width, i), sizeAt(height, i), internalFormat,
                         paletted.entry, std::move(texels[static_cast<size_t>(i)]))) {
      return c.setError(GL_OUT_OF_MEMORY);
    }
  }
}

void specifyBlocks(Context& c, const ImageTarget& image, GLint level, const CompressedFormat& format,
                   GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  Texture& texture = boundTexture(c, image.slot);
  if (!validLevel(texture, level) || !validSize(c, image.slot, level, width, height)) {
    return c.setError(GL_INVALID_VALUE);
  }
  if (border != 0) return c.setError(format.errors.border);
  if (!compressible(format, width, height)) {
    // IMG_texture_compression_pvrtc restates the error of section 3.7.1.
    return c.setError(format.decodeBlock ? GL_INVALID_OPERATION : GL_INVALID_VALUE);
  }
  if (imageSize != compressedSize(format, width, height)) return c.setError(GL_INVALID_VALUE);
  if (texture.immutable()) return c.setError(GL_INVALID_OPERATION);

  std::unique_ptr<std::byte[]> texels;
  if (data && width > 0 && height > 0) {
    texels = allocateTexels(width, height, format.decoded, false);
    if (!texels) return c.setError(GL_OUT_OF_MEMORY);
    decodeCompressed(format, data, width, height, texels.get());
  }
  if (!texture.specify(c, image.face, level, width, height, format.name, format.decoded, std::move(texels))) {
    c.setError(GL_OUT_OF_MEMORY);
  }
}

// Whether a format lets such a part of a level be replaced.
bool replaceable(const CompressedFormat& format, const TextureLevel& level, const render::Rect& part) {
  const bool aligned = part.x % 4 == 0 && part.y % 4 == 0;
  switch (format.subImages) {
    case SubImages::Blocks:
      return aligned && (part.width % 4 == 0 || part.x + part.width == level.width) &&
             (part.height % 4 == 0 || part.y + part.height == level.height);
    case SubImages::BlocksOrSide:
      return aligned && (part.width % 4 == 0 || part.width == level.width) &&
             (part.height % 4 == 0 || part.height == level.height);
    default:
      return part.x == 0 && part.y == 0 && part.width == level.width && part.height == level.height;
  }
}

}  // namespace

GL_API void GL_APIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat,
                                               GLsizei width, GLsizei height, GLint border, GLsizei imageSize,
                                               const void* data) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount || !isCompressed(internalformat)) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  if (const CompressedFormat* format = compressedFormat(internalformat)) {
    return specifyBlocks(*c, image, level, *format, width, height, border, imageSize, data);
  }
  specifyPaletted(*c, image, level, internalformat, width, height, border, imageSize, data);
}

GL_API void GL_APIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                                  GLsizei width, GLsizei height, GLenum format,
                                                  GLsizei imageSize, const void* data) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level) || width < 0 || height < 0 || imageSize < 0) {
    return c->setError(GL_INVALID_VALUE);
  }
  const TextureLevel& t = texture.at(image.face, level);
  const CompressedFormat* blocks = compressedFormat(format);
  // Paletted formats take no sub-images (section 3.7.4).
  if (!blocks || t.internalFormat != format) return c->setError(GL_INVALID_OPERATION);
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE);
  const render::Rect part{xoffset, yoffset, width, height};
  if (!replaceable(*blocks, t, part)) return c->setError(GL_INVALID_OPERATION);
  if (imageSize != compressedSize(*blocks, width, height)) return c->setError(GL_INVALID_VALUE);
  if (!data || width == 0 || height == 0) return;

  const std::unique_ptr<std::byte[]> texels = allocateTexels(width, height, blocks->decoded, false);
  if (!texels) return c->setError(GL_OUT_OF_MEMORY);
  decodeCompressed(*blocks, data, width, height, texels.get());
  const PixelRows rows{texels.get(), rowPitch(width, blocks->decoded, 1), blocks->decoded};
  if (!texture.replace(*c, image.face, level, part, rows)) c->setError(GL_OUT_OF_MEMORY);
}
