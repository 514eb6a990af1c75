// Section 3.4: what a surface consists of.
#pragma once

#include <EGL/egl.h>

#include <vector>

#include "layer/egl/window_system.h"
#include "layer/render/renderer.h"

namespace anteroom::egl {

struct Config {
  EGLint id = 0;  // from 1 on; also the handle
  render::Format color = render::Format::None;
  // Formats of the images; the two may be one image of Depth24Stencil8, also where the config promises fewer
  // bits.
  render::Format depth = render::Format::None;
  render::Format stencil = render::Format::None;
  EGLint depthBits = 0;
  EGLint stencilBits = 0;
  EGLint samples = 0;                  // 0: not multisampled
  EGLint maxWidth = 0, maxHeight = 0;  // of a pbuffer
  bool window = false;
  Visual visual;  // of windows

  EGLConfig handle() const { return reinterpret_cast<EGLConfig>(static_cast<intptr_t>(id)); }
  // Tables 3.1 and 3.4. False: no such attribute.
  bool query(EGLint name, EGLint& value) const;
  // The value of an attribute that exists.
  EGLint get(EGLint name) const;
};

// All that a device can have without loss, numbered. `system` null: without windows.
std::vector<Config> makeConfigs(const render::Caps& caps, const WindowSystem* system);

// Section 2.2: whether a context of one can draw to a surface of the other.
bool areCompatible(const Config& one, const Config& other);

// Section 3.4.1: those that match, sorted. Throws EGL_BAD_ATTRIBUTE.
std::vector<const Config*> chooseConfigs(const std::vector<Config>& configs, const EGLint* attributes);

}  // namespace anteroom::egl
