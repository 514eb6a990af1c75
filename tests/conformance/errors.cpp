// Section 2.5: enumerants that a command does not name, the error rules of rasterization, of chapter 4 and of
// queries, and what an error leaves alone.
#include "rejections.h"

namespace conformance {
namespace {

class Errors : public RejectionTest {};

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
