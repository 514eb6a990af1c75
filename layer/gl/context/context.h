// A GL context, the objects that contexts share, and what every command begins with.
//
// A command looks like this:
//
//   extern "C" void GL_APIENTRY glLineWidth(GLfloat width) {
//     Context* c = current();
//     if (!c) return;
//     if (!(width > 0))
//       return c->setError(GL_INVALID_VALUE, wrongNumber("width", width, "Give a width above 0"));
//     c->set(c->state.raster.lineWidth, width, gen::kGroupRaster);
//   }
//
// Validation comes first and changes nothing; state goes straight into `state`, whose groups are marked.
// Commands that touch shared objects or the renderer hold a ShareLock; internal functions never take one.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "layer/gl/context/fault.h"
#include "layer/gl/context/object_table.h"
#include "layer/gl/front_end.h"
#include "layer/render/renderer.h"
#include "registry/gl.h"

namespace anteroom::gl {

struct BufferObject;  // buffer.h: `GLuint name` and `std::shared_ptr<render::Buffer> store` (null: size 0)
struct Texture;       // texture.h: `GLuint name` and the rest
class DebugOutput;    // debug_output.h
struct Renderbuffer;  // framebuffer_object.h
struct FramebufferObject;
struct SyncObject;   // fences.h
struct FenceObject;  // fences.h

// Held, after the group's own, by who uses images of several groups (OES_EGL_image).
extern std::mutex sharedImagesMutex;

// Textures and buffers of contexts that share. A context alone in its group takes no lock.
class ShareGroup {
 public:
  explicit ShareGroup(render::Device& d) : device(d) {}

  // After `contexts` was raised: the command that a context, alone until then, is in without the lock ends.
  void awaitCommand() const;

  render::Device& device;
  ObjectTable<Texture> textures;
  ObjectTable<BufferObject> buffers;
  ObjectTable<Renderbuffer> renderbuffers;
  ObjectTable<FramebufferObject> framebuffers;
  ObjectTable<SyncObject> syncs;

  // Every context of the group looks at these groups again before it draws: kGroupTextures and
  // kGroupFramebuffer when the images, completeness or sampler state of any texture change; kGroupArrays when
  // any buffer's store is replaced; kGroupFramebuffer when an attachment of any framebuffer object, or a
  // renderbuffer's storage, changes. New contents alone do not count. Under the ShareLock.
  void tell(gen::Groups groups) const;
  Context* first = nullptr;  // of its contexts, which are chained

  int mappedBuffers = 0;  // how many buffer objects are mapped

  std::atomic<int> contexts{0};
  std::atomic<bool> inCommand{false};  // the only context is, without the lock
  std::mutex mutex;
  // Whether it ever had an EGLImage's sibling. It changes only while no other thread is in a command of the
  // group.
  std::atomic<bool> sharesImages{false};
};

class ShareLock {
 public:
  explicit ShareLock(ShareGroup& group) : group_(group), held_(lock(group)) {}
  ~ShareLock() { unlock(group_, held_); }
  ShareLock(const ShareLock&) = delete;
  ShareLock& operator=(const ShareLock&) = delete;

  struct Held {
    bool group, images;
  };
  static Held lock(ShareGroup& group) {
    const bool contended = !enterAlone(group);
    if (contended) group.mutex.lock();
    const bool images = group.sharesImages.load(std::memory_order_acquire);
    if (images) sharedImagesMutex.lock();
    return {contended, images};
  }
  static void unlock(ShareGroup& group, const Held& held) {
    if (held.images) sharedImagesMutex.unlock();
    if (held.group)
      group.mutex.unlock();
    else
      group.inCommand.store(false, std::memory_order_release);
  }

 private:
  // Two plain stores a command. Who makes a second context has all threads of the process see things in one
  // order (ShareGroup::awaitCommand), so that none is needed here.
  static bool enterAlone(ShareGroup& group) {
    if (group.contexts.load(std::memory_order_acquire) > 1) return false;
    group.inCommand.store(true, std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
    if (group.contexts.load(std::memory_order_acquire) <= 1) [[likely]]
      return true;
    group.inCommand.store(false, std::memory_order_release);
    return false;
  }

  ShareGroup& group_;
  const Held held_;
};

// Limits that queries report (Tables 6.19 to 6.21).
inline constexpr int kModelviewDepth = 32;
inline constexpr int kProjectionDepth = 32;
inline constexpr int kTextureDepth = 10;

// The matrices below the top; the top lives in render::State.
template <int Depth>
struct MatrixStack {
  std::array<glm::dmat4, Depth - 1> below;
  int depth = 1;
};

enum TextureSlot : uint8_t { kSlot2D, kSlotCube, kSlot3D, kSlotExternal, kSlotCount };

struct UnitBindings {
  std::array<std::shared_ptr<Texture>, kSlotCount> bound;  // never null: name 0 is a default texture
  std::array<bool, kSlotCount> enabled{};
  TextureSlot sampled = kSlotCount;  // what the last draw sampled; kSlotCount: nothing
};

// Section 2.8. An array as the program described it; the renderer's view of it is made at the draw.
struct ClientArray {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;
  const void* pointer = nullptr;
  bool isOffset = false;                 // pointer was given with a buffer bound: never client memory
  std::shared_ptr<BufferObject> buffer;  // null also when that buffer has been deleted
};

struct VertexArrays {
  std::array<ClientArray, gen::kAttributeCount> arrays;
  std::shared_ptr<BufferObject> elementBuffer;
};
VertexArrays initialVertexArrays();

// OES_vertex_array_object. `arrays` is empty while the object is bound: they lie in the context then.
struct VertexArrayObject {
  explicit VertexArrayObject(GLuint n) : name(n) {}

  const GLuint name;
  VertexArrays arrays = initialVertexArrays();
  std::string label;
};

struct Hints {
  GLenum perspectiveCorrection = GL_DONT_CARE;
  GLenum pointSmooth = GL_DONT_CARE;
  GLenum lineSmooth = GL_DONT_CARE;
  GLenum fog = GL_DONT_CARE;
  GLenum generateMipmap = GL_DONT_CARE;
};

class Context {
 public:
  Context(render::Device& device, std::shared_ptr<ShareGroup> shareGroup,
          std::unique_ptr<render::Context> renderContext, const ContextOptions& contextOptions);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Section 2.5: the first error stays until glGetError. KHR_no_error: there is none but that of memory.
  // `command`: a helper passes on the name of the command that called it.
  void setError(GLenum code, const Fault& fault = {}, const char* command = __builtin_FUNCTION()) {
    if (options.noError && code != GL_OUT_OF_MEMORY) return;
    if (error == GL_NO_ERROR) error = code;
    if (debugOutput || options.logErrors) [[unlikely]]
      reportError(code, fault, command);
  }
  void mark(gen::Groups groups) { changed |= groups; }
  // Stores a value and marks groups when it differs from the old one.
  template <class T>
  void set(T& field, const T& value, gen::Groups groups) {
    if (field == value) return;
    field = value;
    mark(groups);
  }

  // Whether there is something to draw to (false: surfaceless, or an incomplete framebuffer object). Brings
  // state.framebuffer up to date. Under the ShareLock.
  bool framebufferComplete();
  // The same for what pixels are read from, readFramebuffer.
  bool readFramebufferComplete();

  render::State state;
  // The groups of `state` in which it may differ from what the renderer drew last: the one account of it.
  // What the state shows of textures is looked up by the next draw while their group is marked.
  gen::Groups changed = gen::kAllGroups;
  // What the state shows of these groups is looked up anew before it is used: contexts of the group, this one
  // too, changed objects. Under the ShareLock.
  gen::Groups told = 0;
  Context* nextOfGroup = nullptr;  // under the ShareLock
  GLenum error = GL_NO_ERROR;
  render::Device& device;
  std::shared_ptr<ShareGroup> group;
  std::unique_ptr<render::Context> renderer;
  const ContextOptions options;
  const bool groupsCommands;  // tools want to see which command did what (tool_names.h)

  bool hasFramebuffer = false;  // state.framebuffer is one
  bool hadFramebuffer = false;  // viewport and scissor have their initial values
  bool hasDefaultFramebuffer = false;
  render::Framebuffer defaultFramebuffer;
  render::Framebuffer defaultReadFramebuffer;
  // OES_framebuffer_object. Null: the default framebuffer, or no renderbuffer.
  std::shared_ptr<FramebufferObject> boundFramebuffer;
  std::shared_ptr<FramebufferObject> boundReadFramebuffer;  // APPLE_framebuffer_multisample
  std::shared_ptr<Renderbuffer> boundRenderbuffer;
  render::Framebuffer
      readFramebuffer;  // where pixels come from: state.framebuffer, but for EGL's read surface

  // Section 2.10.2.
  GLenum matrixMode = GL_MODELVIEW;
  MatrixStack<kModelviewDepth> modelviewStack;
  MatrixStack<kProjectionDepth> projectionStack;
  std::array<MatrixStack<kTextureDepth>, gen::kMaxTextureUnits> textureStacks;

  // OES_matrix_palette. state.fixed shows the palette while it is enabled.
  bool paletteEnabled = false;
  int currentPaletteMatrix = 0;
  gen::Palette palette;

  // Sections 2.8, 2.9.
  VertexArrays vertexArrays = initialVertexArrays();
  ObjectTable<VertexArrayObject> vertexArrayObjects;
  std::shared_ptr<VertexArrayObject> defaultVertexArray;  // name 0
  std::shared_ptr<VertexArrayObject> boundVertexArray;    // never null
  std::shared_ptr<BufferObject> arrayBuffer;
  int clientActiveTexture = 0;

  // Section 3.7. Bindings or enables that changed mark kGroupTextures.
  int activeTexture = 0;
  std::array<UnitBindings, gen::kMaxTextureUnits> units;
  std::array<std::shared_ptr<Texture>, kSlotCount> defaultTextures;

  ObjectTable<FenceObject> fences;  // NV_fence

  // Section 3.6.1.
  int packAlignment = 4;
  int unpackAlignment = 4;

  Hints hints;
  GLint stencilRef = 0;  // as given; state.ops has it clamped to what the stencil buffer can hold
  std::string rendererName;
  std::string extensions;  // made by the first query

  // KHR_debug.
  bool debugOutput = false;  // errors and slow commands make messages
  bool debugSynchronous = false;
  const std::unique_ptr<DebugOutput> debug;  // never null

 private:
  void reportError(GLenum code, const Fault& fault, const char* command) const;
  void hear();
  bool hasWindowToReady() const;
  void readyWindows();
};

// Makes `framebuffer` (null: none) what draws go to and, unless there is a `read`, what pixels are read from,
// and follows what the state knows of it.
void useFramebuffer(Context& context, const render::Framebuffer* framebuffer,
                    const render::Framebuffer* read = nullptr);
void useDefaultFramebuffer(Context& context);
// Derived multisample state: section 4.1.3 applies only when MULTISAMPLE is on and there is more than one
// sample.
void updateMultisample(Context& context);
// Section 4.1.5: the reference is clamped to [0, 2^s - 1], s the bits of the stencil buffer (0: there is
// none).
int stencilBits(const Context& context);
void applyStencilRef(Context& context);

// Constant initialised and in the thread's static block: one load.
extern constinit thread_local Context* currentContextOfThread __attribute__((tls_model("initial-exec")));
inline Context* current() {
  return currentContextOfThread;
}

// Section 2.3: fixed-point numbers are value / 65536. The other way: nearest, ties away from zero,
// saturating; NaN gives 0.
constexpr float fromFixed(GLfixed value) {
  return static_cast<float>(value / 65536.0);
}
constexpr double fixedToDouble(GLfixed value) {
  return value / 65536.0;
}
GLfixed toFixed(double value);
// Nearest integer, saturating; NaN gives 0 (section 6.1.2).
GLint roundToInt(double value);
// [-1, 1] to the whole range of int: colors, normals, depth values (section 6.1.2).
GLint normalisedToInt(double value);

}  // namespace anteroom::gl
