// OES_framebuffer_object, OES_fbo_render_mipmap, OES_rgb8_rgba8, OES_depth24, OES_stencil8,
// OES_packed_depth_stencil, EXT_discard_framebuffer.
#include <fmt/format.h>

#include "extension_commands.h"

namespace conformance {
namespace {

constexpr Vec4 kBlue = {0, 0, 1, 1}, kGreen = {0, 1, 0, 1}, kRed = {1, 0, 0, 1};

// Loaded by SetUp.
struct Commands {
  PFNGLBINDFRAMEBUFFEROESPROC BindFramebufferOES = nullptr;
  PFNGLBINDRENDERBUFFEROESPROC BindRenderbufferOES = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC CheckFramebufferStatusOES = nullptr;
  PFNGLDELETEFRAMEBUFFERSOESPROC DeleteFramebuffersOES = nullptr;
  PFNGLDELETERENDERBUFFERSOESPROC DeleteRenderbuffersOES = nullptr;
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC FramebufferRenderbufferOES = nullptr;
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC FramebufferTexture2DOES = nullptr;
  PFNGLGENFRAMEBUFFERSOESPROC GenFramebuffersOES = nullptr;
  PFNGLGENRENDERBUFFERSOESPROC GenRenderbuffersOES = nullptr;
  PFNGLGENERATEMIPMAPOESPROC GenerateMipmapOES = nullptr;
  PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC GetFramebufferAttachmentParameterivOES = nullptr;
  PFNGLGETRENDERBUFFERPARAMETERIVOESPROC GetRenderbufferParameterivOES = nullptr;
  PFNGLISFRAMEBUFFEROESPROC IsFramebufferOES = nullptr;
  PFNGLISRENDERBUFFEROESPROC IsRenderbufferOES = nullptr;
  PFNGLRENDERBUFFERSTORAGEOESPROC RenderbufferStorageOES = nullptr;
} gl;

void loadCommands() {
  load(gl.BindFramebufferOES, "glBindFramebufferOES");
  load(gl.BindRenderbufferOES, "glBindRenderbufferOES");
  load(gl.CheckFramebufferStatusOES, "glCheckFramebufferStatusOES");
  load(gl.DeleteFramebuffersOES, "glDeleteFramebuffersOES");
  load(gl.DeleteRenderbuffersOES, "glDeleteRenderbuffersOES");
  load(gl.FramebufferRenderbufferOES, "glFramebufferRenderbufferOES");
  load(gl.FramebufferTexture2DOES, "glFramebufferTexture2DOES");
  load(gl.GenFramebuffersOES, "glGenFramebuffersOES");
  load(gl.GenRenderbuffersOES, "glGenRenderbuffersOES");
  load(gl.GenerateMipmapOES, "glGenerateMipmapOES");
  load(gl.GetFramebufferAttachmentParameterivOES, "glGetFramebufferAttachmentParameterivOES");
  load(gl.GetRenderbufferParameterivOES, "glGetRenderbufferParameterivOES");
  load(gl.IsFramebufferOES, "glIsFramebufferOES");
  load(gl.IsRenderbufferOES, "glIsRenderbufferOES");
  load(gl.RenderbufferStorageOES, "glRenderbufferStorageOES");
}

class FramebufferObjects : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_OES_framebuffer_object");
    loadCommands();
  }
};

GLint get(GLenum name) {
  GLint value = -1;
  glGetIntegerv(name, &value);
  return value;
}

GLuint texture(GLint size, GLenum format = GL_RGBA, GLenum type = GL_UNSIGNED_BYTE) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size, size, 0, format, type, nullptr);
  useNearest();
  return name;
}

GLuint renderbuffer(GLenum format, GLsizei width, GLsizei height) {
  GLuint name = 0;
  gl.GenRenderbuffersOES(1, &name);
  gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, name);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, format, width, height);
  return name;
}

GLuint framebuffer() {
  GLuint name = 0;
  gl.GenFramebuffersOES(1, &name);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, name);
  return name;
}

void attach(GLenum point, GLuint name) {
  gl.FramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, point, GL_RENDERBUFFER_OES, name);
}
void attachTexture(GLuint name, GLint level = 0, GLenum target = GL_TEXTURE_2D) {
  gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, target, name, level);
}

GLenum status() {
  return gl.CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES);
}

void clearTo(const Vec4& c) {
  glClearColor(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
               static_cast<GLfloat>(c[3]));
  glClear(GL_COLOR_BUFFER_BIT);
}

void drawIn(const Vec4& c, const Rect& rect) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
  drawRect(rect);
}

// Its lower left quarter is red, the rest blue: right side up when it is drawn with it and read back.
TEST_F(FramebufferObjects, RenderToTextureAndSampleIt) {
  const GLuint target = texture(32);
  const GLuint object = framebuffer();
  attachTexture(target);
  ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  glViewport(0, 0, 32, 32);
  for (int round = 0; round < 3; ++round) {
    const Vec4 corner = round == 1 ? kGreen : kRed;
    clearTo(kBlue);
    drawIn(corner, {-1, -1, 0, 0});
    EXPECT_PIXEL(4, 4, corner);
    EXPECT_PIXEL(4, 28, kBlue);
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
    glViewport(0, 0, 64, 64);
    glEnable(GL_TEXTURE_2D);
    glColor4f(1, 1, 1, 1);
    drawTexturedRect({}, 0, 0, 1, 1);
    glDisable(GL_TEXTURE_2D);
    EXPECT_PIXEL(8, 8, corner);
    EXPECT_PIXEL(8, 56, kBlue);
    EXPECT_PIXEL(56, 8, kBlue);
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, object);
    glViewport(0, 0, 32, 32);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// OES_framebuffer_object 4.4.4: depth alone is complete. Draws without DEPTH_TEST leave it as it is; draws with it are
// tested and written.
TEST_F(FramebufferObjects, OfDepthAlone) {
  const GLuint target = texture(16);
  framebuffer();
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(GL_DEPTH_COMPONENT16_OES, 16, 16));
  if (status() != GL_FRAMEBUFFER_COMPLETE_OES) GTEST_SKIP() << "depth alone cannot be drawn to here";
  glViewport(0, 0, 16, 16);
  drawIn(kRed, {});  // before anything else is known of the image
  glClearDepthf(0.5f);
  glClear(GL_DEPTH_BUFFER_BIT);
  glFinish();
  drawIn(kRed, {});
  glFinish();
  glEnable(GL_DEPTH_TEST);
  glPushMatrix();
  glTranslatef(0, 0, -0.5f);  // nearer: a depth of 0.25
  drawIn(kRed, {-1, -1, 0, 1});
  glPopMatrix();
  attachTexture(target);
  clearTo(kBlue);
  glPushMatrix();
  glTranslatef(0, 0, -0.25f);  // between the two
  drawIn(kGreen, {});
  glPopMatrix();
  EXPECT_PIXEL(4, 8, kBlue);
  EXPECT_PIXEL(12, 8, kGreen);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// The window's pixels are untouched by what happens in an object.
TEST_F(FramebufferObjects, TheDefaultFramebufferIsApart) {
  clearTo(kGreen);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA4_OES, 16, 16));
  clearTo(kRed);
  EXPECT_PIXEL(4, 4, kRed);
  EXPECT_EQ(get(GL_RED_BITS), 4);
  EXPECT_EQ(get(GL_DEPTH_BITS), 0);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  EXPECT_PIXEL(4, 4, kGreen);
  EXPECT_EQ(get(GL_RED_BITS), 8);
  EXPECT_EQ(get(GL_DEPTH_BITS), 24);
}

TEST_F(FramebufferObjects, ColorFormats) {
  const struct {
    GLenum format;
    int red, green, blue, alpha;
  } rows[] = {{GL_RGB565_OES, 5, 6, 5, 0},
              {GL_RGBA4_OES, 4, 4, 4, 4},
              {GL_RGB5_A1_OES, 5, 5, 5, 1},
              {GL_RGB8_OES, 8, 8, 8, 0},
              {GL_RGBA8_OES, 8, 8, 8, 8}};
  framebuffer();
  for (const auto& row : rows) {
    attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(row.format, 8, 8));
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES}) << fmt::format("{:#x}", row.format);
    GLint bits[4];
    const GLenum names[] = {GL_RENDERBUFFER_RED_SIZE_OES, GL_RENDERBUFFER_GREEN_SIZE_OES,
                            GL_RENDERBUFFER_BLUE_SIZE_OES, GL_RENDERBUFFER_ALPHA_SIZE_OES};
    for (int i = 0; i < 4; ++i) gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, names[i], &bits[i]);
    EXPECT_GE(bits[0], row.red);
    EXPECT_GE(bits[1], row.green);
    EXPECT_GE(bits[2], row.blue);
    EXPECT_GE(bits[3], row.alpha);
    clearTo({0.25, 0.5, 0.75, 1});
    EXPECT_PIXEL(4, 4, {0.25, 0.5, 0.75, 1}, 1.0 / ((1 << row.alpha) - 1 > 1 && row.alpha == 4 ? 15 : 31));
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, DepthAndStencil) {
  for (const GLenum format : {GLenum{GL_DEPTH_COMPONENT16_OES}, GLenum{GL_DEPTH_COMPONENT24_OES},
                              GLenum{GL_STENCIL_INDEX8_OES}, GLenum{GL_DEPTH24_STENCIL8_OES}}) {
    const bool depth = format != GL_STENCIL_INDEX8_OES;
    const bool stencil = format == GL_STENCIL_INDEX8_OES || format == GL_DEPTH24_STENCIL8_OES;
    framebuffer();
    attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA8_OES, 64, 64));
    const GLuint buffer = renderbuffer(format, 64, 64);
    GLint bits = 0;
    if (depth) {
      attach(GL_DEPTH_ATTACHMENT_OES, buffer);
      gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_DEPTH_SIZE_OES, &bits);
      EXPECT_GE(bits, format == GL_DEPTH_COMPONENT16_OES ? 16 : 24);
    }
    if (stencil) {
      attach(GL_STENCIL_ATTACHMENT_OES, buffer);
      gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_STENCIL_SIZE_OES, &bits);
      EXPECT_EQ(bits, 8);
      EXPECT_EQ(get(GL_STENCIL_BITS), 8);
    }
    if (onMesa() && status() == GL_FRAMEBUFFER_UNSUPPORTED_OES) continue;
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES}) << fmt::format("{:#x}", format);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (depth) {
      glEnable(GL_DEPTH_TEST);
      drawIn(kRed, {-1, -1, 0, 1, 0});
      drawIn(kGreen, {-1, -1, 1, 1, 0.5});
      EXPECT_PIXEL(8, 8, kRed);
      EXPECT_PIXEL(56, 8, kGreen);
      glDisable(GL_DEPTH_TEST);
    }
    if (stencil) {
      glEnable(GL_STENCIL_TEST);
      glStencilFunc(GL_ALWAYS, 1, 255);
      glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
      drawIn(kRed, {-1, -1, 0, 1, 0});
      glStencilFunc(GL_NOTEQUAL, 1, 255);
      drawIn(kGreen, {-1, -1, 1, 1, 0});
      EXPECT_PIXEL(8, 8, kRed);
      EXPECT_PIXEL(56, 8, kGreen);
      glDisable(GL_STENCIL_TEST);
    }
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, CubeFaces) {
  GLuint cube = 0;
  glGenTextures(1, &cube);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, cube);
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
  }
  useNearest(GL_TEXTURE_CUBE_MAP_OES);
  framebuffer();
  for (GLenum face = 0; face < 6; ++face) {
    attachTexture(cube, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo({face / 5.0, 1 - face / 5.0, face % 2 / 1.0, 1});
    GLint got = 0;
    gl.GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES,
                                              GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES, &got);
    EXPECT_EQ(static_cast<GLenum>(got), GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  const GLfloat vertices[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glColor4f(1, 1, 1, 1);
  for (int face = 0; face < 6; ++face) {
    GLfloat directions[12] = {};
    for (int i = 0; i < 4; ++i) directions[i * 3 + face / 2] = face % 2 ? -1.0f : 1.0f;
    glTexCoordPointer(3, GL_FLOAT, 0, directions);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    EXPECT_PIXEL(32, 32, {face / 5.0, 1 - face / 5.0, face % 2 / 1.0, 1}) << face;
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, GenerateMipmap) {
  MESA_DISAGREES("4.4.2.4 of OES_framebuffer_object", "what is drawn to level 0 afterwards is lost");
  const GLuint target = texture(32);
  framebuffer();
  attachTexture(target);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const GLuint object = static_cast<GLuint>(get(GL_FRAMEBUFFER_BINDING_OES));
  for (const Vec4& color : {kRed, kGreen}) {
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, object);
    clearTo(color);
    gl.GenerateMipmapOES(GL_TEXTURE_2D);
    clearTo(kBlue);  // the levels above stay
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
    glEnable(GL_TEXTURE_2D);
    glColor4f(1, 1, 1, 1);
    drawTexturedRect({}, 0, 0, 1, 1);
    EXPECT_PIXEL(32, 32, kBlue);
    drawTexturedRect({}, 0, 0, 16, 16);
    EXPECT_PIXEL(32, 32, color);
    glDisable(GL_TEXTURE_2D);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.GenerateMipmapOES(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.GenerateMipmapOES(GL_TEXTURE_CUBE_MAP_OES);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST_F(FramebufferObjects, RenderToMipLevels) {
  NEEDS_EXTENSION("GL_OES_fbo_render_mipmap");
  const Vec4 colors[] = {kRed, kGreen, kBlue};
  const GLuint target = texture(4);
  for (GLint level = 1; level < 3; ++level) {
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 4 >> level, 4 >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
  }
  framebuffer();
  for (GLint level = 0; level < 3; ++level) {
    attachTexture(target, level);
    ASSERT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    clearTo(colors[level]);
    EXPECT_PIXEL(0, 0, colors[level]);
  }
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glColor4f(1, 1, 1, 1);
  for (int level = 0; level < 3; ++level) {
    drawTexturedRect({}, 0, 0, 16 << level, 16 << level);
    EXPECT_PIXEL(32, 32, colors[level]) << level;
  }
}

TEST_F(FramebufferObjects, Completeness) {
  framebuffer();
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  const GLuint color = renderbuffer(GL_RGBA4_OES, 16, 16);
  attach(GL_DEPTH_ATTACHMENT_OES, color);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES});
  attach(GL_DEPTH_ATTACHMENT_OES, 0);
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA4_OES, 0, 16));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES});
  attach(GL_COLOR_ATTACHMENT0_OES, color);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  attachTexture(texture(16, GL_LUMINANCE));
  EXPECT_NE(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});

  // Nothing can be drawn to, cleared or read from one that is not complete.
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  drawRect();
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  std::uint8_t pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_GL_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);

  // It follows its images.
  const GLuint image = texture(16);
  attachTexture(image);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  clearTo(kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  clearTo(kGreen);
  EXPECT_PIXEL(30, 30, kGreen);
  glDeleteTextures(1, &image);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES});
  GLint type = 1;
  gl.GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES,
                                            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, &type);
  EXPECT_EQ(type, GL_NONE_OES);
}

TEST_F(FramebufferObjects, DimensionsMustAgree) {
  MESA_DISAGREES("4.4.4.2 of OES_framebuffer_object", "attachments of different sizes are accepted");
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA4_OES, 16, 16));
  attach(GL_DEPTH_ATTACHMENT_OES, renderbuffer(GL_DEPTH_COMPONENT16_OES, 16, 8));
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_OES});
}

TEST_F(FramebufferObjects, NamesAndQueries) {
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), 0);
  GLuint names[2] = {};
  gl.GenFramebuffersOES(2, names);
  EXPECT_FALSE(gl.IsFramebufferOES(names[0]));
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, names[0]);
  EXPECT_TRUE(gl.IsFramebufferOES(names[0]));
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), static_cast<GLint>(names[0]));
  const GLuint buffer = renderbuffer(GL_RGBA4_OES, 16, 8);
  EXPECT_TRUE(gl.IsRenderbufferOES(buffer));
  EXPECT_EQ(get(GL_RENDERBUFFER_BINDING_OES), static_cast<GLint>(buffer));
  EXPECT_GE(get(GL_MAX_RENDERBUFFER_SIZE_OES), 64);
  attach(GL_COLOR_ATTACHMENT0_OES, buffer);
  GLint value = 0;
  const auto query = [&](GLenum name) {
    gl.GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, name, &value);
    return value;
  };
  EXPECT_EQ(query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_RENDERBUFFER_OES);
  EXPECT_EQ(query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES), static_cast<GLint>(buffer));
  EXPECT_GL_ERROR(GL_NO_ERROR);
  query(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_HEIGHT_OES, &value);
  EXPECT_EQ(value, 8);
  gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_INTERNAL_FORMAT_OES, &value);
  EXPECT_EQ(value, GL_RGBA4_OES);
  gl.DeleteRenderbuffersOES(1, &buffer);
  EXPECT_FALSE(gl.IsRenderbufferOES(buffer));
  EXPECT_EQ(get(GL_RENDERBUFFER_BINDING_OES), 0);
  EXPECT_EQ(query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_NONE_OES);
  gl.DeleteFramebuffersOES(2, names);
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), 0);
  EXPECT_EQ(status(), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, Errors) {
  const GLuint image = texture(16);
  attachTexture(image);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // nothing can be attached to the default framebuffer
  attach(GL_COLOR_ATTACHMENT0_OES, 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA4_OES, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  framebuffer();
  const GLuint buffer = renderbuffer(GL_RGBA4_OES, 16, 16);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.BindFramebufferOES(GL_RENDERBUFFER_OES, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.BindRenderbufferOES(GL_FRAMEBUFFER_OES, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA4_OES, -1, 1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA4_OES, 1, get(GL_MAX_RENDERBUFFER_SIZE_OES) + 1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  attach(GL_COLOR_BUFFER_BIT, buffer);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  attach(GL_COLOR_ATTACHMENT0_OES, 999);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  attachTexture(999);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  attachTexture(image, -1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  attachTexture(image, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  gl.GenFramebuffersOES(-1, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.DeleteRenderbuffersOES(-1, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(gl.CheckFramebufferStatusOES(GL_TEXTURE_2D), 0u);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// Copies read the bound object.
TEST_F(FramebufferObjects, CopyTexImage) {
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA8_OES, 16, 16));
  clearTo(kRed);
  texture(1);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 16, 16, 0);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  clearTo(kGreen);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  glEnable(GL_TEXTURE_2D);
  glColor4f(1, 1, 1, 1);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kRed);
}

TEST_F(FramebufferObjects, Discard) {
  NEEDS_EXTENSION("GL_EXT_discard_framebuffer");
  COMMAND(PFNGLDISCARDFRAMEBUFFEREXTPROC, DiscardFramebufferEXT);
  const GLenum ofWindow[] = {GL_COLOR_EXT, GL_DEPTH_EXT, GL_STENCIL_EXT};
  const GLenum ofObject[] = {GL_COLOR_ATTACHMENT0_OES, GL_DEPTH_ATTACHMENT_OES, GL_STENCIL_ATTACHMENT_OES};
  DiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 3, ofWindow);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  DiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 1, ofObject);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  framebuffer();
  attach(GL_COLOR_ATTACHMENT0_OES, renderbuffer(GL_RGBA4_OES, 16, 16));
  DiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 3, ofObject);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  clearTo(kGreen);
  EXPECT_PIXEL(4, 4, kGreen);
  DiscardFramebufferEXT(GL_FRAMEBUFFER_OES, 1, ofWindow);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  DiscardFramebufferEXT(GL_RENDERBUFFER_OES, 1, ofObject);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  DiscardFramebufferEXT(GL_FRAMEBUFFER_OES, -1, ofObject);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

}  // namespace
}  // namespace conformance
