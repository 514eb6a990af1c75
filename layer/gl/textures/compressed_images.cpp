// CompressedTexImage2D and CompressedTexSubImage2D (sections 3.7.3, 3.7.4).
#include <algorithm>
#include <array>

#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/paletted.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

Fault wrongImageSize(GLsizei imageSize) {
  return wrongNumber("imageSize", imageSize, "Give the bytes that the format needs for this size");
}

// |level| + 1 levels, from level 0 on.
void specifyPaletted(Context& c, const ImageTarget& image, GLint level, GLenum internalFormat, GLsizei width,
                     GLsizei height, GLint border, GLsizei imageSize, const void* data, const char* command) {
  Texture& texture = boundTexture(c, image.slot);
  const PalettedFormat paletted = palettedFormat(internalFormat);
  if (level > 0 || level <= -texture.levels())
    return c.setError(GL_INVALID_VALUE,
                      wrongNumber("level", level, "Give 0, or minus the number of levels after the first"),
                      command);
  if (!validSize(c, image.slot, 0, width, height) || border != 0)
    return c.setError(GL_INVALID_VALUE, wrongSize(width, height, border), command);
  const int levels = 1 - level;
  if (imageSize != palettedSize(paletted, width, height, levels))
    return c.setError(GL_INVALID_VALUE, wrongImageSize(imageSize), command);
  if (texture.immutable()) return c.setError(GL_INVALID_OPERATION, immutable(), command);

  std::array<std::unique_ptr<std::byte[]>, 32> texels;
  const std::byte* indices = static_cast<const std::byte*>(data) + (data ? paletted.paletteBytes() : 0);
  const auto sizeAt = [](GLsizei size, int i) { return size > 0 ? std::max(size >> i, 1) : 0; };
  for (int i = 0; data && i < levels; ++i) {
    const int w = sizeAt(width, i), h = sizeAt(height, i);
    if (w == 0 || h == 0) break;
    std::unique_ptr<std::byte[]>& decoded = texels[static_cast<size_t>(i)];
    decoded = allocateTexels(w, h, paletted.entry, false);
    if (!decoded) return c.setError(GL_OUT_OF_MEMORY, {}, command);
    decodePaletted(paletted, data, indices, static_cast<size_t>(w) * static_cast<size_t>(h), decoded.get());
    indices += paletted.levelBytes(w, h);
  }
  for (int i = 0; i < levels; ++i) {
    if (!texture.specify(c, image.face, i, {sizeAt(width, i), sizeAt(height, i)}, internalFormat,
                         paletted.entry, std::move(texels[static_cast<size_t>(i)]))) {
      return c.setError(GL_OUT_OF_MEMORY, {}, command);
    }
  }
}

void specifyBlocks(Context& c, const ImageTarget& image, GLint level, const CompressedFormat& format,
                   GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data,
                   const char* command) {
  Texture& texture = boundTexture(c, image.slot);
  if (!validLevel(texture, level))
    return c.setError(GL_INVALID_VALUE,
                      wrongNumber("level", level, "Give a level from 0 to log2 of the largest size"),
                      command);
  if (!validSize(c, image.slot, level, width, height))
    return c.setError(GL_INVALID_VALUE, wrongSize(width, height, 0), command);
  if (border != 0) return c.setError(format.errors.border, wrongSize(width, height, border), command);
  if (!compressible(format, width, height)) {
    // IMG_texture_compression_pvrtc restates the error of section 3.7.1.
    return c.setError(format.decodeBlock ? GL_INVALID_OPERATION : GL_INVALID_VALUE,
                      wrongNumber("width", width,
                                  "Give a size that the format can have, such as a square of a power of two"),
                      command);
  }
  if (imageSize != compressedSize(format, width, height))
    return c.setError(GL_INVALID_VALUE, wrongImageSize(imageSize), command);
  if (texture.immutable()) return c.setError(GL_INVALID_OPERATION, immutable(), command);

  std::unique_ptr<std::byte[]> texels;
  if (data && width > 0 && height > 0) {
    texels = allocateTexels(width, height, format.decoded, false);
    if (!texels) return c.setError(GL_OUT_OF_MEMORY, {}, command);
    decodeCompressed(format, data, width, height, texels.get());
  }
  if (!texture.specify(c, image.face, level, {width, height}, format.name, format.decoded,
                       std::move(texels))) {
    c.setError(GL_OUT_OF_MEMORY, {}, command);
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
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  if (!isCompressed(internalformat))
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("internalformat", internalformat, "Use one of COMPRESSED_TEXTURE_FORMATS"));
  ShareLock lock(*c->group);
  if (const CompressedFormat* format = compressedFormat(internalformat)) {
    return specifyBlocks(*c, image, level, *format, width, height, border, imageSize, data, __func__);
  }
  specifyPaletted(*c, image, level, internalformat, width, height, border, imageSize, data, __func__);
}

GL_API void GL_APIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                                  GLsizei width, GLsizei height, GLenum format,
                                                  GLsizei imageSize, const void* data) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level))
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber("level", level, "Give a level from 0 to log2 of the largest size"));
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, wrongSize(width, height, 0));
  if (imageSize < 0) return c->setError(GL_INVALID_VALUE, wrongImageSize(imageSize));
  const TextureLevel& t = texture.at(image.face, level);
  const CompressedFormat* blocks = compressedFormat(format);
  // Paletted formats take no sub-images (section 3.7.4).
  if (!blocks || t.internalFormat != format)
    return c->setError(
        GL_INVALID_OPERATION,
        wrongEnum("format", format, "Use the format of the level; paletted ones take no parts"));
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE, outsideLevel());
  const render::Rect part{xoffset, yoffset, width, height};
  if (!replaceable(*blocks, t, part))
    return c->setError(GL_INVALID_OPERATION, wrongState("The format does not let this part be replaced",
                                                        "Replace whole blocks, or the whole level"));
  if (imageSize != compressedSize(*blocks, width, height))
    return c->setError(GL_INVALID_VALUE, wrongImageSize(imageSize));
  if (!data || width == 0 || height == 0) return;

  const std::unique_ptr<std::byte[]> texels = allocateTexels(width, height, blocks->decoded, false);
  if (!texels) return c->setError(GL_OUT_OF_MEMORY);
  decodeCompressed(*blocks, data, width, height, texels.get());
  const PixelRows rows{texels.get(), rowPitch(width, blocks->decoded, 1), blocks->decoded};
  if (!texture.replace(*c, image.face, level, {xoffset, yoffset, 0, {width, height}}, rows))
    c->setError(GL_OUT_OF_MEMORY);
}
