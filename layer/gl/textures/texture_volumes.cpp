// OES_texture_3D: images of three dimensions. Slices follow each other in memory without gaps.
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

Fault wrongTarget(GLenum target) {
  return wrongEnum("target", target, "Use TEXTURE_3D_OES");
}

bool insideVolume(const TextureLevel& level, const Box& box) {
  return box.z >= 0 && box.size.depth <= level.depth && box.z <= level.depth - box.size.depth &&
         inside(level, box.x, box.y, box.size.width, box.size.height);
}

}  // namespace

GL_API void GL_APIENTRY glTexImage3DOES(GLenum target, GLint level, GLenum internalformat, GLsizei width,
                                        GLsizei height, GLsizei depth, GLint border, GLenum format,
                                        GLenum type, const void* pixels) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_3D_OES) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, kSlot3D);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (!isTexImageFormat(internalformat))
    return c->setError(GL_INVALID_VALUE, wrongEnum("internalformat", internalformat,
                                                   "Use a base format such as RGBA, the same as format"));
  if (!isPixelPair(format, type)) return c->setError(GL_INVALID_ENUM, wrongPixelPair(format, type));
  if (!validVolume(*c, level, width, height, depth) || border != 0)
    return c->setError(GL_INVALID_VALUE, wrongVolume(width, height, depth, border));
  if (!combines(internalformat, format, type) || texture.immutable())
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState("internalformat, format and type do not go together, or the texture is immutable",
                   "Use a row of table 3.8, such as RGBA, RGBA and UNSIGNED_BYTE"));
  const render::Format given = formatOf(format, type);
  const PixelRows rows{pixels, rowPitch(width, given, c->unpackAlignment), given};
  if (!texture.specify(*c, 0, level, {width, height, depth}, internalformat, rows))
    c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glTexSubImage3DOES(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                           GLint zoffset, GLsizei width, GLsizei height, GLsizei depth,
                                           GLenum format, GLenum type, const void* pixels) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_3D_OES) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, kSlot3D);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0 || depth < 0)
    return c->setError(GL_INVALID_VALUE, wrongVolume(width, height, depth, 0));
  if (!isPixelPair(format, type)) return c->setError(GL_INVALID_ENUM, wrongPixelPair(format, type));
  const TextureLevel& t = texture.at(0, level);
  const render::Format given = formatOf(format, type);
  if (!takesTexels(t.internalFormat, format) || given == render::Format::None)
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("The level was never specified, or has another format",
                                  "Use the format that glTexImage3DOES gave it"));
  const Box box{xoffset, yoffset, zoffset, {width, height, depth}};
  if (!insideVolume(t, box)) return c->setError(GL_INVALID_VALUE, outsideLevel());
  const PixelRows rows{pixels, rowPitch(width, given, c->unpackAlignment), given};
  if (!texture.replace(*c, 0, level, box, rows)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glCopyTexSubImage3DOES(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                               GLint zoffset, GLint x, GLint y, GLsizei width,
                                               GLsizei height) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_3D_OES) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, kSlot3D);
  if (!validLevel(texture, level)) return c->setError(GL_INVALID_VALUE, wrongLevel(level));
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, wrongSize(width, height, 0));
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable());
  const TextureLevel& t = texture.at(0, level);
  if (baseFormatOf(t.internalFormat) == 0 || !canCopy(c->readFramebuffer, t.internalFormat))
    return c->setError(GL_INVALID_OPERATION, cannotCopy());
  if (!insideVolume(t, {xoffset, yoffset, zoffset, {width, height, 1}}))
    return c->setError(GL_INVALID_VALUE, outsideLevel());
  if (!texture.replaceFromFramebuffer(*c, 0, level, xoffset, yoffset, zoffset, {x, y, width, height}))
    c->setError(GL_OUT_OF_MEMORY);
}

// No compressed format that is here has slices: no such image can be specified.
GL_API void GL_APIENTRY glCompressedTexImage3DOES(GLenum target, GLint, GLenum internalformat, GLsizei,
                                                  GLsizei, GLsizei, GLint, GLsizei, const void*) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_3D_OES) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  c->setError(GL_INVALID_ENUM, wrongEnum("internalformat", internalformat,
                                         "Use glTexImage3DOES: compressed formats have two dimensions"));
}

GL_API void GL_APIENTRY glCompressedTexSubImage3DOES(GLenum target, GLint, GLint, GLint, GLint, GLsizei,
                                                     GLsizei, GLsizei, GLenum format, GLsizei, const void*) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_3D_OES) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  c->setError(GL_INVALID_OPERATION, wrongEnum("format", format, "Use glTexSubImage3DOES: no level has it"));
}
