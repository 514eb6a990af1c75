// What the cases of multisampled framebuffer objects stand on.
#pragma once

#include "extension_commands.h"

namespace conformance {

inline constexpr Vec4 kBlack = {0, 0, 0, 1}, kBlue = {0, 0, 1, 1}, kGreen = {0, 1, 0, 1}, kRed = {1, 0, 0, 1},
                      kWhite = {1, 1, 1, 1};

using StorageProc = PFNGLRENDERBUFFERSTORAGEMULTISAMPLEEXTPROC;
using AttachProc = PFNGLFRAMEBUFFERTEXTURE2DMULTISAMPLEEXTPROC;

class MultisampledFixture : public GlTest {
 protected:
  // Loaded by SetUp.
  struct Commands {
    PFNGLBINDFRAMEBUFFEROESPROC BindFramebuffer;
    PFNGLBINDRENDERBUFFEROESPROC BindRenderbuffer;
    PFNGLCHECKFRAMEBUFFERSTATUSOESPROC CheckFramebufferStatus;
    PFNGLDELETEFRAMEBUFFERSOESPROC DeleteFramebuffers;
    PFNGLFRAMEBUFFERRENDERBUFFEROESPROC FramebufferRenderbuffer;
    PFNGLFRAMEBUFFERTEXTURE2DOESPROC FramebufferTexture2D;
    PFNGLGENFRAMEBUFFERSOESPROC GenFramebuffers;
    PFNGLGENRENDERBUFFERSOESPROC GenRenderbuffers;
    PFNGLGENERATEMIPMAPOESPROC GenerateMipmap;
    PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC GetAttachmentParameter;
    PFNGLGETRENDERBUFFERPARAMETERIVOESPROC GetRenderbufferParameter;
    PFNGLDISCARDFRAMEBUFFEREXTPROC DiscardFramebuffer;
    StorageProc StorageApple, StorageExt, StorageImg;
    AttachProc AttachExt, AttachImg;
    PFNGLRESOLVEMULTISAMPLEFRAMEBUFFERAPPLEPROC Resolve;
  };
  static inline Commands gl;

  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_APPLE_framebuffer_multisample");
    NEEDS_EXTENSION("GL_EXT_multisampled_render_to_texture");
    NEEDS_EXTENSION("GL_IMG_multisampled_render_to_texture");
    load(gl.BindFramebuffer, "glBindFramebufferOES");
    load(gl.BindRenderbuffer, "glBindRenderbufferOES");
    load(gl.CheckFramebufferStatus, "glCheckFramebufferStatusOES");
    load(gl.DeleteFramebuffers, "glDeleteFramebuffersOES");
    load(gl.FramebufferRenderbuffer, "glFramebufferRenderbufferOES");
    load(gl.FramebufferTexture2D, "glFramebufferTexture2DOES");
    load(gl.GenFramebuffers, "glGenFramebuffersOES");
    load(gl.GenRenderbuffers, "glGenRenderbuffersOES");
    load(gl.GenerateMipmap, "glGenerateMipmapOES");
    load(gl.GetAttachmentParameter, "glGetFramebufferAttachmentParameterivOES");
    load(gl.GetRenderbufferParameter, "glGetRenderbufferParameterivOES");
    load(gl.DiscardFramebuffer, "glDiscardFramebufferEXT");
    load(gl.StorageApple, "glRenderbufferStorageMultisampleAPPLE");
    load(gl.StorageExt, "glRenderbufferStorageMultisampleEXT");
    load(gl.StorageImg, "glRenderbufferStorageMultisampleIMG");
    load(gl.AttachExt, "glFramebufferTexture2DMultisampleEXT");
    load(gl.AttachImg, "glFramebufferTexture2DMultisampleIMG");
    load(gl.Resolve, "glResolveMultisampleFramebufferAPPLE");
    samples_ = get(GL_MAX_SAMPLES_EXT);
    ASSERT_GE(samples_, 2);
  }

  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  static GLuint texture(GLint size, GLenum format = GL_RGBA) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size, size, 0, format, GL_UNSIGNED_BYTE,
                 nullptr);
    useNearest();
    return name;
  }
  GLuint renderbuffer(StorageProc storage, GLenum format, GLsizei size, GLsizei samples) const {
    GLuint name = 0;
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER_OES, name);
    storage(GL_RENDERBUFFER_OES, samples, format, size, size);
    return name;
  }
  static GLuint framebuffer(GLenum target = GL_FRAMEBUFFER_OES) {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(target, name);
    return name;
  }
  static void attach(GLenum point, GLuint name, GLenum target = GL_FRAMEBUFFER_OES) {
    gl.FramebufferRenderbuffer(target, point, GL_RENDERBUFFER_OES, name);
  }
  // A framebuffer object that draws to `texture` with samples, and, if asked, with depth.
  GLuint sampled(AttachProc attachTexture, GLuint texture, GLsizei size, bool depth = false) const {
    const GLuint object = framebuffer();
    attachTexture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture, 0, samples_);
    if (depth)
      attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageExt, GL_DEPTH_COMPONENT16_OES, size, samples_));
    glViewport(0, 0, size, size);
    return object;
  }
  static GLenum status(GLenum target = GL_FRAMEBUFFER_OES) { return gl.CheckFramebufferStatus(target); }

  static void clearTo(const Vec4& c, GLbitfield more = 0) {
    glClearColor(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
                 static_cast<GLfloat>(c[3]));
    glClear(GL_COLOR_BUFFER_BIT | more);
  }
  static void setColor(const Vec4& c) {
    glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
              static_cast<GLfloat>(c[3]));
  }
  // The half of the target under the diagonal from the upper left to the lower right, at depth z.
  static void drawHalf(const Vec4& color, GLfloat z = 0) {
    setColor(color);
    const GLfloat triangle[] = {-1, -1, z, 1, -1, z, -1, 1, z};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, triangle);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisableClientState(GL_VERTEX_ARRAY);
  }
  // The window filled with the bound texture.
  void showTexture() const {
    gl.BindFramebuffer(GL_FRAMEBUFFER_OES, 0);
    glViewport(0, 0, width(), height());
    glEnable(GL_TEXTURE_2D);
    setColor(kWhite);
    drawTexturedRect({}, 0, 0, 1, 1);
    glDisable(GL_TEXTURE_2D);
  }
  // An edge of white on black: inside white, outside black, on the diagonal in between.
  void expectSmoothHalf(const char* where) const {
    SCOPED_TRACE(where);
    EXPECT_PIXEL(4, 4, kWhite);
    EXPECT_PIXEL(28, 28, kBlack);
    for (int i = 1; i < 31; ++i) {
      const double edge = readPixel(i, 31 - i)[0];
      ASSERT_GT(edge, 0.2) << i;
      ASSERT_LT(edge, 0.8) << i;
    }
  }

  GLint samples_ = 0;
};

}  // namespace conformance
