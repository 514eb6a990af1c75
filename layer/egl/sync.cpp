#include "layer/egl/sync.h"

#include <EGL/eglext.h>

#include <chrono>

#include "layer/egl/attributes.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"

namespace anteroom::egl {
namespace {

// EGL 1.5 and EGL_KHR_fence_sync name different errors for an unknown type.
template <typename Integer>
EGLSync createSync(EGLDisplay dpy, EGLenum type, const Integer* attributes, EGLint unknownType,
                   const char* name = __builtin_FUNCTION()) {
  return command<EGLSync>(
      EGL_NO_SYNC,
      [&](Lock&) {
        Display& display = initializedDisplay(dpy);
        require(type == EGL_SYNC_FENCE || type == EGL_SYNC_REUSABLE_KHR, unknownType);
        require(isEmpty(attributes), EGL_BAD_ATTRIBUTE);
        if (type == EGL_SYNC_REUSABLE_KHR) return display.syncs.add(std::make_shared<ReusableSync>());
        const Binding* binding = currentBinding();
        require(binding != nullptr && &binding->context->display == &display, EGL_BAD_MATCH);
        return display.syncs.add(std::make_shared<FenceSync>(binding->context));
      },
      name);
}

template <typename Integer>
EGLBoolean getSyncAttribute(EGLDisplay dpy, EGLSync sync, EGLint attribute, Integer* value,
                            const char* name = __builtin_FUNCTION()) {
  return command<EGLBoolean>(
      EGL_FALSE,
      [&](Lock& lock) {
        const auto found = initializedDisplay(dpy).sync(sync);
        require(value != nullptr, EGL_BAD_PARAMETER);
        switch (attribute) {
          case EGL_SYNC_TYPE:
            *value = static_cast<Integer>(found->type());
            break;
          case EGL_SYNC_STATUS:
            *value = found->wait(lock, 0) ? EGL_SIGNALED : EGL_UNSIGNALED;
            break;
          case EGL_SYNC_CONDITION:
            require(found->type() == EGL_SYNC_FENCE, EGL_BAD_MATCH);
            *value = EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
            break;
          default:
            throw Error{EGL_BAD_ATTRIBUTE};
        }
        return EGL_TRUE;
      },
      name);
}

}  // namespace

FenceSync::FenceSync(const std::shared_ptr<Context>& context)
    : context_(context), fence_(gl::RendererLock(*context->gl)->insertFence()) {
  context->fenced = true;
}

bool FenceSync::wait(Lock& lock, uint64_t timeout) {
  const auto context = context_.lock();
  if (signaled_ || context == nullptr) return true;
  lock.unlock();
  const bool passed = gl::rendererOf(*context->gl).waitFence(fence_, timeout);
  lock.lock();
  signaled_ |= passed;
  return passed;
}

EGLenum ReusableSync::type() const {
  return EGL_SYNC_REUSABLE_KHR;
}

bool ReusableSync::wait(Lock& lock, uint64_t timeout) {
  const uint64_t before = signals_;
  const auto released = [&] { return signaled_ || signals_ != before; };
  // Clocks do not reach further.
  constexpr uint64_t kLongest = uint64_t{1} << 60;
  if (timeout <= kLongest) {
    return changed_.wait_for(lock, std::chrono::nanoseconds(static_cast<int64_t>(timeout)), released);
  }
  changed_.wait(lock, released);
  return true;
}

void ReusableSync::set(bool signaled) {
  signals_ += signaled && !signaled_;
  signaled_ = signaled;
  if (signaled) changed_.notify_all();
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
    const auto taken = initializedDisplay(dpy).syncs.take(sync);
    require(taken != nullptr, EGL_BAD_PARAMETER);
    taken->abandon();
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglDestroySyncKHR(EGLDisplay dpy, EGLSyncKHR sync) {
  return eglDestroySync(dpy, sync);
}

EGLBoolean EGLAPIENTRY eglSignalSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLenum mode) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const auto found = initializedDisplay(dpy).sync(sync);
    require(found->type() == EGL_SYNC_REUSABLE_KHR, EGL_BAD_MATCH);
    require(mode == EGL_SIGNALED_KHR || mode == EGL_UNSIGNALED_KHR, EGL_BAD_ATTRIBUTE);
    static_cast<ReusableSync&>(*found).set(mode == EGL_SIGNALED_KHR);
    return EGL_TRUE;
  });
}

EGLint EGLAPIENTRY eglClientWaitSync(EGLDisplay dpy, EGLSync sync, EGLint flags, EGLTime timeout) {
  return command<EGLint>(EGL_FALSE, [&](Lock& lock) {
    const auto found = initializedDisplay(dpy).sync(sync);
    // A fence was flushed when it was inserted.
    const bool flush = (flags & EGL_SYNC_FLUSH_COMMANDS_BIT) != 0 && found->type() != EGL_SYNC_FENCE;
    if (flush && currentContext() != nullptr && !found->wait(lock, 0))
      gl::RendererLock(*currentContext()->gl)->flush();
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
    found->waitInServer(lock);
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
