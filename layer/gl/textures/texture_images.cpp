// TexImage2D, TexImage3DOES and their alternatives (sections 3.7.1 to 3.7.4, OES_texture_3D).
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;
using render::Format;

namespace {

// As the program gave them: slices follow each other in memory without gaps.
struct ClientTexels {
  GLenum format, type;
  const void* data;
};

PixelRows rowsOf(const Context& c, const ClientTexels& texels, GLsizei width) {
  const Format given = formatOf(texels.format, texels.type);
  return {texels.data, rowPitch(width, given, c.unpackAlignment), given};
}

void specifyImage(const CommandImage& image, GLint level, GLenum internalFormat, const Extent& size,
                  GLint border, const ClientTexels& texels) {
  Context& c = *image.context;
  ShareLock lock(*c.group);
  Texture& texture = image.texture();
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  // The errors that texts of compressed formats state are those of TexImage2D.
  const CompressedFormat* blocks = image.slot == kSlot3D ? nullptr : compressedFormat(internalFormat);
  if (blocks) return image.error(blocks->errors.texImage);
  if (!isTexImageFormat(internalFormat))
    return image.error(GL_INVALID_VALUE, wrongEnum("internalformat", internalFormat,
                                                   "Use a base format such as RGBA, the same as format"));
  if (!isPixelPair(texels.format, texels.type))
    return image.error(GL_INVALID_ENUM, wrongPixelPair(texels.format, texels.type));
  if (!validSize(c, image.slot, level, size) || border != 0)
    return image.error(GL_INVALID_VALUE, wrongSize(image.slot, size, border));
  if (!combines(internalFormat, texels.format, texels.type) || texture.immutable())
    return image.error(
        GL_INVALID_OPERATION,
        wrongState("internalformat, format and type do not go together, or the texture is immutable",
                   "Use a row of table 3.8, such as RGBA, RGBA and UNSIGNED_BYTE"));
  if (!texture.specify(c, image.face, level, size, internalFormat, rowsOf(c, texels, size.width)))
    image.error(GL_OUT_OF_MEMORY);
}

void replaceTexels(const CommandImage& image, GLint level, const Box& box, const ClientTexels& texels) {
  Context& c = *image.context;
  ShareLock lock(*c.group);
  Texture& texture = image.texture();
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  if (box.size.width < 0 || box.size.height < 0 || box.size.depth < 0)
    return image.error(GL_INVALID_VALUE, wrongSize(image.slot, box.size, 0));
  if (!isPixelPair(texels.format, texels.type))
    return image.error(GL_INVALID_ENUM, wrongPixelPair(texels.format, texels.type));
  const TextureLevel& t = texture.at(image.face, level);
  // A compressed level takes none (sections 3.7.3, 3.7.4); nor does one that was never specified.
  if (!takesTexels(t.internalFormat, texels.format) || formatOf(texels.format, texels.type) == Format::None)
    return image.error(GL_INVALID_OPERATION,
                       wrongState("The level was never specified, is compressed, or has another format",
                                  "Use the format that the level was specified with"));
  if (!inside(t, box)) return image.error(GL_INVALID_VALUE, outsideLevel());
  if (!texture.replace(c, image.face, level, box, rowsOf(c, texels, box.size.width)))
    image.error(GL_OUT_OF_MEMORY);
}

// From the framebuffer's rectangle at (x, y).
void copyTexels(const CommandImage& image, GLint level, const Box& box, GLint x, GLint y) {
  Context& c = *image.context;
  ShareLock lock(*c.group);
  Texture& texture = image.texture();
  const GLsizei width = box.size.width, height = box.size.height;
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0) return image.error(GL_INVALID_VALUE, wrongSize(image.slot, box.size, 0));
  if (const GLenum error = readError(c)) return image.error(error, unreadable());
  const TextureLevel& t = texture.at(image.face, level);
  // Undefined levels have no base format; compressed ones take no sub-images that are not.
  if (baseFormatOf(t.internalFormat) == 0 || isCompressed(t.internalFormat) ||
      !canCopy(c.readFramebuffer, t.internalFormat)) {
    return image.error(GL_INVALID_OPERATION, cannotCopy());
  }
  if (!inside(t, box)) return image.error(GL_INVALID_VALUE, outsideLevel());
  if (!texture.replaceFromFramebuffer(c, image.face, level, box.x, box.y, box.z, {x, y, width, height}))
    image.error(GL_OUT_OF_MEMORY);
}

// What CopyTexImage2D stores: no more bits than the framebuffer has, but those of a sized format.
Format copiedFormat(Format framebuffer, GLenum internalFormat) {
  if (isSized(internalFormat)) return sizedFormat(internalFormat);
  if (pixelFormatOf(framebuffer).format == internalFormat) return framebuffer;
  return formatOf(internalFormat, GL_UNSIGNED_BYTE);
}

}  // namespace

GL_API void GL_APIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width,
                                     GLsizei height, GLint border, GLenum format, GLenum type,
                                     const void* pixels) {
  if (const CommandImage image = flatImage(target))
    specifyImage(image, level, static_cast<GLenum>(internalformat), {width, height}, border,
                 {format, type, pixels});
}

GL_API void GL_APIENTRY glTexImage3DOES(GLenum target, GLint level, GLenum internalformat, GLsizei width,
                                        GLsizei height, GLsizei depth, GLint border, GLenum format,
                                        GLenum type, const void* pixels) {
  if (const CommandImage image = volumeImage(target))
    specifyImage(image, level, internalformat, {width, height, depth}, border, {format, type, pixels});
}

GL_API void GL_APIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                        GLsizei width, GLsizei height, GLenum format, GLenum type,
                                        const void* pixels) {
  if (const CommandImage image = flatImage(target))
    replaceTexels(image, level, {xoffset, yoffset, 0, {width, height}}, {format, type, pixels});
}

GL_API void GL_APIENTRY glTexSubImage3DOES(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                           GLint zoffset, GLsizei width, GLsizei height, GLsizei depth,
                                           GLenum format, GLenum type, const void* pixels) {
  if (const CommandImage image = volumeImage(target))
    replaceTexels(image, level, {xoffset, yoffset, zoffset, {width, height, depth}}, {format, type, pixels});
}

GL_API void GL_APIENTRY glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                                            GLint y, GLsizei width, GLsizei height) {
  if (const CommandImage image = flatImage(target))
    copyTexels(image, level, {xoffset, yoffset, 0, {width, height}}, x, y);
}

GL_API void GL_APIENTRY glCopyTexSubImage3DOES(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                               GLint zoffset, GLint x, GLint y, GLsizei width,
                                               GLsizei height) {
  if (const CommandImage image = volumeImage(target))
    copyTexels(image, level, {xoffset, yoffset, zoffset, {width, height}}, x, y);
}

GL_API void GL_APIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                                         GLsizei width, GLsizei height, GLint border) {
  const CommandImage image = flatImage(target);
  if (!image) return;
  Context& c = *image.context;
  ShareLock lock(*c.group);
  Texture& texture = image.texture();
  if (const CompressedFormat* blocks = compressedFormat(internalformat))
    return image.error(blocks->errors.copyTexImage);
  if (!isCopyFormat(internalformat))
    return image.error(GL_INVALID_ENUM,
                       wrongEnum("internalformat", internalformat, "Use a base format such as RGBA"));
  if (!validLevel(texture, level)) return image.error(GL_INVALID_VALUE, wrongLevel(level));
  if (!validSize(c, image.slot, level, {width, height}) || border != 0)
    return image.error(GL_INVALID_VALUE, wrongSize(image.slot, {width, height}, border));
  const render::Framebuffer& framebuffer = c.readFramebuffer;
  if (const GLenum error = readError(c)) return image.error(error, unreadable());
  if (!canCopy(framebuffer, internalformat) || texture.immutable())
    return image.error(GL_INVALID_OPERATION, cannotCopy());

  const Format stored = copiedFormat(framebuffer.color.image->desc().format, internalformat);
  if (!texture.specifyFromFramebuffer(c, image.face, level, {x, y, width, height}, internalformat, stored))
    image.error(GL_OUT_OF_MEMORY);
}
