// The seam's windows: an image that is drawn to, and shown by the window system picture for picture.
#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

#include "layer/render/state.h"

namespace anteroom::render {

struct Hud;

enum class WindowSystem : uint8_t { Xcb, Wayland };

// A window in the words of its system.
struct NativeWindow {
  WindowSystem system = WindowSystem::Xcb;
  void* connection = nullptr;  // xcb_connection_t, wl_display
  void* surface = nullptr;     // wl_surface
  uint32_t id = 0;             // xcb_window_t
};

// What the next picture of a window is to be like.
struct PictureWish {
  bool there = true;  // false: the native window is gone, and nobody sees what is drawn
  int width = 0,
      height = 0;          // pixels of the native window where its system leaves them to the program, else 0
  int interval = 1;        // 0: it is shown at once; 1: at the next refresh of the screen
  bool preserved = false;  // it starts with the one before
};

// Who has a window made: asked when its picture begins and when it is shown, by the thread that draws.
class WindowOwner {
 public:
  virtual PictureWish wish() const = 0;

 protected:
  ~WindowOwner() = default;
};

struct WindowDesc {
  NativeWindow native;
  const WindowOwner* owner = nullptr;  // never null; outlives the window
  Format format = Format::RGBA8;       // of 8 bits a component
  Format depth = Format::None, stencil = Format::None;
  int samples = 1;
  bool translucent = false;  // by alpha, what is behind the window shows (colors are premultiplied)
};

enum class Presented : uint8_t {
  Shown,  // or not to be seen, as windows without pixels are
  Lost,   // the native window is gone
  OutOfMemory,
};

// Belongs to one thread at a time, like the context that draws to it, but for what says otherwise. The native
// window and its connection outlive it.
class Window {
 public:
  virtual ~Window() = default;

  // Whether framebuffer() is that of the next picture. From any thread.
  bool isReady() const { return ready_.load(std::memory_order_relaxed); }
  // Readies it if it is not, which waits for the window system where the interval says so. A window that is
  // lost has images, too, which nobody sees. False: out of memory; framebuffer() is what it was.
  virtual bool makeReady() = 0;
  // It is ready no longer: the picture was shown, or nothing has been drawn to it and its size may change.
  void expire() { ready_.store(false, std::memory_order_relaxed); }

  // Row 0 is at the top. The images are others than before when the size has changed, and only then. With
  // samples they are resolved into an image of the window.
  const Framebuffer& framebuffer() const { return framebuffer_; }
  // Its size, pixels. From any thread.
  int width() const { return width_.load(std::memory_order_relaxed); }
  int height() const { return height_.load(std::memory_order_relaxed); }
  // What the program calls it, for tools that look at the device.
  virtual void setLabel(std::string_view) {}

  // How many pictures ago the contents of a picture that is ready were drawn; 0: never.
  virtual int age() const = 0;
  // Drawn over the next picture on its way to the screen. Null: nothing is.
  virtual void setHud(const Hud*) {}

 protected:
  std::atomic<bool> ready_{false};
  std::atomic<int> width_{0}, height_{0};
  Framebuffer framebuffer_;
};

}  // namespace anteroom::render
