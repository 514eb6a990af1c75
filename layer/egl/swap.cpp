// Section 3.10: posting the color buffer.
#include <algorithm>
#include <vector>

#include "layer/egl/commands.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

// The draw surface of the calling thread, which posting wants. Throws EGL_BAD_SURFACE.
const Binding& postedBinding(EGLDisplay dpy, EGLSurface handle) {
  const auto surface = initializedDisplay(dpy).surface(handle);
  const Binding* binding = currentBinding();
  require(binding != nullptr && binding->draw == surface, EGL_BAD_SURFACE);
  return *binding;
}

// `rects`: x, y, width and height each, from the lower left; EGL_KHR_swap_buffers_with_damage.
EGLBoolean swap(EGLDisplay dpy, EGLSurface surface, const EGLint* rects, EGLint count,
                const char* name = __builtin_FUNCTION()) {
  return command<EGLBoolean>(
      EGL_FALSE,
      [&](Lock& lock) {
        const Binding& binding = postedBinding(dpy, surface);
        require(count >= 0 && (count == 0 || rects != nullptr), EGL_BAD_PARAMETER);
        lock.unlock();
        std::vector<render::Rect> damage;
        for (; count > 0; --count, rects += 4) damage.push_back({rects[0], rects[1], rects[2], rects[3]});
        ++binding.context->frames;
        binding.draw->post(binding, damage);
        binding.context->device->endFrame();
        return EGL_TRUE;
      },
      name);
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLBoolean EGLAPIENTRY eglSwapBuffers(EGLDisplay dpy, EGLSurface surface) {
  return swap(dpy, surface, nullptr, 0);
}

EGLBoolean EGLAPIENTRY eglSwapBuffersWithDamageEXT(EGLDisplay dpy, EGLSurface surface, const EGLint* rects,
                                                   EGLint n_rects) {
  return swap(dpy, surface, rects, n_rects);
}

EGLBoolean EGLAPIENTRY eglSwapBuffersWithDamageKHR(EGLDisplay dpy, EGLSurface surface, const EGLint* rects,
                                                   EGLint n_rects) {
  return swap(dpy, surface, rects, n_rects);
}

EGLBoolean EGLAPIENTRY eglCopyBuffers(EGLDisplay dpy, EGLSurface surface, EGLNativePixmapType) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) -> EGLBoolean {
    postedBinding(dpy, surface);
    throw Error{EGL_BAD_NATIVE_PIXMAP};
  });
}

EGLBoolean EGLAPIENTRY eglSwapInterval(EGLDisplay dpy, EGLint interval) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    initializedDisplay(dpy);
    const Binding* binding = currentBinding();
    require(binding != nullptr, EGL_BAD_CONTEXT);
    require(binding->draw != nullptr, EGL_BAD_SURFACE);
    const Config& config = binding->draw->config;
    binding->draw->setSwapInterval(
        std::clamp(interval, config.get(EGL_MIN_SWAP_INTERVAL), config.get(EGL_MAX_SWAP_INTERVAL)));
    return EGL_TRUE;
  });
}
