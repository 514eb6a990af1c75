#pragma once

#include <EGL/egl.h>

#include <string>

namespace bench {

constexpr int kWidth = 1024;
constexpr int kHeight = 768;

// The surfaceless display where the implementation offers it, else the default one, initialised
// (EGL 1.5, 3.2). Throws std::runtime_error.
EGLDisplay openDisplay();

// A current ES 1 context on an RGBA8888 pbuffer of kWidth x kHeight with 24 bits of depth and 8 of stencil.
class Session {
 public:
  explicit Session(EGLDisplay display);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  EGLDisplay display_;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

// What answers: "GL_RENDERER, GL_VERSION, EGL_VENDOR". Needs a current context.
std::string implementationName(EGLDisplay display);

}  // namespace bench
