// Section 3.6: rendering to textures.
#include <GLES/gl.h>

#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

bool Surface::bindTexture(const std::shared_ptr<Context>& context) {
  if (!allocate()) throw Error{EGL_BAD_ALLOC};
  gl::shareImages(*context->gl);
  // A reference of its own, whose end shows that no texture holds the image any more.
  const std::shared_ptr<render::Image> loan(framebuffer_.color.image.get(),
                                            [image = framebuffer_.color.image](render::Image*) {});
  if (!gl::bindTexImage(*context->gl, GL_TEXTURE_2D, loan, attributes.textureFormat == EGL_TEXTURE_RGBA)) {
    return false;
  }
  loan_ = loan;
  boundIn_ = context;
  return true;
}

void Surface::releaseTexture(Context* current) {
  const auto loan = loan_.lock();
  const auto boundIn = boundIn_.lock();
  Context* context = boundIn != nullptr ? boundIn.get() : current;
  if (loan != nullptr && context != nullptr) gl::releaseTexImage(*context->gl, loan);
  loan_.reset();
  boundIn_.reset();
}

namespace {

std::shared_ptr<Surface> textureSurface(EGLDisplay dpy, EGLSurface surface, EGLint buffer) {
  auto found = initializedDisplay(dpy).surface(surface);
  require(buffer == EGL_BACK_BUFFER, EGL_BAD_PARAMETER);
  require(found->isTexture(), EGL_BAD_MATCH);
  const bool rgba = found->attributes.textureFormat == EGL_TEXTURE_RGBA;
  require(found->config.get(rgba ? EGL_BIND_TO_TEXTURE_RGBA : EGL_BIND_TO_TEXTURE_RGB) == EGL_TRUE,
          EGL_BAD_SURFACE);
  return found;
}

// What was drawn to the surface before is in the texture: glFlush where it is current, glFinish on the last
// context elsewhere, unless another thread has that context: then it is the program's to wait for it.
void completeDrawing(const Surface& surface) {
  const auto last = surface.drawnBy.lock();
  if (last == nullptr) return;
  if (last->thread == &thisThread()) {
    gl::RendererLock(*last->gl)->flush();
  } else if (last->thread == nullptr) {
    gl::RendererLock(*last->gl)->finish();
  }
}

}  // namespace
}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

EGLBoolean EGLAPIENTRY eglBindTexImage(EGLDisplay dpy, EGLSurface surface, EGLint buffer) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    const auto found = textureSurface(dpy, surface, buffer);
    require(!found->isBound(), EGL_BAD_ACCESS);
    const Binding* binding = currentBinding();
    if (binding == nullptr) return EGL_TRUE;  // "is ignored if there is no current rendering context"
    completeDrawing(*found);
    require(found->bindTexture(binding->context), EGL_BAD_MATCH);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglReleaseTexImage(EGLDisplay dpy, EGLSurface surface, EGLint buffer) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    textureSurface(dpy, surface, buffer)->releaseTexture(currentContext());
    return EGL_TRUE;
  });
}
