#include "layer/egl/errors.h"

#include <cstdio>

#include "layer/egl/current.h"

namespace anteroom::egl {

void Mutex::lock() {
  mutex_.lock();
  owner_.store(&thisThread(), std::memory_order_relaxed);
}

void Mutex::unlock() {
  owner_.store(nullptr, std::memory_order_relaxed);
  mutex_.unlock();
}

bool Mutex::isMine() const {
  return owner_.load(std::memory_order_relaxed) == &thisThread();
}

Mutex& mutex() {
  static constinit Mutex instance;
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
