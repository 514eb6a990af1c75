// Section 3.3.
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

constexpr const char* kVersion = "1.5 Anteroom";

constexpr const char* kClientExtensions =
    "EGL_EXT_client_extensions EGL_EXT_device_base EGL_EXT_device_enumeration EGL_EXT_device_query "
    "EGL_EXT_platform_base EGL_EXT_platform_device EGL_KHR_client_get_all_proc_addresses "
    "EGL_MESA_platform_surfaceless";

constexpr const char* kDisplayExtensions =
    "EGL_KHR_create_context EGL_KHR_create_context_no_error EGL_KHR_fence_sync "
    "EGL_KHR_get_all_proc_addresses "
    "EGL_KHR_no_config_context EGL_KHR_surfaceless_context EGL_KHR_wait_sync";

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

const char* displayString(EGLint name) {
  switch (name) {
    case EGL_CLIENT_APIS:
      return "OpenGL_ES";
    case EGL_EXTENSIONS:
      return kDisplayExtensions;
    case EGL_VENDOR:
      return "Anteroom";
    case EGL_VERSION:
      return kVersion;
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
    initializedDisplay(dpy);
    found = displayString(name);
    require(found != nullptr, EGL_BAD_PARAMETER);
    return found;
  });
}
