#include "layer/egl/current.h"

#include <pthread.h>

#include <utility>

#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

constinit thread_local Thread thread{EGL_SUCCESS, EGL_OPENGL_ES_API, nullptr};

// Drops what is current. Deferred destruction happens here.
void release() {
  const std::unique_ptr<Binding> former(std::exchange(thread.binding, nullptr));
  if (former == nullptr) return;
  gl::setDefaultFramebuffer(*former->context->gl, nullptr);
  gl::makeCurrent(nullptr);
  former->context->thread = nullptr;
  for (const auto& surface : {former->draw, former->read}) {
    if (surface != nullptr) surface->thread = nullptr;
  }
}

// A thread that ends with a current context gives it back. Unlike a destructor of a thread_local, this is
// not called by exit: functions registered with atexit may still draw.
void endThread(void*) {
  const Lock lock(mutex());
  release();
}

void releaseAtThreadEnd() {
  struct Key {
    pthread_key_t key;
    bool made = pthread_key_create(&key, endThread) == 0;
  };
  static const Key end{};
  if (end.made) pthread_setspecific(end.key, &thread);
}

// Throws EGL_BAD_ACCESS.
template <typename Object>
void requireFree(const Object& object) {
  require(object == nullptr || object->thread == nullptr || object->thread == &thread, EGL_BAD_ACCESS);
}

bool isCompatible(const Context& context, const Surface& surface) {
  return !context.config || areCompatible(*context.config, surface.config);
}

Binding findBinding(const Display& display, EGLSurface draw, EGLSurface read, EGLContext context) {
  Binding next;
  if (context != EGL_NO_CONTEXT) next.context = display.context(context);
  if (draw != EGL_NO_SURFACE) next.draw = display.surface(draw);
  if (read != EGL_NO_SURFACE) next.read = display.surface(read);
  require(next.context != nullptr && !next.draw == !next.read, EGL_BAD_MATCH);
  for (const auto& surface : {next.draw, next.read}) {
    require(surface == nullptr || isCompatible(*next.context, *surface), EGL_BAD_MATCH);
  }
  requireFree(next.context);
  requireFree(next.draw);
  requireFree(next.read);
  for (const auto& surface : {next.draw, next.read}) {
    require(surface == nullptr || surface->allocate(), EGL_BAD_ALLOC);
  }
  return next;
}

void bind(Binding next) {
  releaseAtThreadEnd();
  if (thread.binding != nullptr && *thread.binding == next)
    return gl::RendererLock(*next.context->gl)->flush();
  auto binding = std::make_unique<Binding>(std::move(next));
  release();
  gl::makeCurrent(binding->context->gl.get());
  useSurfaces(*binding);
  binding->context->thread = &thread;
  for (const auto& surface : {binding->draw, binding->read}) {
    if (surface == nullptr) continue;
    surface->thread = &thread;
    if (surface->isTexture()) gl::shareImages(*binding->context->gl);
  }
  if (binding->draw != nullptr) binding->draw->drawnBy = binding->context;
  thread.binding = binding.release();
}

}  // namespace

Thread& thisThread() {
  return thread;
}

void abandonBinding() {
  thread.binding = nullptr;
  gl::abandonContexts();
}

void useSurfaces(const Binding& binding) {
  const auto framebufferOf = [](const auto& surface) { return surface ? &surface->framebuffer() : nullptr; };
  gl::setDefaultFramebuffer(*binding.context->gl, framebufferOf(binding.draw), framebufferOf(binding.read));
}

void readyWindow(const Binding& binding) {
  render::Window* const window = binding.draw->framebuffer().window;
  if (window == nullptr || window->isReady()) return;
  if (!window->makeReady()) log("out of memory for the images of a window");
  useSurfaces(binding);
}

}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLBoolean EGLAPIENTRY eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext ctx) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const Display& display = displayOf(dpy);
    if (ctx == EGL_NO_CONTEXT && draw == EGL_NO_SURFACE && read == EGL_NO_SURFACE) {
      release();  // the one case that an uninitialized display allows
      return EGL_TRUE;
    }
    require(display.initialized(), EGL_NOT_INITIALIZED);
    bind(findBinding(display, draw, read, ctx));
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglReleaseThread() {
  return command<EGLBoolean>(EGL_FALSE, [](Lock&) {
    release();
    thread.api = EGL_OPENGL_ES_API;
    return EGL_TRUE;
  });
}

EGLContext EGLAPIENTRY eglGetCurrentContext() {
  setError(EGL_SUCCESS);
  const Context* context = currentContext();
  return context == nullptr ? EGL_NO_CONTEXT : context->handle;
}

EGLDisplay EGLAPIENTRY eglGetCurrentDisplay() {
  setError(EGL_SUCCESS);
  const Context* context = currentContext();
  return context == nullptr ? EGL_NO_DISPLAY : context->display.handle();
}

EGLSurface EGLAPIENTRY eglGetCurrentSurface(EGLint readdraw) {
  return command<EGLSurface>(EGL_NO_SURFACE, [&](Lock&) {
    require(readdraw == EGL_DRAW || readdraw == EGL_READ, EGL_BAD_PARAMETER);
    const Binding* binding = currentBinding();
    if (binding == nullptr || binding->draw == nullptr) return EGL_NO_SURFACE;
    return (readdraw == EGL_DRAW ? binding->draw : binding->read)->handle;
  });
}

EGLBoolean EGLAPIENTRY eglBindAPI(EGLenum api) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(api == EGL_OPENGL_ES_API, EGL_BAD_PARAMETER);
    thread.api = api;
    return EGL_TRUE;
  });
}

EGLenum EGLAPIENTRY eglQueryAPI() {
  setError(EGL_SUCCESS);
  return thread.api;
}

EGLBoolean EGLAPIENTRY eglWaitClient() {
  return command<EGLBoolean>(EGL_FALSE, [](Lock& lock) {
    Context* context = currentContext();
    if (context == nullptr) return EGL_TRUE;
    lock.unlock();
    gl::RendererLock(*context->gl)->finish();
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglWaitGL() {
  return eglWaitClient();
}

EGLBoolean EGLAPIENTRY eglWaitNative(EGLint engine) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock& lock) {
    const Context* context = currentContext();
    require(engine == EGL_CORE_NATIVE_ENGINE || context == nullptr, EGL_BAD_PARAMETER);
    const auto system = context == nullptr ? nullptr : context->display.windowSystem();
    lock.unlock();
    if (system != nullptr) system->wait();
    return EGL_TRUE;
  });
}
