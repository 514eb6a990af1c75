// EXT_texture_storage and APPLE_copy_texture_levels.
#include <algorithm>
#include <bit>

#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/texture_validation.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

bool sameSize(const TextureLevel& a, const TextureLevel& b) {
  return a.extent() == b.extent();
}

// The level of `to` at which `count` levels have the sizes of those of `from` that begin at `base`. -1: none.
int matchingLevel(const Texture& to, const Texture& from, int base, int count) {
  int first = 0;
  while (first < to.immutableLevels() && !sameSize(to.at(0, first), from.at(0, base))) ++first;
  if (count > to.immutableLevels() - first) return -1;
  for (int i = 0; i < count; ++i) {
    if (!sameSize(to.at(0, first + i), from.at(0, base + i))) return -1;
  }
  return first;
}

}  // namespace

GL_API void GL_APIENTRY glTexStorage2DEXT(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                                          GLsizei height) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = bindingSlot(target);
  const render::Format format = storageFormat(internalformat);
  if ((slot != kSlot2D && slot != kSlotCube) || format == render::Format::None) {
    const bool known = slot == kSlot2D || slot == kSlotCube;
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum(known ? "internalformat" : "target", known ? internalformat : target,
                  "Use TEXTURE_2D or TEXTURE_CUBE_MAP_OES, and a sized format such as RGBA8_OES"));
  }
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, slot);
  if (levels < 1 || width < 1 || height < 1 || !validSize(*c, slot, 0, width, height)) {
    return c->setError(GL_INVALID_VALUE, levels < 1 ? wrongNumber("levels", levels, "Give one level or more")
                                                    : wrongSize(width, height, 0));
  }
  const CompressedFormat* blocks = compressedFormat(internalformat);
  const int most = static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
  if (texture.name == 0 || texture.immutable() || levels > most)
    return c->setError(GL_INVALID_OPERATION,
                       levels > most
                           ? wrongNumber("levels", levels, "Give log2 of the larger size and 1 at most")
                           : wrongState("The texture is the default one or immutable", "Bind a new texture"));
  for (int i = 0; blocks && i < levels; ++i) {
    const bool fits = compressible(*blocks, std::max(width >> i, 1), std::max(height >> i, 1));
    if (!fits)
      return c->setError(GL_INVALID_OPERATION,
                         wrongNumber("width", width, "Give a size whose levels the format can have"));
  }
  texture.store(*c, levels, {width, height}, internalformat, format);
}

GL_API void GL_APIENTRY glTexStorage3DEXT(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                                          GLsizei height, GLsizei depth) {
  Context* c = current();
  if (!c) return;
  const render::Format format = storageFormat(internalformat);
  if (target != GL_TEXTURE_3D_OES || format == render::Format::None) {
    const bool known = target == GL_TEXTURE_3D_OES;
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum(known ? "internalformat" : "target", known ? internalformat : target,
                                 "Use TEXTURE_3D_OES, and a sized format such as RGBA8_OES"));
  }
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, kSlot3D);
  if (levels < 1 || std::min({width, height, depth}) < 1 || !validVolume(*c, 0, width, height, depth)) {
    return c->setError(GL_INVALID_VALUE, levels < 1 ? wrongNumber("levels", levels, "Give one level or more")
                                                    : wrongVolume(width, height, depth, 0));
  }
  const int most = static_cast<int>(std::bit_width(static_cast<unsigned>(std::max({width, height, depth}))));
  if (texture.name == 0 || texture.immutable() || levels > most || isCompressed(internalformat))
    return c->setError(
        GL_INVALID_OPERATION,
        levels > most ? wrongNumber("levels", levels, "Give log2 of the largest size and 1 at most")
                      : wrongState("The texture is the default one or immutable, or the format is compressed",
                                   "Bind a new texture, and use a format such as RGBA8_OES"));
  texture.store(*c, levels, {width, height, depth}, internalformat, format);
}

GL_API void GL_APIENTRY glCopyTextureLevelsAPPLE(GLuint destinationTexture, GLuint sourceTexture,
                                                 GLint sourceBaseLevel, GLsizei sourceLevelCount) {
  Context* c = current();
  if (!c) return;
  if (destinationTexture == 0 || sourceTexture == 0)
    return c->setError(GL_INVALID_VALUE,
                       wrongState("One of the textures is 0", "Give two textures of glGenTextures"));
  ShareLock lock(*c->group);
  const std::shared_ptr<Texture> to = c->group->textures.find(destinationTexture);
  const std::shared_ptr<Texture> from = c->group->textures.find(sourceTexture);
  if (!to || !from || !to->immutable() || !from->immutable() || to->slot != from->slot ||
      to->at(0, 0).internalFormat != from->at(0, 0).internalFormat) {
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("The textures are not immutable, or differ in target or format",
                                  "Make both with glTexStorage2DEXT alike"));
  }
  if (sourceBaseLevel < 0 || sourceBaseLevel >= from->immutableLevels() || sourceLevelCount < 1 ||
      sourceLevelCount > from->immutableLevels() - sourceBaseLevel) {
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber("sourceBaseLevel", sourceBaseLevel, "Give levels that the source has"));
  }
  const int first = matchingLevel(*to, *from, sourceBaseLevel, sourceLevelCount);
  if (first < 0)
    return c->setError(GL_INVALID_OPERATION, wrongState("The destination has no levels of these sizes",
                                                        "Make it with the levels that are copied"));
  for (int i = 0; to != from && i < sourceLevelCount; ++i) {
    if (!to->copyLevel(*c, first + i, *from, sourceBaseLevel + i)) return c->setError(GL_OUT_OF_MEMORY);
  }
}
