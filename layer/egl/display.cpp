#include "layer/egl/display.h"

#include <string>
#include <utility>

#include "layer/egl/attributes.h"
#include "layer/egl/errors.h"
#include "layer/egl/fork.h"
#include "layer/egl/renderer.h"

namespace anteroom::egl {
namespace {

// Never destroyed: other threads may still draw while the process ends.
std::vector<std::unique_ptr<Display>>& displays() {
  static auto& instance = *new std::vector<std::unique_ptr<Display>>;
  return instance;
}

// EGL_EXT_device_enumeration: one device, the one that ANTEROOM_DEVICE and the renderer choose at
// initialization.
char theDevice;
EGLDeviceEXT deviceHandle() {
  return &theDevice;
}

EGLDisplay findOrCreate(const Platform& platform) {
  for (const auto& display : displays()) {
    if (display->platform() == platform) return display->handle();
  }
  displays().push_back(std::make_unique<Display>(platform));
  return displays().back()->handle();
}

// EGL_EXT_platform_x11, EGL_EXT_platform_xcb: the one attribute there is.
template <typename Integer>
EGLint screenOf(const Integer* attributes, EGLint name) {
  EGLint screen = -1;
  forEachAttribute(attributes, [&](EGLint attribute, EGLAttrib value) {
    require(attribute == name && value >= 0 && value <= 0xff, EGL_BAD_ATTRIBUTE);
    screen = static_cast<EGLint>(value);
  });
  return screen;
}

template <typename Integer>
EGLDisplay platformDisplay(EGLenum platform, void* native, const Integer* attributes) {
  Platform wanted{platform, native, -1};
  switch (platform) {
    case EGL_PLATFORM_SURFACELESS_MESA:
      require(native == EGL_DEFAULT_DISPLAY, EGL_BAD_PARAMETER);
      break;
    case EGL_PLATFORM_DEVICE_EXT:
      require(native == deviceHandle(), EGL_BAD_PARAMETER);
      break;
    case EGL_PLATFORM_X11_KHR:
    case EGL_PLATFORM_XCB_EXT:
      wanted.screen = screenOf(attributes, platform == EGL_PLATFORM_X11_KHR ? EGL_PLATFORM_X11_SCREEN_KHR
                                                                            : EGL_PLATFORM_XCB_SCREEN_EXT);
      if (wanted.screen >= 0) openX11(wanted);  // throws where there is no such screen
      return findOrCreate(wanted);
    case EGL_PLATFORM_WAYLAND_KHR:
      break;
    default:
      throw Error{EGL_BAD_PARAMETER};
  }
  require(isEmpty(attributes), EGL_BAD_ATTRIBUTE);
  return findOrCreate(wanted);
}

}  // namespace

void* newHandle() {
  static uintptr_t last = 0x10000;
  return reinterpret_cast<void*>(++last);
}

// Null: the platform has no windows. Throws EGL_NOT_INITIALIZED.
static std::shared_ptr<WindowSystem> openWindowSystem(const Platform& platform) {
  std::shared_ptr<WindowSystem> system;
  switch (platform.name) {
    case EGL_PLATFORM_X11_KHR:
    case EGL_PLATFORM_XCB_EXT:
      system = openX11(platform);
      break;
    case EGL_PLATFORM_WAYLAND_KHR:
      system = openWayland(platform);
      break;
    default:
      return nullptr;
  }
  if (system != nullptr) return system;
  const char* const server = platform.name == EGL_PLATFORM_WAYLAND_KHR ? "Wayland" : "X";
  const char* const where = platform.name == EGL_PLATFORM_WAYLAND_KHR ? "WAYLAND_DISPLAY" : "DISPLAY";
  log((std::string("no ") + server + " server answers: check " + where +
       ", or set EGL_PLATFORM=surfaceless to draw without windows")
          .c_str());
  throw Error{EGL_NOT_INITIALIZED};
}

void Display::initialize() {
  if (initialized()) return;
  auto system = openWindowSystem(platform_);
  std::optional<render::WindowSystem> windows;
  if (system != nullptr) windows = system->name();
  std::string error;
  std::shared_ptr<render::Device> device = findDevice(windows, error);
  if (device == nullptr) {
    log(error.c_str());
    throw Error{EGL_NOT_INITIALIZED};
  }
  configs_ = makeConfigs(device->caps(), device->caps().windows ? system.get() : nullptr);
  windowSystem_ = std::move(system);
  device_ = std::move(device);
  registerForkHandlers();
}

void Display::terminate() {
  syncs.forEach([](Sync& sync) { sync.abandon(); });
  syncs.clear();
  images.clear();
  surfaces.clear();
  contexts.clear();
  configs_.clear();
  device_.reset();
  windowSystem_.reset();
}

void Display::abandon() {
  struct Remains {
    Handles<Context> contexts;
    Handles<Image> images;
    Handles<Surface> surfaces;
    Handles<Sync> syncs;
    std::shared_ptr<render::Device> device;
    std::shared_ptr<WindowSystem> windowSystem;  // to end its connection would end the parent's
  };
  static auto& all = *new std::vector<Remains>;
  all.push_back({std::exchange(contexts, {}), std::exchange(images, {}), std::exchange(surfaces, {}),
                 std::exchange(syncs, {}), std::exchange(device_, nullptr),
                 std::exchange(windowSystem_, nullptr)});
  configs_.clear();
}

const Config& Display::config(EGLConfig handle) const {
  const auto id = reinterpret_cast<uintptr_t>(handle);
  require(id >= 1 && id <= configs_.size(), EGL_BAD_CONFIG);
  return configs_[id - 1];
}

std::shared_ptr<Context> Display::context(EGLContext handle) const {
  auto found = contexts.find(handle);
  require(found != nullptr, EGL_BAD_CONTEXT);
  return found;
}

std::shared_ptr<Surface> Display::surface(EGLSurface handle) const {
  auto found = surfaces.find(handle);
  require(found != nullptr, EGL_BAD_SURFACE);
  return found;
}

std::shared_ptr<Sync> Display::sync(EGLSync handle) const {
  auto found = syncs.find(handle);
  require(found != nullptr, EGL_BAD_PARAMETER);
  return found;
}

Display& displayOf(EGLDisplay handle) {
  for (const auto& display : displays()) {
    if (display->handle() != handle) continue;
    notePrimary(handle, true);
    return *display;
  }
  throw Error{EGL_BAD_DISPLAY};
}

Display& initializedDisplay(EGLDisplay handle) {
  Display& display = displayOf(handle);
  require(display.initialized(), EGL_NOT_INITIALIZED);
  return display;
}

void abandonDisplays() {
  abandonDevice();
  for (const auto& display : displays()) {
    if (display->initialized()) display->abandon();
  }
}

bool isContextOfAnyDisplay(EGLContext handle) {
  for (const auto& display : displays()) {
    if (display->contexts.find(handle) != nullptr) return true;
  }
  return false;
}

void forEachContext(void (*visit)(Context& context)) {
  for (const auto& display : displays()) display->contexts.forEach(visit);
}

}  // namespace anteroom::egl

using namespace anteroom::egl;

EGLDisplay EGLAPIENTRY eglGetDisplay(EGLNativeDisplayType display_id) {
  return command<EGLDisplay>(EGL_NO_DISPLAY, [&](Lock&) -> EGLDisplay {
    Platform platform = guessPlatform(display_id);
    if (platform.name == EGL_NONE) return EGL_NO_DISPLAY;  // which is no error
    const bool windows =
        platform.name != EGL_PLATFORM_SURFACELESS_MESA && platform.name != EGL_PLATFORM_DEVICE_EXT;
    if (!windows) {
      if (display_id != EGL_DEFAULT_DISPLAY && display_id != deviceHandle()) return EGL_NO_DISPLAY;
      platform.native = platform.name == EGL_PLATFORM_DEVICE_EXT ? deviceHandle() : nullptr;
    }
    return findOrCreate(platform);
  });
}

EGLDisplay EGLAPIENTRY eglGetPlatformDisplay(EGLenum platform, void* native_display,
                                             const EGLAttrib* attrib_list) {
  return command<EGLDisplay>(EGL_NO_DISPLAY,
                             [&](Lock&) { return platformDisplay(platform, native_display, attrib_list); });
}

EGLDisplay EGLAPIENTRY eglGetPlatformDisplayEXT(EGLenum platform, void* native_display,
                                                const EGLint* attrib_list) {
  return command<EGLDisplay>(EGL_NO_DISPLAY,
                             [&](Lock&) { return platformDisplay(platform, native_display, attrib_list); });
}

EGLBoolean EGLAPIENTRY eglInitialize(EGLDisplay dpy, EGLint* major, EGLint* minor) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    displayOf(dpy).initialize();
    if (major != nullptr) *major = 1;
    if (minor != nullptr) *minor = 5;
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglTerminate(EGLDisplay dpy) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    displayOf(dpy).terminate();
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglQueryDevicesEXT(EGLint max_devices, EGLDeviceEXT* devices, EGLint* num_devices) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(num_devices != nullptr && (devices == nullptr || max_devices > 0), EGL_BAD_PARAMETER);
    if (devices != nullptr) devices[0] = deviceHandle();
    *num_devices = 1;
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglQueryDeviceAttribEXT(EGLDeviceEXT device, EGLint, EGLAttrib*) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) -> EGLBoolean {
    require(device == deviceHandle(), EGL_BAD_DEVICE_EXT);
    throw Error{EGL_BAD_ATTRIBUTE};  // EGL_EXT_device_query defines none
  });
}

const char* EGLAPIENTRY eglQueryDeviceStringEXT(EGLDeviceEXT device, EGLint name) {
  return command<const char*>(nullptr, [&](Lock&) {
    require(device == deviceHandle(), EGL_BAD_DEVICE_EXT);
    require(name == EGL_EXTENSIONS, EGL_BAD_PARAMETER);
    return "";
  });
}

EGLBoolean EGLAPIENTRY eglQueryDisplayAttribEXT(EGLDisplay dpy, EGLint attribute, EGLAttrib* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    initializedDisplay(dpy);
    require(attribute == EGL_DEVICE_EXT, EGL_BAD_ATTRIBUTE);
    require(value != nullptr, EGL_BAD_PARAMETER);
    *value = reinterpret_cast<EGLAttrib>(deviceHandle());
    return EGL_TRUE;
  });
}
