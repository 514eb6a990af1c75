// A context with attributes of its own, current on the case's surface while it lives.
#pragma once

#include <vector>

#include "harness.h"

namespace conformance {

class OtherContext {
 public:
  // `attributes`: pairs for eglCreateContext, without the end.
  explicit OtherContext(std::vector<EGLint> attributes) : former_(eglGetCurrentContext()) {
    EGLint id = 0, count = 0;
    eglQueryContext(display(), former_, EGL_CONFIG_ID, &id);
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = nullptr;
    eglChooseConfig(display(), wanted, &config, 1, &count);
    attributes.insert(attributes.end(), {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE});
    context_ = eglCreateContext(display(), config, EGL_NO_CONTEXT, attributes.data());
    error_ = eglGetError();
    makeCurrent(context_);
  }
  ~OtherContext() {
    makeCurrent(former_);
    if (valid()) eglDestroyContext(display(), context_);
  }
  OtherContext(const OtherContext&) = delete;
  OtherContext& operator=(const OtherContext&) = delete;
  bool valid() const { return context_ != EGL_NO_CONTEXT; }
  // Of eglCreateContext.
  EGLint error() const { return error_; }

 private:
  static void makeCurrent(EGLContext context) {
    const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
    if (context != EGL_NO_CONTEXT) eglMakeCurrent(display(), surface, surface, context);
  }

  EGLContext former_, context_ = EGL_NO_CONTEXT;
  EGLint error_ = EGL_SUCCESS;
};

}  // namespace conformance
