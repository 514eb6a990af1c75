// EXT_multisampled_render_to_texture, IMG_multisampled_render_to_texture, and what APPLE_framebuffer_multisample has in
// common with them.
#include <cmath>
#include <cstring>
#include <vector>

#include "multisampled_fixture.h"

namespace conformance {
namespace {

using MultisampledTargets = MultisampledFixture;

TEST_F(MultisampledTargets, Limits) {
  EXPECT_EQ(get(GL_MAX_SAMPLES_APPLE), samples_);
  EXPECT_EQ(get(GL_MAX_SAMPLES_IMG), samples_);
  GLfloat real = 0;
  glGetFloatv(GL_MAX_SAMPLES_EXT, &real);
  EXPECT_EQ(real, static_cast<GLfloat>(samples_));
  GLfixed fixed = 0;
  glGetFixedv(GL_MAX_SAMPLES_EXT, &fixed);
  EXPECT_EQ(fixed, samples_ * 65536);
  GLboolean truth = GL_FALSE;
  glGetBooleanv(GL_MAX_SAMPLES_EXT, &truth);
  EXPECT_EQ(truth, GL_TRUE);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// The count is at least what was asked for; 0 is 0; the plain command makes it 0 again.
TEST_F(MultisampledTargets, RenderbufferSamples) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER_OES, name);
  const auto count = [] {
    GLint value[2] = {-1, -1};
    gl.GetRenderbufferParameter(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_SAMPLES_EXT, &value[0]);
    gl.GetRenderbufferParameter(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_SAMPLES_IMG, &value[1]);
    EXPECT_EQ(value[0], value[1]);
    return value[0];
  };
  EXPECT_EQ(count(), 0);
  for (const StorageProc storage : {gl.StorageApple, gl.StorageExt, gl.StorageImg}) {
    for (GLsizei asked = 0; asked <= samples_; ++asked) {
      storage(GL_RENDERBUFFER_OES, asked, GL_RGBA8_OES, 16, 8);
      EXPECT_GE(count(), asked);
      EXPECT_LE(count(), asked == 0 ? 0 : samples_);
      GLint size = 0;
      gl.GetRenderbufferParameter(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_WIDTH_OES, &size);
      EXPECT_EQ(size, 16);
      gl.GetRenderbufferParameter(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_HEIGHT_OES, &size);
      EXPECT_EQ(size, 8);
    }
    EXPECT_GT(count(), 0);
    command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES")(GL_RENDERBUFFER_OES, GL_RGBA8_OES,
                                                                         16, 8);
    EXPECT_EQ(count(), 0);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(MultisampledTargets, StorageErrors) {
  const GLint size = get(GL_MAX_RENDERBUFFER_SIZE_OES);
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  for (const StorageProc storage : {gl.StorageApple, gl.StorageExt, gl.StorageImg}) {
    gl.BindRenderbuffer(GL_RENDERBUFFER_OES, 0);
    storage(GL_RENDERBUFFER_OES, samples_, GL_RGBA8_OES, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    gl.BindRenderbuffer(GL_RENDERBUFFER_OES, name);
    storage(GL_TEXTURE_2D, samples_, GL_RGBA8_OES, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    storage(GL_RENDERBUFFER_OES, samples_, GL_RGBA, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    storage(GL_RENDERBUFFER_OES, samples_ + 1, GL_RGBA8_OES, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    storage(GL_RENDERBUFFER_OES, -1, GL_RGBA8_OES, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    storage(GL_RENDERBUFFER_OES, samples_, GL_RGBA8_OES, size + 1, 4);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    storage(GL_RENDERBUFFER_OES, samples_, GL_RGBA8_OES, 4, -1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
}

TEST_F(MultisampledTargets, AttachErrorsAndQueries) {
  const GLuint name = texture(16);
  const GLuint object = framebuffer();
  const struct {
    AttachProc attach;
    GLenum query;
  } rows[] = {{gl.AttachExt, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT},
              {gl.AttachImg, GL_TEXTURE_SAMPLES_IMG}};
  for (const auto& row : rows) {
    gl.BindFramebuffer(GL_FRAMEBUFFER_OES, object);
    const auto tryWith = [&](GLenum target, GLenum point, GLenum image, GLuint texture, GLint level,
                             GLsizei count) { row.attach(target, point, image, texture, level, count); };
    const GLenum color = GL_COLOR_ATTACHMENT0_OES;
    tryWith(GL_TEXTURE_2D, color, GL_TEXTURE_2D, name, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    tryWith(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_TEXTURE_2D, name, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_CUBE_MAP_OES, name, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, samples_ + 1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, -1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, -1, samples_);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, 77777, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, name, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);

    GLint value = -1;
    const auto query = [&] {
      gl.GetAttachmentParameter(GL_FRAMEBUFFER_OES, color, row.query, &value);
      return value;
    };
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, 0);
    EXPECT_EQ(query(), 0);
    EXPECT_EQ(get(GL_SAMPLE_BUFFERS), 0);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, 1);
    EXPECT_GE(query(), 1);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, samples_);
    EXPECT_EQ(query(), samples_);
    EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    EXPECT_EQ(get(GL_SAMPLE_BUFFERS), 1);
    EXPECT_EQ(get(GL_SAMPLES), samples_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0);
    EXPECT_EQ(query(), 0);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    attach(color, renderbuffer(gl.StorageExt, GL_RGBA8_OES, 16, 0));
    query();
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    gl.BindFramebuffer(GL_FRAMEBUFFER_OES, 0);
    tryWith(GL_FRAMEBUFFER_OES, color, GL_TEXTURE_2D, name, 0, samples_);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  }
  gl.AttachImg(GL_DRAW_FRAMEBUFFER_APPLE, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0, samples_);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// All attachments have the same number of samples.
TEST_F(MultisampledTargets, Completeness) {
  const GLuint name = texture(16);
  sampled(gl.AttachExt, name, 16);
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageExt, GL_DEPTH_COMPONENT16_OES, 16, 0));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT});
  EXPECT_GL_ERROR(GL_NO_ERROR);
  clearTo(kRed);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageExt, GL_DEPTH_COMPONENT16_OES, 16, samples_));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  gl.FramebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT});
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(gl.StorageImg, GL_DEPTH_COMPONENT16_OES, 16, samples_));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_IMG});
  gl.AttachImg(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0, samples_);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(gl.StorageApple, GL_RGBA8_OES, 16, samples_));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  EXPECT_EQ(get(GL_SAMPLES), samples_);
}

// The picture is resolved when it is read and when it is sampled, also where the pass was interrupted
// between.
TEST_F(MultisampledTargets, TextureIsResolvedImplicitly) {
  for (const AttachProc attachTexture : {gl.AttachExt, gl.AttachImg}) {
    const GLuint name = texture(32);
    sampled(attachTexture, name, 32);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo(kBlack);
    EXPECT_PIXEL(16, 16, kBlack);
    drawHalf(kWhite);
    expectSmoothHalf("read");
    showTexture();
    const double edge = readPixel(32, 31)[0];
    EXPECT_GT(edge, 0.2);
    EXPECT_LT(edge, 0.8);
    EXPECT_PIXEL(8, 8, kWhite);
    EXPECT_PIXEL(56, 56, kBlack);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// A clear alone arrives in the texture, whole, scissored and masked; so does one after a draw.
TEST_F(MultisampledTargets, ClearsArriveInTheTexture) {
  const GLuint name = texture(32);
  const GLuint object = sampled(gl.AttachExt, name, 32);
  clearTo(kRed);
  showTexture();
  EXPECT_PIXEL(32, 32, kRed);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, object);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 16, 32);
  clearTo(kBlue);
  glDisable(GL_SCISSOR_TEST);
  showTexture();
  EXPECT_PIXEL(8, 32, kBlue);
  EXPECT_PIXEL(56, 32, kRed);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, object);
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  clearTo(kGreen);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  EXPECT_PIXEL(4, 16, {0, 1, 1, 1});
  EXPECT_PIXEL(28, 16, {1, 1, 0, 1});
  drawHalf(kWhite);
  clearTo(kGreen);
  showTexture();
  EXPECT_PIXEL(32, 32, kGreen);
}

// What the texture held before is there when drawing with samples begins, and what others write in between is
// seen: "as if all samples within a pixel have the value most recently written".
TEST_F(MultisampledTargets, SamplesStartWithTheTexture) {
  const GLuint name = texture(32);
  std::vector<std::uint8_t> texels(32 * 32 * 4);
  for (int i = 0; i < 32 * 32; ++i) {
    texels[i * 4] = static_cast<std::uint8_t>(i % 32 * 8);
    texels[i * 4 + 1] = static_cast<std::uint8_t>(i / 32 * 8);
    texels[i * 4 + 3] = 255;
  }
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLuint object = sampled(gl.AttachExt, name, 32);
  drawHalf(kBlue);
  EXPECT_PIXEL(4, 4, kBlue);
  EXPECT_PIXEL(28, 20, {28 * 8 / 255.0, 20 * 8 / 255.0, 0, 1});
  const std::vector<std::uint8_t> red(8 * 8 * 4, 0xff);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 24, 24, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
  drawRect({-1, -1, -0.75, -0.75});
  EXPECT_PIXEL(28, 28, kWhite);
  EXPECT_PIXEL(4, 20, kBlue);
  EXPECT_PIXEL(20, 28, {20 * 8 / 255.0, 28 * 8 / 255.0, 0, 1});
  // Without samples, and with them again.
  gl.FramebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  setColor(kGreen);
  drawRect({0, 0, 1, 1});
  gl.AttachExt(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0, samples_);
  setColor(kRed);
  drawRect({0.5, 0.5, 1, 1});
  EXPECT_PIXEL(20, 20, kGreen);
  EXPECT_PIXEL(28, 28, kRed);
  EXPECT_PIXEL(4, 4, kBlue);
  gl.DeleteFramebuffers(1, &object);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Depth is kept for each sample while passes come and go.
TEST_F(MultisampledTargets, DepthWithInterruptions) {
  const GLuint name = texture(32), other = texture(8);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLuint object = sampled(gl.AttachExt, name, 32, true);
  ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  glEnable(GL_DEPTH_TEST);
  clearTo(kBlack, GL_DEPTH_BUFFER_BIT);
  drawHalf(kGreen, -0.5f);
  EXPECT_PIXEL(4, 4, kGreen);
  glFlush();
  // Another target in between.
  const GLuint aside = framebuffer();
  gl.FramebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, other, 0);
  clearTo(kRed);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, object);
  setColor(kRed);
  drawRect({-1, -1, 1, 1, 0.5});
  EXPECT_PIXEL(4, 4, kGreen);
  EXPECT_PIXEL(28, 28, kRed);
  const Vec4 edge = readPixel(15, 16);
  EXPECT_NEAR(edge[0] + edge[1], 1, 2.0 / 255);
  EXPECT_GT(edge[0], 0.2);
  EXPECT_GT(edge[1], 0.2);
  glDisable(GL_DEPTH_TEST);
  gl.DeleteFramebuffers(1, &aside);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Mipmaps from, and copies of, a texture that is drawn to with samples.
TEST_F(MultisampledTargets, MipmapsAndCopies) {
  const GLuint name = texture(32);
  sampled(gl.AttachExt, name, 32);
  clearTo(kBlack);
  drawHalf(kWhite);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, 0);
  glViewport(0, 0, 8, 8);
  glEnable(GL_TEXTURE_2D);
  setColor(kWhite);
  drawTexturedRect({}, 0, 0, 1, 1);
  glDisable(GL_TEXTURE_2D);
  EXPECT_PIXEL(1, 1, kWhite);
  EXPECT_PIXEL(6, 6, kBlack);
  // Level 2: a texel of the diagonal is the mean of 4x4, half of them white.
  EXPECT_PIXEL(3, 4, {0.5, 0.5, 0.5, 1}, 0.05);

  const GLuint again = sampled(gl.AttachExt, name, 32);
  const GLuint copy = texture(32);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 32, 32, 0);
  useNearest();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  showTexture();
  EXPECT_PIXEL(8, 8, kWhite);
  EXPECT_PIXEL(56, 56, kBlack);
  gl.BindFramebuffer(GL_FRAMEBUFFER_OES, again);
  glViewport(0, 0, 32, 32);
  clearTo(kRed);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 16, 0, 0, 0, 16, 32);
  showTexture();
  EXPECT_PIXEL(8, 8, kWhite);
  EXPECT_PIXEL(56, 8, kRed);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glDeleteTextures(1, &copy);
}

// Every color format, faces of cube maps and smaller levels can be drawn to so.
TEST_F(MultisampledTargets, FormatsFacesAndLevels) {
  const struct {
    GLenum format, type;
    double step;
  } rows[] = {{GL_RGBA, GL_UNSIGNED_BYTE, kOneStep},
              {GL_RGB, GL_UNSIGNED_BYTE, kOneStep},
              {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 1 / 31.0},
              {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 1 / 31.0}};
  for (const auto& row : rows) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(row.format), 32, 32, 0, row.format, row.type, nullptr);
    useNearest();
    sampled(gl.AttachExt, name, 32);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo(kBlack);
    drawHalf(kWhite);
    expectSmoothHalf("format");
    setColor({0.25, 0.5, 0.75, 1});
    drawRect();
    EXPECT_PIXEL(16, 16, {0.25, 0.5, 0.75, 1}, row.step);
  }
  GLuint cube = 0;
  glGenTextures(1, &cube);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, cube);
  for (GLenum face = 0; face < 6; ++face)
    for (GLint level = 0; level < 2; ++level)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, level, GL_RGBA, 64 >> level, 64 >> level, 0,
                   GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  framebuffer();
  glViewport(0, 0, 32, 32);
  for (GLenum face = 0; face < 6; ++face) {
    gl.AttachExt(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face,
                 cube, 1, samples_);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo(kBlack);
    drawHalf(kWhite);
    expectSmoothHalf("face");
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Attachments come and go, also while their samples are in use; nothing is left bound to what is gone.
TEST_F(MultisampledTargets, AttachmentsThatGo) {
  const GLuint object = framebuffer();
  glViewport(0, 0, 32, 32);
  for (int round = 0; round < 6; ++round) {
    const GLuint name = texture(round % 2 ? 32 : 16);
    gl.AttachExt(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0, samples_);
    clearTo(kRed);
    drawHalf(kWhite);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo(kBlack);
    drawHalf(kWhite);
    expectSmoothHalf("respecified");
    glDeleteTextures(1, &name);
    EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  }
  gl.DeleteFramebuffers(1, &object);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
