// Section 2.5: which commands err with what, and that they then change nothing.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

struct Case {
  std::string name;
  GLenum error;
  std::function<void()> command;
};

constexpr GLenum kBadEnum = 0x12345;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr GLfloat kFour[4] = {1, 2, 3, 4};
constexpr GLfixed kFixedFour[4] = {1, 2, 3, 4};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"active texture", GL_INVALID_ENUM, [] { glActiveTexture(GL_TEXTURE0 + 8); }},
      {"active texture below", GL_INVALID_ENUM, [] { glActiveTexture(GL_TEXTURE0 - 1); }},
      {"client active texture", GL_INVALID_ENUM, [] { glClientActiveTexture(GL_TEXTURE0 + 8); }},
      {"multi tex coord", GL_INVALID_ENUM, [] { glMultiTexCoord4f(GL_TEXTURE0 + 8, 1, 1, 1, 1); }},
      {"alpha func", GL_INVALID_ENUM, [] { glAlphaFunc(kBadEnum, 1); }},
      {"alpha func x", GL_INVALID_ENUM, [] { glAlphaFuncx(GL_ALWAYS + 1, 1); }},
      {"blend source", GL_INVALID_ENUM, [] { glBlendFunc(kBadEnum, GL_ONE); }},
      {"blend destination", GL_INVALID_ENUM, [] { glBlendFunc(GL_ONE, kBadEnum); }},
      {"blend saturate", GL_INVALID_ENUM, [] { glBlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE); }},
      {"clear bits", GL_INVALID_VALUE, [] { glClear(GL_COLOR_BUFFER_BIT | 1); }},
      {"clip plane", GL_INVALID_ENUM, [] { glClipPlanef(GL_CLIP_PLANE0 + 8, kFour); }},
      {"color pointer size", GL_INVALID_VALUE, [] { glColorPointer(3, GL_FLOAT, 0, nullptr); }},
      {"color pointer type", GL_INVALID_ENUM, [] { glColorPointer(4, GL_BYTE, 0, nullptr); }},
      {"vertex pointer size", GL_INVALID_VALUE, [] { glVertexPointer(1, GL_FLOAT, 0, nullptr); }},
      {"vertex pointer type", GL_INVALID_ENUM, [] { glVertexPointer(2, GL_UNSIGNED_BYTE, 0, nullptr); }},
      {"vertex pointer stride", GL_INVALID_VALUE, [] { glVertexPointer(2, GL_FLOAT, -1, nullptr); }},
      {"normal pointer type", GL_INVALID_ENUM, [] { glNormalPointer(GL_UNSIGNED_BYTE, 0, nullptr); }},
      {"point size pointer type", GL_INVALID_ENUM, [] { glPointSizePointerOES(GL_SHORT, 0, nullptr); }},
      {"tex coord pointer size", GL_INVALID_VALUE, [] { glTexCoordPointer(5, GL_FLOAT, 0, nullptr); }},
      {"cull face", GL_INVALID_ENUM, [] { glCullFace(GL_CCW); }},
      {"depth func", GL_INVALID_ENUM, [] { glDepthFunc(GL_NEVER - 1); }},
      {"enable", GL_INVALID_ENUM, [] { glEnable(GL_VERTEX_ARRAY); }},
      {"enable light", GL_INVALID_ENUM, [] { glEnable(GL_LIGHT0 + 8); }},
      {"disable", GL_INVALID_ENUM, [] { glDisable(kBadEnum); }},
      {"is enabled", GL_INVALID_ENUM, [] { EXPECT_FALSE(glIsEnabled(GL_CLIP_PLANE0 + 8)); }},
      {"enable client state", GL_INVALID_ENUM, [] { glEnableClientState(GL_LIGHTING); }},
      {"draw arrays mode", GL_INVALID_ENUM, [] { glDrawArrays(GL_TRIANGLE_FAN + 1, 0, 3); }},
      {"draw arrays first", GL_INVALID_VALUE, [] { glDrawArrays(GL_TRIANGLES, -1, 3); }},
      {"draw arrays count", GL_INVALID_VALUE, [] { glDrawArrays(GL_TRIANGLES, 0, -1); }},
      {"draw elements mode", GL_INVALID_ENUM,
       [] { glDrawElements(GL_TRIANGLE_FAN + 1, 3, GL_UNSIGNED_BYTE, kFour); }},
      {"draw elements type", GL_INVALID_ENUM, [] { glDrawElements(GL_TRIANGLES, 3, GL_SHORT, kFour); }},
      {"draw elements count", GL_INVALID_VALUE,
       [] { glDrawElements(GL_TRIANGLES, -3, GL_UNSIGNED_BYTE, kFour); }},
      {"fog scalar color", GL_INVALID_ENUM, [] { glFogf(GL_FOG_COLOR, 1); }},
      {"fog mode", GL_INVALID_ENUM, [] { glFogf(GL_FOG_MODE, GL_REPLACE); }},
      {"fog mode nan", GL_INVALID_ENUM, [] { glFogf(GL_FOG_MODE, kNan); }},
      {"fog density", GL_INVALID_VALUE, [] { glFogf(GL_FOG_DENSITY, -1); }},
      {"front face", GL_INVALID_ENUM, [] { glFrontFace(GL_BACK); }},
      {"frustum near", GL_INVALID_VALUE, [] { glFrustumf(-1, 1, -1, 1, 0, 1); }},
      {"frustum far", GL_INVALID_VALUE, [] { glFrustumf(-1, 1, -1, 1, 1, -1); }},
      {"frustum width", GL_INVALID_VALUE, [] { glFrustumf(1, 1, -1, 1, 1, 2); }},
      {"frustum nan", GL_INVALID_VALUE, [] { glFrustumf(-1, 1, -1, 1, kNan, 2); }},
      {"ortho height", GL_INVALID_VALUE, [] { glOrthof(-1, 1, 2, 2, 1, 2); }},
      {"ortho depth", GL_INVALID_VALUE, [] { glOrthox(-1, 1, 2, 3, 2, 2); }},
      {"hint target", GL_INVALID_ENUM, [] { glHint(kBadEnum, GL_FASTEST); }},
      {"hint mode", GL_INVALID_ENUM, [] { glHint(GL_FOG_HINT, GL_NICEST + 1); }},
      {"light number", GL_INVALID_ENUM, [] { glLightfv(GL_LIGHT0 + 8, GL_AMBIENT, kFour); }},
      {"light scalar", GL_INVALID_ENUM, [] { glLightf(GL_LIGHT0, GL_AMBIENT, 1); }},
      {"light pname", GL_INVALID_ENUM, [] { glLightfv(GL_LIGHT0, GL_EMISSION, kFour); }},
      {"light exponent", GL_INVALID_VALUE, [] { glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5f); }},
      {"light cutoff", GL_INVALID_VALUE, [] { glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91); }},
      {"light cutoff x", GL_INVALID_VALUE, [] { glLightx(GL_LIGHT0, GL_SPOT_CUTOFF, -1); }},
      {"light attenuation", GL_INVALID_VALUE, [] { glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1); }},
      {"light attenuation nan", GL_INVALID_VALUE, [] { glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, kNan); }},
      {"light model", GL_INVALID_ENUM, [] { glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1); }},
      {"material face", GL_INVALID_ENUM, [] { glMaterialfv(GL_FRONT, GL_AMBIENT, kFour); }},
      {"material shininess", GL_INVALID_VALUE, [] { glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, -1); }},
      {"material scalar", GL_INVALID_ENUM, [] { glMaterialx(GL_FRONT_AND_BACK, GL_EMISSION, 1); }},
      {"line width", GL_INVALID_VALUE, [] { glLineWidth(0); }},
      {"line width nan", GL_INVALID_VALUE, [] { glLineWidth(kNan); }},
      {"logic op", GL_INVALID_ENUM, [] { glLogicOp(GL_SET + 1); }},
      {"matrix mode", GL_INVALID_ENUM, [] { glMatrixMode(GL_TEXTURE_2D); }},
      {"point size", GL_INVALID_VALUE, [] { glPointSizex(0); }},
      {"point parameter", GL_INVALID_VALUE, [] { glPointParameterf(GL_POINT_SIZE_MIN, -1); }},
      {"point parameter scalar", GL_INVALID_ENUM,
       [] { glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1); }},
      {"pop matrix", GL_STACK_UNDERFLOW, [] { glPopMatrix(); }},
      {"scissor", GL_INVALID_VALUE, [] { glScissor(0, 0, -1, 1); }},
      {"viewport", GL_INVALID_VALUE, [] { glViewport(0, 0, 1, -1); }},
      {"shade model", GL_INVALID_ENUM, [] { glShadeModel(GL_LINE_SMOOTH); }},
      {"stencil func", GL_INVALID_ENUM, [] { glStencilFunc(GL_KEEP, 1, 1); }},
      {"stencil op", GL_INVALID_ENUM, [] { glStencilOp(GL_KEEP, GL_ZERO, GL_ALWAYS); }},
      {"tex env target", GL_INVALID_ENUM, [] { glTexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_ADD); }},
      {"tex env mode", GL_INVALID_ENUM, [] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_SUBTRACT); }},
      {"tex env color", GL_INVALID_ENUM, [] { glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1); }},
      {"tex env scale", GL_INVALID_VALUE, [] { glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3); }},
      {"tex env scale x", GL_INVALID_VALUE, [] { glTexEnvx(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 2); }},
      {"combine alpha", GL_INVALID_ENUM, [] { glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB); }},
      {"combine operand", GL_INVALID_ENUM,
       [] { glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR); }},
      {"combine source", GL_INVALID_ENUM, [] { glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE_2D); }},
      {"sprite", GL_INVALID_ENUM, [] { glTexEnvi(GL_POINT_SPRITE_OES, GL_TEXTURE_ENV_MODE, GL_ADD); }},
      {"tex gen coord", GL_INVALID_ENUM,
       [] { glTexGeniOES(GL_TEXTURE_2D, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES); }},
      {"tex gen mode", GL_INVALID_ENUM,
       [] { glTexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_LINEAR); }},
      {"get string", GL_INVALID_ENUM, [] { EXPECT_EQ(glGetString(GL_AMBIENT), nullptr); }},
      {"clip plane x", GL_INVALID_ENUM, [] { glClipPlanex(GL_CLIP_PLANE0 - 1, kFixedFour); }},
  };
  return all;
}

class Errors : public GlTest {};

}  // namespace

TEST_F(Errors, IsSetAndTheStateIsUntouched) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    changed() = 0;
    one.command();
    EXPECT_EQ(glGetError(), one.error);
    EXPECT_EQ(changed(), 0u);
  }
  EXPECT_TRUE(renderer().draws.empty());
  EXPECT_TRUE(renderer().clears.empty());
}

TEST_F(Errors, TheFirstStays) {
  glLineWidth(-1);
  glEnable(kBadEnum);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Errors, QueriesLeaveTheResultAlone) {
  GLfloat value = 7;
  glGetFloatv(kBadEnum, &value);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
  glGetLightfv(GL_LIGHT0, GL_SHININESS, &value);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
  glGetMaterialfv(GL_FRONT_AND_BACK, GL_SHININESS, &value);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
  glGetTexEnvfv(GL_TEXTURE_ENV, GL_COORD_REPLACE_OES, &value);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(value, 7);
}

TEST_F(Errors, NullParametersAreIgnored) {
  glLightfv(GL_LIGHT0, GL_POSITION, nullptr);
  glMaterialxv(GL_FRONT_AND_BACK, GL_AMBIENT, nullptr);
  glFogfv(GL_FOG_COLOR, nullptr);
  glLoadMatrixf(nullptr);
  glMultMatrixx(nullptr);
  glClipPlanef(GL_CLIP_PLANE0, nullptr);
  glTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, nullptr);
  glGetIntegerv(GL_MAX_LIGHTS, nullptr);
  glGetPointerv(GL_VERTEX_ARRAY_POINTER, nullptr);
}

TEST(ErrorsWithoutContext, CommandsDoNothing) {
  for (const Case& one : cases()) one.command();
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(glGetString(GL_VERSION), nullptr);
}

TEST_F(Errors, NoFramebufferNoDrawing) {
  setDefaultFramebuffer(*context, nullptr);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glDrawArrays(GL_POINTS, 0, 1);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  EXPECT_EQ(integer(GL_RED_BITS), 0);
  EXPECT_TRUE(renderer().draws.empty());
  EXPECT_TRUE(renderer().clears.empty());
}

}  // namespace anteroom::gl::test
