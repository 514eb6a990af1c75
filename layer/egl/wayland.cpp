// Wayland: windows are wl_egl_windows, which say their own size.
#include <poll.h>
#include <wayland-client.h>
#include <wayland-egl-backend.h>

#include <atomic>
#include <cerrno>
#include <chrono>

#include "layer/egl/errors.h"
#include "layer/egl/window_system.h"

namespace anteroom::egl {
namespace {

// How long a picture waits for the one before to be seen: windows that are hidden never are.
constexpr int kLongestWait = 1000;  // ms

// Tells when a surface's last picture has been seen. Used by one thread at a time.
class FrameClock {
 public:
  FrameClock(wl_display* display, wl_surface* surface) : display_(display) {
    queue_ = wl_display_create_queue(display);
    // A wrapper: what it makes is heard of in our queue, whatever the program's surface does.
    surface_ = static_cast<wl_surface*>(wl_proxy_create_wrapper(surface));
    if (surface_ != nullptr) wl_proxy_set_queue(reinterpret_cast<wl_proxy*>(surface_), queue_);
  }
  ~FrameClock() {
    forget();
    if (surface_ != nullptr) wl_proxy_wrapper_destroy(surface_);
    wl_event_queue_destroy(queue_);
  }
  FrameClock(const FrameClock&) = delete;
  FrameClock& operator=(const FrameClock&) = delete;

  void wait() {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(kLongestWait);
    while (callback_ != nullptr) {
      while (wl_display_prepare_read_queue(display_, queue_) != 0) {
        if (wl_display_dispatch_queue_pending(display_, queue_) < 0) return forget();
      }
      if (callback_ == nullptr) return wl_display_cancel_read(display_);
      wl_display_flush(display_);
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd ready{wl_display_get_fd(display_), POLLIN, 0};
      if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) <= 0) {
        wl_display_cancel_read(display_);
        if (left > 0 && errno == EINTR) continue;
        return forget();
      }
      if (wl_display_read_events(display_) != 0) return forget();
      wl_display_dispatch_queue_pending(display_, queue_);
    }
  }

  // The next picture that is shown is the one to wait for.
  void start() {
    static constexpr wl_callback_listener kListener = {
        [](void* self, wl_callback*, uint32_t) { static_cast<FrameClock*>(self)->forget(); }};
    forget();
    callback_ = surface_ == nullptr ? nullptr : wl_surface_frame(surface_);
    if (callback_ != nullptr) wl_callback_add_listener(callback_, &kListener, this);
  }

 private:
  void forget() {
    if (callback_ != nullptr) wl_callback_destroy(callback_);
    callback_ = nullptr;
  }

  wl_display* const display_;
  wl_event_queue* queue_;
  wl_surface* surface_;
  wl_callback* callback_ = nullptr;  // null: the last picture has been seen
};

class WaylandWindow final : public NativeWindow {
 public:
  WaylandWindow(std::shared_ptr<void> system, wl_display* display, wl_egl_window* window)
      : system_(std::move(system)), display_(display), window_(window), clock_(display, window->surface) {
    require(window->driver_private == nullptr, EGL_BAD_ALLOC);
    window->driver_private = this;
    window->destroy_window_callback = [](void* self) { static_cast<WaylandWindow*>(self)->gone_ = true; };
  }
  ~WaylandWindow() override {
    if (gone_) return;
    window_->driver_private = nullptr;
    window_->destroy_window_callback = nullptr;
  }

  render::NativeWindow handle() const override {
    return {render::WindowSystem::Wayland, display_, window_->surface, 0};
  }
  bool isTranslucent() const override { return true; }
  bool size(EGLint& width, EGLint& height) const override {
    if (gone_) return false;
    width = window_->width;
    height = window_->height;
    return true;
  }
  bool isSizedByProgram() const override { return true; }
  bool isThere() const override { return !gone_; }
  bool isPaced() const override { return true; }
  void pace(EGLint interval) override {
    if (interval == 0) return;
    clock_.wait();
    clock_.start();
  }

 private:
  const std::shared_ptr<void> system_;
  wl_display* const display_;
  wl_egl_window* const window_;
  FrameClock clock_;
  std::atomic<bool> gone_{false};
};

class Wayland final : public WindowSystem, public std::enable_shared_from_this<Wayland> {
 public:
  Wayland(wl_display* display, bool owned) : display_(display), owned_(owned) {}
  ~Wayland() override {
    if (owned_) wl_display_disconnect(display_);
  }

  render::WindowSystem name() const override { return render::WindowSystem::Wayland; }

  std::vector<Visual> visuals(bool alpha, const render::Caps&) const override {
    return {{0, EGL_NONE, alpha}};
  }

  std::unique_ptr<NativeWindow> window(uintptr_t native, const Visual& visual) override {
    return platformWindow(reinterpret_cast<void*>(native), visual);
  }
  std::unique_ptr<NativeWindow> platformWindow(void* native, const Visual&) override {
    auto* const window = static_cast<wl_egl_window*>(native);
    // Before version 3 the first member was a pointer.
    require(window != nullptr && window->version == WL_EGL_WINDOW_VERSION && window->surface != nullptr,
            EGL_BAD_NATIVE_WINDOW);
    return std::make_unique<WaylandWindow>(shared_from_this(), display_, window);
  }

  void wait() const override {
    wl_event_queue* const queue = wl_display_create_queue(display_);
    wl_display_roundtrip_queue(display_, queue);
    wl_event_queue_destroy(queue);
  }

 private:
  wl_display* const display_;
  const bool owned_;
};

}  // namespace

std::shared_ptr<WindowSystem> openWayland(const Platform& platform) {
  auto* display = static_cast<wl_display*>(platform.native);
  const bool owned = display == nullptr;
  if (owned) display = wl_display_connect(nullptr);
  return display == nullptr ? nullptr : std::make_shared<Wayland>(display, owned);
}

}  // namespace anteroom::egl
