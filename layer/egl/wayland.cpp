// Wayland: windows are wl_egl_windows, which say their own size.
#include <dlfcn.h>
#include <wayland-client-core.h>
#include <wayland-egl-backend.h>

#include <atomic>

#include "layer/egl/errors.h"
#include "layer/egl/window_system.h"

namespace anteroom::egl {
namespace {

// libwayland-client is loaded when the default display is asked for: otherwise a program has done so.
void* clientLibrary() {
  static void* const library = dlopen("libwayland-client.so.0", RTLD_NOW | RTLD_LOCAL);
  return library;
}

template <typename Function>
Function clientFunction(const char* name) {
  void* const found = clientLibrary() == nullptr ? nullptr : dlsym(clientLibrary(), name);
  return reinterpret_cast<Function>(found);
}

class WaylandWindow final : public NativeWindow {
 public:
  WaylandWindow(std::shared_ptr<void> system, wl_display* display, wl_egl_window* window)
      : system_(std::move(system)), display_(display), window_(window) {
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

 private:
  const std::shared_ptr<void> system_;
  wl_display* const display_;
  wl_egl_window* const window_;
  std::atomic<bool> gone_{false};
};

class Wayland final : public WindowSystem, public std::enable_shared_from_this<Wayland> {
 public:
  Wayland(wl_display* display, bool owned) : display_(display), owned_(owned) {}
  ~Wayland() override {
    if (owned_) clientFunction<decltype(&wl_display_disconnect)>("wl_display_disconnect")(display_);
  }

  render::WindowSystem name() const override { return render::WindowSystem::Wayland; }

  std::vector<Visual> visuals(bool alpha) const override { return {{0, EGL_NONE, alpha}}; }

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
    const auto roundtrip = clientFunction<decltype(&wl_display_roundtrip)>("wl_display_roundtrip");
    if (owned_ && roundtrip != nullptr) roundtrip(display_);
  }

 private:
  wl_display* const display_;
  const bool owned_;
};

}  // namespace

std::shared_ptr<WindowSystem> openWayland(const Platform& platform) {
  auto* display = static_cast<wl_display*>(platform.native);
  const bool owned = display == nullptr;
  if (owned) {
    const auto connect = clientFunction<decltype(&wl_display_connect)>("wl_display_connect");
    display = connect == nullptr ? nullptr : connect(nullptr);
  }
  return display == nullptr ? nullptr : std::make_shared<Wayland>(display, owned);
}

}  // namespace anteroom::egl
