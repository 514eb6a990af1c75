// Section 3.5.1: surfaces on the screen.
#pragma once

#include <atomic>
#include <memory>

#include "layer/egl/surface.h"
#include "layer/egl/window_system.h"
#include "layer/render/window.h"

namespace anteroom::egl {

class WindowSurface final : public Surface, private render::WindowOwner {
 public:
  // Throws EGL_BAD_MATCH, EGL_BAD_ALLOC.
  WindowSurface(const Display& display, std::shared_ptr<render::Device> device, const Config& config,
                const SurfaceAttributes& attributes, std::unique_ptr<NativeWindow> native);

  bool allocate() override;
  const render::Framebuffer& framebuffer() const override { return window_->framebuffer(); }
  EGLint width() const override { return size(0); }
  EGLint height() const override { return size(1); }
  bool isWindow() const override { return true; }
  void post(const Binding& binding, std::span<const render::Rect> damage) override;
  void setSwapBehavior(EGLint behavior) override;
  void setSwapInterval(EGLint interval) override { interval_ = interval; }
  EGLint age() const override;

 private:
  render::PictureWish wish() const override;
  // Pixels: of the picture, or between two of the native window.
  EGLint size(int axis) const;

  const std::unique_ptr<NativeWindow> native_;
  // What other threads set meanwhile.
  std::atomic<EGLint> interval_{1};
  std::atomic<bool> preserved_{false};
  const std::unique_ptr<render::Window> window_;  // touched by the thread where it is current
};

}  // namespace anteroom::egl
