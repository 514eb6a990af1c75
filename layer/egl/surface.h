// Section 3.5: pbuffers. No platform has windows or pixmaps.
#pragma once

#include <EGL/egl.h>

#include <memory>

#include "layer/egl/config.h"
#include "layer/egl/context.h"

namespace anteroom::egl {

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
};

class Surface {
 public:
  Surface(const Display& owner, std::shared_ptr<render::Device> device, const Config& config,
          const SurfaceAttributes& attributes);

  // Creates the images when they are first needed. False: out of memory.
  bool allocate();
  // After allocate().
  const render::Framebuffer& framebuffer() const { return framebuffer_; }
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

 private:
  EGLint levels() const;
  bool createImages();

  std::shared_ptr<render::Device> device_;
  render::Framebuffer framebuffer_;
  // The color image as a texture has it: alive as long as any texture holds it.
  std::weak_ptr<render::Image> loan_;
  std::weak_ptr<Context> boundIn_;
};

}  // namespace anteroom::egl
