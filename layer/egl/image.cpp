// Section 3.9. No client API here has resources that can become images: every source is refused.
#include <EGL/egl.h>

#include "layer/egl/attributes.h"
#include "layer/egl/display.h"

using namespace anteroom::egl;

namespace {

// Table 3.10.
bool isTarget(EGLenum target) {
  switch (target) {
    case EGL_GL_TEXTURE_2D:
    case EGL_GL_TEXTURE_3D:
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_X:
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Y:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y:
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Z:
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Z:
    case EGL_GL_RENDERBUFFER:
      return true;
    default:
      return false;
  }
}

}  // namespace

EGLImage EGLAPIENTRY eglCreateImage(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer,
                                    const EGLAttrib*) {
  return command<EGLImage>(EGL_NO_IMAGE, [&](Lock&) -> EGLImage {
    const Display& display = initializedDisplay(dpy);
    // The targets of table 3.10 all need a context.
    if (ctx != EGL_NO_CONTEXT || isTarget(target)) display.context(ctx);
    throw Error{EGL_BAD_PARAMETER};
  });
}

EGLBoolean EGLAPIENTRY eglDestroyImage(EGLDisplay dpy, EGLImage) {
  return command<EGLBoolean>(EGL_FALSE, [&](Lock&) -> EGLBoolean {
    initializedDisplay(dpy);
    throw Error{EGL_BAD_PARAMETER};
  });
}
