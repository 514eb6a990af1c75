#include "context.h"

#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace room {
namespace {

bool listed(const char* list, std::string_view name) {
  const std::string_view all = list != nullptr ? list : "";
  for (std::size_t at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) return true;
  }
  return false;
}

// Without a window system the default display often fails, so the surfaceless platform is asked first,
// unless EGL_PLATFORM says what the user wants.
std::vector<EGLDisplay> candidateDisplays() {
  std::vector<EGLDisplay> displays;
  if (std::getenv("EGL_PLATFORM") == nullptr &&
      listed(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
    displays.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  }
  displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return displays;
}

EGLConfig chooseConfig(EGLDisplay display, int samples) {
  // The passes need destination alpha and stencil.
  for (; samples >= 0; samples = samples > 1 ? samples / 2 : samples - 1) {
    const std::array<EGLint, 19> wanted = {EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_ES_BIT,
                                           EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_ALPHA_SIZE,
                                           8,
                                           EGL_DEPTH_SIZE,
                                           24,
                                           EGL_STENCIL_SIZE,
                                           8,
                                           EGL_SAMPLES,
                                           samples,
                                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_TRUE && count == 1) return config;
  }
  return nullptr;
}

}  // namespace

Context::Context(int width, int height, int samples) : width_(width), height_(height) {
  for (EGLDisplay display : candidateDisplays()) {
    if (display != EGL_NO_DISPLAY && open(display, samples)) return;
  }
  throw std::runtime_error(fmt::format(
      "no OpenGL ES 1.x context with a {} x {} pbuffer (RGBA8888, depth 24, stencil 8) could be made; "
      "the last EGL error is 0x{:04X}. Without a window system try EGL_PLATFORM=surfaceless.",
      width, height, error_));
}

Context::~Context() {
  close();
}

bool Context::open(EGLDisplay display, int samples) {
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    error_ = eglGetError();
    return false;
  }
  display_ = display;
  const EGLConfig config = chooseConfig(display, samples);
  const std::array<EGLint, 5> size = {EGL_WIDTH, width_, EGL_HEIGHT, height_, EGL_NONE};
  const std::array<EGLint, 3> version = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  checkSize(display, config);
  if (config != nullptr && eglBindAPI(EGL_OPENGL_ES_API) == EGL_TRUE) {
    surface_ = eglCreatePbufferSurface(display, config, size.data());
    context_ = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
    if (surface_ != EGL_NO_SURFACE && context_ != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, surface_, surface_, context_) == EGL_TRUE) {
      eglGetConfigAttrib(display, config, EGL_SAMPLES, &samples_);
      return true;
    }
  }
  error_ = config != nullptr ? eglGetError() : EGL_BAD_CONFIG;
  close();
  return false;
}

// One plain sentence instead of the EGL error that would follow.
void Context::checkSize(EGLDisplay display, EGLConfig config) {
  EGLint width = 0;
  EGLint height = 0;
  if (config == nullptr || eglGetConfigAttrib(display, config, EGL_MAX_PBUFFER_WIDTH, &width) != EGL_TRUE ||
      eglGetConfigAttrib(display, config, EGL_MAX_PBUFFER_HEIGHT, &height) != EGL_TRUE ||
      (width_ <= width && height_ <= height)) {
    return;
  }
  close();
  throw std::runtime_error(
      fmt::format("{} x {} pixels are more than this implementation draws at once: {} x {}", width_, height_,
                  width, height));
}

void Context::close() {
  if (display_ == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
  eglTerminate(display_);
  eglReleaseThread();
  display_ = EGL_NO_DISPLAY;
  surface_ = EGL_NO_SURFACE;
  context_ = EGL_NO_CONTEXT;
}

std::optional<ImplementationCounters> Context::counters() const {
  if (!listed(eglQueryString(display_, EGL_EXTENSIONS), "EGL_ANTEROOM_context_counters")) return std::nullopt;
  std::array<EGLint, 4> values{};
  constexpr EGLint kFirst = 0x3FE0;  // draws, pipelines, compiles, bytes uploaded
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (eglQueryContext(display_, context_, kFirst + static_cast<EGLint>(i), &values[i]) != EGL_TRUE)
      return std::nullopt;
  }
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(values[i]); };
  return ImplementationCounters{at(0), at(1), at(2), at(3)};
}

ImplementationCounters operator-(const ImplementationCounters& a, const ImplementationCounters& b) {
  const auto since = [](std::uint32_t now, std::uint32_t before) { return (now - before) & 0x7FFFFFFFU; };
  return {since(a.draws, b.draws), since(a.pipelines, b.pipelines), since(a.compiles, b.compiles),
          since(a.uploadedBytes, b.uploadedBytes)};
}

bool hasExtension(std::string_view name) {
  return listed(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), name);
}

void requireExtension(std::string_view name, std::string_view demo) {
  if (!hasExtension(name)) {
    throw MissingExtension(fmt::format("{} needs {}, which this implementation does not have", demo, name));
  }
}

void requireTextureUnits(int units, std::string_view demo) {
  GLint have = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &have);
  if (have < units) {
    throw MissingExtension(
        fmt::format("{} needs {} texture units, and this implementation has {}", demo, units, have));
  }
}

void checkErrors(std::string_view where) {
  std::string errors;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    errors += fmt::format(" 0x{:04X}", error);
    if (errors.size() > 70) break;  // an implementation without a current context may never run dry
  }
  if (!errors.empty()) throw std::runtime_error(fmt::format("GL error in {}:{}", where, errors));
}

}  // namespace room
