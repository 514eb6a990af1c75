#include "session.h"

#include <EGL/eglext.h>
#include <GLES/gl.h>

#include <stdexcept>
#include <string_view>

namespace bench {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string(what) + " failed with EGL error " + std::to_string(eglGetError()));
}

EGLDisplay findDisplay() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (extensions &&
      std::string_view(extensions).find("EGL_MESA_platform_surfaceless") != std::string_view::npos)
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

std::string text(const void* string) {
  return string ? static_cast<const char*>(string) : "?";
}

}  // namespace

EGLDisplay openDisplay() {
  const EGLDisplay display = findDisplay();
  if (display == EGL_NO_DISPLAY) fail("eglGetDisplay");
  if (!eglInitialize(display, nullptr, nullptr)) fail("eglInitialize");
  return display;
}

Session::Session(EGLDisplay display) : display_(display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
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
                           EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(display_, wanted, &config, 1, &count) || count == 0) fail("eglChooseConfig");
  const EGLint size[] = {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
  surface_ = eglCreatePbufferSurface(display_, config, size);
  if (surface_ == EGL_NO_SURFACE) fail("eglCreatePbufferSurface");
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  if (!eglBindAPI(EGL_OPENGL_ES_API)) fail("eglBindAPI");
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
  if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
  if (!eglMakeCurrent(display_, surface_, surface_, context_)) fail("eglMakeCurrent");
}

Session::~Session() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
}

std::string implementationName(EGLDisplay display) {
  return text(glGetString(GL_RENDERER)) + ", " + text(glGetString(GL_VERSION)) + ", " +
         text(eglQueryString(display, EGL_VENDOR));
}

}  // namespace bench
