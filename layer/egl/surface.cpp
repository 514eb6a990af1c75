#include "layer/egl/surface.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <utility>

#include "layer/egl/attributes.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"

namespace anteroom::egl {

using render::Format;

namespace {

EGLint oneOf(EGLAttrib value, std::initializer_list<EGLint> values) {
  const auto found = std::find(values.begin(), values.end(), value);
  require(found != values.end(), EGL_BAD_ATTRIBUTE);
  return *found;
}

EGLint sizeOf(EGLAttrib value) {
  require(value >= 0, EGL_BAD_PARAMETER);
  return static_cast<EGLint>(value);
}

void setAttribute(SurfaceAttributes& attributes, EGLint name, EGLAttrib value) {
  switch (name) {
    case EGL_WIDTH:
      attributes.width = sizeOf(value);
      break;
    case EGL_HEIGHT:
      attributes.height = sizeOf(value);
      break;
    case EGL_LARGEST_PBUFFER:
      attributes.largest = toBoolean(value);
      break;
    case EGL_MIPMAP_TEXTURE:
      attributes.mipmapTexture = toBoolean(value);
      break;
    case EGL_TEXTURE_FORMAT:
      attributes.textureFormat = oneOf(value, {EGL_NO_TEXTURE, EGL_TEXTURE_RGB, EGL_TEXTURE_RGBA});
      break;
    case EGL_TEXTURE_TARGET:
      attributes.textureTarget = oneOf(value, {EGL_NO_TEXTURE, EGL_TEXTURE_2D});
      break;
    default:
      setSurfaceAttribute(attributes, name, value);
  }
}

bool isPowerOfTwo(EGLint size) {
  return size > 0 && std::has_single_bit(static_cast<unsigned>(size));
}

// EGL_LARGEST_PBUFFER: a texture keeps its aspect ratio and stays a power of two.
void shrinkToFit(SurfaceAttributes& attributes, const Config& config) {
  const auto fits = [&] {
    return attributes.width <= config.maxWidth && attributes.height <= config.maxHeight;
  };
  if (attributes.textureFormat == EGL_NO_TEXTURE) {
    attributes.width = std::min(attributes.width, config.maxWidth);
    attributes.height = std::min(attributes.height, config.maxHeight);
  }
  while (!fits()) {
    attributes.width = std::max(1, attributes.width / 2);
    attributes.height = std::max(1, attributes.height / 2);
  }
}

SurfaceAttributes parsePbuffer(const EGLint* list, const Config& config) {
  SurfaceAttributes attributes;
  forEachAttribute(list, [&](EGLint name, EGLAttrib value) { setAttribute(attributes, name, value); });
  requireMatch(attributes, config);
  const bool texture = attributes.textureFormat != EGL_NO_TEXTURE;
  require(texture == (attributes.textureTarget != EGL_NO_TEXTURE), EGL_BAD_MATCH);
  // ES 1.1 has only textures of powers of two (section 3.7.1 of its specification).
  require(!texture || (isPowerOfTwo(attributes.width) && isPowerOfTwo(attributes.height)), EGL_BAD_MATCH);
  if (attributes.largest) shrinkToFit(attributes, config);
  require(attributes.width <= config.maxWidth && attributes.height <= config.maxHeight, EGL_BAD_ALLOC);
  return attributes;
}

// No platform has pixmaps: whatever else is wrong, the handle is no native one.
EGLSurface refusePixmap(EGLDisplay dpy, const char* name = __builtin_FUNCTION()) {
  return command<EGLSurface>(
      EGL_NO_SURFACE,
      [&](Lock&) -> EGLSurface {
        initializedDisplay(dpy);
        throw Error{EGL_BAD_NATIVE_PIXMAP};
      },
      name);
}

// The next picture tells the size and the age. Not under the lock: it may wait for the window system.
void readyWhereCurrent(const Surface& surface, EGLint attribute) {
  const Binding* binding = currentBinding();
  const bool current = binding != nullptr && binding->draw.get() == &surface;
  require(current || attribute != EGL_BUFFER_AGE_EXT, EGL_BAD_SURFACE);
  if (current) readyWindow(*binding);
}

EGLint query(const Surface& surface, EGLint attribute) {
  const SurfaceAttributes& is = surface.attributes;
  switch (attribute) {
    case EGL_CONFIG_ID:
      return surface.config.id;
    case EGL_WIDTH:
      return surface.width();
    case EGL_HEIGHT:
      return surface.height();
    case EGL_LARGEST_PBUFFER:
      return is.largest;
    case EGL_TEXTURE_FORMAT:
      return is.textureFormat;
    case EGL_TEXTURE_TARGET:
      return is.textureTarget;
    case EGL_MIPMAP_TEXTURE:
      return is.mipmapTexture;
    case EGL_MIPMAP_LEVEL:
      return is.mipmapLevel;
    case EGL_GL_COLORSPACE:
      return is.glColorspace;
    case EGL_VG_COLORSPACE:
      return is.vgColorspace;
    case EGL_VG_ALPHA_FORMAT:
      return is.vgAlphaFormat;
    case EGL_MULTISAMPLE_RESOLVE:
      return is.multisampleResolve;
    case EGL_SWAP_BEHAVIOR:
      return is.swapBehavior;
    case EGL_RENDER_BUFFER:
      return is.renderBuffer;
    case EGL_PRESENT_OPAQUE_EXT:
      return is.presentOpaque;
    case EGL_BUFFER_AGE_EXT:
      return surface.age();
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
      return EGL_UNKNOWN;
    default:
      throw Error{EGL_BAD_ATTRIBUTE};
  }
}

// Attributes of pbuffers, to which windows give no answer.
bool isOfPbuffers(EGLint attribute) {
  switch (attribute) {
    case EGL_LARGEST_PBUFFER:
    case EGL_TEXTURE_FORMAT:
    case EGL_TEXTURE_TARGET:
    case EGL_MIPMAP_TEXTURE:
    case EGL_MIPMAP_LEVEL:
      return true;
    default:
      return false;
  }
}

}  // namespace

void setSurfaceAttribute(SurfaceAttributes& attributes, EGLint name, EGLAttrib value) {
  switch (name) {
    case EGL_GL_COLORSPACE:
      attributes.glColorspace = oneOf(value, {EGL_GL_COLORSPACE_LINEAR, EGL_GL_COLORSPACE_SRGB});
      break;
    case EGL_VG_COLORSPACE:
      attributes.vgColorspace = oneOf(value, {EGL_VG_COLORSPACE_sRGB, EGL_VG_COLORSPACE_LINEAR});
      break;
    case EGL_VG_ALPHA_FORMAT:
      attributes.vgAlphaFormat = oneOf(value, {EGL_VG_ALPHA_FORMAT_NONPRE, EGL_VG_ALPHA_FORMAT_PRE});
      break;
    default:
      throw Error{EGL_BAD_ATTRIBUTE};
  }
}

void requireMatch(const SurfaceAttributes& attributes, const Config& config) {
  const EGLint types = config.get(EGL_SURFACE_TYPE);
  require(attributes.vgColorspace == EGL_VG_COLORSPACE_sRGB || (types & EGL_VG_COLORSPACE_LINEAR_BIT) != 0,
          EGL_BAD_MATCH);
  require(
      attributes.vgAlphaFormat == EGL_VG_ALPHA_FORMAT_NONPRE || (types & EGL_VG_ALPHA_FORMAT_PRE_BIT) != 0,
      EGL_BAD_MATCH);
}

Format colorFormat(const Config& config, const SurfaceAttributes& attributes) {
  if (attributes.glColorspace != EGL_GL_COLORSPACE_SRGB) return config.color;
  if (config.color == Format::RGBA8) return Format::SRGB8Alpha8;
  return config.color == Format::RGB8 ? Format::SRGB8 : config.color;
}

Surface::Surface(const Display& owner, std::shared_ptr<render::Device> device, const Config& withConfig,
                 const SurfaceAttributes& withAttributes, std::unique_ptr<Hud> hud)
    : display(owner),
      config(withConfig),
      attributes(withAttributes),
      device_(std::move(device)),
      hud_(std::move(hud)) {}

EGLint Surface::levels() const {
  if (!isTexture() || !attributes.mipmapTexture) return 1;
  return std::bit_width(static_cast<unsigned>(std::max(attributes.width, attributes.height)));
}

bool Surface::allocate() {
  return framebuffer_.color.image != nullptr || createImages();
}

// A pbuffer without pixels gets one that no query shows, so that drawing to it is like drawing to any
// other.
bool Surface::createImages() {
  const EGLint level = std::clamp(attributes.mipmapLevel, 0, levels() - 1);
  render::ImageDesc desc;
  desc.renderable = true;
  desc.samples = std::max(1, config.samples);
  render::Framebuffer next;
  next.samples = desc.samples;
  next.width = std::max(1, attributes.width >> level);
  next.height = std::max(1, attributes.height >> level);
  next.color = framebuffer_.color;
  next.color.level = level;
  if (next.color.image == nullptr) {
    desc.format = colorFormat(config, attributes);
    desc.width = std::max(1, attributes.width);
    desc.height = std::max(1, attributes.height);
    desc.levels = levels();
    next.color.image = device_->createImage(desc);
    if (next.color.image == nullptr) return false;
  }
  if (!createDepthStencil(next)) return false;
  framebuffer_ = next;
  nameImages();
  return true;
}

// For tools that look at the device.
void Surface::nameImages() const {
  if (!device_->caps().objectNames) return;
  const auto name = [&](const render::Attachment& attachment, const char* use) {
    if (attachment.image == nullptr) return;
    char text[48];
    std::snprintf(text, sizeof text, "pbuffer %p %s", handle, use);
    attachment.image->setLabel(text);
  };
  name(framebuffer_.stencil, "stencil");
  name(framebuffer_.depth, "depth");
  name(framebuffer_.color, "color");
}

bool Surface::createDepthStencil(render::Framebuffer& next) const {
  render::ImageDesc desc;
  desc.renderable = true;
  desc.samples = next.samples;
  desc.width = next.width;
  desc.height = next.height;
  if (config.depth != Format::None) {
    desc.format = config.depth;
    next.depth.image = device_->createImage(desc);
    if (next.depth.image == nullptr) return false;
  }
  if (config.stencil != Format::None) {
    desc.format = config.stencil;
    next.stencil.image = config.stencil == config.depth ? next.depth.image : device_->createImage(desc);
    if (next.stencil.image == nullptr) return false;
  }
  return true;
}

const render::Hud* Surface::updateHud(const Binding& binding) {
  if (!hud_) return nullptr;
  const render::Context& renderer = gl::rendererOf(*binding.context->gl);
  hud_->frame(renderer.stats(), &renderer, Hud::Clock::now());
  return &hud_->picture();
}

void Surface::post(const Binding& binding, std::span<const render::Rect>) {
  if (const render::Hud* const picture = updateHud(binding))
    gl::RendererLock(*binding.context->gl)->drawHud(framebuffer_, *picture);
  gl::RendererLock(*binding.context->gl)->flush();
}

bool Surface::setMipmapLevel(EGLint level) {
  const EGLint former = std::exchange(attributes.mipmapLevel, level);
  const bool same = std::clamp(level, 0, levels() - 1) == std::clamp(former, 0, levels() - 1);
  if (same || framebuffer_.color.image == nullptr || createImages()) return true;
  attributes.mipmapLevel = former;
  return false;
}

}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLSurface EGLAPIENTRY eglCreatePbufferSurface(EGLDisplay dpy, EGLConfig config, const EGLint* attrib_list) {
  return command<EGLSurface>(EGL_NO_SURFACE, [&](Lock&) {
    Display& display = initializedDisplay(dpy);
    const Config& with = display.config(config);
    return display.surfaces.add(std::make_shared<Surface>(display, display.device(), with,
                                                          parsePbuffer(attrib_list, with), createHud(false)));
  });
}

EGLSurface EGLAPIENTRY eglCreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer,
                                                        EGLConfig config, const EGLint*) {
  // OpenVG images are the only client buffers there are, and no buffer is the handle of one.
  return command<EGLSurface>(EGL_NO_SURFACE, [&](Lock&) -> EGLSurface {
    initializedDisplay(dpy).config(config);
    throw Error{EGL_BAD_PARAMETER};
  });
}

EGLSurface EGLAPIENTRY eglCreatePixmapSurface(EGLDisplay dpy, EGLConfig, EGLNativePixmapType, const EGLint*) {
  return refusePixmap(dpy);
}

EGLSurface EGLAPIENTRY eglCreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig, void*, const EGLAttrib*) {
  return refusePixmap(dpy);
}

EGLSurface EGLAPIENTRY eglCreatePlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig, void*, const EGLint*) {
  return refusePixmap(dpy);
}

EGLBoolean EGLAPIENTRY eglDestroySurface(EGLDisplay dpy, EGLSurface surface) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(initializedDisplay(dpy).surfaces.take(surface) != nullptr, EGL_BAD_SURFACE);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglQuerySurface(EGLDisplay dpy, EGLSurface surface, EGLint attribute, EGLint* value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock& lock) {
    const auto found = initializedDisplay(dpy).surface(surface);
    require(value != nullptr, EGL_BAD_PARAMETER);
    if (attribute == EGL_WIDTH || attribute == EGL_HEIGHT || attribute == EGL_BUFFER_AGE_EXT) {
      lock.unlock();
      readyWhereCurrent(*found, attribute);
    }
    const EGLint answer = query(*found, attribute);
    if (!found->isWindow() || !isOfPbuffers(attribute)) *value = answer;
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglSurfaceAttrib(EGLDisplay dpy, EGLSurface surface, EGLint attribute, EGLint value) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const auto found = initializedDisplay(dpy).surface(surface);
    const EGLint types = found->config.get(EGL_SURFACE_TYPE);
    switch (attribute) {
      case EGL_MIPMAP_LEVEL: {
        require(found->setMipmapLevel(value), EGL_BAD_ALLOC);
        const Binding* binding = currentBinding();
        if (binding != nullptr && (binding->draw == found || binding->read == found)) useSurfaces(*binding);
        break;
      }
      case EGL_MULTISAMPLE_RESOLVE:
        oneOf(value, {EGL_MULTISAMPLE_RESOLVE_DEFAULT, EGL_MULTISAMPLE_RESOLVE_BOX});
        require(value == EGL_MULTISAMPLE_RESOLVE_DEFAULT || (types & EGL_MULTISAMPLE_RESOLVE_BOX_BIT) != 0,
                EGL_BAD_MATCH);
        found->attributes.multisampleResolve = value;
        break;
      case EGL_SWAP_BEHAVIOR:
        oneOf(value, {EGL_BUFFER_DESTROYED, EGL_BUFFER_PRESERVED});
        require(value == EGL_BUFFER_DESTROYED || (types & EGL_SWAP_BEHAVIOR_PRESERVED_BIT) != 0,
                EGL_BAD_MATCH);
        found->setSwapBehavior(value);
        break;
      default:
        throw Error{EGL_BAD_ATTRIBUTE};
    }
    return EGL_TRUE;
  });
}
