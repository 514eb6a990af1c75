#include "layer/egl/errors.h"

#include <cstdio>

#include "layer/egl/current.h"

namespace anteroom::egl {

std::mutex& mutex() {
  static std::mutex instance;
  return instance;
}

void setError(EGLint code) {
  thisThread().error = code;
  thisThread().primary = nullptr;
}

void log(const char* message) {
  std::fprintf(stderr, "anteroom: %s\n", message);
}

}  // namespace anteroom::egl

using namespace anteroom::egl;

EGLint EGLAPIENTRY eglGetError() {
  const EGLint error = thisThread().error;
  setError(EGL_SUCCESS);
  return error;
}
