#include "layer/egl/config.h"

#include <algorithm>
#include <optional>

#include "layer/egl/config_attributes.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

using render::Format;

bool isRenderable(const render::Caps& caps, Format format) {
  return caps.renderable[static_cast<int>(format)];
}

std::optional<Format> firstRenderable(const render::Caps& caps, std::initializer_list<Format> formats) {
  for (Format format : formats) {
    if (isRenderable(caps, format)) return format;
  }
  return std::nullopt;
}

// The images behind depth and stencil bits. False: the device cannot have them.
bool chooseDepthStencil(const render::Caps& caps, Config& config) {
  std::optional<Format> depth = Format::None, stencil = Format::None;
  if (config.depthBits != 0 && config.stencilBits != 0) {
    depth = stencil = firstRenderable(caps, {Format::Depth24Stencil8});
  } else if (config.depthBits == 16) {
    depth = firstRenderable(caps, {Format::Depth16, Format::Depth24, Format::Depth24Stencil8});
  } else if (config.depthBits == 24) {
    depth = firstRenderable(caps, {Format::Depth24, Format::Depth24Stencil8});
  } else if (config.stencilBits != 0) {
    stencil = firstRenderable(caps, {Format::Stencil8, Format::Depth24Stencil8});
  }
  if (!depth || !stencil) return false;
  config.depth = *depth;
  config.stencil = *stencil;
  return true;
}

}  // namespace

bool Config::query(EGLint name, EGLint& value) const {
  const ConfigAttribute* attribute = configAttribute(name);
  if (attribute == nullptr || attribute->value == nullptr) return false;
  value = attribute->value(*this);
  return true;
}

EGLint Config::get(EGLint name) const {
  EGLint value = 0;
  query(name, value);
  return value;
}

namespace {

// The color buffers of a device, with the visuals that their windows can have.
struct ColorBuffer {
  Format format;
  bool window = false;
  Visual visual;
};

std::vector<ColorBuffer> colorBuffers(const render::Caps& caps, const WindowSystem* system) {
  std::vector<ColorBuffer> buffers, more;
  for (Format format : {Format::RGBA8, Format::RGB8, Format::RGB565, Format::RGBA5551, Format::RGBA4444}) {
    if (!isRenderable(caps, format)) continue;
    std::vector<Visual> visuals;
    if (system != nullptr && render::info(format).red == 8)
      visuals = system->visuals(render::info(format).alpha != 0, caps);
    if (visuals.empty()) buffers.push_back({format, false, {}});
    for (const Visual& visual : visuals)
      (&visual == &visuals[0] ? buffers : more).push_back({format, true, visual});
  }
  // Second visuals come last, so that the first are chosen where nothing else decides.
  buffers.insert(buffers.end(), more.begin(), more.end());
  return buffers;
}

}  // namespace

std::vector<Config> makeConfigs(const render::Caps& caps, const WindowSystem* system) {
  std::vector<Config> configs;
  for (const ColorBuffer& buffer : colorBuffers(caps, system)) {
    for (EGLint samples : {0, 4}) {
      if (samples > caps.maxSamples) continue;
      for (EGLint depthBits : {0, 16, 24}) {
        for (EGLint stencilBits : {0, 8}) {
          Config config;
          config.color = buffer.format;
          config.window = buffer.window;
          config.visual = buffer.visual;
          config.depthBits = depthBits;
          config.stencilBits = stencilBits;
          config.samples = samples;
          config.maxWidth = std::min(caps.maxTextureSize, caps.maxViewport[0]);
          config.maxHeight = std::min(caps.maxTextureSize, caps.maxViewport[1]);
          if (!chooseDepthStencil(caps, config)) continue;
          config.id = static_cast<EGLint>(configs.size()) + 1;
          configs.push_back(config);
        }
      }
    }
  }
  return configs;
}

bool areCompatible(const Config& one, const Config& other) {
  return one.color == other.color && one.depthBits == other.depthBits &&
         one.stencilBits == other.stencilBits && one.samples == other.samples;
}

namespace {

template <typename Get>
void returnConfigs(size_t count, Get get, EGLConfig* configs, EGLint configSize, EGLint* numConfig) {
  if (configs != nullptr) {
    count = std::min(count, static_cast<size_t>(std::max(configSize, 0)));
    for (size_t i = 0; i < count; ++i) configs[i] = get(i).handle();
  }
  *numConfig = static_cast<EGLint>(count);
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom::egl;

EGLBoolean EGLAPIENTRY eglGetConfigs(EGLDisplay dpy, EGLConfig* configs, EGLint config_size,
                                     EGLint* num_config) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const std::vector<Config>& all = initializedDisplay(dpy).configs();
    require(num_config != nullptr, EGL_BAD_PARAMETER);
    returnConfigs(
        all.size(), [&](size_t i) { return all[i]; }, configs, config_size, num_config);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglChooseConfig(EGLDisplay dpy, const EGLint* attrib_list, EGLConfig* configs,
                                       EGLint config_size, EGLint* num_config) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const Display& display = initializedDisplay(dpy);
    require(num_config != nullptr, EGL_BAD_PARAMETER);
    const auto chosen = chooseConfigs(display.configs(), attrib_list);
    returnConfigs(
        chosen.size(), [&](size_t i) { return *chosen[i]; }, configs, config_size, num_config);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglGetConfigAttrib(EGLDisplay dpy, EGLConfig config, EGLint attribute, EGLint* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const Config& found = initializedDisplay(dpy).config(config);
    require(value != nullptr, EGL_BAD_PARAMETER);
    require(found.query(attribute, *value), EGL_BAD_ATTRIBUTE);
    return EGL_TRUE;
  });
}
