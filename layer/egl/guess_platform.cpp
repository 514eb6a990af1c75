// Section 3.2: what native display eglGetDisplay was given.
#include <sys/mman.h>
#include <unistd.h>
#include <wayland-client-protocol.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "layer/egl/errors.h"
#include "layer/egl/window_system.h"

namespace anteroom::egl {
namespace {

struct Name {
  const char* word;
  EGLenum platform;
};
constexpr Name kNames[] = {
    {"x11", EGL_PLATFORM_X11_KHR},         {"xcb", EGL_PLATFORM_XCB_EXT},
    {"wayland", EGL_PLATFORM_WAYLAND_KHR}, {"surfaceless", EGL_PLATFORM_SURFACELESS_MESA},
    {"device", EGL_PLATFORM_DEVICE_EXT},
};

// Null: not set.
const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? nullptr : value;
}

// EGL_NONE: the environment names none.
EGLenum namedPlatform() {
  const char* word = variable("EGL_PLATFORM");
  if (word == nullptr) word = variable("EGL_DISPLAY");
  if (word == nullptr) return EGL_NONE;
  for (const Name& name : kNames)
    if (std::strcmp(name.word, word) == 0) return name.platform;
  log((std::string("EGL_PLATFORM=") + word +
       " is unknown: x11, xcb, wayland, surfaceless and device are known")
          .c_str());
  return EGL_NONE;
}

// Whether a pointer can be read there.
bool isMapped(const void* address) {
  const auto at = reinterpret_cast<uintptr_t>(address);
  const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  if (at % alignof(void*) != 0 || at < page) return false;
  unsigned char present;
  return mincore(reinterpret_cast<void*>(at / page * page), page, &present) == 0;
}

// A wl_display is an object of the protocol, and such begin with their interface.
bool isWayland(void* native) {
  const void* first;
  std::memcpy(&first, native, sizeof first);
  return first == &wl_display_interface;
}

EGLenum environmentOffers() {
  if (variable("DISPLAY") != nullptr) return EGL_PLATFORM_X11_KHR;
  if (variable("WAYLAND_DISPLAY") != nullptr) return EGL_PLATFORM_WAYLAND_KHR;
  return EGL_PLATFORM_SURFACELESS_MESA;
}

}  // namespace

Platform guessPlatform(void* native) {
  EGLenum name = namedPlatform();
  if (name == EGL_NONE) {
    if (native == nullptr)
      name = environmentOffers();
    else if (isMapped(native))
      name = isWayland(native) ? EGL_PLATFORM_WAYLAND_KHR : EGL_PLATFORM_X11_KHR;
  }
  return {name, native, -1};
}

}  // namespace anteroom::egl
