// What queries of chapter 6 read. Initial values and how they convert are conformance's: queries, query_conversions.

#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

class Queries : public GlTest {};

}  // namespace

TEST_F(Queries, EnvironmentsBelongToTheActiveUnit) {
  glActiveTexture(GL_TEXTURE5);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, GL_PRIMARY_COLOR);
  glTexEnvx(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  EXPECT_EQ(state().fixed.units[5].env.srcAlpha[2], GLenum{GL_PRIMARY_COLOR});
  EXPECT_TRUE(state().fixed.units[5].env.coordReplace);
  EXPECT_EQ(state().fixed.units[0].env.srcAlpha[2], GLenum{GL_CONSTANT});
  glActiveTexture(GL_TEXTURE0);
  GLint source = 0;
  glGetTexEnviv(GL_TEXTURE_ENV, GL_SRC2_ALPHA, &source);
  EXPECT_EQ(source, GL_CONSTANT);
}

TEST_F(Queries, PointersReadBack) {
  static const GLfloat data[4] = {};
  void* pointer = nullptr;
  glClientActiveTexture(GL_TEXTURE1);
  glTexCoordPointer(2, GL_FLOAT, 0, data);
  glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
  EXPECT_EQ(pointer, data);
  glClientActiveTexture(GL_TEXTURE0);
  glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
  EXPECT_EQ(pointer, nullptr);
  glPointSizePointerOES(GL_FIXED, 8, data);
  glGetPointerv(GL_POINT_SIZE_ARRAY_POINTER_OES, &pointer);
  EXPECT_EQ(pointer, data);
  EXPECT_EQ(integer(GL_POINT_SIZE_ARRAY_TYPE_OES), GL_FIXED);
  EXPECT_EQ(integer(GL_POINT_SIZE_ARRAY_STRIDE_OES), 8);
  glGetPointerv(GL_VERTEX_ARRAY, &pointer);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
}

}  // namespace anteroom::gl::test
