// APPLE_framebuffer_multisample: what is resolved, by whom, and framebuffers to read from and to draw to.
#include <cmath>
#include <cstring>
#include <vector>

#include "multisampled_fixture.h"

namespace conformance {
namespace {

using MultisampledResolves = MultisampledFixture;

// A renderbuffer of EXT or IMG is resolved when it is read; Apple's must be resolved by the command.
TEST_F(MultisampledResolves, Renderbuffers) {
  for (const StorageProc storage : {gl.StorageExt, gl.StorageImg}) {
    framebuffer();
    attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(storage, GL_RGBA8_OES, 32, samples_));
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    glViewport(0, 0, 32, 32);
    clearTo(kBlack);
    drawHalf(kWhite);
    expectSmoothHalf("renderbuffer");
  }
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, GL_RGBA8_OES, 32, samples_));
  clearTo(kBlack);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  std::uint8_t pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  texture(32);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 32, 32, 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST_F(MultisampledResolves, ResolveCommand) {
  const GLuint many = framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, GL_RGBA8_OES, 32, samples_));
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageApple, GL_DEPTH_COMPONENT16_OES, 32, samples_));
  glViewport(0, 0, 32, 32);
  clearTo(kBlack, GL_DEPTH_BUFFER_BIT);
  drawHalf(kWhite);
  const GLuint name = texture(32);
  const GLuint one = framebuffer();
  gl.FramebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  clearTo(kRed);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, many);
  EXPECT_EQ(get(GL_READ_FRAMEBUFFER_BINDING_APPLE), static_cast<GLint>(many));
  EXPECT_EQ(get(GL_DRAW_FRAMEBUFFER_BINDING_APPLE), static_cast<GLint>(one));
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), static_cast<GLint>(one));
  EXPECT_EQ(get(GL_SAMPLE_BUFFERS), 0);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 32, 16);
  gl.Resolve();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, one);
  EXPECT_PIXEL(4, 4, kWhite);
  EXPECT_PIXEL(28, 12, kBlack);
  EXPECT_PIXEL(4, 28, kRed);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, many);
  glDisable(GL_SCISSOR_TEST);
  gl.Resolve();
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, one);
  expectSmoothHalf("resolved");
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Into the window, right side up.
TEST_F(MultisampledResolves, ResolveIntoTheDefaultFramebuffer) {
  framebuffer(GL_READ_FRAMEBUFFER_APPLE);
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, GL_RGBA8_OES, 64, samples_),
         GL_READ_FRAMEBUFFER_APPLE);
  GLint name = get(GL_READ_FRAMEBUFFER_BINDING_APPLE);
  EXPECT_EQ(get(GL_DRAW_FRAMEBUFFER_BINDING_APPLE), 0);
  clearTo(kRed);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER_APPLE, static_cast<GLuint>(name));
  clearTo(kBlue);
  setColor(kGreen);
  drawRect({-1, -1, 0, 0});
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER_APPLE, 0);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 64, 48);
  gl.Resolve();
  glDisable(GL_SCISSOR_TEST);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, 0);
  EXPECT_PIXEL(8, 8, kGreen);
  EXPECT_PIXEL(40, 8, kBlue);
  EXPECT_PIXEL(8, 40, kBlue);
  EXPECT_PIXEL(8, 56, kRed);
}

TEST_F(MultisampledResolves, ResolveErrors) {
  const auto object = [&](GLenum format, GLsizei size, GLsizei count) {
    const GLuint made = framebuffer();
    attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, format, size, count));
    return made;
  };
  const GLuint many = object(GL_RGBA8_OES, 16, samples_), opaque = object(GL_RGB565_OES, 16, samples_);
  const GLuint one = object(GL_RGBA8_OES, 16, 0), large = object(GL_RGBA8_OES, 32, 0);
  const GLuint depthOnly = framebuffer();
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageApple, GL_DEPTH_COMPONENT16_OES, 16, samples_));
  const GLuint empty = framebuffer();
  const auto resolve = [&](GLuint read, GLuint draw) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, read);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER_APPLE, draw);
    gl.Resolve();
  };
  resolve(many, one);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (const auto& [read, draw] : std::initializer_list<std::pair<GLuint, GLuint>>{{one, large},
                                                                                   {many, many},
                                                                                   {many, large},
                                                                                   {opaque, one},
                                                                                   {depthOnly, one},
                                                                                   {many, depthOnly},
                                                                                   {many, 0}}) {
    resolve(read, draw);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION) << read << " to " << draw;
  }
  resolve(empty, one);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  resolve(many, empty);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
}

// READ_ and DRAW_FRAMEBUFFER_APPLE as targets of every command; reads come from the one, draws go to the
// other.
TEST_F(MultisampledResolves, ReadAndDrawBindings) {
  const GLuint first = framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, GL_RGBA8_OES, 16, 0));
  glViewport(0, 0, 16, 16);
  clearTo(kRed);
  const GLuint second = framebuffer();
  EXPECT_EQ(get(GL_READ_FRAMEBUFFER_BINDING_APPLE), static_cast<GLint>(second));
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, first);
  EXPECT_EQ(status(GL_READ_FRAMEBUFFER_APPLE), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  EXPECT_EQ(status(GL_DRAW_FRAMEBUFFER_APPLE), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  EXPECT_PIXEL(8, 8, kRed);
  clearTo(kGreen);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  const GLuint name = texture(16);
  gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER_APPLE, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  GLint type = 0;
  gl.GetAttachmentParameter(GL_DRAW_FRAMEBUFFER_APPLE, GL_COLOR_ATTACHMENT0_OES,
                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, &type);
  EXPECT_EQ(type, GL_TEXTURE);
  gl.GetAttachmentParameter(GL_READ_FRAMEBUFFER_APPLE, GL_COLOR_ATTACHMENT0_OES,
                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, &type);
  EXPECT_EQ(type, GL_RENDERBUFFER_OES);
  clearTo(kGreen);
  EXPECT_PIXEL(8, 8, kRed);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 16);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, second);
  EXPECT_PIXEL(4, 8, kRed);
  EXPECT_PIXEL(12, 8, kGreen);
  const GLenum color = GL_COLOR_ATTACHMENT0_OES;
  gl.DiscardFramebuffer(GL_READ_FRAMEBUFFER_APPLE, 1, &color);
  gl.DiscardFramebuffer(GL_DRAW_FRAMEBUFFER_APPLE, 1, &color);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  // Deleting unbinds it from both.
  gl.DeleteFramebuffers(1, &second);
  EXPECT_EQ(get(GL_READ_FRAMEBUFFER_BINDING_APPLE), 0);
  EXPECT_EQ(get(GL_DRAW_FRAMEBUFFER_BINDING_APPLE), 0);
  // A texture that is deleted leaves both.
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER_APPLE, first);
  gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER_APPLE, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  glDeleteTextures(1, &name);
  EXPECT_EQ(status(GL_READ_FRAMEBUFFER_APPLE), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  std::uint8_t pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  gl.BindFramebuffer(GL_RENDERBUFFER_OES, first);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

}  // namespace
}  // namespace conformance
