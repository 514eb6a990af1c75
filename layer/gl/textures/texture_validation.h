// What the commands that specify images ask of their arguments (section 3.7.1).
#pragma once

#include <algorithm>

#include "layer/gl/textures/texture.h"

namespace anteroom::gl {

inline bool validLevel(const Texture& texture, GLint level) {
  return level >= 0 && level < texture.levels();
}

// Sizes that a level can have; faces of cube maps are square.
inline bool validSize(const Context& c, TextureSlot slot, GLint level, GLsizei width, GLsizei height) {
  const render::Caps& caps = c.device.caps();
  const int limit = std::max((slot == kSlotCube ? caps.maxCubeMapSize : caps.maxTextureSize) >> level, 1);
  if (width < 0 || height < 0 || width > limit || height > limit) return false;
  return slot != kSlotCube || width == height;
}

inline bool validVolume(const Context& c, GLint level, GLsizei width, GLsizei height, GLsizei depth) {
  const int limit = std::max(c.device.caps().maxVolumeSize >> level, 1);
  return std::min({width, height, depth}) >= 0 && std::max({width, height, depth}) <= limit;
}

inline bool inside(const TextureLevel& level, GLint x, GLint y, GLsizei width, GLsizei height) {
  return x >= 0 && y >= 0 && width <= level.width && height <= level.height && x <= level.width - width &&
         y <= level.height - height;
}

// Table 3.9: whether texels of the internal format can be copied from the framebuffer: components can be
// dropped, not added.
bool canCopy(const render::Framebuffer& framebuffer, GLenum internalFormat);

// The format and type of texels from the program: known, and together one of ours.
inline bool isPixelPair(GLenum format, GLenum type) {
  return isPixelFormat(format) && isPixelType(type);
}

Fault wrongLevel(GLint level);
Fault wrongPixelPair(GLenum format, GLenum type);
Fault cannotCopy();

}  // namespace anteroom::gl
