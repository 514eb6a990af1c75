#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "layer/egl/eglanteroom.h"
#include "layer/tools/info/facts.h"

namespace info {

const std::vector<ConfigColumn> kConfigColumns = {
    {EGL_CONFIG_ID, "id"},
    {EGL_BUFFER_SIZE, "bits"},
    {EGL_RED_SIZE, "r"},
    {EGL_GREEN_SIZE, "g"},
    {EGL_BLUE_SIZE, "b"},
    {EGL_ALPHA_SIZE, "a"},
    {EGL_DEPTH_SIZE, "depth"},
    {EGL_STENCIL_SIZE, "stencil"},
    {EGL_SAMPLES, "samples"},
    {EGL_NATIVE_VISUAL_ID, "visual"},
    {EGL_SURFACE_TYPE, "surfaces"},
    {EGL_CONFIG_CAVEAT, "caveat"},
};

namespace {

struct Limit {
  GLenum name;
  const char* text;
  int count;
};

constexpr Limit kLimits[] = {
    {GL_MAX_LIGHTS, "MAX_LIGHTS", 1},
    {GL_MAX_CLIP_PLANES, "MAX_CLIP_PLANES", 1},
    {GL_MAX_MODELVIEW_STACK_DEPTH, "MAX_MODELVIEW_STACK_DEPTH", 1},
    {GL_MAX_PROJECTION_STACK_DEPTH, "MAX_PROJECTION_STACK_DEPTH", 1},
    {GL_MAX_TEXTURE_STACK_DEPTH, "MAX_TEXTURE_STACK_DEPTH", 1},
    {GL_MAX_TEXTURE_UNITS, "MAX_TEXTURE_UNITS", 1},
    {GL_MAX_TEXTURE_SIZE, "MAX_TEXTURE_SIZE", 1},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE_OES, "MAX_CUBE_MAP_TEXTURE_SIZE_OES", 1},
    {0x8073, "MAX_3D_TEXTURE_SIZE_OES", 1},
    {GL_MAX_RENDERBUFFER_SIZE_OES, "MAX_RENDERBUFFER_SIZE_OES", 1},
    {GL_MAX_SAMPLES_APPLE, "MAX_SAMPLES_APPLE", 1},
    {GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, "MAX_TEXTURE_MAX_ANISOTROPY_EXT", 1},
    {GL_MAX_TEXTURE_LOD_BIAS_EXT, "MAX_TEXTURE_LOD_BIAS_EXT", 1},
    {GL_MAX_VIEWPORT_DIMS, "MAX_VIEWPORT_DIMS", 2},
    {GL_ALIASED_POINT_SIZE_RANGE, "ALIASED_POINT_SIZE_RANGE", 2},
    {GL_SMOOTH_POINT_SIZE_RANGE, "SMOOTH_POINT_SIZE_RANGE", 2},
    {GL_ALIASED_LINE_WIDTH_RANGE, "ALIASED_LINE_WIDTH_RANGE", 2},
    {GL_SMOOTH_LINE_WIDTH_RANGE, "SMOOTH_LINE_WIDTH_RANGE", 2},
    {GL_SUBPIXEL_BITS, "SUBPIXEL_BITS", 1},
    {GL_MAX_PALETTE_MATRICES_OES, "MAX_PALETTE_MATRICES_OES", 1},
    {GL_MAX_VERTEX_UNITS_OES, "MAX_VERTEX_UNITS_OES", 1},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, "NUM_COMPRESSED_TEXTURE_FORMATS", 1},
};

std::string text(const void* string) {
  return string == nullptr ? "" : static_cast<const char*>(string);
}

Names split(const std::string& words, char separator) {
  Names names;
  std::istringstream stream(words);
  for (std::string name; std::getline(stream, name, separator);)
    if (!name.empty()) names.push_back(name);
  return names;
}

bool contains(const Names& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string fileOf(const void* address) {
  Dl_info found{};
  if (dladdr(address, &found) == 0) return "?";
  char* resolved = realpath(found.dli_fname, nullptr);
  const std::string path = resolved == nullptr ? found.dli_fname : resolved;
  std::free(resolved);
  return path;
}

std::vector<Config> configsOf(EGLDisplay display) {
  EGLint count = 0;
  eglGetConfigs(display, nullptr, 0, &count);
  std::vector<EGLConfig> handles(static_cast<size_t>(count));
  eglGetConfigs(display, handles.data(), count, &count);
  std::vector<Config> configs;
  for (EGLConfig handle : handles) {
    Config config;
    for (const ConfigColumn& column : kConfigColumns)
      eglGetConfigAttrib(display, handle, column.attribute, &config.values.emplace_back(0));
    configs.push_back(config);
  }
  return configs;
}

class Platforms {
 public:
  explicit Platforms(Facts& facts) : facts_(facts) {}

  void add(const char* name, EGLDisplay display) {
    if (display == EGL_NO_DISPLAY) return;
    for (size_t i = 0; i < displays_.size(); ++i)
      if (displays_[i] == display) return facts_.platforms[i].names.emplace_back(name), void();
    if (std::find(failed_.begin(), failed_.end(), display) != failed_.end()) return;
    if (!eglInitialize(display, nullptr, nullptr)) return failed_.push_back(display);
    displays_.push_back(display);
    facts_.platforms.push_back({{name},
                                text(eglQueryString(display, EGL_VENDOR)),
                                text(eglQueryString(display, EGL_VERSION)),
                                text(eglQueryString(display, EGL_CLIENT_APIS)),
                                split(text(eglQueryString(display, EGL_EXTENSIONS)), ' '),
                                configsOf(display)});
  }
  void add(const char* name, const char* extension, EGLenum platform, void* native = nullptr) {
    if (contains(facts_.clientExtensions, extension))
      add(name, eglGetPlatformDisplay(platform, native, nullptr));
  }
  EGLDisplay first() const { return displays_.empty() ? EGL_NO_DISPLAY : displays_.front(); }

 private:
  Facts& facts_;
  std::vector<EGLDisplay> displays_, failed_;
};

EGLDeviceEXT firstDevice() {
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  return query != nullptr && query(1, &device, &count) && count > 0 ? device : nullptr;
}

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

void openPlatforms(Platforms& platforms) {
  platforms.add("default", eglGetDisplay(EGL_DEFAULT_DISPLAY));
  platforms.add("surfaceless", "EGL_MESA_platform_surfaceless", EGL_PLATFORM_SURFACELESS_MESA);
  if (EGLDeviceEXT device = firstDevice(); device != nullptr)
    platforms.add("device", "EGL_EXT_platform_device", EGL_PLATFORM_DEVICE_EXT, device);
  if (isSet("DISPLAY")) {
    platforms.add("x11", "EGL_EXT_platform_x11", EGL_PLATFORM_X11_EXT);
    platforms.add("xcb", "EGL_EXT_platform_xcb", EGL_PLATFORM_XCB_EXT);
  }
  if (isSet("WAYLAND_DISPLAY"))
    platforms.add("wayland", "EGL_EXT_platform_wayland", EGL_PLATFORM_WAYLAND_EXT);
}

void askLimits(Gl& gl) {
  while (glGetError() != GL_NO_ERROR) {
  }
  for (const Limit& limit : kLimits) {
    GLfloat values[2]{};
    glGetFloatv(limit.name, values);
    if (glGetError() != GL_NO_ERROR) continue;
    gl.limits.emplace_back(limit.text, limit.count == 1 ? fmt::format("{}", values[0])
                                                        : fmt::format("{} {}", values[0], values[1]));
  }
}

void askGl(EGLDisplay display, Gl& gl) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_ES_API) || !eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
    return;
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return;
  gl.vendor = text(glGetString(GL_VENDOR));
  gl.renderer = text(glGetString(GL_RENDERER));
  gl.version = text(glGetString(GL_VERSION));
  gl.extensions = split(text(glGetString(GL_EXTENSIONS)), ' ');
  askLimits(gl);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
}

}  // namespace

Facts ask() {
  Facts facts;
  facts.eglLibrary = fileOf(reinterpret_cast<void*>(&eglInitialize));
  facts.glLibrary = fileOf(reinterpret_cast<void*>(&glGetString));
  facts.eglVersion = text(eglQueryString(EGL_NO_DISPLAY, EGL_VERSION));
  facts.clientExtensions = split(text(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)), ' ');
  Platforms platforms(facts);
  openPlatforms(platforms);
  if (platforms.first() == EGL_NO_DISPLAY) return facts;
  if (contains(facts.platforms.front().extensions, "EGL_ANTEROOM_origin")) {
    const auto origin = [&](EGLint name) { return text(eglQueryString(platforms.first(), name)); };
    facts.devices = split(origin(EGL_DEVICES_ANTEROOM), '\n');
    facts.choice = origin(EGL_DEVICE_CHOICE_ANTEROOM);
    facts.driver = origin(EGL_DRIVER_ANTEROOM);
    facts.cache = origin(EGL_SHADER_CACHE_ANTEROOM);
    facts.quirks = split(origin(EGL_QUIRKS_ANTEROOM), ' ');
  }
  askGl(platforms.first(), facts.gl);
  return facts;
}

}  // namespace info
