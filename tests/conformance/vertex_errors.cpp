// Chapter 2: the error rules of arrays, buffer objects, matrices, lighting and materials.
#include <limits>

#include "rejections.h"

namespace conformance {
namespace {

class VertexErrors : public RejectionTest {};

// 2.8, 2.9
TEST_F(VertexErrors, VertexArrays) {
  const GLfloat data[16] = {};
  const GLushort indices[4] = {};
  reject({
      REJECT("2.8", glVertexPointer(1, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glVertexPointer(5, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glVertexPointer(-1, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glVertexPointer(3, GL_UNSIGNED_BYTE, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glVertexPointer(3, GL_UNSIGNED_SHORT, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glVertexPointer(3, GL_FLOAT, -1, data), GL_INVALID_VALUE)
          .notMesa("the array is changed all the same"),
      REJECT("2.8", glNormalPointer(GL_UNSIGNED_BYTE, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glNormalPointer(GL_FLOAT, -4, data), GL_INVALID_VALUE)
          .notMesa("the array is changed all the same"),
      REJECT("2.8", glColorPointer(3, GL_UNSIGNED_BYTE, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glColorPointer(5, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glColorPointer(4, GL_BYTE, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glColorPointer(4, GL_SHORT, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glColorPointer(4, GL_FLOAT, -1, data), GL_INVALID_VALUE)
          .notMesa("the array is changed all the same"),
      REJECT("2.8", glTexCoordPointer(1, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glTexCoordPointer(5, GL_FLOAT, 0, data), GL_INVALID_VALUE),
      REJECT("2.8", glTexCoordPointer(2, GL_UNSIGNED_BYTE, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glTexCoordPointer(2, GL_FLOAT, -1, data), GL_INVALID_VALUE)
          .notMesa("the array is changed all the same"),
      REJECT("2.8", glPointSizePointerOES(GL_SHORT, 0, data), GL_INVALID_ENUM),
      REJECT("2.8", glPointSizePointerOES(GL_FLOAT, -1, data), GL_INVALID_VALUE)
          .notMesa("the array is changed all the same"),
      REJECT("2.8", glClientActiveTexture(GL_TEXTURE0 + integer(GL_MAX_TEXTURE_UNITS)), GL_INVALID_ENUM),
      REJECT("2.8", glClientActiveTexture(GL_TEXTURE0 - 1), GL_INVALID_ENUM),
      REJECT("2.10.2", glActiveTexture(GL_TEXTURE0 + integer(GL_MAX_TEXTURE_UNITS)), GL_INVALID_ENUM)
          .notMesa("a unit beyond the maximum is accepted"),
      REJECT("2.10.2", glActiveTexture(0), GL_INVALID_ENUM),
      REJECT("2.8", glDrawArrays(7, 0, 3), GL_INVALID_ENUM),
      REJECT("2.5", glDrawArrays(GL_TRIANGLES, 0, -1), GL_INVALID_VALUE),
      REJECT("2.8", glDrawArrays(GL_TRIANGLES, -1, 3), GL_INVALID_VALUE)
          .notMesa("no error without a vertex array"),
      REJECT("2.8", glDrawElements(7, 3, GL_UNSIGNED_SHORT, indices), GL_INVALID_ENUM),
      REJECT("2.5", glDrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_SHORT, indices), GL_INVALID_VALUE),
      REJECT("2.8", glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, indices), GL_INVALID_ENUM),
      REJECT("2.8", glDrawElements(GL_TRIANGLES, 3, GL_SHORT, indices), GL_INVALID_ENUM),
  });
}

// 2.9
TEST_F(VertexErrors, BufferObjects) {
  GLuint buffer = 0, names[2] = {};
  GLint value = 0;
  glGenBuffers(1, &buffer);
  // No text gives a code for the buffer calls with 0 bound; OpenGL 1.5 has INVALID_OPERATION.
  reject({
      REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW), GL_INVALID_OPERATION),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, 0, 4, kFloats), GL_INVALID_OPERATION),
      REJECT("2.9", glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value), GL_INVALID_OPERATION),
  });
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 16, nullptr, GL_STATIC_DRAW);
  reject({
      REJECT("2.9", glBindBuffer(GL_TEXTURE_2D, buffer), GL_INVALID_ENUM),
      REJECT("2.9", glBufferData(GL_TEXTURE_2D, 4, nullptr, GL_STATIC_DRAW), GL_INVALID_ENUM),
      REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW), GL_INVALID_VALUE),
      REJECT("2.9", glBufferSubData(kNoEnum, 0, 4, kFloats), GL_INVALID_ENUM),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, -1, 4, kFloats), GL_INVALID_VALUE),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, 0, -1, kFloats), GL_INVALID_VALUE),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, 13, 4, kFloats), GL_INVALID_VALUE),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, 17, 0, kFloats), GL_INVALID_VALUE),
      REJECT("2.9", glBufferSubData(GL_ARRAY_BUFFER, std::numeric_limits<GLintptr>::max(), 8, kFloats),
             GL_INVALID_VALUE)
          .notMesa("the sum overflows and it crashes"),
      REJECT("2.9", glGenBuffers(-1, names), GL_INVALID_VALUE),
      REJECT("2.9", glDeleteBuffers(-1, names), GL_INVALID_VALUE),
      REJECT("6.1.3", glGetBufferParameteriv(kNoEnum, GL_BUFFER_SIZE, &value), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetBufferParameteriv(GL_ARRAY_BUFFER, kNoEnum, &value), GL_INVALID_ENUM),
  });
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
  EXPECT_EQ(value, 16);
}

// 2.9, Table 2.5: only STATIC_DRAW and DYNAMIC_DRAW.
TEST_F(VertexErrors, BufferUsage) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  constexpr GLenum kStaticRead = 0x88E5;
  reject({REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, 4, nullptr, kNoEnum), GL_INVALID_ENUM),
          REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, 4, nullptr, kStaticRead), GL_INVALID_ENUM)});
}

// 2.10.2
TEST_F(VertexErrors, Matrices) {
  reject({
      REJECT("2.10.2", glFrustumf(-1, 1, -1, 1, 0, 10), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(-1, 1, -1, 1, -1, 10), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(-1, 1, -1, 1, 1, 0), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(-1, 1, -1, 1, 1, -1), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(-1, 1, -1, 1, 2, 2), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(1, 1, -1, 1, 1, 10), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumf(-1, 1, 2, 2, 1, 10), GL_INVALID_VALUE),
      REJECT("2.10.2", glOrthof(1, 1, -1, 1, -1, 1), GL_INVALID_VALUE),
      REJECT("2.10.2", glOrthof(-1, 1, 1, 1, -1, 1), GL_INVALID_VALUE),
      REJECT("2.10.2", glOrthof(-1, 1, -1, 1, 1, 1), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumx(-65536, 65536, -65536, 65536, 0, 655360), GL_INVALID_VALUE),
      REJECT("2.10.2", glFrustumx(65536, 65536, -65536, 65536, 65536, 655360), GL_INVALID_VALUE),
      REJECT("2.10.2", glOrthox(65536, 65536, 0, 65536, 0, 65536), GL_INVALID_VALUE),
      REJECT("2.10.2", glPopMatrix(), GL_STACK_UNDERFLOW),
  });
  for (GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
    const GLenum depthName = mode == GL_MODELVIEW    ? GL_MAX_MODELVIEW_STACK_DEPTH
                             : mode == GL_PROJECTION ? GL_MAX_PROJECTION_STACK_DEPTH
                                                     : GL_MAX_TEXTURE_STACK_DEPTH;
    glMatrixMode(mode);
    for (GLint depth = 1; depth < integer(depthName); ++depth) glPushMatrix();
    EXPECT_GL_ERROR(GL_NO_ERROR);
    glTranslatef(1, 2, 3);
    reject({REJECT("2.10.2", glPushMatrix(), GL_STACK_OVERFLOW)});
    for (GLint depth = 1; depth < integer(depthName); ++depth) glPopMatrix();
    reject({REJECT("2.10.2", glPopMatrix(), GL_STACK_UNDERFLOW)});
  }
}

// 2.12.2, Tables 2.8, 2.9
TEST_F(VertexErrors, Lighting) {
  const GLfloat negative[4] = {-1, -1, -1, -1}, large[4] = {129, 0, 0, 0}, cutoff[4] = {91, 0, 0, 0};
  const GLfixed negativex[4] = {-65536, 0, 0, 0};
  const GLenum beyond = GL_LIGHT0 + static_cast<GLenum>(integer(GL_MAX_LIGHTS));
  GLfloat f[4];
  GLfixed x[4];
  reject({
      REJECT("2.12.2", glMaterialf(GL_FRONT, GL_SHININESS, 1), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialfv(GL_BACK, GL_AMBIENT, kFloats), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialx(GL_FRONT, GL_SHININESS, 65536), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialxv(kNoEnum, GL_AMBIENT, kFixed), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialf(GL_FRONT_AND_BACK, GL_AMBIENT, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("2.12.2", glMaterialx(GL_FRONT_AND_BACK, GL_DIFFUSE, 65536), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialfv(GL_FRONT_AND_BACK, GL_POSITION, kFloats), GL_INVALID_ENUM),
      REJECT("2.12.2", glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, -0.5f), GL_INVALID_VALUE),
      REJECT("2.12.2", glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 128.5f), GL_INVALID_VALUE),
      REJECT("2.12.2", glMaterialfv(GL_FRONT_AND_BACK, GL_SHININESS, large), GL_INVALID_VALUE),
      REJECT("2.12.2", glMaterialx(GL_FRONT_AND_BACK, GL_SHININESS, -1), GL_INVALID_VALUE),
      REJECT("2.12.2", glMaterialxv(GL_FRONT_AND_BACK, GL_SHININESS, negativex), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(beyond, GL_SPOT_CUTOFF, 10), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightfv(beyond, GL_AMBIENT, kFloats), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightf(GL_LIGHT0 - 1, GL_SPOT_CUTOFF, 10), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_POSITION, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("2.12.2", glLightx(GL_LIGHT0, GL_AMBIENT, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("2.12.2", glLightfv(GL_LIGHT0, GL_SHININESS, kFloats), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.01f), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90.5f), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 179), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, -0.1f), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -0.1f), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -0.1f), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightfv(GL_LIGHT0, GL_CONSTANT_ATTENUATION, negative), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightx(GL_LIGHT0, GL_SPOT_EXPONENT, -1), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightxv(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, negativex), GL_INVALID_VALUE),
      REJECT("2.12.2", glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("2.12.2", glLightModelx(GL_LIGHT_MODEL_AMBIENT, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("2.12.2", glLightModelf(kNoEnum, 1), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightModelfv(GL_AMBIENT, kFloats), GL_INVALID_ENUM),
      REJECT("2.12.2", glLightModelxv(kNoEnum, kFixed), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetLightfv(beyond, GL_AMBIENT, f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetLightfv(GL_LIGHT0, GL_SHININESS, f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetLightxv(beyond, GL_AMBIENT, x), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetMaterialxv(GL_FRONT_AND_BACK, GL_AMBIENT, x), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetMaterialfv(GL_FRONT, GL_POSITION, f), GL_INVALID_ENUM),
  });
}

}  // namespace
}  // namespace conformance
