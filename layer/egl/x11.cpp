// X11, by xcb alone: a Display of Xlib has a connection of xcb inside.
#include <dlfcn.h>
#include <xcb/xcb.h>

#include <cstdlib>
#include <memory>
#include <set>

#include "layer/egl/errors.h"
#include "layer/egl/window_system.h"

// Last: its macros have names of ours.
#include <X11/Xlib.h>

namespace anteroom::egl {
namespace {

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
template <typename Reply>
using Owned = std::unique_ptr<Reply, Free>;

// Windows that have a surface. Never destroyed: threads may draw while the process ends.
std::set<xcb_window_t>& taken() {
  static auto& instance = *new std::set<xcb_window_t>;
  return instance;
}

Owned<xcb_get_geometry_reply_t> geometryOf(xcb_connection_t* connection, xcb_drawable_t drawable) {
  xcb_generic_error_t* error = nullptr;
  Owned<xcb_get_geometry_reply_t> reply(
      xcb_get_geometry_reply(connection, xcb_get_geometry(connection, drawable), &error));
  const Owned<xcb_generic_error_t> owned(error);
  return reply;
}

class X11Window final : public NativeWindow {
 public:
  X11Window(std::shared_ptr<void> system, xcb_connection_t* connection, xcb_window_t window, int depth)
      : system_(std::move(system)), connection_(connection), window_(window), depth_(depth) {
    require(taken().insert(window).second, EGL_BAD_ALLOC);
  }
  ~X11Window() override { taken().erase(window_); }

  render::NativeWindow handle() const override {
    return {render::WindowSystem::Xcb, connection_, nullptr, window_};
  }
  bool isTranslucent() const override { return depth_ == 32; }
  bool size(EGLint& width, EGLint& height) const override {
    const auto geometry = geometryOf(connection_, window_);
    if (geometry == nullptr) return false;
    width = geometry->width;
    height = geometry->height;
    return true;
  }
  bool isSizedByProgram() const override { return false; }

 private:
  const std::shared_ptr<void> system_;  // whose connection it may be
  xcb_connection_t* const connection_;
  const xcb_window_t window_;
  const int depth_;
};

xcb_screen_t* screenOf(xcb_connection_t* connection, int number) {
  xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(connection));
  for (; screens.rem > 0 && number > 0; --number) xcb_screen_next(&screens);
  return number == 0 && screens.rem > 0 ? screens.data : nullptr;
}

class X11 final : public WindowSystem, public std::enable_shared_from_this<X11> {
 public:
  X11(xcb_connection_t* connection, xcb_screen_t* screen, bool owned, bool xlib)
      : connection_(connection), screen_(screen), owned_(owned), xlib_(xlib) {}
  ~X11() override {
    if (owned_) xcb_disconnect(connection_);
  }

  render::WindowSystem name() const override { return render::WindowSystem::Xcb; }

  std::vector<Visual> visuals(bool alpha, const render::Caps& caps) const override {
    std::vector<Visual> found;
    // A window of the usual depth hides what is behind, whatever its colors' alpha.
    addVisual(24, found);
    if (alpha && caps.x11Alpha) addVisual(32, found);
    return found;
  }

  std::unique_ptr<NativeWindow> window(uintptr_t native, const Visual& visual) override {
    // Also sends what Xlib still holds back of the window's making.
    const auto geometry = geometryOf(connection_, static_cast<xcb_window_t>(native));
    require(geometry != nullptr, EGL_BAD_NATIVE_WINDOW);
    require(isWindow(static_cast<xcb_window_t>(native)), EGL_BAD_NATIVE_WINDOW);
    // Colors with alpha may be asked for without a thought of the visual.
    const int depth = geometry->depth;
    require(depth == 24 || (depth == 32 && visual.alpha), EGL_BAD_MATCH);
    return std::make_unique<X11Window>(shared_from_this(), connection_, static_cast<xcb_window_t>(native),
                                       depth);
  }

  std::unique_ptr<NativeWindow> platformWindow(void* native, const Visual& visual) override {
    require(native != nullptr, EGL_BAD_NATIVE_WINDOW);
    return xlib_ ? window(*static_cast<const ::Window*>(native), visual)
                 : window(*static_cast<const xcb_window_t*>(native), visual);
  }

  void wait() const override {
    const Owned<xcb_get_input_focus_reply_t> reply(
        xcb_get_input_focus_reply(connection_, xcb_get_input_focus(connection_), nullptr));
  }

 private:
  // A pixmap has a geometry, too, but no attributes.
  bool isWindow(xcb_window_t window) const {
    xcb_generic_error_t* error = nullptr;
    const Owned<xcb_get_window_attributes_reply_t> reply(
        xcb_get_window_attributes_reply(connection_, xcb_get_window_attributes(connection_, window), &error));
    const Owned<xcb_generic_error_t> owned(error);
    return reply != nullptr;
  }

  // The screen's TrueColor visual with 8 bits a component of that depth; its default one before others.
  void addVisual(int depth, std::vector<Visual>& found) const {
    const xcb_visualtype_t* best = nullptr;
    xcb_depth_iterator_t depths = xcb_screen_allowed_depths_iterator(screen_);
    for (; depths.rem > 0; xcb_depth_next(&depths)) {
      if (depths.data->depth != depth) continue;
      xcb_visualtype_iterator_t types = xcb_depth_visuals_iterator(depths.data);
      for (; types.rem > 0; xcb_visualtype_next(&types)) {
        const xcb_visualtype_t& type = *types.data;
        const bool fits = type._class == XCB_VISUAL_CLASS_TRUE_COLOR && type.red_mask == 0xff0000 &&
                          type.green_mask == 0xff00 && type.blue_mask == 0xff;
        if (fits && (best == nullptr || type.visual_id == screen_->root_visual)) best = &type;
      }
    }
    if (best != nullptr)
      found.push_back({static_cast<EGLint>(best->visual_id), XCB_VISUAL_CLASS_TRUE_COLOR, depth == 32});
  }

  xcb_connection_t* const connection_;
  xcb_screen_t* const screen_;
  const bool owned_, xlib_;
};

// Of a Display. libX11-xcb is loaded when a program has Xlib's type, and not before. Null: it is missing.
xcb_connection_t* connectionOf(Display* display) {
  using Function = xcb_connection_t* (*)(Display*);
  static void* const library = dlopen("libX11-xcb.so.1", RTLD_NOW | RTLD_LOCAL);
  void* const found = library == nullptr ? nullptr : dlsym(library, "XGetXCBConnection");
  if (found != nullptr) return reinterpret_cast<Function>(found)(display);
  log("libX11-xcb.so.1 is missing: install libx11-xcb1");
  return nullptr;
}

}  // namespace

std::shared_ptr<WindowSystem> openX11(const Platform& platform) {
  const bool xlib = platform.name == EGL_PLATFORM_X11_KHR;
  int screen = 0;
  xcb_connection_t* connection = nullptr;
  if (platform.native == nullptr) {
    connection = xcb_connect(nullptr, &screen);
    if (xcb_connection_has_error(connection) != 0) {
      xcb_disconnect(connection);
      return nullptr;
    }
  } else if (xlib) {
    auto* const display = static_cast<Display*>(platform.native);
    screen = DefaultScreen(display);
    connection = connectionOf(display);
  } else {
    connection = static_cast<xcb_connection_t*>(platform.native);
  }
  if (connection == nullptr || xcb_connection_has_error(connection) != 0) return nullptr;
  const bool owned = platform.native == nullptr;
  xcb_screen_t* const found = screenOf(connection, platform.screen >= 0 ? platform.screen : screen);
  if (found != nullptr) return std::make_shared<X11>(connection, found, owned, xlib);
  if (owned) xcb_disconnect(connection);
  throw Error{EGL_BAD_ATTRIBUTE};
}

}  // namespace anteroom::egl
