// Where a texture's texels are: how levels get into images, and when.
#include <algorithm>

#include "layer/gl/debug/tool_names.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/textures/texture_upload.h"

namespace anteroom::gl {

using render::Dimension;
using render::Format;
using render::Image;

bool upload(Context& c, Image& image, const render::Region& region, const PixelRows& rows) {
  const Format format = image.desc().format;
  const size_t height = static_cast<size_t>(region.height);
  if (rows.format == format)
    return c.renderer->upload(image, region, rows.data, rows.pitch, rows.pitch * height);
  const int rowCount = region.height * region.depth;
  const std::unique_ptr<std::byte[]> texels = allocateTexels(region.width, rowCount, format, false);
  if (!texels) return false;
  const size_t pitch = rowPitch(region.width, format, 1);
  convertRows(rows, region.width, rowCount, format, texels.get(), pitch);
  return c.renderer->upload(image, region, texels.get(), pitch, pitch * height);
}

bool clear(Context& c, Image& image, const render::Region& region) {
  const Format format = image.desc().format;
  const std::unique_ptr<std::byte[]> texels = allocateTexels(region.width, region.height, format, true);
  return texels && c.renderer->upload(image, region, texels.get(), rowPitch(region.width, format, 1), 0);
}

bool covers(const render::Framebuffer& framebuffer, const render::Rect& rect) {
  return rect.x >= 0 && rect.y >= 0 && rect.width <= framebuffer.width && rect.height <= framebuffer.height &&
         rect.x <= framebuffer.width - rect.width && rect.y <= framebuffer.height - rect.height;
}

Texture::Place Texture::placeOf(int face, int level) const {
  const TextureLevel& t = at(face, level);
  if (t.isShared()) return {t.shared->image, t.shared->level, t.shared->layer};
  return {t.home, t.homeLevel, t.home && t.home->desc().dimension == Dimension::Cube ? face : 0};
}

// Whether level `level` of `image` is such a one.
bool Texture::usable(const std::shared_ptr<Image>& image, Format format, const Extent& size,
                     int level) const {
  if (!image) return false;
  const render::ImageDesc& desc = image->desc();
  const auto at = [level](int base) { return std::max(base >> level, 1); };
  return level < desc.levels && desc.format == format &&
         size == Extent{at(desc.width), at(desc.height), at(desc.depth)};
}

std::shared_ptr<Image> Texture::createImage(Context& c, Format format, const Extent& size,
                                            int levelCount) const {
  render::ImageDesc desc;
  desc.dimension = slot == kSlotCube ? Dimension::Cube
                   : slot == kSlot3D ? Dimension::Volume
                                     : Dimension::Flat;
  desc.format = format;
  desc.width = size.width;
  desc.height = size.height;
  desc.depth = size.depth;
  desc.levels = levelCount;
  std::shared_ptr<Image> image = c.device.createImage(desc);
  if (image) nameImage(c, *image, "texture", name, label);
  return image;
}

void Texture::labelChanged(const Context& c) const {
  if (image_ && !import_) nameImage(c, *image_, "texture", name, label);
}

// Levels of one internal format may have been given in different types: the format that holds them all.
Format Texture::commonFormat(int levelCount) const {
  const Format format = at(0, 0).format;
  for (int face = 0; face < faces(); ++face) {
    for (int level = 0; level < levelCount; ++level) {
      if (at(face, level).format != format) return widest(format);
    }
  }
  return format;
}

bool Texture::copyTexels(Context& c, int face, int level, const Place& to) const {
  const TextureLevel& t = at(face, level);
  render::Region region{to.level, to.layer, 0, 0, 0, t.width, t.height, t.depth};
  if (t.pending) {
    return upload(c, *to.image, region, {t.pending.get(), rowPitch(t.width, t.format, 1), t.format});
  }
  if (!t.home) return true;
  const render::ImageDesc &from = t.home->desc(), &into = to.image->desc();
  if (from.dimension == into.dimension && from.dimension != Dimension::Cube && from.format == into.format) {
    return c.renderer->copyLevel(*to.image, to.level, *t.home, t.homeLevel);
  }
  const Place source = placeOf(face, level);
  render::Framebuffer framebuffer;
  framebuffer.width = t.width;
  framebuffer.height = t.height;
  region.depth = 1;
  for (region.z = 0; region.z < t.depth; ++region.z) {
    framebuffer.color = {source.image, source.level, source.layer + region.z};
    if (!c.renderer->copyFromFramebuffer(*to.image, region, framebuffer, 0, 0)) return false;
  }
  return true;
}

// Makes `to` the place of a level's texels.
bool Texture::move(Context& c, int face, int level, const std::shared_ptr<Image>& to, int toLevel) {
  TextureLevel& t = edit(face, level);
  if (t.home == to && t.homeLevel == toLevel) return true;
  const int layer = to->desc().dimension == Dimension::Cube ? face : 0;
  if (!copyTexels(c, face, level, {to, toLevel, layer})) return false;
  t.pending.reset();
  t.home = to;
  t.homeLevel = toLevel;
  return true;
}

bool Texture::moveFaces(Context& c, int level, const std::shared_ptr<Image>& to) {
  const std::shared_ptr<Image> home = at(0, level).home;
  const int homeLevel = at(0, level).homeLevel;
  bool together = slot == kSlotCube && home && home != to && home->desc().format == to->desc().format &&
                  home->desc().dimension == Dimension::Cube;
  for (int face = 0; face < faces(); ++face) {
    together = together && at(face, level).home == home && at(face, level).homeLevel == homeLevel;
  }
  if (together) {
    if (!c.renderer->copyLevel(*to, level, *home, homeLevel)) return false;
    for (int face = 0; face < faces(); ++face) {
      edit(face, level).home = to;
      edit(face, level).homeLevel = level;
    }
    return true;
  }
  for (int face = 0; face < faces(); ++face) {
    if (!move(c, face, level, to, level)) return false;
  }
  return true;
}

// Derived levels of all faces, into an image that becomes their place. While a face has derived levels, none
// of its levels but the base lives in image_, so nothing is lost.
bool Texture::deriveInto(Context& c, const std::shared_ptr<Image>& image) {
  if (!moveFaces(c, 0, image) || !c.renderer->generateMipmaps(*image)) return false;
  for (int face = 0; face < faces(); ++face) {
    for (int level = 1; level < image->desc().levels; ++level) {
      TextureLevel& t = edit(face, level);
      if (!t.derived) continue;
      t.derived = false;
      t.home = image;
      t.homeLevel = level;
    }
  }
  return true;
}

// Computes the derived levels of one face, in an image of its own.
bool Texture::computeDerived(Context& c, int face) {
  const TextureLevel& base = at(face, 0);
  const int length = chainLength(base.extent());
  render::ImageDesc desc;
  desc.dimension = slot == kSlot3D ? Dimension::Volume : Dimension::Flat;
  desc.format = base.format;
  desc.width = base.width;
  desc.height = base.height;
  desc.depth = base.depth;
  desc.levels = length;
  const std::shared_ptr<Image> image = c.device.createImage(desc);
  if (!image || !copyTexels(c, face, 0, {image, 0, 0}) || !c.renderer->generateMipmaps(*image)) return false;
  for (int level = 1; level < length; ++level) {
    TextureLevel& t = edit(face, level);
    if (!t.derived) continue;
    t.derived = false;
    t.home = image;
    t.homeLevel = level;
  }
  changed(c);
  return true;
}

// Brings levels 0 to levelCount - 1, which fit together, into image_.
bool Texture::gatherLevels(Context& c, int levelCount) {
  const TextureLevel& base = at(0, 0);
  const Format format = commonFormat(levelCount);
  std::shared_ptr<Image> image = image_;
  if (!usable(image, format, base.extent(), 0) || image->desc().levels < levelCount) {
    image = createImage(c, format, base.extent(), levelCount);
    if (!image) return false;
  }
  bool any = false, all = true;
  for (int face = 0; face < faces(); ++face) {
    const bool derived = levelCount > 1 && hasDerived(face);
    any = any || derived;
    all = all && derived;
  }
  if (any && all && !deriveInto(c, image)) return false;
  for (int face = 0; any && !all && face < faces(); ++face) {
    if (hasDerived(face) && !computeDerived(c, face)) return false;
  }
  for (int level = 0; level < levelCount; ++level) {
    if (!moveFaces(c, level, image)) return false;
  }
  if (image != image_) {
    image_ = image;
    changed(c);
  }
  return true;
}

const std::shared_ptr<Image>& Texture::sampled(Context& c) {
  static const std::shared_ptr<Image> kNone;
  if (ready_) return image_;
  if (!target_ && !gatherLevels(c, sampledLevels())) return kNone;
  ready_ = true;
  return image_;
}

// Gives one level, whatever the others are, a place in an image.
bool Texture::placeInImage(Context& c, int face, int level) {
  if (level > 0 && hasDerived(face) && !computeDerived(c, face)) return false;
  const TextureLevel& t = at(face, level);
  if (t.home) return true;
  if (level == 0 && complete()) return sampled(c) != nullptr;
  if (!usable(image_, t.format, t.extent(), level)) {
    const std::shared_ptr<Image> image = createImage(c, t.format, t.extent(), 1);
    if (!image || !move(c, face, level, image, 0)) return false;
    if (level == 0) image_ = image;
    return true;
  }
  return move(c, face, level, image_, level);
}

bool Texture::copyLevel(Context& c, int level, Texture& source, int sourceLevel) {
  for (int face = 0; face < faces(); ++face) {
    if (source.hasDerived(face) && !source.computeDerived(c, face)) return false;
    if (hasDerived(face) && !computeDerived(c, face)) return false;
    if (!placeInImage(c, face, level) || !source.copyTexels(c, face, sourceLevel, placeOf(face, level)))
      return false;
    if (level == 0) baseChanged(c, face);
  }
  return true;
}

render::Attachment Texture::attachment(Context& c, int face, int level, int slice) {
  if (hasDerived(face) && !computeDerived(c, face)) return {};
  if (!placeInImage(c, face, level)) return {};
  const Place place = placeOf(face, level);
  return {place.image, place.level, place.layer + slice};
}

}  // namespace anteroom::gl
