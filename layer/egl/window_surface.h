// Section 3.5.1: surfaces on the screen.
#pragma once

#include <atomic>
#include <memory>

#include "layer/egl/surface.h"
#include "layer/egl/window_system.h"
#include "layer/render/window.h"

namespace anteroom::egl {

class WindowSurface final : public Surface {
 public:
  WindowSurface(const Display& display, std::shared_ptr<render::Device> device, const Config& config,
                const SurfaceAttributes& attributes, std::unique_ptr<NativeWindow> native,
                std::unique_ptr<render::Window> window);

  bool allocate() override;
  bool isExpired() const override { return expired_; }
  bool renew() override;
  EGLint width() const override { return size(0); }
  EGLint height() const override { return size(1); }
  bool isWindow() const override { return true; }
  void post(const Binding& binding, std::span<const render::Rect> damage) override;
  void setSwapBehavior(EGLint behavior) override;
  void setSwapInterval(EGLint interval) override { interval_ = interval; }
  EGLint age() const override;

 private:
  // Pixels: of the images, or between pictures of the native window.
  EGLint size(int axis) const;

  const std::unique_ptr<NativeWindow> native_;
  const std::unique_ptr<render::Window> window_;  // touched by the thread where it is current
  // What other threads may ask for and set meanwhile.
  std::atomic<bool> expired_{true};  // the images are those of a picture that was shown
  std::atomic<EGLint> size_[2] = {0, 0};
  std::atomic<EGLint> interval_{1};
  std::atomic<bool> preserved_{false};
};

}  // namespace anteroom::egl
