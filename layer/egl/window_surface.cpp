#include "layer/egl/window_surface.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "layer/egl/attributes.h"
#include "layer/egl/commands.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

namespace {

std::unique_ptr<render::Window> createWindow(render::Device& device, const Config& config,
                                             const SurfaceAttributes& attributes, const NativeWindow& native,
                                             const render::WindowOwner& owner) {
  render::WindowDesc desc;
  desc.native = native.handle();
  desc.owner = &owner;
  desc.format = colorFormat(config, attributes);
  desc.depth = config.depth;
  desc.stencil = config.stencil;
  desc.samples = std::max(1, config.samples);
  desc.translucent =
      native.isTranslucent() && !attributes.presentOpaque && render::info(desc.format).alpha != 0;
  auto window = device.createWindow(desc);
  require(window != nullptr, render::isSrgb(desc.format) ? EGL_BAD_MATCH : EGL_BAD_ALLOC);
  return window;
}

}  // namespace

WindowSurface::WindowSurface(const Display& owner, std::shared_ptr<render::Device> device,
                             const Config& withConfig, const SurfaceAttributes& withAttributes,
                             std::unique_ptr<NativeWindow> native)
    : Surface(owner, std::move(device), withConfig, withAttributes, createHud(true)),
      native_(std::move(native)),
      window_(createWindow(*device_, withConfig, withAttributes, *native_, *this)) {}

bool WindowSurface::allocate() {
  if (window_->framebuffer().width != 0) return true;
  char name[32];
  std::snprintf(name, sizeof name, "window %p", handle);
  window_->setLabel(name);
  const bool allocated = window_->makeReady();
  window_->expire();  // until something is drawn, the size may still become another
  return allocated;
}

render::PictureWish WindowSurface::wish() const {
  render::PictureWish wish;
  wish.there = native_->isThere();
  wish.interval = native_->isPaced() ? 0 : interval_.load();
  wish.preserved = preserved_;
  if (native_->isSizedByProgram()) native_->size(wish.width, wish.height);
  return wish;
}

EGLint WindowSurface::size(int axis) const {
  EGLint native[2];
  if (!window_->isReady() && native_->size(native[0], native[1])) return native[axis];
  return axis == 0 ? window_->width() : window_->height();
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
  gl::Context& context = *binding.context->gl;
  if (native_->isThere() && native_->isPaced()) {
    gl::RendererLock(context)->flush();
    native_->pace(interval_);
  }
  const render::Hud* const hud = updateHud(binding);
  window_->setHud(hud);
  // The HUD changes where the program did not draw.
  if (hud != nullptr) damage = {};
  const render::Presented result = gl::RendererLock(context)->present(*window_, damage);
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
EGLSurface createSurface(EGLDisplay dpy, EGLConfig handle, const Integer* list, Find find,
                         const char* name = __builtin_FUNCTION()) {
  return command<EGLSurface>(
      EGL_NO_SURFACE,
      [&](Lock&) {
        Display& display = initializedDisplay(dpy);
        require(display.windowSystem() != nullptr, EGL_BAD_NATIVE_WINDOW);
        const Config& config = display.config(handle);
        require(config.window, EGL_BAD_MATCH);
        const SurfaceAttributes attributes = parse(list, config);
        return display.surfaces.add(std::make_shared<WindowSurface>(
            display, display.device(), config, attributes, find(*display.windowSystem(), config.visual)));
      },
      name);
}

template <typename Integer>
EGLSurface createPlatformWindow(EGLDisplay dpy, EGLConfig config, void* window, const Integer* list,
                                const char* name = __builtin_FUNCTION()) {
  const auto find = [&](WindowSystem& system, const Visual& visual) {
    return system.platformWindow(window, visual);
  };
  return createSurface(dpy, config, list, find, name);
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLSurface EGLAPIENTRY eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType win,
                                              const EGLint* attrib_list) {
  const auto find = [&](WindowSystem& system, const Visual& visual) { return system.window(win, visual); };
  return createSurface(dpy, config, attrib_list, find);
}

EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void* native_window,
                                                      const EGLAttrib* attrib_list) {
  return createPlatformWindow(dpy, config, native_window, attrib_list);
}

EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config,
                                                         void* native_window, const EGLint* attrib_list) {
  return createPlatformWindow(dpy, config, native_window, attrib_list);
}
