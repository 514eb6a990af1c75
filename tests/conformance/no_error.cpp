// KHR_no_error: contexts made with EGL_CONTEXT_OPENGL_NO_ERROR_KHR tell of no error, draw as others do, and
// live through what would be one.
#include <cstdint>
#include <limits>
#include <vector>

#include "extension_commands.h"
#include "other_context.h"

namespace conformance {
namespace {

class NoError : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    context_ = std::make_unique<OtherContext>(std::vector<EGLint>{EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE});
    if (!context_->valid() && onMesa()) GTEST_SKIP() << "Mesa has no such contexts of ES 1.1";
    ASSERT_TRUE(context_->valid());
    NEEDS_EXTENSION("GL_KHR_no_error");
  }
  void TearDown() override {
    context_.reset();
    GlTest::TearDown();
  }

 private:
  std::unique_ptr<OtherContext> context_;
};

// Every kind of error but that of memory.
TEST_F(NoError, NoneIsTold) {
  glEnable(GL_RGBA);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glLineWidth(-1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glBufferSubData(GL_ARRAY_BUFFER, 0, 4, nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glPopMatrix();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int i = 0; i < 100; ++i) glPushMatrix();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  COMMAND(PFNGLBINDFRAMEBUFFEROESPROC, BindFramebufferOES);
  COMMAND(PFNGLCHECKFRAMEBUFFERSTATUSOESPROC, CheckFramebufferStatusOES);
  BindFramebufferOES(GL_FRAMEBUFFER_OES, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  drawRect();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  // That question is no error: it is answered (issue 4).
  EXPECT_EQ(CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES),
            GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
}

// Undefined is not broken: what follows is drawn as ever.
TEST_F(NoError, MisuseDoesNoHarm) {
  const GLint most = std::numeric_limits<GLint>::max();
  std::vector<std::uint8_t> memory(4096);
  glDrawArrays(GL_TRIANGLES, -5, 100);
  glDrawArrays(12345, 0, 3);
  glDrawElements(GL_TRIANGLES, -3, GL_FLOAT, nullptr);
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr);
  glTexImage2D(GL_TEXTURE_2D, 40, GL_RGBA, most, most, 0, GL_RGBA, GL_UNSIGNED_BYTE, memory.data());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, -8, 8, 3, GL_RGB, GL_UNSIGNED_BYTE, memory.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, -100, most, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, memory.data());
  glCopyTexSubImage2D(GL_TEXTURE_2D, 3, 5, 5, -1, -1, most, most);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 64, 64, 0, 1, memory.data());
  glBufferData(GL_ARRAY_BUFFER, -1, memory.data(), GL_RGBA);
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, 16, memory.data(), GL_STATIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 8, 4096, memory.data());
  glVertexPointer(77, GL_RGBA, -4, reinterpret_cast<const void*>(std::uintptr_t{1} << 40));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory.data());
  glViewport(0, 0, -1, -1);
  glActiveTexture(GL_TEXTURE0 + 500);
  glClientActiveTexture(GL_TEXTURE0 + 500);
  glMultiTexCoord4f(GL_TEXTURE0 + 500, 1, 1, 1, 1);
  glLightf(GL_LIGHT0 + 500, GL_SPOT_EXPONENT, -1);
  glMatrixMode(GL_RGBA);
  glFrustumf(1, 1, 2, 2, -1, 0);
  GLint value = 0;
  glGetIntegerv(0xdead, &value);
  EXPECT_EQ(glGetString(0xdead), nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(0, 1, 0, 1);
  drawRect({-1, -1, 0, 1});
  EXPECT_PIXEL(8, 32, {0, 1, 0, 1});
  EXPECT_PIXEL(56, 32, {0, 0, 0, 1});
}

// EGL_KHR_create_context_no_error: neither with debug output, nor shared with contexts that check.
TEST_F(NoError, ContextsThatCannotBe) {
  const OtherContext debugging(
      {EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE, EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
  EXPECT_FALSE(debugging.valid());
  EXPECT_EQ(debugging.error(), EGL_BAD_MATCH);
}

}  // namespace
}  // namespace conformance
