// Section 3.3.
#include <algorithm>
#include <string_view>

#include "layer/egl/display.h"
#include "layer/egl/eglanteroom.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

constexpr const char* kVersion = "1.5 Anteroom " ANTEROOM_VERSION;

constexpr const char* kClientExtensions =
#define ANTEROOM_CLIENT_EXTENSION(name, purpose) "EGL_" #name " "
#define ANTEROOM_DISPLAY_EXTENSION(name, purpose)
#include "layer/egl/extensions.inc"
#undef ANTEROOM_CLIENT_EXTENSION
#undef ANTEROOM_DISPLAY_EXTENSION
    ;

constexpr const char* kDisplayExtensions =
#define ANTEROOM_CLIENT_EXTENSION(name, purpose)
#define ANTEROOM_DISPLAY_EXTENSION(name, purpose) "EGL_" #name " "
#include "layer/egl/extensions.inc"
#undef ANTEROOM_CLIENT_EXTENSION
#undef ANTEROOM_DISPLAY_EXTENSION
    ;

constexpr std::string_view kExtensions[] = {
#define ANTEROOM_CLIENT_EXTENSION(name, purpose) #name,
#define ANTEROOM_DISPLAY_EXTENSION(name, purpose) #name,
#include "layer/egl/extensions.inc"
#undef ANTEROOM_CLIENT_EXTENSION
#undef ANTEROOM_DISPLAY_EXTENSION
};
static_assert(std::ranges::is_sorted(kExtensions));

// What can be asked without a display; null: nothing of that name.
const char* clientString(EGLint name) {
  switch (name) {
    case EGL_EXTENSIONS:
      return kClientExtensions;
    case EGL_VERSION:
      return kVersion;
    default:
      return nullptr;
  }
}

const char* displayString(const render::Origin& origin, EGLint name) {
  switch (name) {
    case EGL_CLIENT_APIS:
      return "OpenGL_ES";
    case EGL_EXTENSIONS:
      return kDisplayExtensions;
    case EGL_VENDOR:
      return "Anteroom";
    case EGL_VERSION:
      return kVersion;
    case EGL_DEVICES_ANTEROOM:
      return origin.devices.c_str();
    case EGL_DEVICE_CHOICE_ANTEROOM:
      return origin.choice.c_str();
    case EGL_DRIVER_ANTEROOM:
      return origin.driver.c_str();
    case EGL_SHADER_CACHE_ANTEROOM:
      return origin.cache.c_str();
    case EGL_QUIRKS_ANTEROOM:
      return origin.quirks.c_str();
    default:
      return nullptr;
  }
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom::egl;

const char* EGLAPIENTRY eglQueryString(EGLDisplay dpy, EGLint name) {
  return command<const char*>(nullptr, [&](Lock&) {
    const char* found = dpy == EGL_NO_DISPLAY ? clientString(name) : nullptr;
    if (found != nullptr) return found;
    const Display& display = initializedDisplay(dpy);
    found = displayString(display.device()->caps().origin, name);
    require(found != nullptr, EGL_BAD_PARAMETER);
    return found;
  });
}
