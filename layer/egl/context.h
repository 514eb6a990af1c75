// Section 3.7: rendering contexts.
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <optional>

#include "layer/egl/config.h"
#include "layer/gl/front_end.h"

namespace anteroom::egl {

class Display;
struct Thread;

struct ContextAttributes {
  EGLint major = 1;
  EGLint minor = 0;
  gl::ContextOptions options;
};

struct Context {
  using GlContext = std::unique_ptr<gl::Context, void (*)(gl::Context*)>;

  Context(Display& owner, std::shared_ptr<render::Device> renderDevice, std::optional<Config> withConfig,
          const ContextAttributes& with, GlContext front);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void* handle = nullptr;
  Display& display;
  std::shared_ptr<render::Device> device;  // outlives `gl`, also when the display has been terminated
  std::optional<Config> config;            // none: EGL_NO_CONFIG_KHR
  ContextAttributes attributes;
  GlContext gl;
  Thread* thread = nullptr;  // where it is current
  uint64_t frames = 0;       // that were swapped
  bool fenced = false;       // a sync object waits for this context's commands
};

}  // namespace anteroom::egl
