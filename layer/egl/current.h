// Section 3.7.3 and 3.12: what is current in a thread.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>

#include "layer/egl/context.h"
#include "layer/egl/surface.h"

namespace anteroom::egl {

struct Binding {
  std::shared_ptr<Context> context;
  std::shared_ptr<Surface> draw, read;  // both null: without a default framebuffer
  bool operator==(const Binding&) const = default;
};

// Without constructor and destructor: commands may be called while a thread or the process ends.
struct Thread {
  EGLint error;
  EGLenum api;
  Binding* binding;  // null: nothing is current
  // EGL_KHR_debug.
  EGLLabelKHR label = nullptr;
  const void* primary = nullptr;  // handle of what the present command works on
  bool primaryIsDisplay = false;
};

Thread& thisThread();

// In a process that was forked: what is current belongs to the parent, and is not touched any more.
void abandonBinding();

// Tells GL of the binding's framebuffers.
void useSurfaces(const Binding& binding);
// Readies the window of the draw surface, if it is one. Its framebuffer may become another one.
void readyWindow(const Binding& binding);

// Null: none.
inline const Binding* currentBinding() {
  return thisThread().binding;
}
inline Context* currentContext() {
  const Binding* binding = currentBinding();
  return binding == nullptr ? nullptr : binding->context.get();
}

}  // namespace anteroom::egl
