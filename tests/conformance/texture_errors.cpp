// Section 3.7: the error rules of textures and their environment.
#include <limits>

#include "rejections.h"

namespace conformance {
namespace {

class TextureErrors : public RejectionTest {};

// 3.7.12
TEST_F(TextureErrors, TextureEnvironment) {
  const GLfloat three[4] = {3, 3, 3, 3};
  const GLint threei[4] = {3, 3, 3, 3};
  const GLfixed threex[4] = {3 * 65536, 0, 0, 0};
  const GLint sourceColor[4] = {GL_SRC_COLOR};
  GLfloat f[4];
  GLint i[4];
  GLfixed x[4];
  reject({
      REJECT("3.7.12", glTexEnvf(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_MODULATE), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_MODULATE), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvx(kNoEnum, GL_TEXTURE_ENV_MODE, GL_MODULATE), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, kNoEnum, GL_MODULATE), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_SUBTRACT), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, 1.5f), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, kNoEnum), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DECAL), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_BLEND), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGBA), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_SRC_COLOR), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, GL_REPLACE), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_DST_COLOR), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, GL_SRC_COLOR), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnviv(GL_TEXTURE_ENV, GL_OPERAND2_ALPHA, sourceColor), GL_INVALID_ENUM),
      REJECT("3.7.12", glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 0), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE, 3 * 65536), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnvfv(GL_TEXTURE_ENV, GL_ALPHA_SCALE, three), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnviv(GL_TEXTURE_ENV, GL_RGB_SCALE, threei), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnvxv(GL_TEXTURE_ENV, GL_ALPHA_SCALE, threex), GL_INVALID_VALUE),
      REJECT("3.7.12", glTexEnvf(GL_TEXTURE_ENV, GL_COORD_REPLACE_OES, 1), GL_INVALID_ENUM),
      REJECT("3.3", glTexEnvf(GL_POINT_SPRITE_OES, GL_TEXTURE_ENV_MODE, GL_MODULATE), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetTexEnvfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetTexEnviv(GL_TEXTURE_ENV, kNoEnum, i), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetTexEnvxv(kNoEnum, GL_TEXTURE_ENV_MODE, x), GL_INVALID_ENUM),
  });
}

// 2.12.2 applies "multi-valued parameter in a scalar command" to lighting; 2.5 to the environment colour.
TEST_F(TextureErrors, ScalarEnvironmentColor) {
  reject({REJECT("3.7.12", glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1), GL_INVALID_ENUM)
              .notMesa("one value of several is set"),
          REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1), GL_INVALID_ENUM)
              .notMesa("one value of several is set"),
          REJECT("3.7.12", glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 65536), GL_INVALID_ENUM)});
}

// 3.7.5, 3.7.11, 6.1.3
TEST_F(TextureErrors, TextureParametersAndObjects) {
  GLuint names[2] = {};
  GLfloat f[4];
  GLint i[4];
  GLfixed x[4];
  const GLint linear[4] = {GL_NEAREST_MIPMAP_LINEAR};
  reject({
      REJECT("3.7.5", glTexParameteri(kNoEnum, GL_TEXTURE_WRAP_S, GL_REPEAT), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameterf(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, GL_REPEAT), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameterx(kNoEnum, GL_TEXTURE_WRAP_S, GL_REPEAT), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameteri(GL_TEXTURE_2D, kNoEnum, GL_REPEAT), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLEAR), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT), GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST_MIPMAP_NEAREST),
             GL_INVALID_ENUM),
      REJECT("3.7.5", glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, linear), GL_INVALID_ENUM),
      REJECT("3.7.11", glBindTexture(kNoEnum, 1), GL_INVALID_ENUM),
      REJECT("3.7.11", glGenTextures(-1, names), GL_INVALID_VALUE),
      REJECT("3.7.11", glDeleteTextures(-1, names), GL_INVALID_VALUE),
      REJECT("6.1.3", glGetTexParameterfv(kNoEnum, GL_TEXTURE_WRAP_S, f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetTexParameteriv(GL_TEXTURE_2D, kNoEnum, i), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetTexParameterxv(kNoEnum, GL_TEXTURE_WRAP_S, x), GL_INVALID_ENUM),
  });
}

// 3.7.1, 3.6.2
TEST_F(TextureErrors, TextureImages) {
  const std::vector<GLubyte> texels(64 * 64 * 4);
  const void* p = texels.data();
  const GLint most = integer(GL_MAX_TEXTURE_SIZE);
  GLint levels = 0;
  while ((1 << levels) < most) ++levels;
  const GLenum t = GL_TEXTURE_2D;
  reject({
      REJECT("3.7.1", glTexImage2D(kNoEnum, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, p),
             GL_INVALID_ENUM),
      REJECT("3.7.1", glTexImage2D(t, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, levels + 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, p),
             GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, 3, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, -1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, 4, -1, 0, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, most * 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr),
             GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, p),
             GL_INVALID_OPERATION),
      REJECT("3.7.1", glTexImage2D(t, 0, GL_ALPHA, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, p),
             GL_INVALID_OPERATION),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BYTE, p), GL_INVALID_ENUM)
          .notMesa("INVALID_OPERATION"),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_RGBA, 4, 4, 0, kNoEnum, GL_UNSIGNED_BYTE, p), GL_INVALID_ENUM)
          .notMesa("INVALID_VALUE"),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, p),
             GL_INVALID_OPERATION),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_5_5_5_1, p),
             GL_INVALID_OPERATION),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, p),
             GL_INVALID_OPERATION),
      REJECT("3.6.2", glTexImage2D(t, 0, GL_ALPHA, 4, 4, 0, GL_ALPHA, GL_UNSIGNED_SHORT_5_6_5, p),
             GL_INVALID_OPERATION),
  });
  if (!hasExtension("GL_OES_texture_npot") && !hasExtension("GL_APPLE_texture_2D_limited_npot")) {
    reject({REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, 3, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, p),
                   GL_INVALID_VALUE),
            REJECT("3.7.1", glTexImage2D(t, 0, GL_RGBA, 4, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, p),
                   GL_INVALID_VALUE)});
  }
  // 3.7.2: nothing can be replaced where nothing is.
  GLuint empty = 0;
  glGenTextures(1, &empty);
  glBindTexture(t, empty);
  reject(
      {REJECT("3.7.2", glTexSubImage2D(t, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_OPERATION,
              GL_INVALID_VALUE),
       REJECT("3.7.2", glCopyTexSubImage2D(t, 0, 0, 0, 0, 0, 1, 1), GL_INVALID_OPERATION, GL_INVALID_VALUE)});
  glTexImage2D(t, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, p);
  reject({
      REJECT("3.7.2", glTexSubImage2D(kNoEnum, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_ENUM),
      REJECT("3.7.2", glTexSubImage2D(t, -1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, levels + 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p),
             GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, 0, -1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 0, -1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 7, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 0, 3, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p), GL_INVALID_VALUE),
      REJECT("3.7.2",
             glTexSubImage2D(t, 0, std::numeric_limits<GLint>::max(), 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, p),
             GL_INVALID_VALUE)
          .notMesa("the sum overflows and it crashes"),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 0, 0, 1, 1, GL_RGBA, GL_BYTE, p), GL_INVALID_ENUM)
          .notMesa("INVALID_OPERATION"),
      REJECT("3.7.2", glTexSubImage2D(t, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, p),
             GL_INVALID_OPERATION),
      REJECT("3.7.2", glCopyTexSubImage2D(kNoEnum, 0, 0, 0, 0, 0, 1, 1), GL_INVALID_ENUM),
      REJECT("3.7.2", glCopyTexSubImage2D(t, -1, 0, 0, 0, 0, 1, 1), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexSubImage2D(t, 0, -1, 0, 0, 0, 1, 1), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexSubImage2D(t, 0, 7, 0, 0, 0, 2, 1), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexSubImage2D(t, 0, 0, 0, 0, 0, -1, 1), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexImage2D(kNoEnum, 0, GL_RGBA, 0, 0, 4, 4, 0), GL_INVALID_ENUM),
      REJECT("3.7.2", glCopyTexImage2D(t, -1, GL_RGBA, 0, 0, 4, 4, 0), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexImage2D(t, 0, GL_RGBA, 0, 0, 4, 4, 1), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexImage2D(t, 0, GL_RGBA, 0, 0, -4, 4, 0), GL_INVALID_VALUE),
      REJECT("3.7.2", glCopyTexImage2D(t, 0, kNoEnum, 0, 0, 4, 4, 0), GL_INVALID_ENUM, GL_INVALID_VALUE),
  });
}

// 3.7.2: the format of a subimage must match the image's.
TEST_F(TextureErrors, SubImageFormat) {
  MESA_DISAGREES("3.7.2", "a subimage of another base format is converted");
  const std::vector<GLubyte> texels(64);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  reject(
      {REJECT("3.7.2", glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, texels.data()),
              GL_INVALID_OPERATION),
       REJECT("3.7.2",
              glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_ALPHA, GL_UNSIGNED_BYTE, texels.data()),
              GL_INVALID_OPERATION)});
}

// 3.7.3, 3.7.4, OES_compressed_paletted_texture
TEST_F(TextureErrors, CompressedImages) {
  const std::vector<GLubyte> data(4096);
  const void* p = data.data();
  const GLenum t = GL_TEXTURE_2D, f = GL_PALETTE4_RGB8_OES;
  const GLsizei size = 16 * 3 + 8;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(t, name);
  reject({
      REJECT("3.7.3", glCompressedTexImage2D(kNoEnum, 0, f, 4, 4, 0, size, p), GL_INVALID_ENUM),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, GL_RGBA, 4, 4, 0, 64, p), GL_INVALID_ENUM),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, kNoEnum, 4, 4, 0, 64, p), GL_INVALID_ENUM),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, f, 4, 4, 0, size - 1, p), GL_INVALID_VALUE),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, f, 4, 4, 0, size + 1, p), GL_INVALID_VALUE),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, f, 4, 4, 0, -1, p), GL_INVALID_VALUE),
      REJECT("3.7.3", glCompressedTexImage2D(t, 0, f, -4, 4, 0, size, p), GL_INVALID_VALUE),
      REJECT("3.7.4", glCompressedTexImage2D(t, 1, f, 4, 4, 0, size, p), GL_INVALID_VALUE),
      REJECT("3.7.4", glCompressedTexImage2D(t, -1, f, 4, 4, 0, size, p), GL_INVALID_VALUE),
      REJECT("3.7.4", glCompressedTexImage2D(t, 0, f, 4, 4, 1, size, p), GL_INVALID_VALUE,
             GL_INVALID_OPERATION),
      REJECT("3.7.4",
             glTexImage2D(t, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, GL_PALETTE4_RGB8_OES, GL_UNSIGNED_BYTE, p),
             GL_INVALID_VALUE, GL_INVALID_OPERATION, GL_INVALID_ENUM),
  });
  glCompressedTexImage2D(t, 0, f, 4, 4, 0, size, p);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  reject({REJECT("3.7.3", glCompressedTexSubImage2D(kNoEnum, 0, 0, 0, 4, 4, f, 8, p), GL_INVALID_ENUM)});
}

// 3.7.4: a paletted image has no subimages.
TEST_F(TextureErrors, PalettedSubImages) {
  MESA_DISAGREES("3.7.4", "the paletted formats are no enumerant of the command");
  const std::vector<GLubyte> data(4096);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, 56, data.data());
  for (GLenum format = GL_PALETTE4_RGB8_OES; format <= GL_PALETTE8_RGB5_A1_OES; ++format) {
    reject({REJECT("3.7.4", glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, format, 8, data.data()),
                   GL_INVALID_OPERATION)});
  }
}

}  // namespace
}  // namespace conformance
