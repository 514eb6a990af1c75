// TexImage2D and its alternatives: validation (sections 3.7.1 to 3.7.4).
#include <algorithm>
#include <array>

#include "layer/gl/framebuffer_object.h"
#include "layer/gl/paletted.h"
#include "layer/gl/texture.h"

using namespace anteroom::gl;
namespace render = anteroom::render;
using render::Format;

namespace {

bool isBaseFormat(GLenum format) {
  return isPixelFormat(format);
}

bool validLevel(const Texture& texture, GLint level) {
  return level >= 0 && level < texture.levels();
}

// Sizes that a level can have; faces of cube maps are square.
bool validSize(const Context& c, TextureSlot slot, GLint level, GLsizei width, GLsizei height) {
  const render::Caps& caps = c.device.caps();
  const int limit = std::max((slot == kSlotCube ? caps.maxCubeMapSize : caps.maxTextureSize) >> level, 1);
  if (width < 0 || height < 0 || width > limit || height > limit) return false;
  return slot != kSlotCube || width == height;
}

bool inside(const TextureLevel& level, GLint x, GLint y, GLsizei width, GLsizei height) {
  return x >= 0 && y >= 0 && width <= level.width && height <= level.height && x <= level.width - width &&
         y <= level.height - height;
}

// Table 3.9: components can be dropped, not added.
bool canCopy(const render::Framebuffer& framebuffer, GLenum baseFormat) {
  if (!framebuffer.color.image) return false;
  const render::FormatInfo& has = render::info(framebuffer.color.image->desc().format);
  switch (baseFormat) {
    case GL_ALPHA:
      return has.alpha != 0;
    case GL_LUMINANCE:
      return has.red != 0 || has.luminance != 0;
    case GL_LUMINANCE_ALPHA:
      return (has.red != 0 || has.luminance != 0) && has.alpha != 0;
    case GL_RGB:
      return has.red != 0;
    default:
      return has.red != 0 && has.alpha != 0;
  }
}

// What CopyTexImage2D stores: no more bits than the framebuffer has.
Format copiedFormat(Format framebuffer, GLenum baseFormat) {
  if (pixelFormatOf(framebuffer).format == baseFormat) return framebuffer;
  return formatOf(baseFormat, GL_UNSIGNED_BYTE);
}

}  // namespace

GL_API void GL_APIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width,
                                     GLsizei height, GLint border, GLenum format, GLenum type,
                                     const void* pixels) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  const GLenum internal = static_cast<GLenum>(internalformat);
  if (!validLevel(texture, level) || !isBaseFormat(internal)) return c->setError(GL_INVALID_VALUE);
  if (!isPixelFormat(format) || !isPixelType(type)) return c->setError(GL_INVALID_ENUM);
  if (!validSize(*c, image.slot, level, width, height) || border != 0) return c->setError(GL_INVALID_VALUE);
  const Format stored = formatOf(format, type);
  if (internal != format || stored == Format::None) return c->setError(GL_INVALID_OPERATION);

  const PixelRows rows{pixels, rowPitch(width, stored, c->unpackAlignment), stored};
  if (!texture.specify(*c, image.face, level, width, height, internal, rows)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                        GLsizei width, GLsizei height, GLenum format, GLenum type,
                                        const void* pixels) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level) || width < 0 || height < 0) return c->setError(GL_INVALID_VALUE);
  if (!isPixelFormat(format) || !isPixelType(type)) return c->setError(GL_INVALID_ENUM);
  const TextureLevel& t = texture.at(image.face, level);
  const Format given = formatOf(format, type);
  // A paletted level matches no format (section 3.7.4); nor does one that was never specified.
  if (t.internalFormat != format || given == Format::None) return c->setError(GL_INVALID_OPERATION);
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE);

  const PixelRows rows{pixels, rowPitch(width, given, c->unpackAlignment), given};
  const render::Rect rect{xoffset, yoffset, width, height};
  if (!texture.replace(*c, image.face, level, rect, rows)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                                         GLsizei width, GLsizei height, GLint border) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!isBaseFormat(internalformat)) return c->setError(GL_INVALID_ENUM);
  if (!validLevel(texture, level) || !validSize(*c, image.slot, level, width, height) || border != 0) {
    return c->setError(GL_INVALID_VALUE);
  }
  const render::Framebuffer& framebuffer = c->readFramebuffer;
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable());
  if (!canCopy(framebuffer, internalformat)) return c->setError(GL_INVALID_OPERATION);

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
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  if (!validLevel(texture, level) || width < 0 || height < 0) return c->setError(GL_INVALID_VALUE);
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable());
  const TextureLevel& t = texture.at(image.face, level);
  // Undefined levels have no base format; paletted ones take no sub-images (OES_compressed_paletted_texture).
  if (!isBaseFormat(t.internalFormat) || !canCopy(c->readFramebuffer, t.internalFormat)) {
    return c->setError(GL_INVALID_OPERATION);
  }
  if (!inside(t, xoffset, yoffset, width, height)) return c->setError(GL_INVALID_VALUE);

  const render::Rect rect{x, y, width, height};
  if (!texture.replaceFromFramebuffer(*c, image.face, level, xoffset, yoffset, rect)) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}

GL_API void GL_APIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat,
                                               GLsizei width, GLsizei height, GLint border, GLsizei imageSize,
                                               const void* data) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  const PalettedFormat paletted = palettedFormat(internalformat);
  if (image.slot == kSlotCount || paletted.indexBits == 0) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, image.slot);
  // |level| + 1 levels, from level 0 on.
  if (level > 0 || level <= -texture.levels()) return c->setError(GL_INVALID_VALUE);
  if (!validSize(*c, image.slot, 0, width, height) || border != 0) return c->setError(GL_INVALID_VALUE);
  const int levels = 1 - level;
  if (imageSize != palettedSize(paletted, width, height, levels)) return c->setError(GL_INVALID_VALUE);

  std::array<std::unique_ptr<std::byte[]>, 32> texels;
  const std::byte* indices = static_cast<const std::byte*>(data) + (data ? paletted.paletteBytes() : 0);
  const auto sizeAt = [](GLsizei size, int i) { return size > 0 ? std::max(size >> i, 1) : 0; };
  for (int i = 0; data && i < levels; ++i) {
    const int w = sizeAt(width, i), h = sizeAt(height, i);
    if (w == 0 || h == 0) break;
    std::unique_ptr<std::byte[]>& decoded = texels[static_cast<size_t>(i)];
    decoded = allocateTexels(w, h, paletted.entry, false);
    if (!decoded) return c->setError(GL_OUT_OF_MEMORY);
    decodePaletted(paletted, data, indices, static_cast<size_t>(w) * static_cast<size_t>(h), decoded.get());
    indices += paletted.levelBytes(w, h);
  }
  for (int i = 0; i < levels; ++i) {
    if (!texture.specify(*c, image.face, i, sizeAt(width, i), sizeAt(height, i), internalformat,
                         paletted.entry, std::move(texels[static_cast<size_t>(i)]))) {
      return c->setError(GL_OUT_OF_MEMORY);
    }
  }
}

// No compressed format that there is takes sub-images (section 3.7.4).
GL_API void GL_APIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint, GLint, GLsizei width,
                                                  GLsizei height, GLenum, GLsizei imageSize, const void*) {
  Context* c = current();
  if (!c) return;
  const ImageTarget image = imageTarget(target);
  if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
  if (!validLevel(boundTexture(*c, image.slot), level) || width < 0 || height < 0 || imageSize < 0) {
    return c->setError(GL_INVALID_VALUE);
  }
  c->setError(GL_INVALID_OPERATION);
}
