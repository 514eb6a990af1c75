// OES_EGL_image_external: textures that only EGLImages define.
#include "image_fixture.h"

namespace conformance {
namespace {

class ExternalTextures : public ImageTest {
 protected:
  void SetUp() override {
    ImageTest::SetUp();
    NEEDS_EXTENSION("GL_OES_EGL_image_external");
  }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  static GLint parameter(GLenum name, GLenum target = GL_TEXTURE_EXTERNAL_OES) {
    GLint value = -1;
    glGetTexParameteriv(target, name, &value);
    return value;
  }
  // Four texels: red, green; blue, white.
  static GLuint quarters() {
    const std::uint8_t texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
    const GLuint name = newTexture();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    return name;
  }
};

constexpr GLenum kExternal = GL_TEXTURE_EXTERNAL_OES;

TEST_F(ExternalTextures, ShowsItsImage) {
  const GLuint source = quarters();
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  const GLuint external = targetOf(image, kExternal);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  drawn(external, kExternal);
  EXPECT_PIXEL(16, 16, kRed);
  EXPECT_PIXEL(48, 16, kGreen);
  EXPECT_PIXEL(16, 48, kBlue);
  EXPECT_PIXEL(48, 48, kWhite);
  // The image's contents are kept, and followed.
  EXPECT_TRUE(near(drawn(source), kWhite));
  glBindTexture(GL_TEXTURE_2D, source);
  replace(kGreen, 2);
  EXPECT_TRUE(near(drawn(external, kExternal), kGreen));
  // Another image, then one that is gone from EGL.
  const EGLImage next = imageOf(EGL_GL_TEXTURE_2D, solid(kBlue));
  glBindTexture(kExternal, external);
  gl.EGLImageTargetTexture2DOES(kExternal, next);
  eglDestroyImage(display(), next);
  eglDestroyImage(display(), image);
  EXPECT_TRUE(near(drawn(external, kExternal), kBlue));
}

TEST_F(ExternalTextures, WithoutAnImage) {
  MESA_DISAGREES("3.7.14 of OES_EGL_image_external", "texturing is off");
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_TRUE(near(drawn(0, kExternal), {0, 0, 0, 1}));
  EXPECT_TRUE(near(drawn(newTexture(kExternal), kExternal), {0, 0, 0, 1}));
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// 3.7.13: before all other targets.
TEST_F(ExternalTextures, Precedence) {
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, solid(kRed));
  const GLuint external = targetOf(image, kExternal);
  const GLuint cube = newTexture(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) specify(kBlue, 1, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  const GLuint flat = solid(kGreen);
  EXPECT_FALSE(glIsEnabled(kExternal));
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(kExternal);
  EXPECT_TRUE(glIsEnabled(kExternal));
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kRed);
  glDisable(kExternal);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kBlue);
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kGreen);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_EXTERNAL_OES), static_cast<GLint>(external));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), static_cast<GLint>(flat));
  static_cast<void>(cube);
  eglDestroyImage(display(), image);
}

// The environment, the texture matrix and the units are those of every texture.
TEST_F(ExternalTextures, EnvironmentAndMatrix) {
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, quarters());
  const GLuint external = targetOf(image, kExternal);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.5f, 0, 0);
  glScalef(0.5f, 0.5f, 1);
  EXPECT_TRUE(near(drawn(external, kExternal), kGreen));
  glLoadIdentity();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glEnable(kExternal);
  glColor4f(0.5f, 0.25f, 1, 1);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(48, 48, {0.5, 0.25, 1, 1});
  EXPECT_PIXEL(16, 16, {0.5, 0, 0, 1});
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  // A second unit adds a flat texture.
  glActiveTexture(GL_TEXTURE1);
  solid(kBlue);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(16, 16, {1, 0, 1, 1});
  glDisable(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE0);
  eglDestroyImage(display(), image);
}

// Alpha comes from the image, and is 1 where that has none.
TEST_F(ExternalTextures, Alpha) {
  const struct {
    GLenum format;
    GLuint texel;
    Vec4 expected;
  } rows[] = {{GL_RGBA, 0x40804020, {0x20 / 255.0, 0x40 / 255.0, 0x80 / 255.0, 0x40 / 255.0}},
              {GL_RGB, 0x804020, {0x20 / 255.0, 0x40 / 255.0, 0x80 / 255.0, 1}}};
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  for (const auto& row : rows) {
    const GLuint source = newTexture();
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(row.format), 1, 1, 0, row.format, GL_UNSIGNED_BYTE,
                 &row.texel);
    const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
    EXPECT_TRUE(near(drawn(targetOf(image, kExternal), kExternal), row.expected));
    eglDestroyImage(display(), image);
  }
}

// A cube map's face and a level, whose coordinates run over it alone.
TEST_F(ExternalTextures, PartsOfTextures) {
  MESA_DISAGREES("3.7.14 of OES_EGL_image_external", "a cube map's face is not sampled");
  const GLuint cube = newTexture(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) {
    specify({face / 5.0, 0, 1, 1}, 4, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  const EGLImage face = imageOf(EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, cube);
  EXPECT_TRUE(near(drawn(targetOf(face, kExternal), kExternal), {1, 0, 1, 1}));
  const GLuint source = newTexture();
  specify(kRed, 2);
  specify(kGreen, 1, 1);
  const EGLImage level = imageOf(EGL_GL_TEXTURE_2D, source, 1);
  EXPECT_TRUE(near(drawn(targetOf(level, kExternal), kExternal), kGreen));
  eglDestroyImage(display(), face);
  eglDestroyImage(display(), level);
}

TEST_F(ExternalTextures, DrawTexture) {
  MESA_DISAGREES("OES_draw_texture", "the crop rectangle of external textures is not looked at");
  NEEDS_EXTENSION("GL_OES_draw_texture");
  COMMAND(PFNGLDRAWTEXIOESPROC, DrawTexiOES);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, quarters());
  const GLuint external = targetOf(image, kExternal);
  const GLint crop[] = {1, 0, 1, 2};
  glTexParameteriv(kExternal, GL_TEXTURE_CROP_RECT_OES, crop);
  glBindTexture(kExternal, external);
  glEnable(kExternal);
  DrawTexiOES(0, 0, 0, 64, 64);
  EXPECT_PIXEL(16, 16, kGreen);
  EXPECT_PIXEL(16, 48, kWhite);
  eglDestroyImage(display(), image);
}

TEST_F(ExternalTextures, Parameters) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(kExternal, name);
  EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
  EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_LINEAR);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_CLAMP_TO_EDGE);
  EXPECT_EQ(parameter(GL_GENERATE_MIPMAP), GL_FALSE);
  EXPECT_EQ(parameter(GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES), 1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (const GLint filter : {GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                             GL_LINEAR_MIPMAP_LINEAR}) {
    glTexParameteri(kExternal, GL_TEXTURE_MIN_FILTER, filter);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
  }
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    for (const GLint mode : {GL_REPEAT, GL_MIRRORED_REPEAT_OES}) {
      glTexParameteri(kExternal, axis, mode);
      EXPECT_GL_ERROR(GL_INVALID_ENUM);
    }
    glTexParameteri(kExternal, axis, GL_CLAMP_TO_EDGE);
    EXPECT_GL_ERROR(GL_NO_ERROR);
  }
  if (!onMesa()) {
    glTexParameteri(kExternal, GL_GENERATE_MIPMAP, GL_TRUE);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    glTexParameteri(kExternal, GL_GENERATE_MIPMAP, GL_FALSE);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    EXPECT_EQ(parameter(GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, GL_TEXTURE_2D), 1);
    EXPECT_EQ(parameter(GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, GL_TEXTURE_CUBE_MAP_OES), 1);
  }
  for (const GLint filter : {GL_NEAREST, GL_LINEAR}) {
    glTexParameteri(kExternal, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(kExternal, GL_TEXTURE_MAG_FILTER, filter);
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), filter);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(ExternalTextures, NamesAndErrors) {
  const GLuint external = newTexture(kExternal);
  EXPECT_TRUE(glIsTexture(external));
  glBindTexture(GL_TEXTURE_2D, external);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  const GLuint flat = solid(kRed);
  glBindTexture(kExternal, flat);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  const std::uint8_t texel[4] = {};
  glTexImage2D(kExternal, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glTexSubImage2D(kExternal, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glCopyTexImage2D(kExternal, 0, GL_RGBA, 0, 0, 1, 1, 0);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glCopyTexSubImage2D(kExternal, 0, 0, 0, 0, 0, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glCompressedTexImage2D(kExternal, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, texel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glCompressedTexSubImage2D(kExternal, 0, 0, 0, 1, 1, GL_PALETTE4_RGB8_OES, 1, texel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.GenerateMipmapOES(kExternal);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.EGLImageTargetTexture2DOES(kExternal, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  // It cannot be rendered to, nor be a source itself.
  GLuint object = 0;
  gl.GenFramebuffersOES(1, &object);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, object);
  gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, kExternal, external, 0);
  EXPECT_NE(glGetError(), GLenum{GL_NO_ERROR});
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  EXPECT_EQ(imageOf(EGL_GL_TEXTURE_2D, external), EGL_NO_IMAGE);
  // Deleted while bound: the default texture is.
  glBindTexture(kExternal, external);
  glDeleteTextures(1, &external);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_EXTERNAL_OES), 0);
  EXPECT_FALSE(glIsTexture(external));
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
