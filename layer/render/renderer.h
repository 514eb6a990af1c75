// The seam: what any renderer offers to the GL and EGL front ends. No Vulkan here.
//
// A Device belongs to an EGLDisplay; a Context to a GL context; images and buffers belong to a share group,
// images of EGLImages to several, and are held by shared_ptr: a renderer keeps what the GPU still uses alive
// after the last reference is gone. Device is thread-safe. A Context, and the images and buffers it uses, are
// used by one thread at a time: the front end sees to that. Functions that can run out of memory say so by
// their result and change nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "gen/profile.h"
#include "layer/render/state.h"
#include "layer/render/window.h"

namespace anteroom::render {

struct Hud;  // hud.h

enum class Dimension : uint8_t { Flat, Cube, Volume };

struct ImageDesc {
  Dimension dimension = Dimension::Flat;
  Format format = Format::RGBA8;
  int width = 1, height = 1, depth = 1;  // level 0, texels
  int levels = 1;
  int samples = 1;
  bool renderable = false;  // will be an attachment (a texture becomes one by being attached: any image may)
};

// Bytes in client memory for a rectangle or box of texels of one level.
struct Region {
  int level = 0;
  int layer = 0;  // cube face; 0 otherwise
  int x = 0, y = 0, z = 0;
  int width = 0, height = 0, depth = 1;
};

class Image {
 public:
  virtual ~Image() = default;
  const ImageDesc& desc() const { return desc_; }
  // What the program calls it, for tools that look at the device.
  virtual void setLabel(std::string_view) {}

 protected:
  explicit Image(const ImageDesc& desc) : desc_(desc) {}
  ImageDesc desc_;
};

// A buffer object's store. Its contents are always readable by the CPU: indices are scanned, arrays are
// gathered.
class Buffer {
 public:
  virtual ~Buffer() = default;
  size_t size() const { return size_; }
  // The current contents, size() bytes. Stays valid until the next write or destruction.
  virtual const std::byte* contents() const = 0;
  // Replaces bytes [offset, offset + size). Draws issued before see the old bytes. False: out of memory.
  virtual bool write(size_t offset, const void* data, size_t size) = 0;

 protected:
  explicit Buffer(size_t size) : size_(size) {}
  size_t size_;
};

// What has happened so far in a context; for tests and --stats.
struct Stats {
  uint64_t draws = 0;
  uint64_t pipelinesCreated = 0;
  uint64_t shadersCompiled = 0;  // calls into glslang
  uint64_t shadersFromCache = 0;
  uint64_t vulkanObjectsCreated = 0;  // of every kind, pipelines and memory included
  uint64_t memoryAllocations = 0;     // device memory
  uint64_t submits = 0;
  uint64_t renderPasses = 0;
  uint64_t bytesUploaded = 0;
  uint64_t memoryBytes = 0;  // device memory that is held now
};

// What a renderer tells of itself, in words, for people who ask.
struct Origin {
  std::string devices;  // those that it found, one a line, and what became of each
  std::string choice;   // why it took the one it has
  std::string driver;   // its name and version
  std::string quirks;   // what is done about that driver's faults: names with spaces between them
  std::string cache;    // the file of compiled shaders, or why there is none
};

struct Caps {
  std::string deviceName;  // goes into GL_RENDERER
  Origin origin;
  gen::Profile profile;
  int maxTextureSize = 2048;
  int maxCubeMapSize = 2048;
  int maxVolumeSize = 256;
  int maxViewport[2] = {2048, 2048};
  float pointSizeRange[2] = {1, 1};
  float lineWidthRange[2] = {1, 1};
  float smoothPointSizeRange[2] = {1, 1};
  float smoothLineWidthRange[2] = {1, 1};
  int subpixelBits = 4;
  float maxAnisotropy = 1;
  float maxLodBias = 14;  // largest absolute value of TEXTURE_LOD_BIAS that is not clamped
  // Formats in which framebuffers can be offered without loss; sample counts other than 1 that work with all.
  bool renderable[kFormatCount] = {};  // indexed by Format
  int maxSamples = 1;
  bool polygonOffsetClamp = true;
  bool windows = false;   // of the window system that the device was made for
  bool x11Alpha = false;  // X windows may be 32 bits deep, and what is behind them shines through
  // ANTEROOM_DEBUG=markers, and a device that can: images want names, draws groups.
  bool objectNames = false;
  bool drawGroups = false;
};

// Hears of what makes a context slow. Called on the context's thread.
class Listener {
 public:
  virtual void slow(std::string_view what) = 0;

 protected:
  ~Listener() = default;
};

class Context {
 public:
  virtual ~Context() = default;

  // Null: nobody listens.
  virtual void setListener(Listener*) {}
  // Groups and points in the stream of commands, for tools that look at the device. Groups are nested.
  virtual void pushGroup(std::string_view) {}
  virtual void popGroup() {}
  virtual void mark(std::string_view) {}
  // The device was lost: nothing that is drawn arrives any more.
  virtual bool lost() const { return false; }

  // A draw is a value: nothing of it is written to. `changed`: the groups in which `state` may differ from
  // that of this context's last draw that returned true, wherever that one lay; all of them at the first. The
  // caller keeps this account: a draw that returned false, or a clear, leaves it as it is.
  //
  // state.fixed.primitive fits call.mode. Arrays: those enabled in state.fixed.attributes; kPosition is
  // enabled. A read beyond a buffer's end gives zeros or any value from the same buffer, never another's
  // memory. False: out of memory.
  virtual bool draw(const State& state, gen::Groups changed, const DrawCall& call) = 0;

  // mask: GL_COLOR_BUFFER_BIT and so on. Honours scissor and write masks (section 4.2.3). `changed`: as a
  // draw in its place would be told.
  virtual bool clear(const State& state, gen::Groups changed, GLbitfield mask) = 0;

  // Reads `rect` of a framebuffer, which may hang over its edges: pixels outside are left untouched in
  // memory. Rows from GL's lowest to highest, `rowPitch` bytes apart; format RGBA8 or the framebuffer's own
  // color format.
  virtual bool readPixels(const Framebuffer& framebuffer, const Rect& rect, Format format, void* out,
                          size_t rowPitch) = 0;

  // Replaces texels of one level. `data` has the image's own format, rows `rowPitch` and slices `slicePitch`
  // bytes apart. The region lies inside the level.
  virtual bool upload(Image& image, const Region& region, const void* data, size_t rowPitch,
                      size_t slicePitch) = 0;

  // glCopyTexSubImage2D: `source`'s lower left corner goes to (region.x, region.y); the rest of the rectangle
  // lies inside the level. Components that the image has not are dropped; source pixels outside the
  // framebuffer leave their texels as they are. Rows keep GL's order.
  virtual bool copyFromFramebuffer(Image& image, const Region& region, const Framebuffer& source, int x,
                                   int y) = 0;

  // Copies all texels of level `sourceLevel` of `source` to `level` of `image`; same format and size.
  virtual bool copyLevel(Image& image, int level, Image& source, int sourceLevel) = 0;

  // Levels 1 and up from level 0, all faces: a box filter (section 3.7.8).
  virtual bool generateMipmaps(Image& image) = 0;

  // glFlush; glFinish. After finish everything that this context issued is done.
  virtual void flush() = 0;
  virtual void finish() = 0;

  // Shows what was drawn to the window, which is not ready any more. `damage`: the parts that differ from the
  // picture before, in GL's coordinates; empty: all of it.
  virtual Presented present(Window&, std::span<const Rect> damage) {
    static_cast<void>(damage);
    return Presented::Lost;
  }

  // A point in this context's stream. insertFence flushes. waitFence: timeout in ns; true when passed. Any
  // thread may wait, in any context of the device, also while others use it. What a context is told after
  // another one's fence was inserted is done after that fence.
  virtual uint64_t insertFence() = 0;
  virtual bool waitFence(uint64_t fence, uint64_t timeout) = 0;

  // Draws over the color of a framebuffer. Changes nothing else that a program could see; statistics do not
  // tell of it.
  virtual void drawHud(const Framebuffer&, const Hud&) {}

  virtual const Stats& stats() const = 0;
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const Caps& caps() const = 0;
  // Null: out of memory, or a size that the device cannot have.
  virtual std::shared_ptr<Image> createImage(const ImageDesc& desc) = 0;
  // `data` null: zeros.
  virtual std::shared_ptr<Buffer> createBuffer(size_t size, const void* data) = 0;
  virtual std::unique_ptr<Context> createContext() = 0;
  // Null: out of memory, or nothing that this device could draw to.
  virtual std::unique_ptr<Window> createWindow(const WindowDesc&) { return nullptr; }
  // A frame of any context has been submitted whole. For tools that look at frames. Thread-safe.
  virtual void endFrame() {}
};

}  // namespace anteroom::render
