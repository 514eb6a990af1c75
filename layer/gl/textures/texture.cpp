// What a texture's levels are: specification, completeness, automatic mipmaps (sections 3.7.1 to 3.7.9).
#include "layer/gl/textures/texture.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>

#include "layer/gl/textures/texture_upload.h"

namespace anteroom::gl {

using render::Format;
using render::Rect;

namespace {

int log2Floor(int value) {
  return std::bit_width(static_cast<unsigned>(value)) - 1;
}

int levelCountFor(TextureSlot slot, const render::Caps& caps) {
  switch (slot) {
    case kSlot2D:
      return log2Floor(std::max(caps.maxTextureSize, 1)) + 1;
    case kSlotCube:
      return log2Floor(std::max(caps.maxCubeMapSize, 1)) + 1;
    case kSlotExternal:
      return 1;
    default:
      return log2Floor(std::max(caps.maxVolumeSize, 1)) + 1;
  }
}

}  // namespace

std::unique_ptr<std::byte[]> allocateTexels(int width, int height, Format format, bool zeroed) {
  const size_t bytes = rowPitch(width, format, 1) * static_cast<size_t>(height);
  std::byte* texels = zeroed ? new (std::nothrow) std::byte[bytes]() : new (std::nothrow) std::byte[bytes];
  return std::unique_ptr<std::byte[]>(texels);
}

Texture::Texture(GLuint textureName, TextureSlot textureSlot, const render::Caps& caps)
    : name(textureName), slot(textureSlot), levels_() {
  levels_.resize(static_cast<size_t>(faces() * levelCountFor(slot, caps)));
  if (slot != kSlotExternal) return;
  // OES_EGL_image_external, 3.7.10 and 3.7.14. Without an image, samples are (0, 0, 0, 1).
  sampler.minFilter = GL_LINEAR;
  sampler.wrapS = sampler.wrapT = GL_CLAMP_TO_EDGE;
  TextureLevel& black = edit(0, 0);
  black.width = black.height = 1;
  black.internalFormat = GL_RGB;
  black.format = Format::RGB8;
}

void Texture::changed(Context& c) {
  ready_ = false;
  c.group->tell(gen::kGroupTextures | gen::kGroupFramebuffer);
}

// Specification.

// Slices without gaps are rows that go on: texels are converted as if they were one tall image.
bool Texture::specify(Context& c, int face, int level, const Extent& size, GLenum internalFormat,
                      const PixelRows& rows) {
  TextureLevel& t = edit(face, level);
  const int width = size.width, rowCount = size.height * size.depth;
  const Format stored = storedFormat(rows.format);
  const bool inPlace = !import_ && !hasShared() && t.home && t.extent() == size && t.format == stored &&
                       t.internalFormat == internalFormat;
  if (!inPlace) {
    std::unique_ptr<std::byte[]> texels;
    if (rows.data && !size.empty()) {
      texels = allocateTexels(width, rowCount, stored, false);
      if (!texels) return false;
      convertRows(rows, width, rowCount, stored, texels.get(), rowPitch(width, stored, 1));
    }
    return specify(c, face, level, size, internalFormat, stored, std::move(texels));
  }
  if (level == 0 && !keepDerived(c, face, size, internalFormat)) return false;
  if (rows.data) {
    const Place place = placeOf(face, level);
    const render::Region all{place.level, place.layer, 0, 0, 0, width, size.height, size.depth};
    if (!upload(c, *place.image, all, rows)) return false;
  }
  if (level == 0) baseChanged(c, face);
  return true;
}

bool Texture::specify(Context& c, int face, int level, const Extent& size, GLenum internalFormat,
                      Format format, std::unique_ptr<std::byte[]> texels) {
  if (level == 0 && !keepDerived(c, face, size, internalFormat)) return false;
  if (!leaveSiblings(c, face, level)) return false;
  releaseImport(c);
  TextureLevel specified;
  specified.width = size.width;
  specified.height = size.height;
  specified.depth = size.depth;
  specified.internalFormat = internalFormat;
  specified.format = format;
  specified.pending = std::move(texels);
  edit(face, level) = std::move(specified);
  changed(c);
  if (level == 0) baseChanged(c, face);
  return true;
}

void Texture::store(Context& c, int levelCount, const Extent& size, GLenum internalFormat, Format format) {
  releaseImport(c);
  for (TextureLevel& t : levels_) t = TextureLevel{};
  image_ = nullptr;
  target_ = false;
  immutableLevels_ = levelCount;
  for (int face = 0; face < faces(); ++face) {
    for (int level = 0; level < levelCount; ++level) {
      TextureLevel& t = edit(face, level);
      t.width = std::max(size.width >> level, 1);
      t.height = std::max(size.height >> level, 1);
      t.depth = std::max(size.depth >> level, 1);
      t.internalFormat = internalFormat;
      t.format = format;
    }
  }
  changed(c);
}

bool Texture::replace(Context& c, int face, int level, const Box& box, const PixelRows& rows) {
  const Extent& size = box.size;
  if (size.empty() || !rows.data) return true;
  TextureLevel& t = edit(face, level);
  if (t.derived && !computeDerived(c, face)) return false;
  if (level == 0 && !keepDerived(c, face, t.extent(), t.internalFormat)) return false;
  if (t.home) {
    const Place place = placeOf(face, level);
    const render::Region region{place.level, place.layer, box.x,       box.y,
                                box.z,       size.width,  size.height, size.depth};
    if (!upload(c, *place.image, region, rows)) return false;
  } else {
    if (!t.pending) t.pending = allocateTexels(t.width, t.height * t.depth, t.format, !(size == t.extent()));
    if (!t.pending) return false;
    const size_t pitch = rowPitch(t.width, t.format, 1);
    PixelRows slice = rows;
    for (int z = box.z; z < box.z + size.depth; ++z) {
      const size_t row = static_cast<size_t>(z) * static_cast<size_t>(t.height) + static_cast<size_t>(box.y);
      const size_t offset = row * pitch + static_cast<size_t>(box.x) * render::info(t.format).bytes;
      convertRows(slice, size.width, size.height, t.format, t.pending.get() + offset, pitch);
      slice.data = static_cast<const std::byte*>(slice.data) + slice.pitch * static_cast<size_t>(size.height);
    }
  }
  if (level == 0) baseChanged(c, face);
  return true;
}

bool Texture::specifyFromFramebuffer(Context& c, int face, int level, const Rect& rect, GLenum internalFormat,
                                     Format format) {
  const render::Framebuffer& source = c.readFramebuffer;
  const int width = rect.width, height = rect.height;
  const Extent size{width, height};
  if (size.empty()) return specify(c, face, level, size, internalFormat, format, nullptr);
  if (level == 0 && !keepDerived(c, face, size, internalFormat)) return false;
  if (!leaveSiblings(c, face, level)) return false;

  const TextureLevel& old = at(face, level);
  Place place;
  bool fresh = false;
  if (!import_ && old.home && old.width == width && old.height == height &&
      old.home->desc().format == format) {
    place = placeOf(face, level);
  } else if (!import_ && !hasDerived(face) && usable(image_, format, size, level)) {
    place = {image_, level, face};
  } else {
    const bool mipmaps = level == 0 && generateMipmap && usesMipmaps();
    place = {createImage(c, format, size, mipmaps ? chainLength(size) : 1), 0, face};
    fresh = true;
  }
  if (!place.image) return false;
  const render::Region region{place.level, place.layer, 0, 0, 0, width, height, 1};
  if (fresh && !covers(source, rect) && !clear(c, *place.image, region)) return false;
  if (!c.renderer->copyFromFramebuffer(*place.image, region, source, rect.x, rect.y)) return false;

  releaseImport(c);
  TextureLevel specified;
  specified.width = width;
  specified.height = height;
  specified.internalFormat = internalFormat;
  specified.format = format;
  specified.home = place.image;
  specified.homeLevel = place.level;
  edit(face, level) = std::move(specified);
  if (level == 0) image_ = place.image;
  changed(c);
  if (level == 0) baseChanged(c, face);
  return true;
}

bool Texture::replaceFromFramebuffer(Context& c, int face, int level, int x, int y, int z, const Rect& rect) {
  if (rect.width == 0 || rect.height == 0) return true;
  const TextureLevel& t = at(face, level);
  if (level == 0 && !keepDerived(c, face, t.extent(), t.internalFormat)) return false;
  if (!placeInImage(c, face, level)) return false;
  const Place place = placeOf(face, level);
  const render::Region region{place.level, place.layer, x, y, z, rect.width, rect.height, 1};
  if (!c.renderer->copyFromFramebuffer(*place.image, region, c.readFramebuffer, rect.x, rect.y)) return false;
  if (level == 0) baseChanged(c, face);
  return true;
}

// Images of EGL.

void Texture::import(Context& c, const std::shared_ptr<render::Image>& image, GLenum internalFormat) {
  for (TextureLevel& t : levels_) t = TextureLevel{};
  TextureLevel& base = edit(0, 0);
  base.width = image->desc().width;
  base.height = image->desc().height;
  base.internalFormat = internalFormat;
  base.format = image->desc().format;
  base.home = image;
  image_ = import_ = image;
  target_ = false;
  changed(c);
  baseChanged(c, 0);
}

// EGL 1.5, 3.6.2: levels that the color buffer defined become null.
void Texture::releaseImport(Context& c) {
  if (!import_) return;
  for (TextureLevel& t : levels_) {
    if (t.home == import_) t = TextureLevel{};
  }
  image_ = import_ = nullptr;
  changed(c);
}

// Completeness.

bool Texture::usesMipmaps() const {
  return sampler.minFilter != GL_NEAREST && sampler.minFilter != GL_LINEAR;
}

int Texture::chainLength(const Extent& base) const {
  const int length = std::min(log2Floor(std::max({base.width, base.height, base.depth, 1})) + 1, levels());
  return immutable() ? std::min(length, immutableLevels_) : length;  // EXT_texture_storage, p
}

Extent Texture::levelExtent(int level) const {
  const TextureLevel& base = at(0, 0);
  return {std::max(base.width >> level, 1), std::max(base.height >> level, 1),
          std::max(base.depth >> level, 1)};
}

int Texture::sampledLevels() const {
  if (!usesMipmaps()) return 1;
  const int length = chainLength(at(0, 0).extent());
  return sampler.maxLevel < length ? sampler.maxLevel + 1 : length;
}

bool Texture::chainComplete(int face) const {
  const TextureLevel& base = at(face, 0);
  const int length = sampledLevels();
  for (int level = 1; level < length; ++level) {
    const TextureLevel& t = at(face, level);
    // OES_required_internalformat: and the same type, where the internal format is a sized one.
    if (t.format != base.format && isSized(base.internalFormat)) return false;
    if (t.internalFormat != base.internalFormat || t.extent() != levelExtent(level)) return false;
  }
  return true;
}

bool Texture::baseComplete() const {
  const TextureLevel& base = at(0, 0);
  if (base.null()) return false;
  for (int face = 0; face < faces(); ++face) {
    const TextureLevel& t = at(face, 0);
    if (slot == kSlotCube && t.width != t.height) return false;
    if (t.extent() != base.extent() || t.internalFormat != base.internalFormat) return false;
  }
  return true;
}

bool Texture::complete() const {
  if (ready_) return true;
  if (!baseComplete()) return false;
  for (int face = 0; usesMipmaps() && face < faces(); ++face) {
    if (!chainComplete(face)) return false;
  }
  return true;
}

bool Texture::switchesLate() const {
  const bool nearest =
      sampler.minFilter == GL_NEAREST_MIPMAP_NEAREST || sampler.minFilter == GL_NEAREST_MIPMAP_LINEAR;
  return sampler.magFilter == GL_LINEAR && nearest && at(0, 0).extent() != Extent{1, 1, 1};
}

bool Texture::canGenerateMipmaps() const {
  if (!baseComplete() || isSrgb(at(0, 0).internalFormat)) return false;  // EXT_sRGB
  return !import_ || import_->desc().levels >= chainLength(at(0, 0).extent());
}

// At once: level 0 may be drawn to before a derived level is needed.
bool Texture::generateMipmaps(Context& c) {
  if (!holdsChain(chainLength(at(0, 0).extent())) && !leaveSiblings(c)) return false;
  for (int face = 0; face < faces(); ++face) deriveChain(c, face);
  return gatherLevels(c, chainLength(at(0, 0).extent()));
}

// Automatic mipmap generation (section 3.7.7). It is put off until a derived level is needed.

bool Texture::derives(GLenum internalFormat) const {
  return generateMipmap && !isCompressed(internalFormat) && !isSrgb(internalFormat);
}

bool Texture::hasDerived(int face, int from) const {
  for (int level = from; level < levels(); ++level) {
    if (at(face, level).derived) return true;
  }
  return false;
}

// Before the base level becomes such a one: derived levels are computed from it as it is, unless they will be
// derived anew.
bool Texture::keepDerived(Context& c, int face, const Extent& size, GLenum internalFormat) {
  const bool again = derives(internalFormat) && !size.empty();
  return !hasDerived(face, again ? chainLength(size) : 1) || computeDerived(c, face);
}

void Texture::baseChanged(Context& c, int face) {
  const TextureLevel& base = at(face, 0);
  if (base.null() || !derives(base.internalFormat)) return;
  const int length = chainLength(base.extent());
  if (import_ && import_->desc().levels < length) return;  // EGL_MIPMAP_TEXTURE is off
  if (!holdsChain(length) && !leaveSiblings(c)) return c.setError(GL_OUT_OF_MEMORY);
  deriveChain(c, face);
  // Siblings do not ask for what is put off.
  if (hasShared() && !gatherLevels(c, length)) c.setError(GL_OUT_OF_MEMORY);
}

void Texture::deriveChain(Context& c, int face) {
  const TextureLevel& base = at(face, 0);
  const int length = chainLength(base.extent());
  for (int level = 1; level < length; ++level) {
    TextureLevel derived;
    derived.width = std::max(base.width >> level, 1);
    derived.height = std::max(base.height >> level, 1);
    derived.depth = std::max(base.depth >> level, 1);
    derived.internalFormat = base.internalFormat;
    derived.format = base.format;
    derived.derived = true;
    derived.shared = at(face, level).shared;
    edit(face, level) = std::move(derived);
  }
  changed(c);
}

}  // namespace anteroom::gl
