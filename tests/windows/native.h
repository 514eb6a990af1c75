// The window systems as their programs use them, and what is really on their screens. Knows nothing of EGL.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "image.h"

namespace windows {

enum class Platform { Xlib, Xcb, Wayland };
const char* name(Platform platform);
// Those whose server the environment names.
std::vector<Platform> platforms();

struct WindowRequest {
  int width = 64, height = 48;
  // The place of the upper left corner.
  int x = 0, y = 0;
  // EGL_NATIVE_VISUAL_ID of the config; 0: the screen's own.
  std::uint32_t visual = 0;
  bool shown = true;
};

// Destroyed with its object, if not before.
class NativeWindow {
 public:
  virtual ~NativeWindow() = default;
  // What eglCreateWindowSurface takes.
  virtual std::uintptr_t value() const = 0;
  // What eglCreatePlatformWindowSurface takes.
  virtual void* pointer() = 0;
  // When it returns, the server knows.
  virtual void resize(int width, int height) = 0;
  virtual void show() = 0;
  virtual void hide() = 0;
  virtual void destroy() = 0;
  // What the user sees of the window, which lies inside the screen with nothing above it.
  virtual Image onScreen() = 0;
};

// A connection; it is closed with its object, after its windows.
class NativeDisplay {
 public:
  static std::unique_ptr<NativeDisplay> open(Platform platform);
  virtual ~NativeDisplay() = default;
  Platform platform() const { return platform_; }
  // What eglGetPlatformDisplay takes.
  virtual void* handle() const = 0;
  virtual std::unique_ptr<NativeWindow> createWindow(const WindowRequest& request) = 0;
  // Colour bits of a visual, alpha included; 0 if there is no such visual.
  virtual int visualDepth(std::uint32_t visual) const = 0;
  // The screen's, in pixels and millimetres.
  struct ScreenSize {
    int width, height, widthMm, heightMm;
  };
  virtual ScreenSize screenSize() const = 0;
  virtual Image screen() = 0;
  // Cuts another connection, by one of its windows; only X can.
  virtual void cut(NativeWindow& window) = 0;
  // What the server complained of since the last call: requests that were not the program's to check.
  virtual std::vector<std::string> complaints() = 0;

 protected:
  explicit NativeDisplay(Platform platform) : platform_(platform) {}

 private:
  Platform platform_;
};

std::unique_ptr<NativeDisplay> openX11(Platform platform);
std::unique_ptr<NativeDisplay> openWayland();

}  // namespace windows
