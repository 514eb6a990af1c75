// EGLImages for the cases that make them: of textures and renderbuffers, and what is defined by them.
#pragma once

#include <cstdint>

#include "extension_commands.h"

namespace conformance {

struct ImageCommands {
  PFNGLEGLIMAGETARGETTEXTURE2DOESPROC EGLImageTargetTexture2DOES =
      command<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>("glEGLImageTargetTexture2DOES");
  PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC EGLImageTargetRenderbufferStorageOES =
      command<PFNGLEGLIMAGETARGETRENDERBUFFERSTORAGEOESPROC>("glEGLImageTargetRenderbufferStorageOES");
  PFNGLGENFRAMEBUFFERSOESPROC GenFramebuffersOES =
      command<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES");
  PFNGLBINDFRAMEBUFFEROESPROC BindFramebufferOES =
      command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC FramebufferTexture2DOES =
      command<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>("glFramebufferTexture2DOES");
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC FramebufferRenderbufferOES =
      command<PFNGLFRAMEBUFFERRENDERBUFFEROESPROC>("glFramebufferRenderbufferOES");
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC CheckFramebufferStatusOES =
      command<PFNGLCHECKFRAMEBUFFERSTATUSOESPROC>("glCheckFramebufferStatusOES");
  PFNGLGENRENDERBUFFERSOESPROC GenRenderbuffersOES =
      command<PFNGLGENRENDERBUFFERSOESPROC>("glGenRenderbuffersOES");
  PFNGLBINDRENDERBUFFEROESPROC BindRenderbufferOES =
      command<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES");
  PFNGLRENDERBUFFERSTORAGEOESPROC RenderbufferStorageOES =
      command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES");
  PFNGLGETRENDERBUFFERPARAMETERIVOESPROC GetRenderbufferParameterivOES =
      command<PFNGLGETRENDERBUFFERPARAMETERIVOESPROC>("glGetRenderbufferParameterivOES");
  PFNGLGENERATEMIPMAPOESPROC GenerateMipmapOES = command<PFNGLGENERATEMIPMAPOESPROC>("glGenerateMipmapOES");
};

class ImageTest : public GlTest {
 protected:
  static constexpr Vec4 kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1}, kBlue{0, 0, 1, 1}, kWhite{1, 1, 1, 1};

  // An image with its contents preserved. EGL_NO_IMAGE: refused.
  static EGLImage imageOf(EGLenum target, GLuint name, EGLAttrib level = 0,
                          EGLContext context = eglGetCurrentContext()) {
    const EGLAttrib attributes[] = {EGL_GL_TEXTURE_LEVEL, level, EGL_IMAGE_PRESERVED, EGL_TRUE, EGL_NONE};
    const EGLAttrib ofRenderbuffer[] = {EGL_IMAGE_PRESERVED, EGL_TRUE, EGL_NONE};
    return eglCreateImage(display(), context, target,
                          reinterpret_cast<EGLClientBuffer>(static_cast<std::uintptr_t>(name)),
                          target == EGL_GL_RENDERBUFFER ? ofRenderbuffer : attributes);
  }

  // A new texture, bound, with NEAREST filters.
  static GLuint newTexture(GLenum target = GL_TEXTURE_2D) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    useNearest(target);
    return name;
  }
  static std::vector<std::uint8_t> texels(const Vec4& color, int size) {
    std::vector<std::uint8_t> all;
    for (int i = 0; i < size * size; ++i) {
      for (const double component : color) all.push_back(static_cast<std::uint8_t>(component * 255 + 0.5));
    }
    return all;
  }
  // A level of one color of the bound texture; RGBA.
  static void specify(const Vec4& color, int size, GLint level = 0, GLenum target = GL_TEXTURE_2D) {
    glTexImage2D(target, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels(color, size).data());
  }
  static void replace(const Vec4& color, int size, GLint level = 0, GLenum target = GL_TEXTURE_2D) {
    glTexSubImage2D(target, level, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, texels(color, size).data());
  }
  static GLuint solid(const Vec4& color, int size = 8) {
    const GLuint name = newTexture();
    specify(color, size);
    return name;
  }
  GLuint targetOf(EGLImage image, GLenum target = GL_TEXTURE_2D) const {
    const GLuint name = newTexture(target);
    gl.EGLImageTargetTexture2DOES(target, image);
    return name;
  }
  GLuint renderbufferOf(EGLImage image) const {
    GLuint name = 0;
    gl.GenRenderbuffersOES(1, &name);
    gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, name);
    gl.EGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, image);
    return name;
  }
  // What the middle of the texture is drawn as.
  Vec4 drawn(GLuint texture, GLenum target = GL_TEXTURE_2D, double repeat = 1) const {
    glBindTexture(target, texture);
    glEnable(target);
    glColor4f(1, 1, 1, 1);
    drawTexturedRect({}, 0, 0, repeat, repeat);
    glDisable(target);
    return readPixel(width() / 2 + 1, height() / 2 + 1);
  }
  // Clears a texture's level or a renderbuffer through a framebuffer object. False: not complete.
  bool paint(const Vec4& color, GLuint name, GLenum target = GL_TEXTURE_2D, GLint level = 0) const {
    GLuint object = 0;
    gl.GenFramebuffersOES(1, &object);
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, object);
    if (target == GL_RENDERBUFFER_OES) {
      gl.FramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, target, name);
    } else {
      gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, target, name, level);
    }
    const bool complete = gl.CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES) == GL_FRAMEBUFFER_COMPLETE_OES;
    if (complete) {
      glClearColor(static_cast<GLfloat>(color[0]), static_cast<GLfloat>(color[1]),
                   static_cast<GLfloat>(color[2]), static_cast<GLfloat>(color[3]));
      glClear(GL_COLOR_BUFFER_BIT);
    }
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
    return complete;
  }

  ImageCommands gl;
};

}  // namespace conformance
