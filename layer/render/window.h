// The seam's windows: an image that is drawn to, and shown by the window system picture for picture.
#pragma once

#include <cstdint>
#include <memory>

#include "layer/render/format.h"

namespace anteroom::render {

class Image;
struct Hud;

enum class WindowSystem : uint8_t { Xcb, Wayland };

// A window in the words of its system.
struct NativeWindow {
  WindowSystem system = WindowSystem::Xcb;
  void* connection = nullptr;  // xcb_connection_t, wl_display
  void* surface = nullptr;     // wl_surface
  uint32_t id = 0;             // xcb_window_t
};

struct WindowDesc {
  NativeWindow native;
  Format format = Format::RGBA8;  // of 8 bits a component
  int samples = 1;
  bool translucent = false;  // by alpha, what is behind the window shows (colors are premultiplied)
};

enum class Presented : uint8_t {
  Shown,  // or not to be seen, as windows without pixels are
  Lost,   // the native window is gone
  OutOfMemory,
};

// Belongs to one thread at a time, like the context that draws to it. The native window and its connection
// outlive it.
class Window {
 public:
  virtual ~Window() = default;

  // Readies an image for the next picture, which waits for the window system where the interval says so.
  // `width`, `height`: pixels of the native window where its system leaves them to the program, else 0. A
  // window that is lost has images, too, which nobody sees. False: out of memory.
  virtual bool acquire(int width, int height) = 0;

  // The native window is gone: what is drawn from now on is not seen.
  virtual void lose() = 0;

  // After acquire(): images of one sample a pixel, row 0 at the top. They are others than before when the
  // size has changed. samples(): null without multisampling; it is resolved into image().
  virtual const std::shared_ptr<Image>& image() const = 0;
  virtual const std::shared_ptr<Image>& samples() const = 0;

  // How many pictures ago the contents of image() were drawn; 0: never.
  virtual int age() const = 0;
  // 0: pictures are shown at once; 1: at the next refresh of the screen.
  virtual void setInterval(int interval) = 0;
  // Whether the next picture starts with the one before.
  virtual void setPreserved(bool preserved) = 0;
  // Drawn over the next picture on its way to the screen. Null: nothing is.
  virtual void setHud(const Hud*) {}
};

}  // namespace anteroom::render
