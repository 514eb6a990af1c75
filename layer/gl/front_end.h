// What EGL needs of the GL front end: contexts, share groups, the default framebuffer, command addresses.
#pragma once

#include <GLES/gl.h>

#include <memory>
#include <string_view>

#include "layer/render/renderer.h"

namespace anteroom::gl {

class Context;       // layer/gl/context/context.h
class ShareGroup;    // texture and buffer objects that contexts share
struct SharedImage;  // what an EGLImage shows: layer/gl/textures/shared_image.h

// What an EGLImage of a display shows. Null: no such image. Called without any lock of GL's.
using FindImage = std::shared_ptr<SharedImage> (*)(void* display, void* image);

struct ContextOptions {
  bool debug = false;
  bool noError = false;
  bool robustAccess = false;
  FindImage findImage = nullptr;
  void* display = nullptr;          // for findImage
  bool logErrors = false;           // to stderr, each with its command and reason
  bool loseContextOnReset = false;  // EXT_robustness: resets are reported
};

// A context on `device`. `shareWith` null: a share group of its own. Null: out of memory.
std::unique_ptr<Context, void (*)(Context*)> createContext(render::Device& device, Context* shareWith,
                                                           const ContextOptions& options);

// The calling thread's current context; null: none. Commands without a current context do nothing.
Context* currentContext();

// Makes `context` (null: none) the calling thread's. EGL has checked that no other thread has it. The former
// context is flushed when it changes.
void makeCurrent(Context* context);

// In a process that was forked, before anything else there: no thread has a context, and those of the parent
// are not touched any more.
void abandonContexts();

// The window-system framebuffer that name 0 means; null: none (EGL_KHR_surfaceless_context). At the first
// call with a framebuffer in a context's life, viewport and scissor take its size (sections 2.10.1, 4.1.2).
// It is copied; the bits that queries such as RED_BITS give come from its images. `read` (null: the same) is
// what pixels are read and copied from. Those of windows are followed from picture to picture: a window
// outlives the call that takes it away again.
void setDefaultFramebuffer(Context& context, const render::Framebuffer* framebuffer,
                           const render::Framebuffer* read = nullptr);

// eglBindTexImage: `image` becomes level 0 of the texture bound to `target` in the active unit; what the
// texture had is released. False: no context, or an unsuitable target. releaseTexImage undoes it wherever it
// is still bound.
bool bindTexImage(Context& context, GLenum target, const std::shared_ptr<render::Image>& image, bool alpha);
void releaseTexImage(Context& context, const std::shared_ptr<render::Image>& image);

// eglCreateImage: a level of a texture (TEXTURE_2D or a face of a cube map), or a renderbuffer, by which
// textures and renderbuffers of all share groups on the device can then be defined. Its contents stay. No
// other thread has `context`, or others share with it.
struct ImageSource {
  GLenum target = 0;  // TEXTURE_2D, TEXTURE_CUBE_MAP_POSITIVE_X_OES and so on, RENDERBUFFER_OES
  GLuint name = 0;
  GLint level = 0;
};
enum class ShareStatus : uint8_t {
  Shared,
  NoSource,  // no such object, not complete, or multisampled
  NoLevel,   // the texture has no such level
  Taken,     // it has siblings already, or a pbuffer is bound to it
  OutOfMemory,
};
ShareStatus shareImage(Context& context, const ImageSource& source, std::shared_ptr<SharedImage>& image);
// Other share groups' commands may use images that the context has from now on: they exclude each other. No
// other thread has `context`, or others share with it.
void shareImages(Context& context);
// Whether another context shares objects with this one.
bool hasCompany(const Context& context);

// For what any thread may ask of it: stats(), waitFence().
render::Context& rendererOf(Context& context);

// The context's renderer, while no other context uses what it shares. No command of GL is called meanwhile.
class RendererLock {
 public:
  explicit RendererLock(Context& context);
  ~RendererLock();
  RendererLock(const RendererLock&) = delete;
  RendererLock& operator=(const RendererLock&) = delete;
  render::Context* operator->() const;

 private:
  Context& context_;
  bool group_, images_;  // the locks that are held
};

using Proc = void (*)();
// The address of a gl* command, null when there is none of that name.
Proc procAddress(std::string_view name);

}  // namespace anteroom::gl
