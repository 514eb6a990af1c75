#include "native.h"

#include <cstdlib>

namespace windows {

const char* name(Platform platform) {
  return platform == Platform::Xlib ? "Xlib" : platform == Platform::Xcb ? "Xcb" : "Wayland";
}

std::vector<Platform> platforms() {
  std::vector<Platform> result;
  if (std::getenv("DISPLAY")) result = {Platform::Xlib, Platform::Xcb};
  if (std::getenv("WAYLAND_DISPLAY")) result.push_back(Platform::Wayland);
  return result;
}

std::unique_ptr<NativeDisplay> NativeDisplay::open(Platform platform) {
  return platform == Platform::Wayland ? openWayland() : openX11(platform);
}

}  // namespace windows
