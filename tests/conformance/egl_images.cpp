// OES_EGL_image with EGL 1.5 section 3.9: textures and renderbuffers that share their texels, also between
// contexts that share nothing else.
#include <atomic>
#include <thread>

#include "image_fixture.h"

namespace conformance {
namespace {

class EglImages : public ImageTest {
 protected:
  void SetUp() override {
    ImageTest::SetUp();
    NEEDS_EXTENSION("GL_OES_EGL_image");
  }
};

#define EXPECT_DRAWN(color, ...) EXPECT_TRUE(near(drawn(__VA_ARGS__), color))

TEST_F(EglImages, TexturesShareTexels) {
  const GLuint source = solid(kRed);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  ASSERT_NE(image, EGL_NO_IMAGE);
  EXPECT_DRAWN(kRed, source);
  const GLuint first = targetOf(image), second = targetOf(image);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_DRAWN(kRed, first);
  glBindTexture(GL_TEXTURE_2D, source);
  replace(kGreen, 8);
  EXPECT_DRAWN(kGreen, first);
  glBindTexture(GL_TEXTURE_2D, second);
  replace(kBlue, 8);
  EXPECT_DRAWN(kBlue, source);
  EXPECT_DRAWN(kBlue, first);
  // A part of it, and by rendering and copying.
  glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels(kRed, 4).data());
  EXPECT_DRAWN(kRed, source);
  ASSERT_TRUE(paint(kWhite, first));
  EXPECT_DRAWN(kWhite, source);
  EXPECT_DRAWN(kWhite, second);
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindTexture(GL_TEXTURE_2D, source);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
  EXPECT_DRAWN(kGreen, second);
  EXPECT_TRUE(eglDestroyImage(display(), image));
}

// The internal format comes from the source, and with it Table 3.15.
TEST_F(EglImages, FormatsAreTheSources) {
  const struct {
    GLenum format, type;
    GLuint texel;
  } rows[] = {{GL_RGBA, GL_UNSIGNED_BYTE, 0x80ff4020},        {GL_RGB, GL_UNSIGNED_BYTE, 0x804020},
              {GL_LUMINANCE, GL_UNSIGNED_BYTE, 0x60},         {GL_ALPHA, GL_UNSIGNED_BYTE, 0x60},
              {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 0x4080}, {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 0x8410},
              {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 0x8421},   {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 0x8421}};
  for (const auto& row : rows) {
    const GLuint source = newTexture();
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(row.format), 1, 1, 0, row.format, row.type, &row.texel);
    const Vec4 expected = drawn(source);
    const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
    ASSERT_NE(image, EGL_NO_IMAGE) << std::hex << row.format;
    EXPECT_DRAWN(expected, source) << std::hex << row.format;
    const GLuint target = targetOf(image);
    EXPECT_DRAWN(expected, target) << std::hex << row.format << ' ' << row.type;
    // It takes texels of the source's format, and no others.
    glBindTexture(GL_TEXTURE_2D, target);
    const GLuint white = ~0u;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, row.format, row.type, &white);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    const GLenum other = row.format == GL_RGBA ? GL_RGB : GL_RGBA;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, other, GL_UNSIGNED_BYTE, &white);
    if (!onMesa()) {
      EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    }
    while (onMesa() && glGetError()) {
    }
    EXPECT_DRAWN(drawn(target), source);
    eglDestroyImage(display(), image);
  }
}

TEST_F(EglImages, LevelsOfATexture) {
  MESA_DISAGREES("3.9.1 of EGL 1.5", "the source does not see what a target of its last level is given");
  const Vec4 colors[] = {kRed, kGreen, kBlue, kWhite};
  const GLuint source = newTexture();
  for (int level = 0; level < 4; ++level) specify(colors[level], 8 >> level, level);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  EGLImage images[4];
  GLuint targets[4];
  for (int level = 0; level < 4; ++level) {
    images[level] = imageOf(EGL_GL_TEXTURE_2D, source, level);
    ASSERT_NE(images[level], EGL_NO_IMAGE) << level;
    targets[level] = targetOf(images[level]);
    EXPECT_DRAWN(colors[level], targets[level]) << level;
  }
  // Both ways, whatever the level is; minified so that the source shows its own level.
  for (int level = 0; level < 4; ++level) {
    glBindTexture(GL_TEXTURE_2D, targets[level]);
    replace(colors[3 - level], 8 >> level);
  }
  for (int level = 0; level < 4; ++level) {
    EXPECT_DRAWN(colors[3 - level], source, GL_TEXTURE_2D, 8 << level) << level;
    ASSERT_TRUE(paint(colors[level], targets[level])) << level;
    EXPECT_DRAWN(colors[level], source, GL_TEXTURE_2D, 8 << level) << level;
    EXPECT_DRAWN(colors[level], targets[level]) << level;
    eglDestroyImage(display(), images[level]);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// A level is sampled as the only one that the texture has: its size counts, its neighbours do not.
TEST_F(EglImages, ALevelIsFilteredAlone) {
  const GLuint source = newTexture();
  specify(kRed, 4);
  const std::uint8_t quarters[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, quarters);
  specify(kRed, 1, 2);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source, 1);
  ASSERT_NE(image, EGL_NO_IMAGE);
  const GLuint target = targetOf(image), plain = newTexture();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, quarters);
  for (const GLint filter : {GL_NEAREST, GL_LINEAR}) {
    for (const GLint wrap : {GL_REPEAT, GL_CLAMP_TO_EDGE}) {
      for (const double repeat : {0.25, 1.0, 3.0, 256.0}) {
        std::vector<std::uint8_t> pictures[2];
        for (const GLuint name : {target, plain}) {
          glBindTexture(GL_TEXTURE_2D, name);
          glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
          glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
          glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
          drawn(name, GL_TEXTURE_2D, repeat);
          pictures[name == plain] = readAll().rgba;
        }
        EXPECT_EQ(pictures[0], pictures[1]) << filter << ' ' << wrap << ' ' << repeat;
      }
    }
  }
  // Filters that need a mipmap make a texture of one level incomplete.
  glBindTexture(GL_TEXTURE_2D, target);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  replace(kRed, 2);
  EXPECT_DRAWN(kWhite, target);
  eglDestroyImage(display(), image);
}

TEST_F(EglImages, FacesOfACubeMap) {
  MESA_DISAGREES("3.8.2 of OES_EGL_image", "a target of a face is not sampled");
  const Vec4 colors[] = {kRed, kGreen, kBlue, kWhite, {1, 1, 0, 1}, {0, 1, 1, 1}};
  const GLuint cube = newTexture(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) {
    specify(colors[face], 4, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  GLuint targets[6];
  for (GLenum face = 0; face < 6; ++face) {
    const EGLImage image = imageOf(EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, cube);
    ASSERT_NE(image, EGL_NO_IMAGE) << face;
    targets[face] = targetOf(image);
    EXPECT_TRUE(eglDestroyImage(display(), image));
    EXPECT_DRAWN(colors[face], targets[face]) << face;
  }
  for (GLenum face = 0; face < 6; ++face) {
    const Vec4& next = colors[(face + 1) % 6];
    if (face % 2) {
      ASSERT_TRUE(paint(next, targets[face]));
    } else {
      glBindTexture(GL_TEXTURE_2D, targets[face]);
      replace(next, 4);
    }
    glBindTexture(GL_TEXTURE_CUBE_MAP_OES, cube);
    GLfloat directions[12] = {};
    for (int i = 0; i < 4; ++i) directions[i * 3 + static_cast<int>(face) / 2] = face % 2 ? -1.0f : 1.0f;
    const GLfloat vertices[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    glEnable(GL_TEXTURE_CUBE_MAP_OES);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices);
    glTexCoordPointer(3, GL_FLOAT, 0, directions);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glDisable(GL_TEXTURE_CUBE_MAP_OES);
    EXPECT_PIXEL(32, 32, next) << face;
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(EglImages, RenderbuffersBothWays) {
  for (const GLenum format : {GLenum{GL_RGBA8_OES}, GLenum{GL_RGB565_OES}, GLenum{GL_RGBA4_OES}}) {
    GLuint source = 0;
    gl.GenRenderbuffersOES(1, &source);
    gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, source);
    gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, format, 16, 8);
    ASSERT_TRUE(paint(kRed, source, GL_RENDERBUFFER_OES));
    const EGLImage image = imageOf(EGL_GL_RENDERBUFFER, source);
    ASSERT_NE(image, EGL_NO_IMAGE) << std::hex << format;
    const GLuint texture = targetOf(image), buffer = renderbufferOf(image);
    EXPECT_DRAWN(kRed, texture);
    GLint value = 0;
    gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_WIDTH_OES, &value);
    EXPECT_EQ(value, 16);
    gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_HEIGHT_OES, &value);
    EXPECT_EQ(value, 8);
    gl.GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_GREEN_SIZE_OES, &value);
    EXPECT_GE(value, format == GL_RGBA4_OES ? 4 : 6);
    ASSERT_TRUE(paint(kGreen, buffer, GL_RENDERBUFFER_OES));
    EXPECT_DRAWN(kGreen, texture);
    ASSERT_TRUE(paint(kBlue, texture));
    EXPECT_DRAWN(kBlue, texture);
    // Storage of its own again: the others keep theirs.
    gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, buffer);
    gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA8_OES, 4, 4);
    ASSERT_TRUE(paint(kRed, buffer, GL_RENDERBUFFER_OES));
    EXPECT_DRAWN(kBlue, texture);
    eglDestroyImage(display(), image);
  }
  // And a texture's texels as a renderbuffer.
  const GLuint texture = solid(kRed, 4);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, texture);
  const GLuint buffer = renderbufferOf(image);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  ASSERT_TRUE(paint(kGreen, buffer, GL_RENDERBUFFER_OES));
  EXPECT_DRAWN(kGreen, texture);
  eglDestroyImage(display(), image);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Depth of one framebuffer object, tested in another.
TEST_F(EglImages, DepthRenderbuffers) {
  MESA_DISAGREES("2.5.1 of EGL_KHR_gl_image", "images of depth renderbuffers are refused");
  GLuint source = 0;
  gl.GenRenderbuffersOES(1, &source);
  gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, source);
  gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT16_OES, 64, 64);
  const EGLImage image = imageOf(EGL_GL_RENDERBUFFER, source);
  ASSERT_NE(image, EGL_NO_IMAGE);
  const GLuint buffers[] = {source, renderbufferOf(image)};
  const GLuint colors[] = {solid(kRed, 64), solid(kRed, 64)};
  GLuint objects[2];
  gl.GenFramebuffersOES(2, objects);
  for (int i = 0; i < 2; ++i) {
    gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, objects[i]);
    gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, colors[i], 0);
    gl.FramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES,
                                  buffers[i]);
    ASSERT_EQ(gl.CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
    glEnable(GL_DEPTH_TEST);
    if (i == 0) glClear(GL_DEPTH_BUFFER_BIT);
    glColor4f(0, 1, 0, 1);
    drawRect(i == 0 ? Rect{-1, -1, 0, 1, -0.5} : Rect{-1, -1, 1, 1, 0});
  }
  EXPECT_PIXEL(16, 32, kRed);
  EXPECT_PIXEL(48, 32, kGreen);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  const GLuint texture = newTexture();
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, image);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  static_cast<void>(texture);
  eglDestroyImage(display(), image);
}

// 3.9.1: the texels live while any sibling does, and respecification concerns the one that it is done to.
TEST_F(EglImages, SiblingsOutliveEachOther) {
  const GLuint source = solid(kRed);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  const GLuint first = targetOf(image), second = targetOf(image);
  EXPECT_TRUE(eglDestroyImage(display(), image));
  glDeleteTextures(1, &source);
  EXPECT_DRAWN(kRed, first);
  glBindTexture(GL_TEXTURE_2D, first);
  replace(kGreen, 8);
  EXPECT_DRAWN(kGreen, second);
  glBindTexture(GL_TEXTURE_2D, first);
  specify(kBlue, 8);
  EXPECT_DRAWN(kBlue, first);
  EXPECT_DRAWN(kGreen, second);
  glDeleteTextures(1, &first);
  EXPECT_DRAWN(kGreen, second);
  ASSERT_TRUE(paint(kRed, second));
  EXPECT_DRAWN(kRed, second);
}

TEST_F(EglImages, RespecifiedSource) {
  MESA_DISAGREES("3.9.1 of EGL 1.5", "a level of the same size is written in place, for all siblings");
  for (int how = 0; how < 3; ++how) {
    const GLuint source = solid(kRed);
    const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
    const GLuint target = targetOf(image);
    glBindTexture(GL_TEXTURE_2D, source);
    if (how == 0) specify(kGreen, 8);
    if (how == 1) specify(kGreen, 16);
    if (how == 2) {
      glClearColor(0, 1, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
      glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8, 8, 0);
    }
    EXPECT_DRAWN(kGreen, source) << how;
    EXPECT_DRAWN(kRed, target) << how;
    glBindTexture(GL_TEXTURE_2D, target);
    replace(kBlue, 8);
    EXPECT_DRAWN(kGreen, source) << how;
    EXPECT_DRAWN(kBlue, targetOf(image)) << how;
    eglDestroyImage(display(), image);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// OES_EGL_image, issue 1: another level is respecification too; what there is, is copied.
TEST_F(EglImages, RespecifiedLevelOfATarget) {
  MESA_DISAGREES("3.8.2 of OES_EGL_image", "the texels of level 0 are not copied");
  const GLuint source = solid(kRed, 2);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  const GLuint target = targetOf(image);
  specify(kGreen, 1, 1);
  EXPECT_DRAWN(kRed, target);
  glBindTexture(GL_TEXTURE_2D, source);
  replace(kBlue, 2);
  EXPECT_DRAWN(kRed, target);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  EXPECT_DRAWN(kGreen, target, GL_TEXTURE_2D, 256);
  EXPECT_DRAWN(kBlue, source);
  eglDestroyImage(display(), image);
}

// EGL_KHR_gl_image, issue 2, for the faces of a cube map; each keeps what it had.
TEST_F(EglImages, RespecifiedFace) {
  MESA_DISAGREES("3.8.2 of OES_EGL_image", "a target of a face is not sampled");
  const GLuint cube = newTexture(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) specify(kRed, 4, 0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, cube);
  const GLuint target = targetOf(image);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, cube);
  specify(kGreen, 4, 0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES);
  EXPECT_DRAWN(kRed, target);
  ASSERT_TRUE(paint(kBlue, cube, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES));
  EXPECT_DRAWN(kRed, target);
  // A cube map's face as a texture, orphaned in its turn.
  specify(kWhite, 2, 1);
  EXPECT_DRAWN(kRed, target);
  eglDestroyImage(display(), image);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// EGL_KHR_gl_image, issue 4.
TEST_F(EglImages, GenerateMipmap) {
  MESA_DISAGREES("EGL_KHR_gl_image, issue 4", "a target stays one");
  const GLuint source = newTexture();
  for (int level = 0; level < 3; ++level) specify(kRed, 4 >> level, level);
  const EGLImage base = imageOf(EGL_GL_TEXTURE_2D, source), one = imageOf(EGL_GL_TEXTURE_2D, source, 1);
  ASSERT_NE(one, EGL_NO_IMAGE);
  const GLuint ofBase = targetOf(base), ofOne = targetOf(one);
  glBindTexture(GL_TEXTURE_2D, ofBase);
  replace(kGreen, 4);
  // The source was complete: it stays a sibling, and so do its levels.
  glBindTexture(GL_TEXTURE_2D, source);
  gl.GenerateMipmapOES(GL_TEXTURE_2D);
  EXPECT_DRAWN(kGreen, ofOne);
  // As does automatic generation.
  glBindTexture(GL_TEXTURE_2D, source);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  replace(kBlue, 4);
  EXPECT_DRAWN(kBlue, ofOne);
  EXPECT_DRAWN(kBlue, ofBase);
  // A target has but one level: more of them are its own.
  glBindTexture(GL_TEXTURE_2D, ofBase);
  gl.GenerateMipmapOES(GL_TEXTURE_2D);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  replace(kRed, 4);
  EXPECT_DRAWN(kBlue, source);
  EXPECT_DRAWN(kRed, ofBase);
  eglDestroyImage(display(), base);
  eglDestroyImage(display(), one);
}

// The levels that a target had are gone, and so is what defined it before.
TEST_F(EglImages, TargetsAreDefinedAnew) {
  const GLuint a = solid(kRed, 8), b = solid(kGreen, 2);
  const EGLImage ofA = imageOf(EGL_GL_TEXTURE_2D, a), ofB = imageOf(EGL_GL_TEXTURE_2D, b);
  const GLuint target = solid(kBlue, 4);
  specify(kBlue, 2, 1);
  specify(kBlue, 1, 2);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, ofA);
  EXPECT_DRAWN(kRed, target);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, ofB);
  EXPECT_DRAWN(kGreen, target);
  glBindTexture(GL_TEXTURE_2D, a);
  replace(kWhite, 8);
  EXPECT_DRAWN(kGreen, target);
  // The source itself.
  glBindTexture(GL_TEXTURE_2D, a);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, ofA);
  EXPECT_DRAWN(kWhite, a);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  eglDestroyImage(display(), ofA);
  eglDestroyImage(display(), ofB);
}

// EXT_texture_storage: the levels of an immutable texture can be sources; it cannot become a target, but a
// target can become immutable.
TEST_F(EglImages, ImmutableTextures) {
  NEEDS_EXTENSION("GL_EXT_texture_storage");
  COMMAND(PFNGLTEXSTORAGE2DEXTPROC, TexStorage2DEXT);
  const GLuint source = newTexture();
  TexStorage2DEXT(GL_TEXTURE_2D, 3, GL_RGBA8_OES, 8, 8);
  for (GLint level = 0; level < 3; ++level) replace(kRed, 8 >> level, level);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source, 2);
  ASSERT_NE(image, EGL_NO_IMAGE);
  EXPECT_EQ(imageOf(EGL_GL_TEXTURE_2D, source, 3), EGL_NO_IMAGE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  glBindTexture(GL_TEXTURE_2D, source);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, image);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  const GLuint target = targetOf(image);
  EXPECT_DRAWN(kRed, target);
  replace(kGreen, 2);
  glBindTexture(GL_TEXTURE_2D, source);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  EXPECT_DRAWN(kGreen, source, GL_TEXTURE_2D, 64);
  glBindTexture(GL_TEXTURE_2D, target);
  TexStorage2DEXT(GL_TEXTURE_2D, 1, GL_RGBA8_OES, 4, 4);
  replace(kBlue, 4);
  EXPECT_DRAWN(kBlue, target);
  EXPECT_DRAWN(kGreen, source, GL_TEXTURE_2D, 64);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  eglDestroyImage(display(), image);
}

TEST_F(EglImages, BetweenContexts) {
  const EGLContext here = eglGetCurrentContext();
  const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
  const GLuint source = solid(kRed);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  {
    const Session other{SurfaceRequest{}};
    ASSERT_TRUE(other.makeCurrent());
    GLuint names[4];
    glGenTextures(4, names);  // names of its own, whatever the first context uses
    const GLuint target = targetOf(image), buffer = renderbufferOf(image);
    EXPECT_DRAWN(kRed, target);
    ASSERT_TRUE(paint(kGreen, buffer, GL_RENDERBUFFER_OES));
    glFinish();
    ASSERT_TRUE(eglMakeCurrent(display(), surface, surface, here));
    EXPECT_DRAWN(kGreen, source);
    glDeleteTextures(1, &source);
    EXPECT_TRUE(eglDestroyImage(display(), image));
    ASSERT_TRUE(other.makeCurrent());
    EXPECT_DRAWN(kGreen, target);
    EXPECT_GL_ERROR(GL_NO_ERROR);
  }
  // The context of the last sibling is gone, and its texels with it.
  ASSERT_TRUE(eglMakeCurrent(display(), surface, surface, here));
}

// Contexts of their own in threads of their own, which only read, and one that leaves the siblings.
TEST_F(EglImages, InThreads) {
  const GLuint source = solid(kRed, 16);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  glFinish();
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      {
        const Session session{SurfaceRequest{}};
        wrong += !session.makeCurrent();
        for (int i = 0; i < 20; ++i) {
          const GLuint target = targetOf(image);
          wrong += !near(drawn(target), kRed);
          if (t == 0 && i % 2) specify(kBlue, 16);
          if (t == 0 && i % 2) wrong += !near(drawn(target), kBlue);
          glDeleteTextures(1, &target);
        }
        wrong += glGetError() != GL_NO_ERROR;
      }
      eglReleaseThread();
    });
  }
  for (int i = 0; i < 20; ++i) EXPECT_DRAWN(kRed, source);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_DRAWN(kRed, source);
  eglDestroyImage(display(), image);
}

TEST_F(EglImages, Errors) {
  const GLuint source = solid(kRed);
  const EGLImage image = imageOf(EGL_GL_TEXTURE_2D, source);
  ASSERT_NE(image, EGL_NO_IMAGE);
  const GLuint kept = solid(kGreen);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_CUBE_MAP_OES, image);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, image);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.EGLImageTargetTexture2DOES(GL_RENDERBUFFER_OES, image);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  // Mesa looks into any handle.
  if (!onMesa()) {
    gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, eglGetCurrentContext());
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
  gl.EGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, image);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // none is bound
  GLuint buffer = 0;
  gl.GenRenderbuffersOES(1, &buffer);
  gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, buffer);
  gl.EGLImageTargetRenderbufferStorageOES(GL_TEXTURE_2D, image);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.EGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_TRUE(eglDestroyImage(display(), image));
  if (!onMesa()) {
    gl.EGLImageTargetTexture2DOES(GL_TEXTURE_2D, image);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
  EXPECT_DRAWN(kGreen, kept);

  // Nothing can be rendered to luminance.
  const GLuint grey = newTexture();
  const std::uint8_t texel = 99;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texel);
  const EGLImage luminance = imageOf(EGL_GL_TEXTURE_2D, grey);
  gl.EGLImageTargetRenderbufferStorageOES(GL_RENDERBUFFER_OES, luminance);
  if (!onMesa()) {
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  }
  while (onMesa() && glGetError()) {
  }
  eglDestroyImage(display(), luminance);
}

}  // namespace
}  // namespace conformance
