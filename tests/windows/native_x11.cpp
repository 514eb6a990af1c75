// X11 through Xlib or xcb. Both have an xcb connection, by which windows are made and looked at.
#include <X11/Xlib-xcb.h>
#include <X11/Xlib.h>
#include <xcb/xcb.h>

#include <bit>
#include <cstdlib>
#include <mutex>
#include <stdexcept>

#include "native.h"

namespace windows {
namespace {

template <class T>
struct Freed {
  void operator()(T* reply) const { std::free(reply); }
};
template <class T>
using Reply = std::unique_ptr<T, Freed<T>>;

// Xlib has one error handler for all displays.
std::mutex complaintsMutex;
std::vector<std::string> xlibComplaints;

int noteComplaint(Display*, XErrorEvent* event) {
  std::scoped_lock lock(complaintsMutex);
  xlibComplaints.push_back("error " + std::to_string(event->error_code) + " of request " +
                           std::to_string(event->request_code) + "." + std::to_string(event->minor_code));
  return 0;
}

struct Visual {
  std::uint32_t id = 0, red = 0, green = 0, blue = 0;
  int depth = 0;
};

std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
  const std::uint32_t most = mask >> std::countr_zero(mask);
  return std::uint8_t((((pixel & mask) >> std::countr_zero(mask)) * 255 + most / 2) / most);
}

class X11Display final : public NativeDisplay {
 public:
  explicit X11Display(Platform platform) : NativeDisplay(platform) {
    int screen = 0;
    if (platform == Platform::Xlib) {
      static const bool threads = XInitThreads();
      xlib_ = threads ? XOpenDisplay(nullptr) : nullptr;
      if (!xlib_) throw std::runtime_error("no X display");
      XSetErrorHandler(noteComplaint);
      connection_ = XGetXCBConnection(xlib_);
      screen = DefaultScreen(xlib_);
    } else {
      connection_ = xcb_connect(nullptr, &screen);
      if (xcb_connection_has_error(connection_)) {
        xcb_disconnect(connection_);
        throw std::runtime_error("no X display");
      }
    }
    xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(connection_));
    for (; screen > 0; --screen) xcb_screen_next(&screens);
    screen_ = screens.data;
    for (auto depths = xcb_screen_allowed_depths_iterator(screen_); depths.rem; xcb_depth_next(&depths))
      for (auto visuals = xcb_depth_visuals_iterator(depths.data); visuals.rem; xcb_visualtype_next(&visuals))
        if (const auto& v = *visuals.data;
            v._class == XCB_VISUAL_CLASS_TRUE_COLOR || v._class == XCB_VISUAL_CLASS_DIRECT_COLOR)
          visuals_.push_back({v.visual_id, v.red_mask, v.green_mask, v.blue_mask, depths.data->depth});
  }

  ~X11Display() override {
    if (xlib_)
      XCloseDisplay(xlib_);
    else
      xcb_disconnect(connection_);
  }

  void* handle() const override {
    return platform() == Platform::Xlib ? static_cast<void*>(xlib_) : static_cast<void*>(connection_);
  }
  std::unique_ptr<NativeWindow> createWindow(const WindowRequest& request) override;

  int visualDepth(std::uint32_t id) const override {
    for (const Visual& each : visuals_)
      if (each.id == id) return each.depth;
    return 0;
  }

  ScreenSize screenSize() const override {
    return {screen_->width_in_pixels, screen_->height_in_pixels, screen_->width_in_millimeters,
            screen_->height_in_millimeters};
  }

  Image screen() override {
    return grab(screen_->root, screen_->width_in_pixels, screen_->height_in_pixels,
                visual(screen_->root_visual));
  }

  void cut(NativeWindow& window) override {
    finish(xcb_kill_client_checked(connection_, std::uint32_t(window.value())));
  }

  std::vector<std::string> complaints() override {
    std::vector<std::string> result;
    if (xlib_) {
      XSync(xlib_, False);
      std::scoped_lock lock(complaintsMutex);
      result.swap(xlibComplaints);
      return result;
    }
    sync();
    while (const Reply<xcb_generic_event_t> event{xcb_poll_for_event(connection_)})
      if (event->response_type == 0)
        result.push_back("error " +
                         std::to_string(reinterpret_cast<xcb_generic_error_t&>(*event).error_code));
    return result;
  }

  void sync() {
    Reply<xcb_get_input_focus_reply_t>(
        xcb_get_input_focus_reply(connection_, xcb_get_input_focus(connection_), nullptr));
  }
  // Waits for the request; its errors are nobody's concern.
  void finish(xcb_void_cookie_t cookie) {
    Reply<xcb_generic_error_t>(xcb_request_check(connection_, cookie));
  }

  const Visual& visual(std::uint32_t id) const {
    for (const Visual& each : visuals_)
      if (each.id == id) return each;
    throw std::runtime_error("no such visual");
  }

  // 24 and 32 bits deep: 32 bits a pixel; 16: 16.
  Image grab(xcb_drawable_t drawable, int width, int height, const Visual& visual) {
    const Reply<xcb_get_image_reply_t> reply(
        xcb_get_image_reply(connection_,
                            xcb_get_image(connection_, XCB_IMAGE_FORMAT_Z_PIXMAP, drawable, 0, 0,
                                          std::uint16_t(width), std::uint16_t(height), ~0u),
                            nullptr));
    if (!reply) throw std::runtime_error("the server does not show the window");
    const std::uint8_t* data = xcb_get_image_data(reply.get());
    const std::size_t bytes = visual.depth <= 16 ? 2 : 4;
    const std::size_t stride = (std::size_t(width) * bytes + 3) & ~std::size_t{3};
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::uint8_t* at = data + std::size_t(height - 1 - y) * stride + std::size_t(x) * bytes;
        std::uint32_t pixel = 0;
        for (std::size_t i = 0; i < bytes; ++i) pixel |= std::uint32_t(at[i]) << (8 * i);
        image.at(x, y) = {channel(pixel, visual.red), channel(pixel, visual.green),
                          channel(pixel, visual.blue)};
      }
    }
    return image;
  }

  xcb_connection_t* connection() const { return connection_; }
  xcb_screen_t* root() const { return screen_; }

 private:
  Display* xlib_ = nullptr;
  xcb_connection_t* connection_ = nullptr;
  xcb_screen_t* screen_ = nullptr;
  std::vector<Visual> visuals_;
};

class X11Window final : public NativeWindow {
 public:
  X11Window(X11Display& display, const WindowRequest& request) : display_(display) {
    xcb_connection_t* const connection = display_.connection();
    visual_ = display_.visual(request.visual ? request.visual : display_.root()->root_visual);
    colormap_ = xcb_generate_id(connection);
    xcb_create_colormap(connection, XCB_COLORMAP_ALLOC_NONE, colormap_, display_.root()->root, visual_.id);
    xcb_ = xcb_generate_id(connection);
    xlib_ = xcb_;
    const std::uint32_t values[] = {0, 0, 1, XCB_EVENT_MASK_STRUCTURE_NOTIFY, colormap_};
    display_.finish(xcb_create_window_checked(
        connection, std::uint8_t(visual_.depth), xcb_, display_.root()->root, std::int16_t(request.x),
        std::int16_t(request.y), std::uint16_t(request.width), std::uint16_t(request.height), 0,
        XCB_WINDOW_CLASS_INPUT_OUTPUT, visual_.id,
        XCB_CW_BACK_PIXEL | XCB_CW_BORDER_PIXEL | XCB_CW_OVERRIDE_REDIRECT | XCB_CW_EVENT_MASK |
            XCB_CW_COLORMAP,
        values));
    if (request.shown) show();
  }

  ~X11Window() override {
    destroy();
    display_.finish(xcb_free_colormap_checked(display_.connection(), colormap_));
  }

  std::uintptr_t value() const override { return xcb_; }
  // An XID of Xlib is a long, one of xcb has 32 bits: what stands behind it is not part of it.
  void* pointer() override {
    if (display_.platform() == Platform::Xlib) return &xlib_;
    return &xcb_;
  }
  void resize(int width, int height) override {
    const std::uint32_t size[] = {std::uint32_t(width), std::uint32_t(height)};
    display_.finish(xcb_configure_window_checked(display_.connection(), xcb_,
                                                 XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT, size));
  }
  void show() override { display_.finish(xcb_map_window_checked(display_.connection(), xcb_)); }
  void hide() override { display_.finish(xcb_unmap_window_checked(display_.connection(), xcb_)); }
  void destroy() override {
    if (xcb_) display_.finish(xcb_destroy_window_checked(display_.connection(), xcb_));
    xcb_ = 0;
    xlib_ = 0;
  }
  Image onScreen() override {
    xcb_connection_t* const connection = display_.connection();
    const Reply<xcb_get_geometry_reply_t> size(
        xcb_get_geometry_reply(connection, xcb_get_geometry(connection, xcb_), nullptr));
    if (!size) throw std::runtime_error("the window is gone");
    return display_.grab(xcb_, size->width, size->height, visual_);
  }

 private:
  X11Display& display_;
  Visual visual_;
  xcb_colormap_t colormap_ = 0;
  xcb_window_t xcb_ = 0;
  std::uint32_t behind_ = 0xdeadbeef;
  ::Window xlib_ = 0;
};

std::unique_ptr<NativeWindow> X11Display::createWindow(const WindowRequest& request) {
  return std::make_unique<X11Window>(*this, request);
}

}  // namespace

std::unique_ptr<NativeDisplay> openX11(Platform platform) {
  return std::make_unique<X11Display>(platform);
}

}  // namespace windows
