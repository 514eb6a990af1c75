// What EGL must know of X11 and Wayland: connections, visuals, windows. Called under the lock, unless said.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>
#include <vector>

#include "layer/render/renderer.h"
#include "layer/render/window.h"

namespace anteroom::egl {

// How windows of a config can look to their system.
struct Visual {
  EGLint id = 0;
  EGLint type = EGL_NONE;
  bool alpha = false;  // there is room for alpha, which shows what is behind
};

class NativeWindow {
 public:
  virtual ~NativeWindow() = default;
  virtual render::NativeWindow handle() const = 0;
  // By alpha, when the colors have one, what is behind shows.
  virtual bool isTranslucent() const = 0;
  // Pixels. False: the window is gone. From any thread.
  virtual bool size(EGLint& width, EGLint& height) const = 0;
  // Whether the images' size is what size() says, rather than something that the window system knows.
  virtual bool isSizedByProgram() const = 0;
  // Where swapchains would wait for the screen with the device's queue in their hands: pace(), in their
  // stead, waits before a picture is shown until the one before has been seen. Not under the lock.
  virtual bool isPaced() const { return false; }
  virtual void pace(EGLint /*interval*/) {}
  // False: gone for sure. From any thread; costs nothing.
  virtual bool isThere() const { return true; }
};

class WindowSystem {
 public:
  virtual ~WindowSystem() = default;
  virtual render::WindowSystem name() const = 0;
  // For colors of 8 bits a component on such a device, the best first.
  virtual std::vector<Visual> visuals(bool alpha, const render::Caps& caps) const = 0;
  // `native`: as eglCreateWindowSurface takes it. Throws EGL_BAD_NATIVE_WINDOW; EGL_BAD_MATCH where the
  // window has not the visual; EGL_BAD_ALLOC where it has a surface already.
  virtual std::unique_ptr<NativeWindow> window(uintptr_t native, const Visual& visual) = 0;
  // The same for eglCreatePlatformWindowSurface, which points to it.
  virtual std::unique_ptr<NativeWindow> platformWindow(void* native, const Visual& visual) = 0;
  // What was asked of the window system is done (eglWaitNative).
  virtual void wait() const = 0;
};

// Platforms and their displays, as programs name them.
struct Platform {
  EGLenum name = EGL_PLATFORM_SURFACELESS_MESA;
  void* native = nullptr;  // Display, xcb_connection_t, wl_display; null: the default, which is opened
  EGLint screen = -1;      // of X11; -1: the default
  bool operator==(const Platform&) const = default;
};

// Null: `native` is null and no server answers, or a library that it takes is missing. Throws
// EGL_BAD_ATTRIBUTE where there is no such screen.
std::shared_ptr<WindowSystem> openX11(const Platform& platform);
std::shared_ptr<WindowSystem> openWayland(const Platform& platform);

// What eglGetDisplay is asked for: EGL_PLATFORM or EGL_DISPLAY names it; else a native display tells by what
// it begins with; else it is what the environment offers.
Platform guessPlatform(void* native);

}  // namespace anteroom::egl
