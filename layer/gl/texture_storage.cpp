// Where a texture's texels are: how levels get into images, and when.
#include <algorithm>

#include "layer/gl/texture.h"
#include "layer/gl/texture_upload.h"

namespace anteroom::gl {

using render::Dimension;
using render::Format;
using render::Image;

bool upload(Context& c, Image& image, const render::Region& region, const PixelRows& rows) {
  const Format format = image.desc().format;
  if (rows.format == format) return c.renderer->upload(image, region, rows.data, rows.pitch, 0);
  const std::unique_ptr<std::byte[]> texels = allocateTexels(region.width, region.height, format, false);
  if (!texels) return false;
  const size_t pitch = rowPitch(region.width, format, 1);
  convertRows(rows, region.width, region.height, format, texels.get(), pitch);
  return c.renderer->upload(image, region, texels.get(), pitch, 0);
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
bool Texture::usable(const std::shared_ptr<Image>& image, Format format, int width, int height,
                     int level) const {
  if (!image) return false;
  const render::ImageDesc& desc = image->desc();
  return level < desc.levels && desc.format == format && width == std::max(desc.width >> level, 1) &&
         height == std::max(desc.height >> level, 1);
}

std::shared_ptr<Image> Texture::createImage(Context& c, Format format, int width, int height,
                                            int levelCount) const {
  render::ImageDesc desc;
  desc.dimension = slot == kSlotCube ? Dimension::Cube : Dimension::Flat;
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.levels = levelCount;
  std::shared_ptr<Image> image = c.device.createImage(desc);
  if (image && !label.empty()) image->setLabel(label);
  return image;
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
  const render::Region region{to.level, to.layer, 0, 0, 0, t.width, t.height, 1};
  if (t.pending) {
    return upload(c, *to.image, region, {t.pending.get(), rowPitch(t.width, t.format, 1), t.format});
  }
  if (!t.home) return true;
  const render::ImageDesc &from = t.home->desc(), &into = to.image->desc();
  if (from.dimension == Dimension::Flat && into.dimension == Dimension::Flat && from.format == into.format) {
    return c.renderer->copyLevel(*to.image, to.level, *t.home, t.homeLevel);
  }
  const Place source = placeOf(face, level);
  render::Framebuffer framebuffer;
  framebuffer.color = {source.image, source.level, source.layer};
  framebuffer.width = t.width;
  framebuffer.height = t.height;
  return c.renderer->copyFromFramebuffer(*to.image, region, framebuffer, 0, 0);
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
bool Texture::settle(Context& c, int face) {
  const TextureLevel& base = at(face, 0);
  const int length = chainLength(base.width, base.height);
  render::ImageDesc desc;
  desc.format = base.format;
  desc.width = base.width;
  desc.height = base.height;
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
bool Texture::realise(Context& c, int levelCount) {
  const TextureLevel& base = at(0, 0);
  const Format format = commonFormat(levelCount);
  std::shared_ptr<Image> image = image_;
  if (!usable(image, format, base.width, base.height, 0) || image->desc().levels < levelCount) {
    image = createImage(c, format, base.width, base.height, levelCount);
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
    if (hasDerived(face) && !settle(c, face)) return false;
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
  if (!target_ && !realise(c, sampledLevels())) return kNone;
  ready_ = true;
  return image_;
}

// Gives one level, whatever the others are, a place in an image.
bool Texture::reside(Context& c, int face, int level) {
  if (level > 0 && hasDerived(face) && !settle(c, face)) return false;
  const TextureLevel& t = at(face, level);
  if (t.home) return true;
  if (level == 0 && complete()) return sampled(c) != nullptr;
  if (!usable(image_, t.format, t.width, t.height, level)) {
    const std::shared_ptr<Image> image = createImage(c, t.format, t.width, t.height, 1);
    if (!image || !move(c, face, level, image, 0)) return false;
    if (level == 0) image_ = image;
    return true;
  }
  return move(c, face, level, image_, level);
}

bool Texture::copyLevel(Context& c, int level, Texture& source, int sourceLevel) {
  for (int face = 0; face < faces(); ++face) {
    if (source.hasDerived(face) && !source.settle(c, face)) return false;
    if (hasDerived(face) && !settle(c, face)) return false;
    if (!reside(c, face, level) || !source.copyTexels(c, face, sourceLevel, placeOf(face, level)))
      return false;
    if (level == 0) baseChanged(c, face);
  }
  return true;
}

render::Attachment Texture::attachment(Context& c, int face, int level) {
  if (hasDerived(face) && !settle(c, face)) return {};
  if (!reside(c, face, level)) return {};
  const Place place = placeOf(face, level);
  return {place.image, place.level, place.layer};
}

}  // namespace anteroom::gl
