// Section 3.2: displays. Their handles are their addresses and live as long as the process.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>
#include <vector>

#include "layer/egl/config.h"
#include "layer/egl/context.h"
#include "layer/egl/handles.h"
#include "layer/egl/image.h"
#include "layer/egl/surface.h"
#include "layer/egl/sync.h"
#include "layer/egl/window_system.h"

namespace anteroom::egl {

class Display {
 public:
  explicit Display(const Platform& platform) : platform_(platform) {}

  EGLDisplay handle() { return this; }
  const Platform& platform() const { return platform_; }

  bool initialized() const { return device_ != nullptr; }
  // Throws EGL_NOT_INITIALIZED when there is no device, or no server of its window system.
  void initialize();
  // What is current somewhere lives on until it no longer is; its handles are invalid at once.
  void terminate();
  // In a process that was forked: no longer initialized, and what there was stays untouched for good.
  void abandon();

  const std::shared_ptr<render::Device>& device() const { return device_; }
  // Null: the platform has no windows.
  const std::shared_ptr<WindowSystem>& windowSystem() const { return windowSystem_; }
  const std::vector<Config>& configs() const { return configs_; }
  // These throw EGL_BAD_CONFIG, EGL_BAD_CONTEXT, EGL_BAD_SURFACE and EGL_BAD_PARAMETER.
  const Config& config(EGLConfig handle) const;
  std::shared_ptr<Context> context(EGLContext handle) const;
  std::shared_ptr<Surface> surface(EGLSurface handle) const;
  std::shared_ptr<Sync> sync(EGLSync handle) const;

  Handles<Context> contexts;
  Handles<Image> images;
  Handles<Surface> surfaces;
  Handles<Sync> syncs;

 private:
  const Platform platform_;
  std::shared_ptr<render::Device> device_;
  std::shared_ptr<WindowSystem> windowSystem_;
  std::vector<Config> configs_;
};

// Throws EGL_BAD_DISPLAY.
Display& displayOf(EGLDisplay handle);
// Throws EGL_NOT_INITIALIZED, too.
Display& initializedDisplay(EGLDisplay handle);
// abandon() of all.
void abandonDisplays();
// Whether any display has such a context.
bool isContextOfAnyDisplay(EGLContext handle);
void forEachContext(void (*visit)(Context& context));

}  // namespace anteroom::egl
