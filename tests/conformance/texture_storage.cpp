// EXT_texture_storage, APPLE_copy_texture_levels.
#include <fmt/format.h>

#include <algorithm>

#include "extension_commands.h"

namespace conformance {
namespace {

using TexStorage2D = PFNGLTEXSTORAGE2DEXTPROC;
using CopyTextureLevels = PFNGLCOPYTEXTURELEVELSAPPLEPROC;

constexpr GLenum k2D = GL_TEXTURE_2D, kCube = GL_TEXTURE_CUBE_MAP_OES;

struct Format {
  GLenum internal, format, type;
  std::size_t bytes;  // a texel
};
constexpr Format kFormats[] = {
    {GL_RGB565_OES, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
    {GL_RGBA4_OES, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
    {GL_RGB5_A1_OES, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2},
    {GL_RGB8_OES, GL_RGB, GL_UNSIGNED_BYTE, 3},
    {GL_RGBA8_OES, GL_RGBA, GL_UNSIGNED_BYTE, 4},
    {GL_LUMINANCE8_ALPHA8_EXT, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
    {GL_LUMINANCE8_EXT, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
    {GL_ALPHA8_EXT, GL_ALPHA, GL_UNSIGNED_BYTE, 1},
    {GL_BGRA8_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, 4},
};

GLint immutable(GLenum target = k2D) {
  GLint value = -1;
  glGetTexParameteriv(target, GL_TEXTURE_IMMUTABLE_FORMAT_EXT, &value);
  return value;
}

class TextureStorage : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_EXT_texture_storage");
    storage_ = command<TexStorage2D>("glTexStorage2DEXT");
    ASSERT_NE(storage_, nullptr);
    copyLevels_ = command<CopyTextureLevels>("glCopyTextureLevelsAPPLE");
    glEnable(k2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }

  static GLuint bindNew(GLenum target = k2D) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    useNearest(target);
    return name;
  }

  // A whole level in one color.
  static void fill(GLint level, GLsizei size, std::array<GLubyte, 4> color, GLenum target = k2D) {
    std::vector<GLubyte> texels(static_cast<std::size_t>(size * size * 4));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = color[i % 4];
    glTexSubImage2D(target, level, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }

  static void draw(int size) {
    glViewport(0, 0, size, size);
    drawTexturedRect({}, 0, 0, 1, 1);
  }

  TexStorage2D storage_ = nullptr;
  CopyTextureLevels copyLevels_ = nullptr;
};

// What TexImage2D and TexStorage2DEXT with TexSubImage2D make looks the same.
TEST_F(TextureStorage, EveryFormat) {
  std::vector<GLubyte> data;
  for (int i = 0; i < 8 * 8 * 4; ++i) data.push_back(static_cast<GLubyte>(i * 37 + 11));
  for (const Format& format : kFormats) {
    SCOPED_TRACE(fmt::format("{:#x}", format.internal));
    glClear(GL_COLOR_BUFFER_BIT);
    bindNew();
    glTexImage2D(k2D, 0, static_cast<GLint>(format.format), 8, 8, 0, format.format, format.type, data.data());
    draw(8);
    const Image expected = readImage(0, 0, 8, 8);
    glClear(GL_COLOR_BUFFER_BIT);
    bindNew();
    EXPECT_EQ(immutable(), GL_FALSE);
    storage_(k2D, 1, format.internal, 8, 8);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    EXPECT_EQ(immutable(), GL_TRUE);
    glTexSubImage2D(k2D, 0, 0, 0, 8, 8, format.format, format.type, data.data());
    EXPECT_GL_ERROR(GL_NO_ERROR);
    draw(8);
    EXPECT_EQ(readImage(0, 0, 8, 8).rgba, expected.rgba);
  }
}

// Levels beyond the last one are not wanted: the texture is complete without them.
TEST_F(TextureStorage, Levels) {
  constexpr std::array<std::array<GLubyte, 4>, 3> kColors = {
      {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}}};
  bindNew();
  glTexParameteri(k2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  storage_(k2D, 3, GL_RGBA8_OES, 16, 16);
  for (GLint level = 0; level < 3; ++level)
    fill(level, 16 >> level, kColors[static_cast<std::size_t>(level)]);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int level = 0; level < 5; ++level) {
    draw(16 >> level);
    const auto& c = kColors[static_cast<std::size_t>(std::min(level, 2))];
    EXPECT_PIXEL(0, 0, {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, 1}) << level;
  }
  fill(3, 2, kColors[0]);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // there is none
}

// GENERATE_MIPMAP and GenerateMipmapOES stay within the levels.
TEST_F(TextureStorage, GeneratedLevels) {
  COMMAND(PFNGLGENERATEMIPMAPOESPROC, GenerateMipmapOES);
  for (const bool automatic : {true, false}) {
    bindNew();
    glTexParameteri(k2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    if (automatic) glTexParameteri(k2D, GL_GENERATE_MIPMAP, GL_TRUE);
    storage_(k2D, 2, GL_RGBA8_OES, 8, 8);
    fill(0, 8, {0, 128, 255, 255});
    if (!automatic) GenerateMipmapOES(k2D);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    for (const int size : {8, 4, 2}) {
      draw(size);
      EXPECT_PIXEL(0, 0, {0, 128 / 255.0, 1, 1}) << size;
    }
  }
}

TEST_F(TextureStorage, CubeMaps) {
  NEEDS_EXTENSION("GL_OES_texture_cube_map");
  glDisable(k2D);
  glEnable(kCube);
  bindNew(kCube);
  storage_(kCube, 4, GL_RGBA8_OES, 8, 8);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_EQ(immutable(kCube), GL_TRUE);
  constexpr float kCenters[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (unsigned face = 0; face < 6; ++face) {
    fill(0, 8, {static_cast<GLubyte>(face * 40), 100, 200, 255}, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  for (unsigned face = 0; face < 6; ++face) {
    const float* c = kCenters[face];
    glMultiTexCoord4f(GL_TEXTURE0, c[0], c[1], c[2], 1);
    drawRect();
    EXPECT_PIXEL(4, 4, {face * 40 / 255.0, 100 / 255.0, 200 / 255.0, 1}) << face;
  }
  bindNew(kCube);
  storage_(kCube, 1, GL_RGBA8_OES, 8, 4);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

TEST_F(TextureStorage, CompressedFormats) {
  if (onMesa()) GTEST_SKIP() << "Mesa ties compressed formats to their desktop extensions";
  NEEDS_EXTENSION("GL_OES_compressed_ETC1_RGB8_texture");
  // A block of base color (17, 34, 51) without modifiers but the smallest.
  constexpr GLubyte kBlock[8] = {0x11, 0x22, 0x33, 0, 0, 0, 0, 0};
  bindNew();
  storage_(k2D, 1, GL_ETC1_RGB8_OES, 4, 4);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glCompressedTexSubImage2D(k2D, 0, 0, 0, 4, 4, GL_ETC1_RGB8_OES, 8, kBlock);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  draw(4);
  EXPECT_PIXEL(2, 2, {19 / 255.0, 36 / 255.0, 53 / 255.0, 1}, 0.001);
  glCompressedTexImage2D(k2D, 0, GL_ETC1_RGB8_OES, 4, 4, 0, 8, kBlock);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  // No imageSize would have made these valid.
  bindNew();
  storage_(k2D, 1, GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, 12, 16);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  storage_(k2D, 1, 0x83F2, 6, 8);  // DXT3
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  storage_(k2D, 1, GL_PALETTE4_RGB8_OES, 8, 8);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

TEST_F(TextureStorage, Errors) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  bindNew();
  const auto fails = [&](GLenum error, GLenum target, GLsizei levels, GLenum internal, GLsizei w, GLsizei h) {
    storage_(target, levels, internal, w, h);
    EXPECT_GL_ERROR(error) << levels << " " << internal << " " << w << "x" << h;
    EXPECT_EQ(immutable(), GL_FALSE);
  };
  fails(GL_INVALID_ENUM, 0x9999, 1, GL_RGBA8_OES, 8, 8);
  fails(GL_INVALID_ENUM, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, 1, GL_RGBA8_OES, 8, 8);
  fails(GL_INVALID_ENUM, k2D, 1, GL_RGBA, 8, 8);  // base formats
  fails(GL_INVALID_ENUM, k2D, 1, GL_LUMINANCE, 8, 8);
  fails(GL_INVALID_ENUM, k2D, 1, GL_BGRA_EXT, 8, 8);
  fails(GL_INVALID_ENUM, k2D, 1, 0x9999, 8, 8);
  fails(GL_INVALID_VALUE, k2D, 0, GL_RGBA8_OES, 8, 8);
  fails(GL_INVALID_VALUE, k2D, 1, GL_RGBA8_OES, 0, 8);
  fails(GL_INVALID_VALUE, k2D, 1, GL_RGBA8_OES, 8, 0);
  fails(GL_INVALID_VALUE, k2D, -1, GL_RGBA8_OES, 8, 8);
  fails(GL_INVALID_VALUE, k2D, 1, GL_RGBA8_OES, -8, 8);
  fails(GL_INVALID_VALUE, k2D, 1, GL_RGBA8_OES, largest * 2, 8);
  fails(GL_INVALID_OPERATION, k2D, 5, GL_RGBA8_OES, 8, 8);
  fails(GL_INVALID_OPERATION, k2D, 4, GL_RGBA8_OES, 7, 4);
  glBindTexture(k2D, 0);
  fails(GL_INVALID_OPERATION, k2D, 1, GL_RGBA8_OES, 8, 8);
}

// What would change an immutable texture's structure fails, and changes nothing.
TEST_F(TextureStorage, IsImmutable) {
  bindNew();
  storage_(k2D, 1, GL_RGBA8_OES, 8, 8);
  fill(0, 8, {255, 255, 0, 255});
  const std::vector<GLubyte> data(4096);
  glTexImage2D(k2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glTexImage2D(k2D, 1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glCopyTexImage2D(k2D, 0, GL_RGBA, 0, 0, 8, 8, 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glCompressedTexImage2D(k2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, 56, data.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  storage_(k2D, 1, GL_RGBA8_OES, 8, 8);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glCopyTexSubImage2D(k2D, 0, 0, 0, 0, 0, 1, 1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  draw(8);
  EXPECT_PIXEL(4, 4, {1, 1, 0, 1});
}

// What was specified before is gone.
TEST_F(TextureStorage, ReplacesLevels) {
  bindNew();
  const std::vector<GLubyte> data(4096, 255);
  for (GLint level = 0; level < 4; ++level) {
    glTexImage2D(k2D, level, GL_RGB, 8 >> level, 8 >> level, 0, GL_RGB, GL_UNSIGNED_BYTE, data.data());
  }
  draw(8);
  storage_(k2D, 1, GL_RGBA8_OES, 4, 4);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  fill(0, 4, {255, 0, 255, 0});
  draw(4);
  EXPECT_PIXEL(2, 2, {1, 0, 1, 0});
  glTexSubImage2D(k2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

// --- APPLE_copy_texture_levels

TEST_F(TextureStorage, CopiesLevels) {
  NEEDS_EXTENSION("GL_APPLE_copy_texture_levels");
  const GLuint source = bindNew();
  storage_(k2D, 4, GL_RGBA8_OES, 8, 8);
  for (GLint level = 0; level < 4; ++level) {
    fill(level, 8 >> level, {static_cast<GLubyte>(level * 60), 90, 180, 255});
  }
  for (const bool drawn : {false, true}) {
    glBindTexture(k2D, source);
    if (drawn) draw(8);
    const GLuint destination = bindNew();
    glTexParameteri(k2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    storage_(k2D, 5, GL_RGBA8_OES, 16, 16);
    for (GLint level = 0; level < 5; ++level) fill(level, 16 >> level, {255, 255, 255, 255});
    // Levels 1 and 2 of the source are levels 2 and 3 of the destination.
    copyLevels_(destination, source, 1, 2);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    for (int level = 0; level < 5; ++level) {
      draw(16 >> level);
      const bool copied = level == 2 || level == 3;
      EXPECT_PIXEL(0, 0,
                   copied ? Vec4{(level - 1) * 60 / 255.0, 90 / 255.0, 180 / 255.0, 1} : Vec4{1, 1, 1, 1})
          << level;
    }
  }
}

TEST_F(TextureStorage, CopiesLevelsOfCubeMaps) {
  NEEDS_EXTENSION("GL_APPLE_copy_texture_levels");
  glDisable(k2D);
  glEnable(kCube);
  const GLuint source = bindNew(kCube);
  storage_(kCube, 1, GL_RGBA8_OES, 4, 4);
  for (unsigned face = 0; face < 6; ++face) {
    fill(0, 4, {static_cast<GLubyte>(face * 40), 0, 0, 255}, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  const GLuint destination = bindNew(kCube);
  storage_(kCube, 1, GL_RGBA8_OES, 4, 4);
  copyLevels_(destination, source, 0, 1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glMultiTexCoord4f(GL_TEXTURE0, 0, 0, -1, 1);
  drawRect();
  EXPECT_PIXEL(8, 8, {200 / 255.0, 0, 0, 1});
}

TEST_F(TextureStorage, ErrorsOfCopiedLevels) {
  NEEDS_EXTENSION("GL_APPLE_copy_texture_levels");
  const GLuint source = bindNew();
  storage_(k2D, 3, GL_RGBA8_OES, 8, 8);
  const GLuint destination = bindNew();
  storage_(k2D, 2, GL_RGBA8_OES, 8, 8);
  const GLuint other = bindNew();
  storage_(k2D, 3, GL_RGB8_OES, 8, 8);
  const GLuint larger = bindNew();
  storage_(k2D, 2, GL_RGBA8_OES, 64, 64);
  const GLuint cube = bindNew(kCube);
  storage_(kCube, 3, GL_RGBA8_OES, 8, 8);
  const GLuint mutableOne = bindNew();
  glTexImage2D(k2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  struct Row {
    const char* what;
    GLuint to, from;
    GLint base;
    GLsizei count;
    GLenum error;
  };
  for (const Row& row : {Row{"no destination", 0, source, 0, 1, GL_INVALID_VALUE},
                         Row{"no source", destination, 0, 0, 1, GL_INVALID_VALUE},
                         Row{"level < 0", destination, source, -1, 1, GL_INVALID_VALUE},
                         Row{"level beyond", destination, source, 3, 1, GL_INVALID_VALUE},
                         Row{"no levels", destination, source, 0, 0, GL_INVALID_VALUE},
                         Row{"too many", destination, source, 1, 3, GL_INVALID_VALUE},
                         Row{"overflow", destination, source, 1, 0x7fffffff, GL_INVALID_VALUE},
                         Row{"destination has fewer", destination, source, 0, 3, GL_INVALID_OPERATION},
                         Row{"no level of the size", larger, source, 0, 1, GL_INVALID_OPERATION},
                         Row{"other format", other, source, 0, 1, GL_INVALID_OPERATION},
                         Row{"other target", cube, source, 0, 1, GL_INVALID_OPERATION},
                         Row{"mutable source", destination, mutableOne, 0, 1, GL_INVALID_OPERATION},
                         Row{"mutable destination", mutableOne, source, 0, 1, GL_INVALID_OPERATION},
                         Row{"no such texture", 4711, source, 0, 1, GL_INVALID_OPERATION},
                         Row{"right", destination, source, 0, 2, GL_NO_ERROR}}) {
    copyLevels_(row.to, row.from, row.base, row.count);
    EXPECT_GL_ERROR(row.error) << row.what;
  }
}

// Nor does an EGLImage replace what is immutable; but it may become the source of one.
TEST_F(TextureStorage, RefusesEglImages) {
  NEEDS_EXTENSION("GL_OES_EGL_image");
  COMMAND(PFNGLEGLIMAGETARGETTEXTURE2DOESPROC, EGLImageTargetTexture2DOES);
  const auto createImage = command<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR");
  const auto destroyImage = command<PFNEGLDESTROYIMAGEKHRPROC>("eglDestroyImageKHR");
  ASSERT_TRUE(createImage && destroyImage);
  const GLuint source = bindNew();
  storage_(k2D, 1, GL_RGBA8_OES, 8, 8);
  fill(0, 8, {0, 255, 255, 255});
  const EGLImageKHR image = createImage(display(), eglGetCurrentContext(), EGL_GL_TEXTURE_2D_KHR,
                                        reinterpret_cast<EGLClientBuffer>(std::uintptr_t{source}), nullptr);
  ASSERT_NE(image, EGL_NO_IMAGE_KHR);
  bindNew();
  storage_(k2D, 1, GL_RGBA8_OES, 8, 8);
  EGLImageTargetTexture2DOES(k2D, image);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  bindNew();
  EGLImageTargetTexture2DOES(k2D, image);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  draw(8);
  EXPECT_PIXEL(4, 4, {0, 1, 1, 1});
  // A texture that had an image of others becomes one of its own.
  storage_(k2D, 1, GL_RGBA8_OES, 4, 4);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  fill(0, 4, {255, 0, 0, 255});
  draw(8);
  EXPECT_PIXEL(4, 4, {1, 0, 0, 1});
  glBindTexture(k2D, source);
  draw(8);
  EXPECT_PIXEL(4, 4, {0, 1, 1, 1});
  EXPECT_TRUE(destroyImage(display(), image));
}

// EGL: eglBindTexImage does not replace what is immutable.
TEST_F(TextureStorage, RefusesBoundImages) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_BIND_TO_TEXTURE_RGBA, EGL_TRUE, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display(), wanted, &config, 1, &count);
  if (count == 0) GTEST_SKIP() << "no pbuffer can be a texture";
  const EGLint attributes[] = {
      EGL_WIDTH,      8,       EGL_HEIGHT, 8, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGBA, EGL_TEXTURE_TARGET,
      EGL_TEXTURE_2D, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display(), config, attributes);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  bindNew();
  storage_(k2D, 1, GL_RGBA8_OES, 8, 8);
  EXPECT_FALSE(eglBindTexImage(display(), surface, EGL_BACK_BUFFER));
  EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
  bindNew();
  EXPECT_TRUE(eglBindTexImage(display(), surface, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglReleaseTexImage(display(), surface, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglDestroySurface(display(), surface));
}

}  // namespace
}  // namespace conformance
