// Textures as sources and targets of EGLImages (OES_EGL_image, EGL 1.5 section 3.9). To specify any level of
// such a texture ends that: its texels move to images of its own, and its siblings keep theirs.
#include <algorithm>
#include <new>

#include "layer/gl/textures/texture.h"

namespace anteroom::gl {

using render::Image;

bool TextureLevel::isShared() const {
  return shared && home == shared->image && homeLevel == shared->level;
}

bool Texture::hasShared() const {
  return std::ranges::any_of(levels_, [&](const TextureLevel& level) {
    return level.isShared() && (target_ || !isAlone(level.shared));
  });
}

// Whether levels up to that of a mipmap so long can be made without leaving the siblings (EGL_KHR_gl_image,
// issues 4 and 5).
bool Texture::holdsChain(int length) const {
  return length <= 1 || !hasShared() || (!target_ && image_ && image_->desc().levels >= length);
}

// Levels from 0 on that fit together, whatever the filters select; 0: some face has none.
int Texture::consistentLevels() const {
  if (!baseComplete()) return 0;
  const TextureLevel& base = at(0, 0);
  const int length = chainLength(base.extent());
  for (int level = 1; level < length; ++level) {
    for (int face = 0; face < faces(); ++face) {
      const TextureLevel& t = at(face, level);
      if (t.internalFormat != base.internalFormat || t.extent() != levelExtent(level)) return level;
    }
  }
  return length;
}

// The texture leaves its siblings. Texels of the excepted level, which is about to be specified, are dropped.
bool Texture::leaveSiblings(Context& c, int exceptFace, int exceptLevel) {
  if (!hasShared()) return true;
  std::vector<std::shared_ptr<Image>> own;
  try {
    own.resize(levels_.size());
  } catch (const std::bad_alloc&) {
    return false;
  }
  const auto copied = [&](int face, int level) {
    return at(face, level).isShared() && !(face == exceptFace && level == exceptLevel);
  };
  for (int face = 0; face < faces(); ++face) {
    for (int level = 0; level < levels(); ++level) {
      if (!copied(face, level)) continue;
      const TextureLevel& t = at(face, level);
      render::ImageDesc desc;
      desc.format = t.format;
      desc.width = t.width;
      desc.height = t.height;
      std::shared_ptr<Image>& image = own[index(face, level)];
      image = c.device.createImage(desc);
      if (!image || !copyTexels(c, face, level, {image, 0, 0})) return false;
    }
  }
  for (size_t i = 0; i < levels_.size(); ++i) {
    TextureLevel& t = levels_[i];
    if (t.isShared()) {
      t.home = own[i];
      t.homeLevel = 0;
    }
    t.shared.reset();
  }
  target_ = false;
  image_ = nullptr;
  changed(c);
  return true;
}

void Texture::adopt(Context& c, const std::shared_ptr<SharedImage>& image) {
  for (TextureLevel& t : levels_) t = TextureLevel{};
  TextureLevel& base = edit(0, 0);
  base.width = image->width;
  base.height = image->height;
  base.internalFormat = image->internalFormat;
  base.format = image->image->desc().format;
  base.home = image->image;
  base.homeLevel = image->level;
  base.shared = image;
  image_ = image->image;
  import_ = nullptr;
  target_ = true;
  changed(c);
}

ShareStatus Texture::share(Context& c, int face, int level, std::shared_ptr<SharedImage>& image) {
  if (level < 0 || level >= levels()) return ShareStatus::NoLevel;
  const int count = consistentLevels();
  if (count == 0) return ShareStatus::NoSource;
  for (const TextureLevel& t : levels_) {
    if ((&t - levels_.data()) % levels() >= count && !t.null()) return ShareStatus::NoSource;
  }
  if (level >= count) return complete() ? ShareStatus::NoLevel : ShareStatus::NoSource;
  TextureLevel& t = edit(face, level);
  if (import_ || (t.isShared() && !isAlone(t.shared))) return ShareStatus::Taken;
  if (!target_) {
    // All of them now: later they could not move to a larger image.
    if (!gatherLevels(c, count)) return ShareStatus::OutOfMemory;
    for (TextureLevel& each : levels_) {
      if (each.home == image_) each.format = image_->desc().format;
    }
  }
  const Place place = placeOf(face, level);
  try {
    image = std::make_shared<SharedImage>(
        SharedImage{place.image, place.level, place.layer, t.width, t.height, t.internalFormat});
  } catch (const std::bad_alloc&) {
    return ShareStatus::OutOfMemory;
  }
  t.shared = image;
  return ShareStatus::Shared;
}

// Null also where the part is all that there is.
const SharedImage* Texture::sampledPart() const {
  if (!target_) return nullptr;
  const render::ImageDesc& desc = image_->desc();
  const bool whole = desc.dimension == render::Dimension::Flat && desc.levels == 1;
  return whole ? nullptr : at(0, 0).shared.get();
}

}  // namespace anteroom::gl
