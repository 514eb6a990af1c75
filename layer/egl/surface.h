// Section 3.5: surfaces. Those of pbuffers are here, windows' in window_surface.h; no platform has pixmaps.
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <span>

#include "layer/egl/config.h"
#include "layer/egl/context.h"
#include "layer/egl/hud.h"

namespace anteroom::egl {

struct Binding;

struct SurfaceAttributes {
  EGLint width = 0, height = 0;
  bool largest = false;
  EGLint textureFormat = EGL_NO_TEXTURE;
  EGLint textureTarget = EGL_NO_TEXTURE;
  bool mipmapTexture = false;
  EGLint glColorspace = EGL_GL_COLORSPACE_LINEAR;  // of 8-bit colors
  EGLint vgColorspace = EGL_VG_COLORSPACE_sRGB;
  EGLint vgAlphaFormat = EGL_VG_ALPHA_FORMAT_NONPRE;
  EGLint mipmapLevel = 0;
  EGLint multisampleResolve = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
  EGLint swapBehavior = EGL_BUFFER_DESTROYED;
  // Of windows.
  EGLint renderBuffer = EGL_BACK_BUFFER;  // what was asked for
  bool presentOpaque = false;             // EGL_EXT_present_opaque
};

// Attributes that all kinds of surfaces have. Throws EGL_BAD_ATTRIBUTE for others.
void setSurfaceAttribute(SurfaceAttributes& attributes, EGLint name, EGLAttrib value);
// Those that `config` must be able to. Throws EGL_BAD_MATCH.
void requireMatch(const SurfaceAttributes& attributes, const Config& config);
// KHR_gl_colorspace: only colors of 8 bits have an sRGB format.
render::Format colorFormat(const Config& config, const SurfaceAttributes& attributes);

class Surface {
 public:
  // `hud` null: none.
  Surface(const Display& owner, std::shared_ptr<render::Device> device, const Config& config,
          const SurfaceAttributes& attributes, std::unique_ptr<Hud> hud);
  virtual ~Surface() = default;

  // Creates the images when they are first needed. False: out of memory.
  virtual bool allocate();
  // After allocate().
  virtual const render::Framebuffer& framebuffer() const { return framebuffer_; }
  virtual EGLint width() const { return attributes.width; }
  virtual EGLint height() const { return attributes.height; }
  virtual bool isWindow() const { return false; }

  // eglSwapBuffers, not under the lock. `binding` is the calling thread's. Throws EGL_BAD_NATIVE_WINDOW,
  // EGL_BAD_ALLOC. `damage`: in GL's coordinates; empty: all of it.
  virtual void post(const Binding& binding, std::span<const render::Rect> damage);
  virtual void setSwapBehavior(EGLint behavior) { attributes.swapBehavior = behavior; }
  virtual void setSwapInterval(EGLint) {}
  // EGL_BUFFER_AGE_EXT of a surface whose window is ready.
  virtual EGLint age() const { return 0; }

  // EGL_MIPMAP_LEVEL; takes effect at once where the surface is current, like allocate().
  bool setMipmapLevel(EGLint level);

  // Section 3.6. bindTexture: false: `context`'s texture cannot take it.
  bool isTexture() const { return attributes.textureFormat != EGL_NO_TEXTURE; }
  bool isBound() const { return !loan_.expired(); }
  bool bindTexture(const std::shared_ptr<Context>& context);
  void releaseTexture(Context* current);

  void* handle = nullptr;
  const Display& display;
  const Config config;
  SurfaceAttributes attributes;
  Thread* thread = nullptr;        // where it is current
  std::weak_ptr<Context> drawnBy;  // the last context that had it as its draw surface

 protected:
  // The HUD of the frame that ends now. Null: none.
  const render::Hud* updateHud(const Binding& binding);
  bool hasHud() const { return hud_ != nullptr; }

  const std::shared_ptr<render::Device> device_;

 private:
  EGLint levels() const;
  bool createImages();
  // Depth and stencil of `next`, as large as it is. False: out of memory.
  bool createDepthStencil(render::Framebuffer& next) const;
  void nameImages() const;

  render::Framebuffer framebuffer_;

  // The color image as a texture has it: alive as long as any texture holds it.
  std::weak_ptr<render::Image> loan_;
  std::weak_ptr<Context> boundIn_;
  const std::unique_ptr<Hud> hud_;
};

}  // namespace anteroom::egl
