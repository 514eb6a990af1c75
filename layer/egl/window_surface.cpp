#include "layer/egl/window_surface.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <utility>

#include "layer/egl/attributes.h"
#include "layer/egl/commands.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

WindowSurface::WindowSurface(const Display& owner, std::shared_ptr<render::Device> device,
                             const Config& withConfig, const SurfaceAttributes& withAttributes,
                             std::unique_ptr<NativeWindow> native, std::unique_ptr<render::Window> window)
    : Surface(owner, std::move(device), withConfig, withAttributes, createHud(true)),
      native_(std::move(native)),
      window_(std::move(window)) {}

bool WindowSurface::allocate() {
  if (framebuffer_.width != 0) return true;
  const bool allocated = renew();
  expired_ = true;  // until something is drawn, the size may still become another
  return allocated;
}

bool WindowSurface::renew() {
  if (!native_->isThere()) window_->lose();
  window_->setInterval(native_->isPaced() ? 0 : interval_.load());
  window_->setPreserved(preserved_);
  EGLint width = 0, height = 0;
  if (native_->isSizedByProgram()) native_->size(width, height);
  if (!window_->acquire(width, height)) return false;
  expired_ = false;
  if (framebuffer_.readable().image == window_->image()) return true;

  const std::shared_ptr<render::Image>& image = window_->image();
  render::Framebuffer next;
  next.yDown = true;
  next.samples = std::max(1, config.samples);
  next.width = image->desc().width;
  next.height = image->desc().height;
  if (window_->samples() != nullptr) next.resolve.image = image;
  next.color.image = window_->samples() != nullptr ? window_->samples() : image;
  if (!createDepthStencil(next)) return false;
  framebuffer_ = next;
  nameImages();
  size_[0] = next.width;
  size_[1] = next.height;
  return true;
}

EGLint WindowSurface::size(int axis) const {
  EGLint native[2];
  if (expired_ && native_->size(native[0], native[1])) return native[axis];
  return size_[axis];
}

void WindowSurface::setSwapBehavior(EGLint behavior) {
  Surface::setSwapBehavior(behavior);
  preserved_ = behavior == EGL_BUFFER_PRESERVED;
}

// Pictures that are not kept have the HUD drawn over them.
EGLint WindowSurface::age() const {
  return hasHud() && !preserved_ ? 0 : window_->age();
}

void WindowSurface::post(const Binding& binding, std::span<const render::Rect> damage) {
  renewSurfaces(binding);  // a picture that nobody drew is shown, too
  gl::Context& context = *binding.context->gl;
  if (!native_->isThere()) {
    gl::flush(context);
    window_->lose();
  }
  window_->setPreserved(preserved_);
  if (native_->isThere() && native_->isPaced()) {
    gl::flush(context);
    native_->pace(interval_);
  }
  const render::Hud* const hud = updateHud(binding);
  window_->setHud(hud);
  // The HUD changes where the program did not draw.
  const render::Presented result =
      gl::present(context, *window_, hud == nullptr ? damage : std::span<const render::Rect>());
  expired_ = true;
  gl::expireDefaultFramebuffer(context, renewSurfaces, &binding);
  require(result != render::Presented::Lost, EGL_BAD_NATIVE_WINDOW);
  require(result != render::Presented::OutOfMemory, EGL_BAD_ALLOC);
}

namespace {

template <typename Integer>
SurfaceAttributes parse(const Integer* list, const Config& config) {
  SurfaceAttributes attributes;
  forEachAttribute(list, [&](EGLint name, EGLAttrib value) {
    switch (name) {
      case EGL_RENDER_BUFFER:
        require(value == EGL_BACK_BUFFER || value == EGL_SINGLE_BUFFER, EGL_BAD_ATTRIBUTE);
        attributes.renderBuffer = static_cast<EGLint>(value);
        break;
      case EGL_PRESENT_OPAQUE_EXT:
        attributes.presentOpaque = toBoolean(value);
        break;
      default:
        setSurfaceAttribute(attributes, name, value);
    }
  });
  requireMatch(attributes, config);
  return attributes;
}

// `find`: makes the NativeWindow, of a window system and a visual.
template <typename Integer, typename Find>
EGLSurface createWindow(EGLDisplay dpy, EGLConfig handle, const Integer* list, Find find,
                        const char* name = __builtin_FUNCTION()) {
  return command<EGLSurface>(
      EGL_NO_SURFACE,
      [&](Lock&) {
        Display& display = initializedDisplay(dpy);
        require(display.windowSystem() != nullptr, EGL_BAD_NATIVE_WINDOW);
        const Config& config = display.config(handle);
        require(config.window, EGL_BAD_MATCH);
        const SurfaceAttributes attributes = parse(list, config);
        std::unique_ptr<NativeWindow> native = find(*display.windowSystem(), config.visual);
        render::WindowDesc desc;
        desc.native = native->handle();
        desc.format = colorFormat(config, attributes);
        desc.samples = std::max(1, config.samples);
        desc.translucent =
            native->isTranslucent() && !attributes.presentOpaque && render::info(desc.format).alpha != 0;
        auto window = display.device()->createWindow(desc);
        require(window != nullptr, render::isSrgb(desc.format) ? EGL_BAD_MATCH : EGL_BAD_ALLOC);
        return display.surfaces.add(std::make_shared<WindowSurface>(
            display, display.device(), config, attributes, std::move(native), std::move(window)));
      },
      name);
}

template <typename Integer>
EGLSurface createPlatformWindow(EGLDisplay dpy, EGLConfig config, void* window, const Integer* list,
                                const char* name = __builtin_FUNCTION()) {
  const auto find = [&](WindowSystem& system, const Visual& visual) {
    return system.platformWindow(window, visual);
  };
  return createWindow(dpy, config, list, find, name);
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLSurface EGLAPIENTRY eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType win,
                                              const EGLint* attrib_list) {
  const auto find = [&](WindowSystem& system, const Visual& visual) { return system.window(win, visual); };
  return createWindow(dpy, config, attrib_list, find);
}

EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void* native_window,
                                                      const EGLAttrib* attrib_list) {
  return createPlatformWindow(dpy, config, native_window, attrib_list);
}

EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config,
                                                         void* native_window, const EGLint* attrib_list) {
  return createPlatformWindow(dpy, config, native_window, attrib_list);
}
