// What the commands that specify images ask of their arguments (section 3.7.1).
#pragma once

#include "layer/gl/textures/texture.h"

namespace anteroom::gl {

// The image of the bound texture that a command's target names, and the command, for its errors.
struct CommandImage {
  Context* context = nullptr;  // null: there is none, or the target names no image and the error is set
  const char* command = nullptr;
  TextureSlot slot = kSlotCount;
  int face = 0;

  explicit operator bool() const { return context != nullptr; }
  Texture& texture() const { return boundTexture(*context, slot); }
  void error(GLenum code, const Fault& fault = {}) const { context->setError(code, fault, command); }
};
// TEXTURE_2D, or a face of the cube map.
CommandImage flatImage(GLenum target, const char* command = __builtin_FUNCTION());
// TEXTURE_3D_OES.
CommandImage volumeImage(GLenum target, const char* command = __builtin_FUNCTION());

inline bool validLevel(const Texture& texture, GLint level) {
  return level >= 0 && level < texture.levels();
}

// Sizes that a level can have; faces of cube maps are square.
bool validSize(const Context& c, TextureSlot slot, GLint level, const Extent& size);

// Whether the box, whose size is not negative, lies inside the level.
bool inside(const TextureLevel& level, const Box& box);

// Table 3.9: whether texels of the internal format can be copied from the framebuffer: components can be
// dropped, not added.
bool canCopy(const render::Framebuffer& framebuffer, GLenum internalFormat);

// The format and type of texels from the program: known, and together one of ours.
inline bool isPixelPair(GLenum format, GLenum type) {
  return isPixelFormat(format) && isPixelType(type);
}

Fault wrongLevel(GLint level);
Fault wrongSize(TextureSlot slot, const Extent& size, GLint border);
Fault wrongPixelPair(GLenum format, GLenum type);
Fault outsideLevel();
Fault cannotCopy();
Fault immutable();

}  // namespace anteroom::gl
