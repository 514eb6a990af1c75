// EXT_sRGB, and EGL_KHR_gl_colorspace.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "extension_commands.h"

namespace conformance {
namespace {

double decoded(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double encoded(double c) {
  if (c <= 0) return 0;
  if (c >= 1) return 1;
  return c < 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}
Vec4 encoded(const Vec4& c) {
  return {encoded(c[0]), encoded(c[1]), encoded(c[2]), c[3]};
}

struct Commands {
  PFNGLGENFRAMEBUFFERSOESPROC genFramebuffers = command<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES");
  PFNGLBINDFRAMEBUFFEROESPROC bindFramebuffer = command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC attach =
      command<PFNGLFRAMEBUFFERRENDERBUFFEROESPROC>("glFramebufferRenderbufferOES");
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC attachTexture =
      command<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>("glFramebufferTexture2DOES");
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC status =
      command<PFNGLCHECKFRAMEBUFFERSTATUSOESPROC>("glCheckFramebufferStatusOES");
  PFNGLGENRENDERBUFFERSOESPROC genRenderbuffers =
      command<PFNGLGENRENDERBUFFERSOESPROC>("glGenRenderbuffersOES");
  PFNGLBINDRENDERBUFFEROESPROC bindRenderbuffer =
      command<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES");
  PFNGLRENDERBUFFERSTORAGEOESPROC storage =
      command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES");
  PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC parameter =
      command<PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC>("glGetFramebufferAttachmentParameterivOES");
  PFNGLGENERATEMIPMAPOESPROC generateMipmap = command<PFNGLGENERATEMIPMAPOESPROC>("glGenerateMipmapOES");
};

class Srgb : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_EXT_sRGB");
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_ = Commands();
  }

  static GLuint texture(GLenum format, GLsizei width, GLsizei height, const void* data) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, format, GL_UNSIGNED_BYTE,
                 data);
    return name;
  }

  // A framebuffer object with an sRGB renderbuffer.
  GLuint useRenderbuffer(GLsizei size, GLenum format = GL_SRGB8_ALPHA8_EXT) const {
    GLuint object = 0, color = 0;
    gl_.genRenderbuffers(1, &color);
    gl_.bindRenderbuffer(GL_RENDERBUFFER_OES, color);
    gl_.storage(GL_RENDERBUFFER_OES, format, size, size);
    gl_.genFramebuffers(1, &object);
    gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, object);
    gl_.attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES, color);
    glViewport(0, 0, size, size);
    return object;
  }

  static void color(const Vec4& c) {
    glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
              static_cast<GLfloat>(c[3]));
  }

  Commands gl_;
};

// Every code of a component, linear where it is sampled; alpha is left alone.
TEST_F(Srgb, TexturesAreLinear) {
  std::vector<GLubyte> texels;
  for (int i = 0; i < 256; ++i) {
    for (const int c : {i, 255 - i, i / 2, i}) texels.push_back(static_cast<GLubyte>(c));
  }
  texture(GL_SRGB_ALPHA_EXT, 16, 16, texels.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glEnable(GL_TEXTURE_2D);
  glViewport(0, 0, 16, 16);
  drawTexturedRect({}, 0, 0, 1, 1);
  const Image drawn = readImage(0, 0, 16, 16);
  for (int i = 0; i < 256; ++i) {
    const Vec4 expected = {decoded(i / 255.0), decoded(1 - i / 255.0), decoded(i / 2 / 255.0), i / 255.0};
    EXPECT_TRUE(near(drawn.at(i % 16, i / 16), expected)) << i;
  }
}

TEST_F(Srgb, OpaqueTextures) {
  const std::array<GLubyte, 3> texel = {200, 100, 50};
  texture(GL_SRGB_EXT, 1, 1, texel.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glColor4f(1, 1, 1, 0.5f);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, {decoded(200 / 255.0), decoded(100 / 255.0), decoded(50 / 255.0), 0.5});
}

// Filtering mixes linear colors.
TEST_F(Srgb, FilteringIsLinear) {
  const std::array<GLubyte, 8> texels = {0, 0, 0, 255, 255, 255, 255, 255};
  texture(GL_SRGB_ALPHA_EXT, 2, 1, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glEnable(GL_TEXTURE_2D);
  drawTexturedRect({}, 0.5, 0, 0.5, 1);
  // Encoded first, black and white would mix to 0.5 as well; grays do not.
  EXPECT_PIXEL(32, 32, {0.5, 0.5, 0.5, 1}, 2 * kOneStep);
  const std::array<GLubyte, 8> grays = {64, 64, 64, 255, 192, 192, 192, 255};
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 1, GL_SRGB_ALPHA_EXT, GL_UNSIGNED_BYTE, grays.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  drawTexturedRect({}, 0.5, 0, 0.5, 1);
  const double mean = (decoded(64 / 255.0) + decoded(192 / 255.0)) / 2;
  EXPECT_PIXEL(32, 32, {mean, mean, mean, 1}, 2 * kOneStep);
}

TEST_F(Srgb, FramebuffersAreEncoded) {
  useRenderbuffer(16);
  ASSERT_EQ(gl_.status(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  for (int i = 0; i <= 16; ++i) {
    const Vec4 c = {i / 16.0, 1 - i / 16.0, i / 64.0, i / 16.0};
    color(c);
    drawRect();
    EXPECT_TRUE(near(readImage(8, 8, 1, 1).at(0, 0), encoded(c))) << i;
    glClearColor(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
                 static_cast<GLfloat>(c[3]));
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_TRUE(near(readImage(8, 8, 1, 1).at(0, 0), encoded(c))) << "clear " << i;
  }
  gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// Section 4.1.6: the destination is decoded, blended and encoded again.
TEST_F(Srgb, BlendingIsLinear) {
  useRenderbuffer(16);
  const Vec4 below = {0.2, 0.5, 0.05, 0.6}, above = {0.9, 0.1, 0.4, 0.5};
  color(below);
  drawRect();
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  color(above);
  drawRect();
  Vec4 mixed{};
  for (std::size_t i = 0; i < 4; ++i) mixed[i] = above[i] * above[3] + below[i] * (1 - above[3]);
  EXPECT_TRUE(near(readImage(8, 8, 1, 1).at(0, 0), encoded(mixed), 2 * kOneStep));
  gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// Decoded by the texture and encoded by the framebuffer, every code comes back.
TEST_F(Srgb, CodesSurviveTheWayThroughLinearColors) {
  std::vector<GLubyte> texels;
  for (int i = 0; i < 256; ++i) {
    for (const int c : {i, 255 - i, i * 7 % 256, i}) texels.push_back(static_cast<GLubyte>(c));
  }
  texture(GL_SRGB_ALPHA_EXT, 16, 16, texels.data());
  useRenderbuffer(16);
  glEnable(GL_TEXTURE_2D);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_EQ(readImage(0, 0, 16, 16).rgba, texels);
  gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// Drawn to and then sampled: the linear color comes back.
TEST_F(Srgb, RenderedTextures) {
  for (const GLenum format : {GLenum{GL_SRGB_ALPHA_EXT}, GLenum{GL_SRGB_EXT}}) {
    const GLuint name = texture(format, 16, 16, nullptr);
    GLuint object = 0;
    gl_.genFramebuffers(1, &object);
    gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, object);
    gl_.attachTexture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
    ASSERT_EQ(gl_.status(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    glViewport(0, 0, 16, 16);
    glDisable(GL_TEXTURE_2D);
    color({0.3, 0.6, 0.1, 0.7});
    drawRect();
    gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
    glEnable(GL_TEXTURE_2D);
    glViewport(0, 0, width(), height());
    color({1, 1, 1, 0});
    drawTexturedRect({}, 0, 0, 1, 1);
    EXPECT_PIXEL(32, 32, {0.3, 0.6, 0.1, format == GL_SRGB_EXT ? 0 : 0.7}, 1.5 * kOneStep);
  }
}

// Copies move what is stored.
TEST_F(Srgb, CopiesAreRaw) {
  useRenderbuffer(16);
  const Vec4 c = {0.25, 0.5, 0.75, 0.5};
  color(c);
  drawRect();
  GLuint plain = 0;
  glGenTextures(1, &plain);
  glBindTexture(GL_TEXTURE_2D, plain);
  useNearest();
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 16, 16, 0);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const GLuint same = texture(GL_SRGB_ALPHA_EXT, 16, 16, nullptr);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 16, 16);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
  glEnable(GL_TEXTURE_2D);
  glViewport(0, 0, width(), height());
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, c, 1.5 * kOneStep);
  glBindTexture(GL_TEXTURE_2D, plain);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, encoded(c), 1.5 * kOneStep);
  glDeleteTextures(1, &same);
}

TEST_F(Srgb, ColorEncodingQuery) {
  const auto encoding = [&](GLenum point) {
    GLint value = -1;
    gl_.parameter(GL_FRAMEBUFFER_OES, point, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT, &value);
    return static_cast<GLenum>(value);
  };
  useRenderbuffer(8);
  EXPECT_EQ(encoding(GL_COLOR_ATTACHMENT0_OES), GLenum{GL_SRGB_EXT});
  encoding(GL_DEPTH_ATTACHMENT_OES);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);  // nothing is attached there
  useRenderbuffer(8, GL_RGBA8_OES);
  EXPECT_EQ(encoding(GL_COLOR_ATTACHMENT0_OES), GLenum{GL_LINEAR});
  for (const auto& [format, expected] : {std::pair<GLenum, GLenum>{GL_SRGB_EXT, GL_SRGB_EXT},
                                         std::pair<GLenum, GLenum>{GL_SRGB_ALPHA_EXT, GL_SRGB_EXT},
                                         std::pair<GLenum, GLenum>{GL_RGBA, GL_LINEAR}}) {
    const GLuint name = texture(format, 8, 8, nullptr);
    gl_.attachTexture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
    EXPECT_EQ(encoding(GL_COLOR_ATTACHMENT0_OES), expected);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl_.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// Section 3.7.11: no mipmaps are generated for sRGB textures.
TEST_F(Srgb, NoMipmapGeneration) {
  const std::vector<GLubyte> white(8 * 8 * 4, 255);
  glEnable(GL_TEXTURE_2D);
  for (const GLenum format : {GLenum{GL_SRGB_ALPHA_EXT}, GLenum{GL_SRGB_EXT}}) {
    texture(format, 8, 8, white.data());
    gl_.generateMipmap(GL_TEXTURE_2D);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    if (onMesa()) continue;
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 8, 8, 0, format, GL_UNSIGNED_BYTE,
                 white.data());
    EXPECT_GL_ERROR(GL_NO_ERROR);
    glColor4f(0, 1, 0, 1);
    drawTexturedRect({}, 0, 0, 1, 1);
    EXPECT_PIXEL(32, 32, {0, 1, 0, 1});  // incomplete
  }
}

TEST_F(Srgb, Errors) {
  const std::vector<GLubyte> data(64);
  texture(GL_SRGB_EXT, 2, 2, data.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const auto fails = [&](GLenum error, GLenum internal, GLenum format, GLenum type) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), 2, 2, 0, format, type, data.data());
    EXPECT_GL_ERROR(error) << internal << " " << format << " " << type;
  };
  fails(GL_INVALID_OPERATION, GL_SRGB_EXT, GL_RGB, GL_UNSIGNED_BYTE);
  fails(GL_INVALID_OPERATION, GL_RGB, GL_SRGB_EXT, GL_UNSIGNED_BYTE);
  fails(GL_INVALID_OPERATION, GL_SRGB_ALPHA_EXT, GL_SRGB_EXT, GL_UNSIGNED_BYTE);
  fails(GL_INVALID_OPERATION, GL_SRGB_EXT, GL_SRGB_EXT, GL_UNSIGNED_SHORT_5_6_5);
  fails(GL_INVALID_VALUE, GL_SRGB8_ALPHA8_EXT, GL_SRGB_ALPHA_EXT, GL_UNSIGNED_BYTE);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, data.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB_EXT, 0, 0, 2, 2, 0);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// EGL_KHR_gl_colorspace: a pbuffer that is drawn to in sRGB.
class SrgbSurface : public testing::TestWithParam<int> {};

TEST_P(SrgbSurface, IsEncoded) {
  const char* extensions = eglQueryString(display(), EGL_EXTENSIONS);
  if (onMesa()) GTEST_SKIP() << "Mesa's ES 1.1 contexts do not encode";
  ASSERT_NE(std::string_view(extensions).find("EGL_KHR_gl_colorspace"), std::string_view::npos);
  const int samples = GetParam();
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_SAMPLE_BUFFERS,
                           samples > 0,
                           EGL_SAMPLES,
                           samples,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(eglChooseConfig(display(), wanted, &config, 1, &count));
  if (count == 0) GTEST_SKIP() << "no such config";
  const EGLContext context = eglCreateContext(display(), config, EGL_NO_CONTEXT, nullptr);
  for (const bool srgb : {true, false}) {
    const EGLint attributes[] = {EGL_WIDTH,
                                 16,
                                 EGL_HEIGHT,
                                 16,
                                 EGL_GL_COLORSPACE_KHR,
                                 srgb ? EGL_GL_COLORSPACE_SRGB_KHR : EGL_GL_COLORSPACE_LINEAR_KHR,
                                 EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display(), config, attributes);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    EGLint value = 0;
    EXPECT_TRUE(eglQuerySurface(display(), surface, EGL_GL_COLORSPACE_KHR, &value));
    EXPECT_EQ(value, srgb ? EGL_GL_COLORSPACE_SRGB_KHR : EGL_GL_COLORSPACE_LINEAR_KHR);
    ASSERT_TRUE(eglMakeCurrent(display(), surface, surface, context));
    const Vec4 c = {0.2, 0.5, 0.8, 0.4};
    glColor4f(0.2f, 0.5f, 0.8f, 0.4f);
    drawRect();
    EXPECT_TRUE(near(readImage(8, 8, 1, 1).at(0, 0), srgb ? encoded(c) : c));
    GLint bits = 0;
    glGetIntegerv(GL_ALPHA_BITS, &bits);
    EXPECT_EQ(bits, 8);
    GLint format = 0, type = 0;
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES, &format);
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE_OES, &type);
    GLubyte pixel[4] = {};
    glReadPixels(8, 8, 1, 1, static_cast<GLenum>(format), static_cast<GLenum>(type), pixel);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_TRUE(eglDestroySurface(display(), surface));
  }
  const EGLint wrong[] = {EGL_GL_COLORSPACE_KHR, EGL_NONE, EGL_NONE};
  EXPECT_EQ(eglCreatePbufferSurface(display(), config, wrong), EGL_NO_SURFACE);
  EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
  EXPECT_TRUE(eglDestroyContext(display(), context));
}

INSTANTIATE_TEST_SUITE_P(SrgbOnSurfaces, SrgbSurface, testing::Values(0, 4));

}  // namespace
}  // namespace conformance
