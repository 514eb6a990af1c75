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
  int at = 0;
  while (at < to.immutableLevels() && !sameSize(to.at(0, at), from.at(0, base))) ++at;
  if (count > to.immutableLevels() - at) return -1;
  for (int i = 0; i < count; ++i) {
    if (!sameSize(to.at(0, at + i), from.at(0, base + i))) return -1;
  }
  return at;
}

// Whether the format can have all levels; one that is not compressed can.
bool compressibleLevels(GLenum internalFormat, const Extent& size, int levels) {
  const CompressedFormat* blocks = compressedFormat(internalFormat);
  for (int i = 0; blocks && i < levels; ++i) {
    if (!compressible(*blocks, std::max(size.width >> i, 1), std::max(size.height >> i, 1))) return false;
  }
  return true;
}

// TexStorage2DEXT and TexStorage3DEXT. `slot`: kSlotCount when the command takes no such target.
void storeLevels(GLenum target, TextureSlot slot, GLsizei levels, GLenum internalFormat, const Extent& size,
                 const char* advice, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const render::Format format = storageFormat(internalFormat);
  if (slot == kSlotCount || format == render::Format::None) {
    const bool known = slot != kSlotCount;
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum(known ? "internalformat" : "target", known ? internalFormat : target, advice), command);
  }
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, slot);
  if (levels < 1 || size.empty() || !validSize(*c, slot, 0, size)) {
    return c->setError(
        GL_INVALID_VALUE,
        levels < 1 ? wrongNumber("levels", levels, "Give one level or more") : wrongSize(slot, size, 0),
        command);
  }
  const unsigned largest = static_cast<unsigned>(std::max({size.width, size.height, size.depth}));
  const int most = static_cast<int>(std::bit_width(largest));
  if (levels > most)
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("levels", levels, "Give log2 of the largest size and 1 at most"), command);
  const bool compressedVolume = slot == kSlot3D && isCompressed(internalFormat);
  if (texture.name == 0 || texture.immutable() || compressedVolume)
    return c->setError(GL_INVALID_OPERATION,
                       compressedVolume
                           ? wrongState("The format is compressed", "Use a format such as RGBA8_OES")
                           : wrongState("The texture is the default one or immutable", "Bind a new texture"),
                       command);
  if (!compressibleLevels(internalFormat, size, levels))
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("width", size.width, "Give a size whose levels the format can have"),
                       command);
  texture.store(*c, levels, size, internalFormat, format);
}

}  // namespace

GL_API void GL_APIENTRY glTexStorage2DEXT(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                                          GLsizei height) {
  const TextureSlot slot = bindingSlot(target);
  storeLevels(target, slot == kSlot2D || slot == kSlotCube ? slot : kSlotCount, levels, internalformat,
              {width, height},
              "Use TEXTURE_2D or TEXTURE_CUBE_MAP_OES, and a sized format such as RGBA8_OES");
}

GL_API void GL_APIENTRY glTexStorage3DEXT(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                                          GLsizei height, GLsizei depth) {
  storeLevels(target, target == GL_TEXTURE_3D_OES ? kSlot3D : kSlotCount, levels, internalformat,
              {width, height, depth}, "Use TEXTURE_3D_OES, and a sized format such as RGBA8_OES");
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
  const int level = matchingLevel(*to, *from, sourceBaseLevel, sourceLevelCount);
  if (level < 0)
    return c->setError(GL_INVALID_OPERATION, wrongState("The destination has no levels of these sizes",
                                                        "Make it with the levels that are copied"));
  for (int i = 0; to != from && i < sourceLevelCount; ++i) {
    if (!to->copyLevel(*c, level + i, *from, sourceBaseLevel + i)) return c->setError(GL_OUT_OF_MEMORY);
  }
}
