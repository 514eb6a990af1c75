#include "layer/egl/context.h"

#include <EGL/eglext.h>

#include "layer/egl/attributes.h"
#include "layer/egl/context_stats.h"
#include "layer/egl/counters.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/render/debug_options.h"

namespace anteroom::egl {
namespace {

EGLint counter(Context& context, EGLint attribute) {
  const render::Stats& stats = gl::rendererOf(*context.gl).stats();
  const uint64_t value = attribute == EGL_DRAWS_ANTEROOM       ? stats.draws
                         : attribute == EGL_PIPELINES_ANTEROOM ? stats.pipelinesCreated
                         : attribute == EGL_COMPILES_ANTEROOM  ? stats.shadersCompiled
                                                               : stats.bytesUploaded;
  return static_cast<EGLint>(value & 0x7FFFFFFF);
}

void setFlags(ContextAttributes& attributes, EGLAttrib flags) {
  // Forward-compatible and robust contexts are OpenGL's alone by EGL_KHR_create_context.
  require((flags & ~EGLAttrib{EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR}) == 0, EGL_BAD_ATTRIBUTE);
  attributes.options.debug = flags != 0;
}

void setAttribute(ContextAttributes& attributes, EGLint name, EGLAttrib value) {
  switch (name) {
    case EGL_CONTEXT_MAJOR_VERSION:
      attributes.major = static_cast<EGLint>(value);
      break;
    case EGL_CONTEXT_MINOR_VERSION:
      attributes.minor = static_cast<EGLint>(value);
      break;
    case EGL_CONTEXT_FLAGS_KHR:
      setFlags(attributes, value);
      break;
    case EGL_CONTEXT_OPENGL_DEBUG:
      attributes.options.debug = toBoolean(value);
      break;
    case EGL_CONTEXT_OPENGL_ROBUST_ACCESS:
    case EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT:
      attributes.options.robustAccess = toBoolean(value);
      break;
    case EGL_CONTEXT_OPENGL_NO_ERROR_KHR:
      attributes.options.noError = toBoolean(value);
      break;
    case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY:
    case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT:
      require(value == EGL_NO_RESET_NOTIFICATION || value == EGL_LOSE_CONTEXT_ON_RESET, EGL_BAD_ATTRIBUTE);
      attributes.options.loseContextOnReset = value == EGL_LOSE_CONTEXT_ON_RESET;
      break;
    default:
      throw Error{EGL_BAD_ATTRIBUTE};
  }
}

ContextAttributes parse(const EGLint* list) {
  ContextAttributes attributes;
  forEachAttribute(list, [&](EGLint name, EGLAttrib value) { setAttribute(attributes, name, value); });
  // Neither undefined versions nor those of which no config has the bit (section 3.7.1, errors).
  require(attributes.major == 1 && (attributes.minor == 0 || attributes.minor == 1), EGL_BAD_MATCH);
  // EGL_KHR_create_context_no_error.
  const gl::ContextOptions& options = attributes.options;
  require(!options.noError || !(options.debug || options.robustAccess || options.loseContextOnReset),
          EGL_BAD_MATCH);
  return attributes;
}

// Null: EGL_NO_CONTEXT.
std::shared_ptr<Context> findShared(const Display& display, EGLContext handle,
                                    const ContextAttributes& attributes) {
  if (handle == EGL_NO_CONTEXT) return nullptr;
  auto shared = display.contexts.find(handle);
  if (shared == nullptr) throw Error{isContextOfAnyDisplay(handle) ? EGL_BAD_MATCH : EGL_BAD_CONTEXT};
  require(shared->attributes.options.loseContextOnReset == attributes.options.loseContextOnReset,
          EGL_BAD_MATCH);
  require(shared->attributes.options.noError == attributes.options.noError, EGL_BAD_MATCH);
  return shared;
}

EGLint renderBuffer(const Context& context) {
  if (context.thread == nullptr) return EGL_NONE;
  const Binding* binding = context.thread->binding;
  return binding != nullptr && binding->draw != nullptr ? EGL_BACK_BUFFER : EGL_NONE;
}

}  // namespace

Context::Context(Display& owner, std::shared_ptr<render::Device> renderDevice,
                 std::optional<Config> withConfig, const ContextAttributes& with, GlContext front)
    : display(owner),
      device(std::move(renderDevice)),
      config(withConfig),
      attributes(with),
      gl(std::move(front)) {}

Context::~Context() {
  // A sync object whose context is gone counts as signaled.
  if (fenced) gl::RendererLock(*gl)->finish();
  if (render::debugOptions().stats) logStats(*this);
}

}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLContext EGLAPIENTRY eglCreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share_context,
                                        const EGLint* attrib_list) {
  return command<EGLContext>(EGL_NO_CONTEXT, [&](Lock&) {
    Display& display = initializedDisplay(dpy);
    std::optional<Config> with;
    if (config != EGL_NO_CONFIG_KHR) with = display.config(config);
    ContextAttributes attributes = parse(attrib_list);
    attributes.options.findImage = findImage;
    attributes.options.display = &display;
    if (render::debugOptions().stats) logStatsAtExit();
    attributes.options.logErrors = render::debugOptions().errors;
    const auto shared = findShared(display, share_context, attributes);
    auto front =
        gl::createContext(*display.device(), shared ? shared->gl.get() : nullptr, attributes.options);
    require(front != nullptr, EGL_BAD_ALLOC);
    return display.contexts.add(
        std::make_shared<Context>(display, display.device(), with, attributes, std::move(front)));
  });
}

EGLBoolean EGLAPIENTRY eglDestroyContext(EGLDisplay dpy, EGLContext ctx) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(initializedDisplay(dpy).contexts.take(ctx) != nullptr, EGL_BAD_CONTEXT);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglQueryContext(EGLDisplay dpy, EGLContext ctx, EGLint attribute, EGLint* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const auto context = initializedDisplay(dpy).context(ctx);
    require(value != nullptr, EGL_BAD_PARAMETER);
    switch (attribute) {
      case EGL_CONFIG_ID:
        *value = context->config ? context->config->id : 0;
        break;
      case EGL_CONTEXT_CLIENT_TYPE:
        *value = EGL_OPENGL_ES_API;
        break;
      case EGL_CONTEXT_CLIENT_VERSION:
        *value = 1;
        break;
      case EGL_RENDER_BUFFER:
        *value = renderBuffer(*context);
        break;
      default:
        require(isCounter(attribute), EGL_BAD_ATTRIBUTE);
        require(context.get() == currentContext(), EGL_BAD_ACCESS);
        *value = counter(*context, attribute);
    }
    return EGL_TRUE;
  });
}
