#include "layer/egl/image.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include "layer/egl/attributes.h"
#include "layer/egl/current.h"
#include "layer/egl/display.h"

namespace anteroom::egl {
namespace {

// Table 3.10, as GL names the sources. ES 1.x has no three-dimensional textures whose slices could be images;
// nor is any handle that of a native pixmap.
GLenum sourceTarget(EGLenum target) {
  switch (target) {
    case EGL_GL_TEXTURE_2D:
      return GL_TEXTURE_2D;
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_X:
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Y:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y:
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Z:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Z:
      return GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + (target - EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X);
    case EGL_GL_RENDERBUFFER:
      return GL_RENDERBUFFER_OES;
    default:
      throw Error{EGL_BAD_PARAMETER};
  }
}

// Table 3.11. What a renderbuffer's list says is ignored, if it can be said at all.
template <typename Integer>
void readAttributes(const Integer* attributes, gl::ImageSource& source) {
  forEachAttribute(attributes, [&](EGLint name, EGLAttrib value) {
    const bool texture = source.target != GL_RENDERBUFFER_OES;
    switch (name) {
      case EGL_GL_TEXTURE_LEVEL:
        if (texture) source.level = static_cast<GLint>(value);
        break;
      case EGL_GL_TEXTURE_ZOFFSET:
        require(!texture, EGL_BAD_MATCH);
        break;
      case EGL_IMAGE_PRESERVED:  // they always are
        require(value == EGL_TRUE || value == EGL_FALSE, EGL_BAD_PARAMETER);
        break;
      default:
        throw Error{EGL_BAD_PARAMETER};
    }
  });
}

EGLint errorOf(gl::ShareStatus status) {
  switch (status) {
    case gl::ShareStatus::NoSource:
      return EGL_BAD_PARAMETER;
    case gl::ShareStatus::NoLevel:
      return EGL_BAD_MATCH;
    case gl::ShareStatus::Taken:
      return EGL_BAD_ACCESS;
    default:
      return EGL_BAD_ALLOC;
  }
}

template <typename Integer>
EGLImage createImage(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer,
                     const Integer* attributes, const char* commandName = __builtin_FUNCTION()) {
  return command<EGLImage>(
      EGL_NO_IMAGE,
      [&](Lock&) -> EGLImage {
        Display& display = initializedDisplay(dpy);
        gl::ImageSource source;
        source.target = sourceTarget(target);
        const std::shared_ptr<Context> context = display.context(ctx);
        readAttributes(attributes, source);
        const auto name = reinterpret_cast<uintptr_t>(buffer);
        require(name != 0 && name <= UINT32_MAX, EGL_BAD_PARAMETER);
        source.name = static_cast<GLuint>(name);
        // Commands of a context that shares with no other take no locks: they cannot be waited for.
        const bool elsewhere = context->thread != nullptr && context->thread != &thisThread();
        require(!elsewhere || gl::hasCompany(*context->gl), EGL_BAD_ACCESS);
        std::shared_ptr<gl::SharedImage> shared;
        const gl::ShareStatus status = gl::shareImage(*context->gl, source, shared);
        require(status == gl::ShareStatus::Shared, errorOf(status));
        return display.images.add(std::make_shared<Image>(std::move(shared)));
      },
      commandName);
}

}  // namespace

std::shared_ptr<gl::SharedImage> findImage(void* display, void* image) {
  const Lock lock(mutex());
  const std::shared_ptr<Image> found = static_cast<Display*>(display)->images.find(image);
  return found ? found->shared : nullptr;
}

}  // namespace anteroom::egl

using namespace anteroom::egl;

EGLImage EGLAPIENTRY eglCreateImage(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer,
                                    const EGLAttrib* attrib_list) {
  return createImage(dpy, ctx, target, buffer, attrib_list);
}

EGLImageKHR EGLAPIENTRY eglCreateImageKHR(EGLDisplay dpy, EGLContext ctx, EGLenum target,
                                          EGLClientBuffer buffer, const EGLint* attrib_list) {
  return createImage(dpy, ctx, target, buffer, attrib_list);
}

EGLBoolean EGLAPIENTRY eglDestroyImage(EGLDisplay dpy, EGLImage image) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) {
    require(initializedDisplay(dpy).images.take(image) != nullptr, EGL_BAD_PARAMETER);
    return EGL_TRUE;
  });
}

EGLBoolean EGLAPIENTRY eglDestroyImageKHR(EGLDisplay dpy, EGLImageKHR image) {
  return eglDestroyImage(dpy, image);
}
