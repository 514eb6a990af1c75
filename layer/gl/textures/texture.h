// Texture objects (section 3.7): what the program said of each level, and where its texels are.
//
// Nothing is allocated on the device until texels are sampled, copied to or attached. Until then a level's
// texels are kept as the program gave them; then they move into an image that has just the levels which the
// minification filter can select, and the copy is freed. When more levels are wanted later, the image is
// replaced by a larger one. Images are shared_ptrs: draws that were issued with an old one are safe.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "layer/gl/context/context.h"
#include "layer/gl/textures/internal_format.h"
#include "layer/gl/textures/pixel.h"
#include "layer/gl/textures/shared_image.h"
#include "layer/render/renderer.h"

namespace anteroom::gl {

// Texels of a level; depth: slices of a 3D texture, otherwise 1.
struct Extent {
  int width = 0, height = 0, depth = 1;
  bool empty() const { return width <= 0 || height <= 0 || depth <= 0; }
  bool operator==(const Extent&) const = default;
};

struct TextureLevel {
  Extent extent() const { return {width, height, depth}; }
  bool null() const { return extent().empty(); }
  bool isShared() const;  // a sibling of an EGLImage

  int width = 0, height = 0, depth = 1;  // texels
  GLenum internalFormat = 1;             // as specified (internal_format.h; section 3.7.10)
  render::Format format = render::Format::None;

  // Where the texels are: at most one of these. Neither: they are undefined, or derived.
  std::unique_ptr<std::byte[]> pending;  // rows of `format` without gaps
  std::shared_ptr<render::Image> home;
  int homeLevel = 0;                    // of home; its layer is the face for a cube map, else 0
  std::shared_ptr<SharedImage> shared;  // counts as long as home is its image
  bool derived = false;  // to be computed from level 0 (section 3.7.7, automatic mipmap generation)
};

// Memory for texels. Null: out of memory.
std::unique_ptr<std::byte[]> allocateTexels(int width, int height, render::Format format, bool zeroed);

// What a texture image says of a part of itself: slices one after the other.
struct Box {
  int x = 0, y = 0, z = 0;
  Extent size;
};

struct Texture {
  // May throw std::bad_alloc. Faces and levels: for the slot and the device's limits.
  Texture(GLuint textureName, TextureSlot textureSlot, const render::Caps& caps);

  const GLuint name;
  const TextureSlot slot;
  std::string label;

  render::Sampler sampler;
  bool generateMipmap = false;
  std::array<GLint, 4> cropRect{};  // OES_draw_texture

  int faces() const { return slot == kSlotCube ? 6 : 1; }
  int levels() const { return static_cast<int>(levels_.size()) / faces(); }
  const TextureLevel& at(int face, int level) const { return levels_[index(face, level)]; }

  // Sampler state or an image changed: every context looks again.
  void changed(Context& c);
  // `label` changed.
  void labelChanged(const Context& c) const;

  // These change texels; false means out of memory, and that nothing changed. Arguments have been validated.
  // An image of eglBindTexImage is given back when a level is specified.

  // TexImage2D, TexImage3DOES; rows.data null: undefined texels. Slices follow each other without gaps.
  bool specify(Context& c, int face, int level, const Extent& size, GLenum internalFormat,
               const PixelRows& rows);
  // The same with texels that the texture takes over: rows of `format` without gaps, or null.
  bool specify(Context& c, int face, int level, const Extent& size, GLenum internalFormat,
               render::Format format, std::unique_ptr<std::byte[]> texels);
  // TexStorage2DEXT, TexStorage3DEXT: all levels anew, of one format, their texels undefined.
  void store(Context& c, int levelCount, const Extent& size, GLenum internalFormat, render::Format format);
  bool immutable() const { return immutableLevels_ != 0; }
  int immutableLevels() const { return immutableLevels_; }
  // CopyTextureLevelsAPPLE, one level: both are of one size and format.
  bool copyLevel(Context& c, int level, Texture& source, int sourceLevel);
  // TexSubImage2D, TexSubImage3DOES.
  bool replace(Context& c, int face, int level, const Box& box, const PixelRows& rows);
  // CopyTexImage2D: the rectangle of the current framebuffer whose lower left corner is (rect.x, rect.y).
  bool specifyFromFramebuffer(Context& c, int face, int level, const render::Rect& rect,
                              GLenum internalFormat, render::Format format);
  // CopyTexSubImage2D, CopyTexSubImage3DOES: to texel (x, y) of slice z.
  bool replaceFromFramebuffer(Context& c, int face, int level, int x, int y, int z, const render::Rect& rect);

  // eglBindTexImage, eglReleaseTexImage.
  void import(Context& c, const std::shared_ptr<render::Image>& image, GLenum internalFormat);
  bool imported(const std::shared_ptr<render::Image>& image) const { return image && import_ == image; }
  void releaseImport(Context& c);

  // OES_EGL_image: level 0 becomes a sibling of `image`, all other levels are gone.
  void adopt(Context& c, const std::shared_ptr<SharedImage>& image);
  // Makes a level of a face one that an image can be created from.
  ShareStatus share(Context& c, int face, int level, std::shared_ptr<SharedImage>& image);
  // The part of the image that is sampled; null: all of it.
  const SharedImage* sampledPart() const;

  // Section 3.7.9 and OES_texture_cube_map: whether texturing with it is on at all. baseFormat() then says
  // what its texels are.
  bool complete() const;
  GLenum baseFormat() const { return baseFormatOf(at(0, 0).internalFormat); }

  // Section 3.7.8: whether c, which divides magnification from minification, is 0.5. Of one texel alone it
  // does not matter.
  bool switchesLate() const;

  // GenerateMipmapOES: levels 1 and up from level 0. canGenerateMipmaps: there is a level 0 on every face,
  // and faces agree. False: out of memory.
  bool canGenerateMipmaps() const;
  bool generateMipmaps(Context& c);

  // The image to sample, with every level that the sampler can select, for a complete texture. Null: out of
  // memory.
  const std::shared_ptr<render::Image>& sampled(Context& c);

  // One level, of a 3D texture one slice of it, as a render target. image null: out of memory.
  render::Attachment attachment(Context& c, int face, int level, int slice);

 private:
  struct Place {
    std::shared_ptr<render::Image> image;
    int level = 0;
    int layer = 0;
  };

  size_t index(int face, int level) const { return static_cast<size_t>(face * levels() + level); }
  TextureLevel& edit(int face, int level) { return levels_[index(face, level)]; }

  bool usesMipmaps() const;
  int chainLength(const Extent& base) const;  // levels of a full mipmap
  Extent levelExtent(int level) const;        // that fits to level 0
  int sampledLevels() const;                  // that the sampler can select (APPLE_texture_max_level)
  bool chainComplete(int face) const;
  bool derives(GLenum internalFormat) const;
  bool hasDerived(int face, int from = 1) const;
  bool keepDerived(Context& c, int face, const Extent& size, GLenum internalFormat);
  void baseChanged(Context& c, int face);
  void deriveChain(Context& c, int face);
  bool baseComplete() const;

  // texture_sharing.cpp. An EGLImage's siblings are left as soon as a level is specified.
  bool hasShared() const;
  bool holdsChain(int length) const;
  int consistentLevels() const;
  bool leaveSiblings(Context& c, int exceptFace = -1, int exceptLevel = -1);

  // texture_storage.cpp. All but the first two: false, or no image, when out of memory.
  Place placeOf(int face, int level) const;
  bool usable(const std::shared_ptr<render::Image>& image, render::Format format, const Extent& size,
              int level) const;
  std::shared_ptr<render::Image> createImage(Context& c, render::Format format, const Extent& size,
                                             int levels) const;
  render::Format commonFormat(int levelCount) const;
  bool copyTexels(Context& c, int face, int level, const Place& to) const;
  bool move(Context& c, int face, int level, const std::shared_ptr<render::Image>& to, int toLevel);
  bool moveFaces(Context& c, int level, const std::shared_ptr<render::Image>& to);
  bool deriveInto(Context& c, const std::shared_ptr<render::Image>& image);
  bool computeDerived(Context& c, int face);
  bool gatherLevels(Context& c, int levelCount);
  bool placeInImage(Context& c, int face, int level);

  std::vector<TextureLevel> levels_;       // by face, then level
  std::shared_ptr<render::Image> image_;   // what is sampled, or was
  std::shared_ptr<render::Image> import_;  // image_ belongs to EGL
  bool target_ = false;                    // of an EGLImage: image_ is the image that it shows a part of
  int immutableLevels_ = 0;                // 0: not an immutable-format texture
  bool ready_ = false;                     // image_ has what the sampler can select
};

// Makes the default textures (name 0) and binds them to every unit. May throw std::bad_alloc.
void initTextures(Context& c);

// From bindings and enables to state.fixed.units[i].target and baseFormat and state.textures[i]
// (section 3.7.13). Called by a draw under the ShareLock, when kGroupTextures was marked. False: out of memory.
bool updateTextureUnits(Context& c);

// The slot of a target that textures are bound to. kSlotCount: it is none.
TextureSlot bindingSlot(GLenum target);
// The same, and the error is set when there is none.
TextureSlot slotForCommand(Context& c, GLenum target, const char* command = __builtin_FUNCTION());

// The slot and face of a target that names an image. kSlotCount: it is none.
struct ImageTarget {
  TextureSlot slot = kSlotCount;
  int face = 0;
};
ImageTarget imageTarget(GLenum target);

inline Texture& boundTexture(Context& c, TextureSlot slot) {
  return *c.units[static_cast<size_t>(c.activeTexture)].bound[slot];
}

}  // namespace anteroom::gl
