// Section 2.5 and the error rules of every command: the error that the text names, and no state changed by
// it.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "harness.h"
#include "state_snapshot.h"

namespace conformance {
namespace {

constexpr GLenum kNoEnum = 0x9999;
constexpr GLfloat kFloats[16] = {1, 1, 1, 1};
constexpr GLfixed kFixed[16] = {65536, 65536, 65536, 65536};

struct Rejected {
  const char* section;
  const char* text;
  std::function<void()> call;
  // More than one where texts contradict each other or name no code (see the row's section).
  std::vector<GLenum> errors;
  const char* mesaDeparts = nullptr;

  // The row is left out on Mesa, which departs from its section in this way.
  Rejected notMesa(const char* how) && {
    mesaDeparts = how;
    return std::move(*this);
  }
};

// A command that must be rejected: its section, the command, the error or errors that are right.
#define REJECT(section, call, ...)   \
  Rejected {                         \
    section, #call, [&] { call; }, { \
      __VA_ARGS__                    \
    }                                \
  }

class Errors : public GlTest {
 protected:
  void reject(const std::vector<Rejected>& rows) {
    for (const Rejected& row : rows) {
      if (onMesa() && row.mesaDeparts) {
        fmt::print("    Mesa departs from section {}, {}: {}\n", row.section, row.text, row.mesaDeparts);
        continue;
      }
      const StateSnapshot before = takeSnapshot();
      ASSERT_GL_ERROR(GL_NO_ERROR);
      row.call();
      const GLenum error = glGetError();
      EXPECT_TRUE(std::find(row.errors.begin(), row.errors.end(), error) != row.errors.end())
          << row.section << ": " << row.text << " gave " << errorName(error) << ", want "
          << errorName(row.errors[0]);
      EXPECT_EQ(difference(before, takeSnapshot()), "")
          << row.section << ": " << row.text << " changed state";
      while (glGetError() != GL_NO_ERROR) {
      }
    }
  }
};

GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

// 2.5: an enumerant that the command does not name.
TEST_F(Errors, UnknownEnumerants) {
  GLint i[16];
  GLfloat f[16];
  GLfixed x[16];
  GLboolean b[16];
  void* p = nullptr;
  reject({
      REJECT("2.5", glEnable(kNoEnum), GL_INVALID_ENUM),
      REJECT("2.5", glDisable(kNoEnum), GL_INVALID_ENUM),
      REJECT("2.5", glEnable(GL_LIGHT0 + integer(GL_MAX_LIGHTS)), GL_INVALID_ENUM),
      REJECT("2.5", glEnable(GL_CLIP_PLANE0 + integer(GL_MAX_CLIP_PLANES)), GL_INVALID_ENUM),
      REJECT("2.8", glEnable(GL_VERTEX_ARRAY), GL_INVALID_ENUM).notMesa("accepted"),
      REJECT("2.8", glEnableClientState(GL_LIGHTING), GL_INVALID_ENUM),
      REJECT("2.8", glDisableClientState(kNoEnum), GL_INVALID_ENUM),
      REJECT("4.1.4", glAlphaFunc(kNoEnum, 0), GL_INVALID_ENUM),
      REJECT("4.1.4", glAlphaFuncx(kNoEnum, 0), GL_INVALID_ENUM),
      REJECT("4.1.7", glBlendFunc(kNoEnum, GL_ONE), GL_INVALID_ENUM),
      REJECT("4.1.7", glBlendFunc(GL_ONE, kNoEnum), GL_INVALID_ENUM),
      REJECT("4.1.7", glBlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE), GL_INVALID_ENUM),
      REJECT("3.5.1", glCullFace(kNoEnum), GL_INVALID_ENUM),
      REJECT("4.1.6", glDepthFunc(kNoEnum), GL_INVALID_ENUM),
      REJECT("2.12.1", glFrontFace(GL_FRONT), GL_INVALID_ENUM),
      REJECT("5.2", glHint(GL_FOG, GL_NICEST), GL_INVALID_ENUM),
      REJECT("5.2", glHint(GL_FOG_HINT, kNoEnum), GL_INVALID_ENUM),
      REJECT("4.1.9", glLogicOp(GL_ADD), GL_INVALID_ENUM),
      REJECT("2.10.2", glMatrixMode(GL_MODELVIEW_MATRIX), GL_INVALID_ENUM),
      REJECT("2.12.6", glShadeModel(kNoEnum), GL_INVALID_ENUM),
      REJECT("4.1.5", glStencilFunc(kNoEnum, 0, 0), GL_INVALID_ENUM),
      REJECT("4.1.5", glStencilOp(kNoEnum, GL_KEEP, GL_KEEP), GL_INVALID_ENUM),
      REJECT("4.1.5", glStencilOp(GL_KEEP, kNoEnum, GL_KEEP), GL_INVALID_ENUM),
      REJECT("4.1.5", glStencilOp(GL_KEEP, GL_KEEP, kNoEnum), GL_INVALID_ENUM),
      REJECT("3.6.1", glPixelStorei(kNoEnum, 1), GL_INVALID_ENUM),
      REJECT("6.1.1", glGetBooleanv(kNoEnum, b), GL_INVALID_ENUM),
      REJECT("6.1.1", glGetIntegerv(kNoEnum, i), GL_INVALID_ENUM),
      REJECT("6.1.1", glGetFloatv(kNoEnum, f), GL_INVALID_ENUM),
      REJECT("6.1.1", glGetFixedv(kNoEnum, x), GL_INVALID_ENUM),
      REJECT("6.1.1", EXPECT_FALSE(glIsEnabled(kNoEnum)), GL_INVALID_ENUM),
      REJECT("6.1.1", EXPECT_FALSE(glIsEnabled(GL_LIGHT_MODEL_TWO_SIDE)), GL_INVALID_ENUM),
      REJECT("6.1.5", glGetPointerv(GL_VERTEX_ARRAY, &p), GL_INVALID_ENUM),
      REJECT("6.1.5", EXPECT_EQ(glGetString(kNoEnum), nullptr), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetClipPlanef(GL_CLIP_PLANE0 + integer(GL_MAX_CLIP_PLANES), f), GL_INVALID_ENUM),
      REJECT("6.1.3", glGetClipPlanex(kNoEnum, x), GL_INVALID_ENUM),
      REJECT("2.11", glClipPlanef(GL_CLIP_PLANE0 + integer(GL_MAX_CLIP_PLANES), kFloats), GL_INVALID_ENUM),
      REJECT("2.11", glClipPlanex(kNoEnum, kFixed), GL_INVALID_ENUM),
  });
}

// 2.8, 2.9
TEST_F(Errors, VertexArrays) {
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
TEST_F(Errors, BufferObjects) {
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
TEST_F(Errors, BufferUsage) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  constexpr GLenum kStaticRead = 0x88E5;
  reject({REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, 4, nullptr, kNoEnum), GL_INVALID_ENUM),
          REJECT("2.9", glBufferData(GL_ARRAY_BUFFER, 4, nullptr, kStaticRead), GL_INVALID_ENUM)});
}

// 2.10.2
TEST_F(Errors, Matrices) {
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
TEST_F(Errors, Lighting) {
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

// 2.10.1, 3.3, 3.4, 4.1.2, 4.2.3, 3.6.1
TEST_F(Errors, Rasterization) {
  const GLfloat negative[3] = {-1, 0, 0};
  reject({
      REJECT("2.10.1", glViewport(0, 0, -1, 5), GL_INVALID_VALUE),
      REJECT("2.10.1", glViewport(0, 0, 5, -1), GL_INVALID_VALUE),
      REJECT("4.1.2", glScissor(0, 0, -1, 5), GL_INVALID_VALUE),
      REJECT("4.1.2", glScissor(0, 0, 5, -1), GL_INVALID_VALUE),
      REJECT("3.3", glPointSize(0), GL_INVALID_VALUE),
      REJECT("3.3", glPointSize(-1), GL_INVALID_VALUE),
      REJECT("3.3", glPointSizex(0), GL_INVALID_VALUE),
      REJECT("3.4", glLineWidth(0), GL_INVALID_VALUE),
      REJECT("3.4", glLineWidth(-2), GL_INVALID_VALUE),
      REJECT("3.4", glLineWidthx(-1), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterf(GL_POINT_SIZE_MIN, -1), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterf(GL_POINT_SIZE_MAX, -1), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, -1), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterx(GL_POINT_SIZE_MAX, -1), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterfv(GL_POINT_SIZE_MIN, negative), GL_INVALID_VALUE),
      REJECT("3.3", glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("3.3", glPointParameterx(GL_POINT_DISTANCE_ATTENUATION, 1), GL_INVALID_ENUM)
          .notMesa("one value of several is set"),
      REJECT("3.3", glPointParameterf(GL_POINT_SIZE, 1), GL_INVALID_ENUM),
      REJECT("3.3", glPointParameterfv(kNoEnum, kFloats), GL_INVALID_ENUM),
      REJECT("3.3", glPointParameterxv(kNoEnum, kFixed), GL_INVALID_ENUM),
      REJECT("4.2.3", glClear(1), GL_INVALID_VALUE),
      REJECT("4.2.3", glClear(GL_COLOR_BUFFER_BIT | 0x00000200), GL_INVALID_VALUE),
      REJECT("3.6.1", glPixelStorei(GL_UNPACK_ALIGNMENT, 0), GL_INVALID_VALUE),
      REJECT("3.6.1", glPixelStorei(GL_UNPACK_ALIGNMENT, 3), GL_INVALID_VALUE),
      REJECT("3.6.1", glPixelStorei(GL_PACK_ALIGNMENT, 16), GL_INVALID_VALUE),
      REJECT("3.6.1", glPixelStorei(GL_PACK_ALIGNMENT, -4), GL_INVALID_VALUE),
      REJECT("3.8", glFogf(GL_FOG_DENSITY, -1), GL_INVALID_VALUE),
      REJECT("3.8", glFogfv(GL_FOG_DENSITY, negative), GL_INVALID_VALUE),
      REJECT("3.8", glFogx(GL_FOG_DENSITY, -1), GL_INVALID_VALUE),
      REJECT("3.8", glFogf(GL_FOG_MODE, GL_NEAREST), GL_INVALID_ENUM),
      REJECT("3.8", glFogx(GL_FOG_MODE, GL_NEAREST), GL_INVALID_ENUM),
      REJECT("3.8", glFogf(GL_FOG_COLOR, 1), GL_INVALID_ENUM).notMesa("one value of several is set"),
      REJECT("3.8", glFogx(GL_FOG_COLOR, 65536), GL_INVALID_ENUM).notMesa("one value of several is set"),
      REJECT("3.8", glFogf(kNoEnum, 1), GL_INVALID_ENUM),
      REJECT("3.8", glFogfv(kNoEnum, kFloats), GL_INVALID_ENUM),
      REJECT("3.8", glFogxv(kNoEnum, kFixed), GL_INVALID_ENUM),
  });
}

// 3.7.12
TEST_F(Errors, TextureEnvironment) {
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
TEST_F(Errors, ScalarEnvironmentColor) {
  reject({REJECT("3.7.12", glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1), GL_INVALID_ENUM)
              .notMesa("one value of several is set"),
          REJECT("3.7.12", glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1), GL_INVALID_ENUM)
              .notMesa("one value of several is set"),
          REJECT("3.7.12", glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 65536), GL_INVALID_ENUM)});
}

// 3.7.5, 3.7.11, 6.1.3
TEST_F(Errors, TextureParametersAndObjects) {
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
TEST_F(Errors, TextureImages) {
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
TEST_F(Errors, SubImageFormat) {
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
TEST_F(Errors, CompressedImages) {
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
TEST_F(Errors, PalettedSubImages) {
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

// 4.3.1
TEST_F(Errors, ReadPixels) {
  std::vector<GLubyte> pixels(64 * 64 * 4, 0xcd);
  const std::vector<GLubyte> untouched = pixels;
  reject({
      REJECT("2.5", glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data()), GL_INVALID_VALUE),
      REJECT("2.5", glReadPixels(0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data()), GL_INVALID_VALUE),
      // 4.3.1 accepts only two combinations and names no code for the others.
      REJECT("4.3.1", glReadPixels(0, 0, 1, 1, kNoEnum, GL_UNSIGNED_BYTE, pixels.data()), GL_INVALID_ENUM,
             GL_INVALID_OPERATION)
          .notMesa("INVALID_VALUE"),
      REJECT("4.3.1", glReadPixels(0, 0, 1, 1, GL_RGBA, GL_BYTE, pixels.data()), GL_INVALID_ENUM,
             GL_INVALID_OPERATION),
      REJECT("4.3.1", glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels.data()),
             GL_INVALID_ENUM, GL_INVALID_OPERATION)
          .notMesa("every format is accepted"),
  });
  EXPECT_EQ(pixels, untouched);
}

// 2.5: a draw that is rejected leaves the framebuffer as it is.
TEST_F(Errors, RejectedDrawWritesNothing) {
  const GLfloat positions[] = {-1, -1, 3, -1, -1, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glDrawArrays(7, 0, 3);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  const GLubyte indices[] = {0, 1, 2};
  glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, indices);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_PIXEL(32, 32, {0, 0, 0, 0}, 0);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | 1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_PIXEL(32, 32, {0, 0, 0, 0}, 0);
}

// Commands without any error of their own.
TEST_F(Errors, NoneWhereNoneIsNamed) {
  glColorMask(GL_FALSE, GL_TRUE, 7, GL_FALSE);
  glDepthMask(9);
  glStencilMask(0x12345678);
  glClearStencil(-1);
  glPolygonOffset(-1e30f, 1e30f);
  glDepthRangef(1, 0);
  glDepthRangef(5, -5);
  glSampleCoverage(-3, 5);
  glViewport(-100000, 100000, 0, 0);
  glScissor(-100000, 100000, 0, 0);
  glPointParameterf(GL_POINT_SIZE_MIN, 10);
  glPointParameterf(GL_POINT_SIZE_MAX, 5);
  glFogf(GL_FOG_START, 1);
  glFogf(GL_FOG_END, 1);
  glRotatef(90, 0, 0, 0);
  glScalef(0, 0, 0);
  glDrawArrays(GL_TRIANGLES, 0, 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawElements(GL_LINES, 0, GL_UNSIGNED_BYTE, nullptr);
  const GLuint unknown[] = {0, 12345, 777};
  glDeleteTextures(3, unknown);
  glDeleteBuffers(3, unknown);
  EXPECT_FALSE(glIsTexture(12345));
  EXPECT_FALSE(glIsBuffer(12345));
  glReadPixels(0, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glFlush();
  glFinish();
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
