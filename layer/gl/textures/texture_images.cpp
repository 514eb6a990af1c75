// TexImage2D and its alternatives: validation (sections 3.7.1 to 3.7.4).
#include <algorithm>
#include <array>

#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;
using render::Format;

namespace {

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
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  const GLenum internal = static_cast<GLenum>(internalformat);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (const CompressedFormat* blocks = compressedFormat(internal))
    return c->setError(blocks->errors.texImage);
  if (!isTexImageFormat(internal))
    return c->setError(GL_INVALID_VALUE, wrongEnum("internalformat", internal,
                                                   "Use a base format such as RGBA, the same as format"));
  if (!isPixelPair(format, type)) return c->setError(GL_INVALID_ENUM, wrongPixelPair(format, type));
  if (!validSize(*c, image.slot, level, width, height) || border != 0)
    return c->setError(GL_INVALID_VALUE, wrongSize(width, height, border));
  if (!combines(internal, format, type) || texture.immutable())
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState("internalformat, format and type do not go together, or the texture is immutable",
                   "Use a row of table 3.8, such as RGBA, RGBA and UNSIGNED_BYTE"));

  const Format given = formatOf(format, type);
  const PixelRows rows{pixels, rowPitch(width, given, c->unpackAlignment), given};
  if (!texture.specify(*c, image.face, level, {width, height}, internal, rows)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                        GLsizei width, GLsizei height, GLenum format, GLenum type,
                                        const void* pixels) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, wrongSize(width, height, 0));
  if (!isPixelPair(format, type)) return c->setError(GL_INVALID_ENUM, wrongPixelPair(format, type));
  const TextureLevel& t = texture.at(image.face, level);
  const Format given = formatOf(format, type);
  // A compressed level takes none (sections 3.7.3, 3.7.4); nor does one that was never specified.
  if (!takesTexels(t.internalFormat, format) || given == Format::None) {
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("The level was never specified, is compressed, or has another format",
                                  "Use the format that glTexImage2D gave it"));
  }
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE, outsideLevel());

  const PixelRows rows{pixels, rowPitch(width, given, c->unpackAlignment), given};
  const Box box{xoffset, yoffset, 0, {width, height}};
  if (!texture.replace(*c, image.face, level, box, rows)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                                         GLsizei width, GLsizei height, GLint border) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (const CompressedFormat* blocks = compressedFormat(internalformat)) {
    return c->setError(blocks->errors.copyTexImage);
  }
  if (!isCopyFormat(internalformat))
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("internalformat", internalformat, "Use a base format such as RGBA"));
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (!validSize(*c, image.slot, level, width, height) || border != 0)
    return c->setError(GL_INVALID_VALUE, wrongSize(width, height, border));
  const render::Framebuffer& framebuffer = c->readFramebuffer;
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable());
  if (!canCopy(framebuffer, internalformat) || texture.immutable())
    return c->setError(GL_INVALID_OPERATION, cannotCopy());

  const Format stored = copiedFormat(framebuffer.color.image->desc().format, internalformat);
  const render::Rect rect{x, y, width, height};
  if (!texture.specifyFromFramebuffer(*c, image.face, level, rect, internalformat, stored)) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}

GL_API void GL_APIENTRY glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                                            GLint y, GLsizei width, GLsizei height) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM, wrongImageTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, wrongSize(width, height, 0));
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable());
  const TextureLevel& t = texture.at(image.face, level);
  // Undefined levels have no base format; compressed ones take no sub-images that are not.
  if (baseFormatOf(t.internalFormat) == 0 || isCompressed(t.internalFormat) ||
      !canCopy(c->readFramebuffer, t.internalFormat)) {
    return c->setError(GL_INVALID_OPERATION, cannotCopy());
  }
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE, outsideLevel());

  const render::Rect rect{x, y, width, height};
  if (!texture.replaceFromFramebuffer(*c, image.face, level, xoffset, yoffset, 0, rect)) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}
