// libEGL_anteroom.so.0: Anteroom as a vendor of glvnd's libEGL.so.1, by <glvnd/libeglabi.h>. glvnd loads
// every vendor into every program that uses EGL: libanteroom.so.0 comes with the first call that needs it,
// and no C++ library before.
#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <pthread.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "layer/loader/egl_table.h"

namespace anteroom::egl {
namespace {

using Proc = __eglMustCastToProperFunctionPointerType;

const __EGLapiExports* glvnd = nullptr;
// Null: not loaded, or cannot be.
std::atomic<const CommandTable*> table{nullptr};

void load() {
  void* library = dlopen("libanteroom.so.0", RTLD_NOW | RTLD_LOCAL);
  void* symbol = library == nullptr ? nullptr : dlsym(library, "glAnteroomEglTable");
  if (symbol == nullptr) {
    std::fprintf(stderr, "anteroom: %s\n", dlerror());
    return;
  }
  const CommandTable* found = reinterpret_cast<decltype(&glAnteroomEglTable)>(symbol)();
  if (found->version == kTableVersion && found->size == sizeof(CommandTable))
    table = found;
  else
    std::fprintf(stderr, "anteroom: libEGL_anteroom.so.0 and libanteroom.so.0 are of different versions.\n");
}

Proc implementation(const char* name) {
  static pthread_once_t once = PTHREAD_ONCE_INIT;
  pthread_once(&once, load);
  return table != nullptr ? table.load()->eglGetProcAddress(name) : nullptr;
}

enum Command {
#define ANTEROOM_CORE(Result, name, parameters, arguments) k_##name,
#define ANTEROOM_EXTENSION(name) k_##name,
  ANTEROOM_EGL_COMMANDS(ANTEROOM_CORE) ANTEROOM_EGL_EXTENSION_COMMANDS(ANTEROOM_EXTENSION) kCommandCount
#undef ANTEROOM_CORE
#undef ANTEROOM_EXTENSION
};

constexpr const char* kNames[] = {
#define ANTEROOM_CORE(Result, name, parameters, arguments) #name,
#define ANTEROOM_EXTENSION(name) #name,
    ANTEROOM_EGL_COMMANDS(ANTEROOM_CORE) ANTEROOM_EGL_EXTENSION_COMMANDS(ANTEROOM_EXTENSION)
#undef ANTEROOM_CORE
#undef ANTEROOM_EXTENSION
};

// Where glvnd keeps each command of an extension in a vendor's table; -1: nobody has asked for it.
int dispatchIndices[kCommandCount];

template <Command command, typename Function>
struct Route;

template <Command command, typename Result, typename... Arguments>
struct Route<command, Result (*)(Arguments...)> {
  using Function = Result (*)(Arguments...);

  // Our own command, by way of its library.
  static Result EGLAPIENTRY call(Arguments... arguments) {
    static std::atomic<Proc> found{nullptr};
    if (found == nullptr) found = implementation(kNames[command]);
    return found != nullptr ? reinterpret_cast<Function>(found.load())(arguments...) : Result();
  }

  // What programs call: the command of whichever vendor its first argument is of.
  static Result EGLAPIENTRY dispatch(Arguments... arguments) {
    glvnd->threadInit();
    __EGLvendorInfo* vendor = vendorOf(arguments...);
    const Proc found =
        vendor == nullptr ? nullptr : glvnd->fetchDispatchEntry(vendor, dispatchIndices[command]);
    if (found == nullptr) {
      glvnd->setEGLError(kOfDevice ? EGL_BAD_DEVICE_EXT : EGL_BAD_DISPLAY);
      return Result();
    }
    glvnd->setLastVendor(vendor);
    return reinterpret_cast<Function>(found)(arguments...);
  }

 private:
  static constexpr bool kOfDevice = std::string_view(kNames[command]).find("eglQueryDevice") == 0;

  template <typename First, typename... Rest>
  static __EGLvendorInfo* vendorOf(First first, Rest...) {
    // Commands that begin with neither a display nor a device are glvnd's own: they go to every vendor.
    if constexpr (!std::is_same_v<First, void*>)
      return nullptr;
    else if constexpr (kOfDevice)
      return glvnd->getVendorFromDevice(first);
    else
      return glvnd->getVendorFromDisplay(first);
  }
  static __EGLvendorInfo* vendorOf() { return nullptr; }
};

constexpr std::string_view kClientExtensions =
#define ANTEROOM_CLIENT_EXTENSION(name, purpose) "EGL_" #name " "
#define ANTEROOM_DISPLAY_EXTENSION(name, purpose)
#include "layer/egl/extensions.inc"
#undef ANTEROOM_CLIENT_EXTENSION
#undef ANTEROOM_DISPLAY_EXTENSION
    ;

// Those that are platforms: glvnd lists them though it does not know them.
constexpr auto kPlatformExtensions = [] {
  std::array<char, kClientExtensions.size() + 1> text{};
  size_t length = 0;
  for (size_t begin = 0; begin < kClientExtensions.size();) {
    const std::string_view name =
        kClientExtensions.substr(begin, kClientExtensions.find(' ', begin) + 1 - begin);
    if (name.find("_platform_") != name.npos && name.find("_platform_base") == name.npos)
      for (const char c : name) text[length++] = c;
    begin += name.size();
  }
  return text;
}();

const char* getVendorString(int name) {
  return name == __EGL_VENDOR_STRING_PLATFORM_EXTENSIONS ? kPlatformExtensions.data() : nullptr;
}

// What glvnd asks of every vendor, wanted or not, needs no library.
const char* EGLAPIENTRY queryString(EGLDisplay display, EGLint name) {
  if (display == EGL_NO_DISPLAY && name == EGL_EXTENSIONS) return kClientExtensions.data();
  return Route<k_eglQueryString, decltype(&eglQueryString)>::call(display, name);
}
EGLBoolean EGLAPIENTRY bindApi(EGLenum api) {
  return table != nullptr ? table.load()->eglBindAPI(api) : api == EGL_OPENGL_ES_API;
}
EGLBoolean EGLAPIENTRY releaseThread() {
  return table != nullptr ? table.load()->eglReleaseThread() : EGL_TRUE;
}
EGLint EGLAPIENTRY getError() {
  return table != nullptr ? table.load()->eglGetError() : EGL_SUCCESS;
}

// EGL_NONE: eglGetDisplay(EGL_DEFAULT_DISPLAY).
EGLDisplay getPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* attributes) {
  if (platform == EGL_NONE)
    return Route<k_eglGetDisplay, decltype(&eglGetDisplay)>::call(EGL_DEFAULT_DISPLAY);
  return Route<k_eglGetPlatformDisplay, decltype(&eglGetPlatformDisplay)>::call(platform, native, attributes);
}

// EGL_NONE: let glvnd find out, who knows X11's and Wayland's displays apart, but not xcb's connections.
EGLenum findNativeDisplayPlatform(void*) {
  const char* named = std::getenv("EGL_PLATFORM");
  return named != nullptr && std::string_view(named) == "xcb" ? EGL_PLATFORM_XCB_EXT : EGL_NONE;
}

EGLBoolean getSupportsApi(EGLenum api) {
  return api == EGL_OPENGL_ES_API ? EGL_TRUE : EGL_FALSE;
}

struct Addresses {
  Proc own;       // for glvnd
  Proc dispatch;  // for programs; null: glvnd has its own
};

const Addresses kAddresses[] = {
#define ANTEROOM_OWN(name) reinterpret_cast<Proc>(&Route<k_##name, decltype(&::name)>::call)
#define ANTEROOM_CORE(Result, name, parameters, arguments) {ANTEROOM_OWN(name), nullptr},
#define ANTEROOM_EXTENSION(name) \
  {ANTEROOM_OWN(name), reinterpret_cast<Proc>(&Route<k_##name, decltype(&::name)>::dispatch)},
    ANTEROOM_EGL_COMMANDS(ANTEROOM_CORE) ANTEROOM_EGL_EXTENSION_COMMANDS(ANTEROOM_EXTENSION)
#undef ANTEROOM_CORE
#undef ANTEROOM_EXTENSION
#undef ANTEROOM_OWN
};

// kCommandCount: no such command.
int find(std::string_view name) {
  int command = 0;
  while (command < kCommandCount && kNames[command] != name) ++command;
  return command;
}

void* getProcAddress(const char* name) {
  const int command = find(name);
  switch (command) {
    case k_eglQueryString:
      return reinterpret_cast<void*>(&queryString);
    case k_eglBindAPI:
      return reinterpret_cast<void*>(&bindApi);
    case k_eglReleaseThread:
      return reinterpret_cast<void*>(&releaseThread);
    case k_eglGetError:
      return reinterpret_cast<void*>(&getError);
    case kCommandCount:
      // Commands of EGL that we do not have need no library either.
      return std::string_view(name).starts_with("gl") ? reinterpret_cast<void*>(implementation(name))
                                                      : nullptr;
    default:
      return reinterpret_cast<void*>(kAddresses[command].own);
  }
}

void* getDispatchAddress(const char* name) {
  const int command = find(name);
  return command < kCommandCount ? reinterpret_cast<void*>(kAddresses[command].dispatch) : nullptr;
}

void setDispatchIndex(const char* name, int index) {
  const int command = find(name);
  if (command < kCommandCount) dispatchIndices[command] = index;
}

}  // namespace
}  // namespace anteroom::egl

extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version,
                                                                        const __EGLapiExports* exports,
                                                                        __EGLvendorInfo*,
                                                                        __EGLapiImports* imports) {
  using namespace anteroom::egl;
  if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) return EGL_FALSE;
  glvnd = exports;
  for (int& index : dispatchIndices) index = -1;
  imports->getPlatformDisplay = getPlatformDisplay;
  imports->getSupportsAPI = getSupportsApi;
  imports->getVendorString = getVendorString;
  imports->getProcAddress = getProcAddress;
  imports->getDispatchAddress = getDispatchAddress;
  imports->setDispatchIndex = setDispatchIndex;
  if (EGL_VENDOR_ABI_GET_MINOR_VERSION(version) >= 2)
    imports->findNativeDisplayPlatform = findNativeDisplayPlatform;
  return EGL_TRUE;
}
