// EGL_KHR_debug: messages about errors, for a callback, and labels of objects.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace anteroom::egl {

// A command fails: sets the thread's error and tells the callback, if there is one. Not under the lock.
void fail(EGLint code, const char* command) noexcept;

// The object that the current command works on; the first one that is no display counts. Null: none yet.
void notePrimary(const void* handle, bool isDisplay);

// An object is gone. Under the lock.
void forgetLabel(const void* handle);

}  // namespace anteroom::egl
