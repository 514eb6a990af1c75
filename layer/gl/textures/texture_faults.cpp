// What commands that specify images ask for, and what they say of their errors.
#include "layer/gl/textures/texture_validation.h"

namespace anteroom::gl {

Fault wrongImageTarget(GLenum target) {
  return wrongEnum("target", target, "Use TEXTURE_2D, or a face such as TEXTURE_CUBE_MAP_POSITIVE_X_OES");
}

Fault wrongSize(GLsizei width, GLsizei height, GLint border) {
  if (border != 0) return wrongNumber("border", border, "Give 0");
  const bool ofHeight = height < 0 || (width >= 0 && height > width);
  return wrongNumber(
      ofHeight ? "height" : "width", ofHeight ? height : width,
      "Give a size from 0 to MAX_TEXTURE_SIZE at level 0, half of it at each next one; faces are square");
}

Fault wrongVolume(GLsizei width, GLsizei height, GLsizei depth, GLint border) {
  if (border != 0) return wrongNumber("border", border, "Give 0");
  const char* advice =
      "Give a size from 0 to MAX_3D_TEXTURE_SIZE_OES at level 0, half of it at each next one";
  if (width < 0 || (width >= height && width >= depth && height >= 0 && depth >= 0))
    return wrongNumber("width", width, advice);
  const bool ofHeight = height < 0 || (height >= depth && depth >= 0);
  return wrongNumber(ofHeight ? "height" : "depth", ofHeight ? height : depth, advice);
}

Fault wrongLevel(GLint level) {
  return wrongNumber("level", level, "Give a level from 0 to log2 of the largest size");
}

Fault wrongPixelPair(GLenum format, GLenum type) {
  const bool known = isPixelFormat(format);
  return wrongEnum(known ? "type" : "format", known ? type : format,
                   "Use a format such as RGBA and a type such as UNSIGNED_BYTE");
}

Fault cannotCopy() {
  return wrongState("The framebuffer lacks components of the texture, or the level takes none",
                    "Copy to a format with the framebuffer's components or fewer (table 3.9), of a level "
                    "that was specified");
}

Fault outsideLevel() {
  return wrongState("The rectangle does not lie inside the level",
                    "Keep xoffset + width and yoffset + height within its size");
}

Fault immutable() {
  return wrongState("The texture is immutable",
                    "Replace its texels with glTexSubImage2D, or use another texture");
}

bool canCopy(const render::Framebuffer& framebuffer, GLenum internalFormat) {
  if (!framebuffer.color.image) return false;
  const render::FormatInfo& has = render::info(framebuffer.color.image->desc().format);
  switch (baseFormatOf(internalFormat)) {
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

}  // namespace anteroom::gl
