#include "layer/egl/sync.h"

#include <EGL/eglext.h>

#include "layer/egl/attributes.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"

namespace anteroom::egl {
namespace {

// EGL 1.5 and EGL_KHR_fence_sync name different errors for an unknown type.
template <typename Integer>
EGLSync createSync(EGLDisplay dpy, EGLenum type, const Integer* attributes, EGLint unknownType) {
  return command<EGLSync>(EGL_NO_SYNC, [&](Lock&) {
    Display& display = initializedDisplay(dpy);
    require(type == EGL_SYNC_FENCE, unknownType);
    require(isEmpty(attributes), EGL_BAD_ATTRIBUTE);
    const Binding* binding = currentBinding();
    require(binding != nullptr && &binding->context->display == &display, EGL_BAD_MATCH);
    return display.syncs.add(std::make_shared<Sync>(binding->context));
  });
}

template <typename Integer>
EGLBoolean getSyncAttribute(EGLDisplay dpy, EGLSync sync, EGLint attribute, Integer* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock& lock) {
    const auto found = initializedDisplay(dpy).sync(sync);
    require(value != nullptr, EGL_BAD_PARAMETER);
    switch (attribute) {
      case EGL_SYNC_TYPE:
        *value = EGL_SYNC_FENCE;
        break;
      case EGL_SYNC_STATUS:
        *value = found->wait(lock, 0) ? EGL_SIGNALED : EGL_UNSIGNALED;
        break;
      case EGL_SYNC_CONDITION:
        *value = EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
        break;
      default:
        throw Error{EGL_BAD_ATTRIBUTE};
    }
    return EGL_TRUE;
  });
}

}  // namespace

Sync::Sync(const std::shared_ptr<Context>& context)
    : context_(context), fence_(gl::insertFence(*context->gl)) {
  context->fenced = true;
}

bool Sync::wait(Lock& lock, uint64_t timeout) {
  const auto context = context_.lock();
  if (signaled_ || context == nullptr) return true;
  lock.unlock();
  const bool passed = gl::rendererOf(*context->gl).waitFence(fence_, timeout);
  lock.lock();
  signaled_ |= passed;
  return passed;
}

}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLSync EGLAPIENTRY eglCreateSync(EGLDisplay dpy, EGLenum type, const EGLAttrib* attrib_list) {
  return createSync(dpy, type, attrib_list, EGL_BAD_PARAMETER);
}

EGLSyncKHR EGLAPIENTRY eglCreateSyncKHR(EGLDisplay dpy, EGLenum type, const EGLint* attrib_list) {
  return createSync(dpy, type, attrib_list, EGL_BAD_ATTRIBUTE);
}

EGLBoolean EGLAPIENTRY eglDestroySync(EGLDisplay dpy, EGLSync sync) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(initializedDisplay(dpy).syncs.take(sync) != nullptr, EGL_BAD_PARAMETER);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglDestroySyncKHR(EGLDisplay dpy, EGLSyncKHR sync) {
  return eglDestroySync(dpy, sync);
}

EGLint EGLAPIENTRY eglClientWaitSync(EGLDisplay dpy, EGLSync sync, EGLint, EGLTime timeout) {
  return command<EGLint>(EGL_FALSE, [&](Lock& lock) {
    // EGL_SYNC_FLUSH_COMMANDS_BIT asks for nothing more: inserting a fence flushes.
    const auto found = initializedDisplay(dpy).sync(sync);
    return found->wait(lock, timeout) ? EGL_CONDITION_SATISFIED : EGL_TIMEOUT_EXPIRED;
  });
}

EGLint EGLAPIENTRY eglClientWaitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags, EGLTimeKHR timeout) {
  return eglClientWaitSync(dpy, sync, flags, timeout);
}

EGLBoolean EGLAPIENTRY eglWaitSync(EGLDisplay dpy, EGLSync sync, EGLint flags) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock& lock) {
    const auto found = initializedDisplay(dpy).sync(sync);
    require(currentContext() != nullptr, EGL_BAD_MATCH);
    require(flags == 0, EGL_BAD_PARAMETER);
    found->wait(lock, EGL_FOREVER);  // the server may wait on the CPU (section 3.8.1.3)
    return EGL_TRUE;
  });
}

EGLint EGLAPIENTRY eglWaitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags) {
  return static_cast<EGLint>(eglWaitSync(dpy, sync, flags));
}

EGLBoolean EGLAPIENTRY eglGetSyncAttrib(EGLDisplay dpy, EGLSync sync, EGLint attribute, EGLAttrib* value) {
  return getSyncAttribute(dpy, sync, attribute, value);
}

EGLBoolean EGLAPIENTRY eglGetSyncAttribKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint attribute, EGLint* value) {
  return getSyncAttribute(dpy, sync, attribute, value);
}
