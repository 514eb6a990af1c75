// Section 3.1: a command fails with one error and without side effects; what it did last is kept for the
// thread.
#pragma once

#include <EGL/egl.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <new>

#include "layer/egl/debug.h"

namespace anteroom::egl {

// Thrown inside the implementation, never through a command.
struct Error {
  EGLint code;
};

inline void require(bool condition, EGLint code) {
  if (!condition) throw Error{code};
}

// One lock guards every display and all that belongs to them. It knows who has it, for a driver may fork in a
// command.
class Mutex {
 public:
  void lock();
  void unlock();
  bool isMine() const;

 private:
  std::mutex mutex_;
  std::atomic<const void*> owner_{nullptr};  // a thread's Thread
};
using Lock = std::unique_lock<Mutex>;
Mutex& mutex();

// What eglGetError will return in this thread: a command has ended.
void setError(EGLint code);

// One line on stderr.
void log(const char* message);

// The frame of every command: runs `body` under the lock, which it may release while it waits, and turns what
// it throws into the thread's error and the result `failed`. `name`: the command's, where a helper calls.
template <typename Result, typename Body>
Result command(Result failed, Body body, const char* name = __builtin_FUNCTION()) noexcept {
  try {
    Lock lock(mutex());
    const Result result = body(lock);
    setError(EGL_SUCCESS);
    return result;
  } catch (const Error& error) {
    fail(error.code, name);
  } catch (const std::bad_alloc&) {
    fail(EGL_BAD_ALLOC, name);
  } catch (const std::exception& error) {
    log(error.what());
    fail(EGL_BAD_ALLOC, name);
  }
  return failed;
}

}  // namespace anteroom::egl
