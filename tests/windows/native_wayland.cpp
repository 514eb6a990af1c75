// Wayland. All windows are subsurfaces of one toplevel that fills the output: their places on the screen are
// known.
#include <screenshooter-client-protocol.h>
#include <sys/mman.h>
#include <unistd.h>
#include <wayland-client.h>
#include <wayland-egl.h>
#include <xdg-shell-client-protocol.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "native.h"

namespace windows {
namespace {

template <auto destroy>
struct Destroyed {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
template <class T, auto destroy>
using Owned = std::unique_ptr<T, Destroyed<destroy>>;

// A picture in shared memory.
class ShmBuffer {
 public:
  ShmBuffer(wl_shm* shm, int width, int height, std::uint32_t format)
      : size_(std::size_t(width) * std::size_t(height) * 4) {
    const int file = memfd_create("picture", MFD_CLOEXEC);
    if (file < 0 || ftruncate(file, off_t(size_)) != 0) throw std::runtime_error("no shared memory");
    memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory_ == MAP_FAILED) throw std::runtime_error("no shared memory");
    wl_shm_pool* const pool = wl_shm_create_pool(shm, file, std::int32_t(size_));
    buffer_ = wl_shm_pool_create_buffer(pool, 0, width, height, width * 4, format);
    wl_shm_pool_destroy(pool);
    close(file);
  }
  ~ShmBuffer() {
    wl_buffer_destroy(buffer_);
    munmap(memory_, size_);
  }
  ShmBuffer(const ShmBuffer&) = delete;
  ShmBuffer& operator=(const ShmBuffer&) = delete;
  wl_buffer* buffer() const { return buffer_; }
  const std::uint8_t* data() const { return static_cast<const std::uint8_t*>(memory_); }

 private:
  std::size_t size_;
  void* memory_;
  wl_buffer* buffer_;
};

class WaylandDisplay final : public NativeDisplay {
 public:
  WaylandDisplay() : NativeDisplay(Platform::Wayland), display_(wl_display_connect(nullptr)) {
    if (!display_) throw std::runtime_error("no Wayland display");
    registry_.reset(wl_display_get_registry(display_.get()));
    wl_registry_add_listener(registry_.get(), &kRegistryListener, this);
    roundtrip();
    if (!compositor_ || !subcompositor_ || !shm_ || !output_ || !shell_ || !shooter_)
      throw std::runtime_error("the Wayland server lacks what the tests need");
    xdg_wm_base_add_listener(shell_.get(), &kShellListener, nullptr);
    wl_output_add_listener(output_.get(), &kOutputListener, this);
    weston_screenshooter_add_listener(shooter_.get(), &kShooterListener, this);
    roundtrip();
  }

  void* handle() const override { return display_.get(); }
  std::unique_ptr<NativeWindow> createWindow(const WindowRequest& request) override;
  int visualDepth(std::uint32_t) const override { return 0; }
  ScreenSize screenSize() const override { return size_; }

  Image screen() override {
    const ShmBuffer shot(shm_.get(), size_.width, size_.height, WL_SHM_FORMAT_XRGB8888);
    shotDone_ = false;
    weston_screenshooter_shoot(shooter_.get(), output_.get(), shot.buffer());
    while (!shotDone_)
      if (wl_display_dispatch(display_.get()) < 0)
        throw std::runtime_error("the Wayland connection is broken");
    Image image(size_.width, size_.height);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* pixel = shot.data() + 4 * ((image.height - 1 - y) * image.width + x);
        image.at(x, y) = {pixel[2], pixel[1], pixel[0]};
      }
    }
    return image;
  }

  void cut(NativeWindow&) override {}

  std::vector<std::string> complaints() override {
    roundtrip();
    if (const int error = wl_display_get_error(display_.get())) return {std::strerror(error)};
    return {};
  }

  void roundtrip() { wl_display_roundtrip(display_.get()); }
  void commitBase() { wl_surface_commit(base_.get()); }
  wl_compositor* compositor() const { return compositor_.get(); }
  wl_subcompositor* subcompositor() const { return subcompositor_.get(); }
  wl_surface* base() const { return base_.get(); }

 private:
  ScreenSize size_{};
  bool configured_ = false, shotDone_ = false;

  // The toplevel is black and in fullscreen.
  void openBase() {
    if (base_) return;
    base_.reset(wl_compositor_create_surface(compositor_.get()));
    baseXdg_.reset(xdg_wm_base_get_xdg_surface(shell_.get(), base_.get()));
    xdg_surface_add_listener(baseXdg_.get(), &kSurfaceListener, this);
    baseToplevel_.reset(xdg_surface_get_toplevel(baseXdg_.get()));
    xdg_toplevel_add_listener(baseToplevel_.get(), &kToplevelListener, nullptr);
    xdg_toplevel_set_fullscreen(baseToplevel_.get(), output_.get());
    commitBase();
    while (!configured_)
      if (wl_display_dispatch(display_.get()) < 0)
        throw std::runtime_error("the Wayland connection is broken");
    basePicture_ = std::make_unique<ShmBuffer>(shm_.get(), size_.width, size_.height, WL_SHM_FORMAT_XRGB8888);
    wl_surface_attach(base_.get(), basePicture_->buffer(), 0, 0);
    wl_surface_damage_buffer(base_.get(), 0, 0, size_.width, size_.height);
    commitBase();
    roundtrip();
    // Weston does not repaint for the first frame of a subsurface, whose frame callback would then never
    // come.
    repaints_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        wl_surface_damage_buffer(base_.get(), 0, 0, 1, 1);
        commitBase();
        wl_display_flush(display_.get());
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
  }

  static WaylandDisplay& self(void* data) { return *static_cast<WaylandDisplay*>(data); }

  template <class T>
  static void bind(T& to, wl_registry* registry, std::uint32_t id, const wl_interface& interface,
                   std::uint32_t version) {
    to.reset(static_cast<typename T::pointer>(wl_registry_bind(registry, id, &interface, version)));
  }
  static void addGlobal(void* data, wl_registry* registry, std::uint32_t id, const char* which,
                        std::uint32_t) {
    const std::string_view interface = which;
    WaylandDisplay& to = self(data);
    if (interface == wl_compositor_interface.name)
      bind(to.compositor_, registry, id, wl_compositor_interface, 4);
    else if (interface == wl_subcompositor_interface.name)
      bind(to.subcompositor_, registry, id, wl_subcompositor_interface, 1);
    else if (interface == wl_shm_interface.name)
      bind(to.shm_, registry, id, wl_shm_interface, 1);
    else if (interface == wl_output_interface.name && !to.output_)
      bind(to.output_, registry, id, wl_output_interface, 1);
    else if (interface == xdg_wm_base_interface.name)
      bind(to.shell_, registry, id, xdg_wm_base_interface, 1);
    else if (interface == weston_screenshooter_interface.name)
      bind(to.shooter_, registry, id, weston_screenshooter_interface, 1);
  }
  static constexpr wl_registry_listener kRegistryListener{addGlobal,
                                                          [](void*, wl_registry*, std::uint32_t) {}};
  static constexpr xdg_wm_base_listener kShellListener{
      [](void*, xdg_wm_base* shell, std::uint32_t serial) { xdg_wm_base_pong(shell, serial); }};
  static constexpr wl_output_listener kOutputListener{
      .geometry =
          [](void* data, wl_output*, int, int, int widthMm, int heightMm, int, const char*, const char*,
             int) {
            self(data).size_.widthMm = widthMm;
            self(data).size_.heightMm = heightMm;
          },
      .mode =
          [](void* data, wl_output*, std::uint32_t flags, int width, int height, int) {
            if (!(flags & WL_OUTPUT_MODE_CURRENT)) return;
            self(data).size_.width = width;
            self(data).size_.height = height;
          },
      .done = nullptr,
      .scale = nullptr,
      .name = nullptr,
      .description = nullptr};
  static constexpr weston_screenshooter_listener kShooterListener{
      [](void* data, weston_screenshooter*) { self(data).shotDone_ = true; }};
  static constexpr xdg_surface_listener kSurfaceListener{
      [](void* data, xdg_surface* surface, std::uint32_t serial) {
        xdg_surface_ack_configure(surface, serial);
        self(data).configured_ = true;
      }};
  static constexpr xdg_toplevel_listener kToplevelListener{
      .configure = [](void*, xdg_toplevel*, int, int, wl_array*) {},
      .close = [](void*, xdg_toplevel*) {},
      .configure_bounds = nullptr,
      .wm_capabilities = nullptr};

  Owned<wl_display, wl_display_disconnect> display_;
  Owned<wl_registry, wl_registry_destroy> registry_;
  Owned<wl_compositor, wl_compositor_destroy> compositor_;
  Owned<wl_subcompositor, wl_subcompositor_destroy> subcompositor_;
  Owned<wl_shm, wl_shm_destroy> shm_;
  Owned<wl_output, wl_output_destroy> output_;
  Owned<xdg_wm_base, xdg_wm_base_destroy> shell_;
  Owned<weston_screenshooter, weston_screenshooter_destroy> shooter_;
  std::unique_ptr<ShmBuffer> basePicture_;
  Owned<wl_surface, wl_surface_destroy> base_;
  Owned<xdg_surface, xdg_surface_destroy> baseXdg_;
  Owned<xdg_toplevel, xdg_toplevel_destroy> baseToplevel_;
  std::jthread repaints_;
};

class WaylandWindow final : public NativeWindow {
 public:
  WaylandWindow(WaylandDisplay& display, const WindowRequest& request)
      : display_(display),
        request_(request),
        surface_(wl_compositor_create_surface(display.compositor())),
        subsurface_(wl_subcompositor_get_subsurface(display.subcompositor(), surface_.get(), display.base())),
        window_(wl_egl_window_create(surface_.get(), request.width, request.height)) {
    wl_subsurface_set_desync(subsurface_.get());
    if (request.shown)
      show();
    else
      hide();
  }

  std::uintptr_t value() const override { return reinterpret_cast<std::uintptr_t>(window_.get()); }
  void* pointer() override { return window_.get(); }
  void resize(int width, int height) override {
    wl_egl_window_resize(window_.get(), width, height, 0, 0);
    request_.width = width;
    request_.height = height;
  }
  void show() override { moveTo(request_.x, request_.y); }
  // Off the screen: the server sends no frame callbacks.
  void hide() override { moveTo(-10'000, -10'000); }
  // The surface stays, since nothing may outlive it that was made of it.
  void destroy() override { window_.reset(); }
  Image onScreen() override {
    const int height = display_.screenSize().height;
    return display_.screen().part(request_.x, height - request_.y - request_.height, request_.width,
                                  request_.height);
  }

 private:
  void moveTo(int x, int y) {
    wl_subsurface_set_position(subsurface_.get(), x, y);
    display_.commitBase();
    display_.roundtrip();
  }

  WaylandDisplay& display_;
  WindowRequest request_;
  Owned<wl_surface, wl_surface_destroy> surface_;
  Owned<wl_subsurface, wl_subsurface_destroy> subsurface_;
  Owned<wl_egl_window, wl_egl_window_destroy> window_;
};

std::unique_ptr<NativeWindow> WaylandDisplay::createWindow(const WindowRequest& request) {
  openBase();
  return std::make_unique<WaylandWindow>(*this, request);
}

}  // namespace

std::unique_ptr<NativeDisplay> openWayland() {
  return std::make_unique<WaylandDisplay>();
}

}  // namespace windows
