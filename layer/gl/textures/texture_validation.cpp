// What commands that specify images ask for, and what they say of their errors.
#include "layer/gl/textures/texture_validation.h"

#include <algorithm>

namespace anteroom::gl {

namespace {

CommandImage image(ImageTarget named, GLenum target, const char* advice, const char* command) {
  Context* c = current();
  if (!c) return {};
  if (named.slot != kSlotCount) return {c, command, named.slot, named.face};
  c->setError(GL_INVALID_ENUM, wrongEnum("target", target, advice), command);
  return {};
}

}  // namespace

CommandImage flatImage(GLenum target, const char* command) {
  return image(imageTarget(target), target,
               "Use TEXTURE_2D, or a face such as TEXTURE_CUBE_MAP_POSITIVE_X_OES", command);
}

CommandImage volumeImage(GLenum target, const char* command) {
  return image({target == GL_TEXTURE_3D_OES ? kSlot3D : kSlotCount}, target, "Use TEXTURE_3D_OES", command);
}

bool validSize(const Context& c, TextureSlot slot, GLint level, const Extent& size) {
  const render::Caps& caps = c.device.caps();
  const int largest = slot == kSlot3D     ? caps.maxVolumeSize
                      : slot == kSlotCube ? caps.maxCubeMapSize
                                          : caps.maxTextureSize;
  const int limit = std::max(largest >> level, 1);
  return std::min({size.width, size.height, size.depth}) >= 0 &&
         std::max({size.width, size.height, size.depth}) <= limit &&
         (slot != kSlotCube || size.width == size.height);
}

bool inside(const TextureLevel& level, const Box& box) {
  const auto within = [](int begin, int length, int all) {
    return begin >= 0 && length <= all && begin <= all - length;
  };
  return within(box.x, box.size.width, level.width) && within(box.y, box.size.height, level.height) &&
         within(box.z, box.size.depth, level.depth);
}

Fault wrongSize(TextureSlot slot, const Extent& size, GLint border) {
  if (border != 0) return wrongNumber("border", border, "Give 0");
  struct Side {
    const char* name;
    GLsizei length;
  };
  const Side sides[] = {{"width", size.width}, {"height", size.height}, {"depth", size.depth}};
  const bool flat = slot != kSlot3D;
  // A negative one, or else the largest.
  const Side* worst = std::max_element(sides, sides + (flat ? 2 : 3), [](const Side& a, const Side& b) {
    return static_cast<GLuint>(a.length) < static_cast<GLuint>(b.length);
  });
  return wrongNumber(
      worst->name, worst->length,
      flat
          ? "Give a size from 0 to MAX_TEXTURE_SIZE at level 0, half of it at each next one; faces are square"
          : "Give a size from 0 to MAX_3D_TEXTURE_SIZE_OES at level 0, half of it at each next one");
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
