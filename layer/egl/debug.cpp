#include "layer/egl/debug.h"

#include <array>
#include <optional>
#include <string>
#include <unordered_map>

#include "layer/egl/attributes.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"
#include "layer/render/debug_options.h"

namespace anteroom::egl {
namespace {

// EGL_DEBUG_MSG_CRITICAL_KHR and the next three; table 13.1.
using Enabled = std::array<bool, 4>;
constexpr Enabled kInitially{true, true, false, false};

struct Debug {
  EGLDEBUGPROCKHR callback = nullptr;
  Enabled enabled = kInitially;
  std::unordered_map<const void*, EGLLabelKHR> labels;  // by handle; there is none without a label
};
// Under the lock. Never destroyed: commands may be called while the process ends.
Debug& debug() {
  static auto& instance = *new Debug;
  return instance;
}

bool* typeOf(Enabled& enabled, EGLint type) {
  const auto index = static_cast<size_t>(type - EGL_DEBUG_MSG_CRITICAL_KHR);
  return type >= EGL_DEBUG_MSG_CRITICAL_KHR && index < enabled.size() ? &enabled[index] : nullptr;
}

EGLLabelKHR labelOf(const void* handle) {
  const auto found = debug().labels.find(handle);
  return found == debug().labels.end() ? nullptr : found->second;
}

struct ErrorText {
  EGLint code;
  const char* name;
  const char* text;  // what is wrong and what to do
};
constexpr ErrorText kErrors[] = {
    {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED",
     "the display is not initialized, or no device was found. Call eglInitialize first, and look at stderr"},
    {EGL_BAD_ACCESS, "EGL_BAD_ACCESS",
     "a context or surface is in use elsewhere. Release it in the thread that has it, or release its "
     "texture"},
    {EGL_BAD_ALLOC, "EGL_BAD_ALLOC",
     "memory ran out. Destroy what is no longer used, or ask for smaller surfaces"},
    {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE",
     "an attribute or its value is unknown here. Compare the list with the command's attributes, and end it "
     "with "
     "EGL_NONE"},
    {EGL_BAD_CONFIG, "EGL_BAD_CONFIG", "the config is none of this display. Take one from eglChooseConfig"},
    {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT",
     "the context is none of this display, was destroyed, or none is current. Create one, and make it "
     "current"},
    {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE",
     "the current surface is no longer valid. Make another one current"},
    {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY",
     "this is no display. Take one from eglGetDisplay or eglGetPlatformDisplay"},
    {EGL_BAD_MATCH, "EGL_BAD_MATCH",
     "arguments do not go together. Use one config for contexts and surfaces, versions 1.0 or 1.1, and like "
     "attributes for contexts that share"},
    {EGL_BAD_NATIVE_PIXMAP, "EGL_BAD_NATIVE_PIXMAP", "there are no native pixmaps here. Use a pbuffer"},
    {EGL_BAD_NATIVE_WINDOW, "EGL_BAD_NATIVE_WINDOW", "there are no native windows here. Use a pbuffer"},
    {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER",
     "an argument is unknown, null or no object of this display. Compare the arguments with what the command "
     "takes"},
    {EGL_BAD_SURFACE, "EGL_BAD_SURFACE",
     "the surface is none of this display, was destroyed, or is none of the kind that the command needs. "
     "Create one "
     "with the config and attributes for it"},
    {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST",
     "the context was lost. Destroy it, and create it anew with its objects"},
};

std::string textOf(EGLint code, const char* command) {
  for (const ErrorText& error : kErrors) {
    if (error.code == code) return std::string(command) + ": " + error.name + ": " + error.text + ".";
  }
  return std::string(command) + ": error " + std::to_string(code) + ".";
}

// The frame of commands that return their error.
template <typename Body>
EGLint coded(Body body, const char* name = __builtin_FUNCTION()) {
  command<EGLBoolean>(
      EGL_FALSE,
      [&](Lock&) {
        body();
        return EGL_TRUE;
      },
      name);
  return thisThread().error;
}

bool exists(const Display& display, EGLenum type, const void* object) {
  switch (type) {
    case EGL_OBJECT_CONTEXT_KHR:
      return display.contexts.find(object) != nullptr;
    case EGL_OBJECT_SURFACE_KHR:
      return display.surfaces.find(object) != nullptr;
    case EGL_OBJECT_IMAGE_KHR:
      return display.images.find(object) != nullptr;
    case EGL_OBJECT_SYNC_KHR:
      return display.syncs.find(object) != nullptr;
    default:
      return false;
  }
}

}  // namespace

void fail(EGLint code, const char* command) noexcept {
  const Thread& thread = thisThread();
  const bool critical = code == EGL_BAD_ALLOC || code == EGL_CONTEXT_LOST;
  const EGLint type = critical ? EGL_DEBUG_MSG_CRITICAL_KHR : EGL_DEBUG_MSG_ERROR_KHR;
  EGLDEBUGPROCKHR callback = nullptr;
  EGLLabelKHR object = nullptr;
  {
    const Lock lock(mutex());
    if (*typeOf(debug().enabled, type)) callback = debug().callback;
    if (callback != nullptr) object = thread.primary == nullptr ? thread.label : labelOf(thread.primary);
  }
  setError(code);
  const bool logged = render::debugOptions().errors;
  if (callback == nullptr && !logged) return;
  try {
    const std::string text = textOf(code, command);
    if (logged) log(text.c_str());
    if (callback == nullptr) return;
    callback(static_cast<EGLenum>(code), command, type, thread.label, object, text.c_str());
  } catch (const std::bad_alloc&) {
    if (callback != nullptr)
      callback(static_cast<EGLenum>(code), command, type, thread.label, object, nullptr);
  }
}

void notePrimary(const void* handle, bool isDisplay) {
  Thread& thread = thisThread();
  if (thread.primary != nullptr && (isDisplay || !thread.primaryIsDisplay)) return;
  thread.primary = handle;
  thread.primaryIsDisplay = isDisplay;
}

void forgetLabel(const void* handle) {
  debug().labels.erase(handle);
}

}  // namespace anteroom::egl

using namespace anteroom::egl;

EGLint EGLAPIENTRY eglDebugMessageControlKHR(EGLDEBUGPROCKHR callback, const EGLAttrib* attrib_list) {
  return coded([&] {
    Enabled enabled = debug().enabled;
    forEachAttribute(attrib_list, [&](EGLint name, EGLAttrib value) {
      bool* const type = typeOf(enabled, name);
      require(type != nullptr, EGL_BAD_ATTRIBUTE);
      *type = toBoolean(value);
    });
    debug().callback = callback;
    debug().enabled = callback != nullptr ? enabled : kInitially;
  });
}

EGLBoolean EGLAPIENTRY eglQueryDebugKHR(EGLint attribute, EGLAttrib* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const bool* const type = typeOf(debug().enabled, attribute);
    require(type != nullptr || attribute == EGL_DEBUG_CALLBACK_KHR, EGL_BAD_ATTRIBUTE);
    require(value != nullptr, EGL_BAD_PARAMETER);
    *value = type != nullptr ? EGLAttrib{*type} : reinterpret_cast<EGLAttrib>(debug().callback);
    return EGL_TRUE;
  });
}

EGLint EGLAPIENTRY eglLabelObjectKHR(EGLDisplay display, EGLenum objectType, EGLObjectKHR object,
                                     EGLLabelKHR label) {
  return coded([&] {
    if (objectType == EGL_OBJECT_THREAD_KHR) {
      thisThread().label = label;
      return;
    }
    const bool isDisplay = objectType == EGL_OBJECT_DISPLAY_KHR;
    const Display& owner = isDisplay ? displayOf(display) : initializedDisplay(display);
    require(isDisplay ? object == display : exists(owner, objectType, object), EGL_BAD_PARAMETER);
    if (label != nullptr)
      debug().labels[object] = label;
    else
      forgetLabel(object);
  });
}
