// CompressedTexImage2D and CompressedTexSubImage2D (sections 3.7.3, 3.7.4).
#include <algorithm>
#include <array>

#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/paletted.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;

namespace {

Fault wrongImageSize(GLsizei imageSize) {
  return wrongNumber("imageSize", imageSize, "Give the bytes that the format needs for this size");
}

// |level| + 1 levels, from level 0 on.
void specifyPaletted(const CommandImage& image, GLint level, GLenum internalFormat, GLsizei width,
                     GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  Context& c = *image.context;
  Texture& texture = image.texture();
  const PalettedFormat paletted = palettedFormat(internalFormat);
  if (level > 0 || level <= -texture.levels())
    return image.error(GL_INVALID_VALUE,
                       wrongNumber("level", level, "Give 0, or minus the number of levels after the first"));
  if (!validSize(c, image.slot, 0, {width, height}) || border != 0)
    return image.error(GL_INVALID_VALUE, wrongSize(image.slot, {width, height}, border));
  const int levels = 1 - level;
  if (imageSize != palettedSize(paletted, width, height, levels))
    return image.error(GL_INVALID_VALUE, wrongImageSize(imageSize));
  if (texture.immutable()) return image.error(GL_INVALID_OPERATION, immutable());

  std::array<std::unique_ptr<std::byte[]>, 32> texels;
  const std::byte* indices = static_cast<const std::byte*>(data) + (data ? paletted.paletteBytes() : 0);
  const auto sizeAt = [](GLsizei size, int i) { return size > 0 ? std::max(size >> i, 1) : 0; };
  for (int i = 0; data && i < levels; ++i) {
    const int w = sizeAt(width, i), h = sizeAt(height, i);
    if (w == 0 || h == 0) break;
    std::unique_ptr<std::byte[]>& decoded = texels[static_cast<size_t>(i)];
    decoded = allocateTexels(w, h, paletted.entry, false);
    if (!decoded) return image.error(GL_OUT_OF_MEMORY);
    decodePaletted(paletted, data, indices, static_cast<size_t>(w) * static_cast<size_t>(h), decoded.get());
    indices += paletted.levelBytes(w, h);
  }
  for (int i = 0; i < levels; ++i) {
    if (!texture.specify(c, image.face, i, {sizeAt(width, i), sizeAt(height, i)}, internalFormat,
                         paletted.entry, std::move(texels[static_cast<size_t>(i)]))) {
      return image.error(GL_OUT_OF_MEMORY);
    }
  }
}

void specifyBlocks(const CommandImage& image, GLint level, const CompressedFormat& format, GLsizei width,
                   GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  Context& c = *image.context;
  Texture& texture = image.texture();
  const Extent size{width, height};
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  if (!validSize(c, image.slot, level, size))
    return image.error(GL_INVALID_VALUE, wrongSize(image.slot, size, 0));
  if (border != 0) return image.error(format.errors.border, wrongSize(image.slot, size, border));
  if (!compressible(format, width, height)) {
    // IMG_texture_compression_pvrtc restates the error of section 3.7.1.
    return image.error(
        format.decodeBlock ? GL_INVALID_OPERATION : GL_INVALID_VALUE,
        wrongNumber("width", width,
                    "Give a size that the format can have, such as a square of a power of two"));
  }
  if (imageSize != compressedSize(format, width, height))
    return image.error(GL_INVALID_VALUE, wrongImageSize(imageSize));
  if (texture.immutable()) return image.error(GL_INVALID_OPERATION, immutable());

  std::unique_ptr<std::byte[]> texels;
  if (data && width > 0 && height > 0) {
    texels = allocateTexels(width, height, format.decoded, false);
    if (!texels) return image.error(GL_OUT_OF_MEMORY);
    decodeCompressed(format, data, width, height, texels.get());
  }
  if (!texture.specify(c, image.face, level, size, format.name, format.decoded, std::move(texels)))
    image.error(GL_OUT_OF_MEMORY);
}

// Whether a format lets such a part of a level be replaced.
bool replaceable(const CompressedFormat& format, const TextureLevel& level, const Box& part) {
  const int width = part.size.width, height = part.size.height;
  const bool aligned = part.x % 4 == 0 && part.y % 4 == 0;
  switch (format.subImages) {
    case SubImages::Blocks:
      return aligned && (width % 4 == 0 || part.x + width == level.width) &&
             (height % 4 == 0 || part.y + height == level.height);
    case SubImages::BlocksOrSide:
      return aligned && (width % 4 == 0 || width == level.width) &&
             (height % 4 == 0 || height == level.height);
    default:
      return part.x == 0 && part.y == 0 && width == level.width && height == level.height;
  }
}

}  // namespace

GL_API void GL_APIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat,
                                               GLsizei width, GLsizei height, GLint border, GLsizei imageSize,
                                               const void* data) {
  const CommandImage image = flatImage(target);
  if (!image) return;
  if (!isCompressed(internalformat))
    return image.error(GL_INVALID_ENUM,
                       wrongEnum("internalformat", internalformat, "Use one of COMPRESSED_TEXTURE_FORMATS"));
  ShareLock lock(*image.context->group);
  if (const CompressedFormat* format = compressedFormat(internalformat))
    return specifyBlocks(image, level, *format, width, height, border, imageSize, data);
  specifyPaletted(image, level, internalformat, width, height, border, imageSize, data);
}

GL_API void GL_APIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                                  GLsizei width, GLsizei height, GLenum format,
                                                  GLsizei imageSize, const void* data) {
  const CommandImage image = flatImage(target);
  if (!image) return;
  Context& c = *image.context;
  ShareLock lock(*c.group);
  Texture& texture = image.texture();
  const Box box{xoffset, yoffset, 0, {width, height}};
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0) return image.error(GL_INVALID_VALUE, wrongSize(image.slot, box.size, 0));
  if (imageSize < 0) return image.error(GL_INVALID_VALUE, wrongImageSize(imageSize));
  const TextureLevel& t = texture.at(image.face, level);
  const CompressedFormat* blocks = compressedFormat(format);
  // Paletted formats take no sub-images (section 3.7.4).
  if (!blocks || t.internalFormat != format)
    return image.error(
        GL_INVALID_OPERATION,
        wrongEnum("format", format, "Use the format of the level; paletted ones take no parts"));
  if (!inside(t, box)) return image.error(GL_INVALID_VALUE, outsideLevel());
  if (!replaceable(*blocks, t, box))
    return image.error(GL_INVALID_OPERATION, wrongState("The format does not let this part be replaced",
                                                        "Replace whole blocks, or the whole level"));
  if (imageSize != compressedSize(*blocks, width, height))
    return image.error(GL_INVALID_VALUE, wrongImageSize(imageSize));
  if (!data || width == 0 || height == 0) return;

  const std::unique_ptr<std::byte[]> texels = allocateTexels(width, height, blocks->decoded, false);
  if (!texels) return image.error(GL_OUT_OF_MEMORY);
  decodeCompressed(*blocks, data, width, height, texels.get());
  const PixelRows rows{texels.get(), rowPitch(width, blocks->decoded, 1), blocks->decoded};
  if (!texture.replace(c, image.face, level, box, rows)) image.error(GL_OUT_OF_MEMORY);
}

// OES_texture_3D. No compressed format that is here has slices: no such image can be specified.
GL_API void GL_APIENTRY glCompressedTexImage3DOES(GLenum target, GLint, GLenum internalformat, GLsizei,
                                                  GLsizei, GLsizei, GLint, GLsizei, const void*) {
  if (const CommandImage image = volumeImage(target))
    image.error(GL_INVALID_ENUM, wrongEnum("internalformat", internalformat,
                                           "Use glTexImage3DOES: compressed formats have two dimensions"));
}

GL_API void GL_APIENTRY glCompressedTexSubImage3DOES(GLenum target, GLint, GLint, GLint, GLint, GLsizei,
                                                     GLsizei, GLsizei, GLenum format, GLsizei, const void*) {
  if (const CommandImage image = volumeImage(target))
    image.error(GL_INVALID_OPERATION, wrongEnum("format", format, "Use glTexSubImage3DOES: no level has it"));
}
