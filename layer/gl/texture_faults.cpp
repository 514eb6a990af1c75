// What commands that specify images say of their errors.
#include "layer/gl/texture.h"

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

Fault outsideLevel() {
  return wrongState("The rectangle does not lie inside the level",
                    "Keep xoffset + width and yoffset + height within its size");
}

Fault immutable() {
  return wrongState("The texture is immutable",
                    "Replace its texels with glTexSubImage2D, or use another texture");
}

}  // namespace anteroom::gl
