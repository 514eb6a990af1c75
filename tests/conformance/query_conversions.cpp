// Section 6.1.2: what a Get command makes of a value of another type, and what is clamped or converted when
// it is set.
#include <bit>
#include <cmath>
#include <limits>

#include "harness.h"
#include "state_tables.h"

namespace conformance {
namespace {

class QueryConversions : public GlTest {};

// 6.1.2: GetBooleanv is FALSE only for zero.
TEST_F(QueryConversions, ToBoolean) {
  GLboolean values[4] = {7, 7, 7, 7};
  glColor4f(0, 0.001f, -3, 1e-30f);
  glGetBooleanv(GL_CURRENT_COLOR, values);
  EXPECT_EQ(std::vector<GLboolean>(values, values + 4),
            (std::vector<GLboolean>{GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE}));
  glViewport(0, 3, 0, 5);
  glGetBooleanv(GL_VIEWPORT, values);
  EXPECT_EQ(std::vector<GLboolean>(values, values + 4),
            (std::vector<GLboolean>{GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE}));
  glGetBooleanv(GL_MATRIX_MODE, values);
  EXPECT_EQ(values[0], GL_TRUE);
}

// 6.1.2: floats are rounded to the nearest integer.
TEST_F(QueryConversions, RoundingToInteger) {
  const struct {
    GLfloat given;
    GLint expected;
  } rows[] = {{0.25f, 0},   {0.75f, 1},   {1.49f, 1},    {1.51f, 2},
              {-0.75f, -1}, {-1.25f, -1}, {100.7f, 101}, {-100.7f, -101}};
  for (const auto& row : rows) {
    glFogf(GL_FOG_START, row.given);
    EXPECT_EQ(integer(GL_FOG_START), row.expected) << row.given;
    glPolygonOffset(row.given, -row.given);
    EXPECT_EQ(integer(GL_POLYGON_OFFSET_FACTOR), row.expected) << row.given;
    EXPECT_EQ(integer(GL_POLYGON_OFFSET_UNITS), -row.expected) << row.given;
  }
  glLineWidth(2.6f);
  EXPECT_EQ(integer(GL_LINE_WIDTH), 3);
}

// 6.1.2: the elements of a matrix are no colours, they are rounded.
TEST_F(QueryConversions, RoundingMatrixToInteger) {
  MESA_DISAGREES("6.1.2", "matrix elements are mapped as colours are");
  glTranslatef(1.6f, -2.6f, 0.4f);
  const std::vector<GLint> matrix = integers(GL_MODELVIEW_MATRIX, 16);
  EXPECT_EQ(matrix[12], 2);
  EXPECT_EQ(matrix[13], -3);
  EXPECT_EQ(matrix[14], 0);
}

// 6.1.2: colours, normals, DepthRange and the depth clear value map [-1, 1] linearly onto the integers; 4.1.4:
// the reference value of the alpha test is converted like an A component.
TEST_F(QueryConversions, LinearMappingToInteger) {
  const double most = std::numeric_limits<GLint>::max();
  glColor4f(1, 0, -1, 0.5f);
  const std::vector<GLint> color = integers(GL_CURRENT_COLOR, 4);
  EXPECT_NEAR(color[0], most, 128);
  EXPECT_NEAR(color[1], 0, 1);
  EXPECT_NEAR(color[2], -most, 128);
  EXPECT_NEAR(color[3], most / 2, 128);
  glNormal3f(1, 0, -0.5f);
  const std::vector<GLint> normal = integers(GL_CURRENT_NORMAL, 3);
  EXPECT_NEAR(normal[0], most, 128);
  EXPECT_NEAR(normal[1], 0, 1);
  EXPECT_NEAR(normal[2], -most / 2, 128);
  glDepthRangef(0.25f, 1);
  const std::vector<GLint> range = integers(GL_DEPTH_RANGE, 2);
  EXPECT_NEAR(range[0], most / 4, 128);
  EXPECT_NEAR(range[1], most, 128);
  glClearDepthf(0.5f);
  EXPECT_NEAR(integer(GL_DEPTH_CLEAR_VALUE), most / 2, 128);
  for (const GLfloat reference : {0.0f, 0.25f, 0.5f, 1.0f}) {
    glAlphaFunc(GL_GREATER, reference);
    EXPECT_NEAR(integer(GL_ALPHA_TEST_REF), reference * most, 128);
  }
  const GLfloat fog[] = {1, 0.5f, 0.25f, 0};
  glFogfv(GL_FOG_COLOR, fog);
  const std::vector<GLint> fogColor = integers(GL_FOG_COLOR, 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(fogColor[static_cast<std::size_t>(i)], fog[i] * most, 128);
  glClearColor(1, 0.5f, 0.25f, 0);
  const std::vector<GLint> clear = integers(GL_COLOR_CLEAR_VALUE, 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(clear[static_cast<std::size_t>(i)], fog[i] * most, 128);
}

// 6.1.2, 2.3: GetFixedv scales integers and floats, not enumerated values; too large a value saturates.
TEST_F(QueryConversions, ToFixed) {
  EXPECT_EQ(fixed(GL_MODELVIEW_STACK_DEPTH), 65536);
  EXPECT_EQ(fixed(GL_UNPACK_ALIGNMENT), 4 * 65536);
  EXPECT_EQ(fixed(GL_RED_BITS), 8 * 65536);
  EXPECT_EQ(fixed(GL_DITHER), 65536);
  glFogf(GL_FOG_START, 1.5f);
  EXPECT_EQ(fixed(GL_FOG_START), 98304);
  glFogf(GL_FOG_START, -0.25f);
  EXPECT_EQ(fixed(GL_FOG_START), -16384);
  glFogf(GL_FOG_START, 1e9f);
  EXPECT_EQ(fixed(GL_FOG_START), std::numeric_limits<GLint>::max());
  glFogf(GL_FOG_START, -1e9f);
  EXPECT_EQ(fixed(GL_FOG_START), std::numeric_limits<GLint>::min());
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// 6.1.2: enumerated values are converted to fixed without scaling.
TEST_F(QueryConversions, EnumeratedToFixed) {
  MESA_DISAGREES("6.1.2", "enumerated values are scaled by 2^16");
  EXPECT_EQ(fixed(GL_MATRIX_MODE), GL_MODELVIEW);
  EXPECT_EQ(fixed(GL_SHADE_MODEL), GL_SMOOTH);
  EXPECT_EQ(fixed(GL_FOG_MODE), GL_EXP);
  EXPECT_EQ(fixed(GL_DEPTH_FUNC), GL_LESS);
  EXPECT_EQ(fixed(GL_ACTIVE_TEXTURE), GL_TEXTURE0);
  EXPECT_EQ(fixed(GL_VERTEX_ARRAY_TYPE), GL_FLOAT);
}

// 6.1.2: GetFloatv coerces integers and enumerated values.
TEST_F(QueryConversions, ToFloat) {
  expectFloats({{NAMED(GL_MATRIX_MODE), {static_cast<GLfloat>(GL_MODELVIEW)}},
                {NAMED(GL_UNPACK_ALIGNMENT), {4}},
                {NAMED(GL_VIEWPORT), {0, 0, static_cast<GLfloat>(width()), static_cast<GLfloat>(height())}},
                {NAMED(GL_DITHER), {1}},
                {NAMED(GL_STENCIL_REF), {0}}});
}

// 2.3, OES_fixed_point: the x commands set the same state, value / 65536.
TEST_F(QueryConversions, FixedPointCommandsSetFloatState) {
  glColor4x(65536, 32768, -16384, 1);
  EXPECT_EQ(floats(GL_CURRENT_COLOR, 4), (std::vector<GLfloat>{1, 0.5f, -0.25f, 1.0f / 65536}));
  glColor4ub(255, 0, 51, 128);
  EXPECT_EQ(floats(GL_CURRENT_COLOR, 4), (std::vector<GLfloat>{1, 0, 51 / 255.0f, 128 / 255.0f}));
  glNormal3x(65536, -65536, 32768);
  EXPECT_EQ(floats(GL_CURRENT_NORMAL, 3), (std::vector<GLfloat>{1, -1, 0.5f}));
  glMultiTexCoord4x(GL_TEXTURE0, 65536, 2 * 65536, 32768, 4 * 65536);
  EXPECT_EQ(floats(GL_CURRENT_TEXTURE_COORDS, 4), (std::vector<GLfloat>{1, 2, 0.5f, 4}));
  glMultiTexCoord4f(GL_TEXTURE1, 1, 2, 3, 4);
  EXPECT_EQ(floats(GL_CURRENT_TEXTURE_COORDS, 4), (std::vector<GLfloat>{1, 2, 0.5f, 4})) << "unit 0's";
  glPointSizex(3 * 65536 + 32768);
  glLineWidthx(2 * 65536);
  glPolygonOffsetx(65536, -32768);
  glAlphaFuncx(GL_GREATER, 32768);
  glClearDepthx(16384);
  glDepthRangex(16384, 49152);
  glSampleCoveragex(32768, GL_TRUE);
  glFogx(GL_FOG_DENSITY, 32768);
  glFogx(GL_FOG_MODE, GL_LINEAR);
  glClearColorx(0, 16384, 32768, 65536);
  glLightModelx(GL_LIGHT_MODEL_TWO_SIDE, 65536);
  const GLfixed ambient[] = {0, 16384, 32768, 65536};
  glLightModelxv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glPointParameterx(GL_POINT_SIZE_MIN, 65536 / 4);
  const GLfixed attenuation[] = {65536, 32768, 16384};
  glPointParameterxv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  expectFloats({{NAMED(GL_POINT_SIZE), {3.5f}},
                {NAMED(GL_LINE_WIDTH), {2}},
                {NAMED(GL_POLYGON_OFFSET_FACTOR), {1}},
                {NAMED(GL_POLYGON_OFFSET_UNITS), {-0.5f}},
                {NAMED(GL_ALPHA_TEST_REF), {0.5f}},
                {NAMED(GL_DEPTH_CLEAR_VALUE), {0.25f}},
                {NAMED(GL_DEPTH_RANGE), {0.25f, 0.75f}},
                {NAMED(GL_SAMPLE_COVERAGE_VALUE), {0.5f}},
                {NAMED(GL_FOG_DENSITY), {0.5f}},
                {NAMED(GL_COLOR_CLEAR_VALUE), {0, 0.25f, 0.5f, 1}},
                {NAMED(GL_LIGHT_MODEL_AMBIENT), {0, 0.25f, 0.5f, 1}},
                {NAMED(GL_POINT_SIZE_MIN), {0.25f}},
                {NAMED(GL_POINT_DISTANCE_ATTENUATION), {1, 0.5f, 0.25f}}});
  expectIntegers({{NAMED(GL_FOG_MODE), {GL_LINEAR}},
                  {NAMED(GL_ALPHA_TEST_FUNC), {GL_GREATER}},
                  {NAMED(GL_SAMPLE_COVERAGE_INVERT), {GL_TRUE}},
                  {NAMED(GL_LIGHT_MODEL_TWO_SIDE), {GL_TRUE}}});
}

// 2.7: the current colour is not clamped; 4.2.3, 3.8, 4.1.4, 3.7.12: these values are, when they are set.
TEST_F(QueryConversions, ClampedWhenSpecified) {
  MESA_DISAGREES("4.2.3, 3.8, 4.1.4, 3.7.12", "values are clamped when they are used");
  const GLfloat wide[] = {2, -1, 0.5f, 1.5f};
  glColor4f(2, -1, 0.5f, 1.5f);
  glClearColor(2, -1, 0.5f, 1.5f);
  glFogfv(GL_FOG_COLOR, wide);
  glAlphaFunc(GL_LESS, 1.5f);
  glClearDepthf(-2);
  glDepthRangef(-1, 3);
  glSampleCoverage(7, GL_FALSE);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, wide);
  expectFloats({{NAMED(GL_CURRENT_COLOR), {2, -1, 0.5f, 1.5f}},
                {NAMED(GL_COLOR_CLEAR_VALUE), {1, 0, 0.5f, 1}},
                {NAMED(GL_FOG_COLOR), {1, 0, 0.5f, 1}},
                {NAMED(GL_ALPHA_TEST_REF), {1}},
                {NAMED(GL_DEPTH_CLEAR_VALUE), {0}},
                {NAMED(GL_DEPTH_RANGE), {0, 1}},
                {NAMED(GL_SAMPLE_COVERAGE_VALUE), {1}}});
  GLfloat color[4] = {};
  glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  EXPECT_EQ(std::vector<GLfloat>(color, color + 4), (std::vector<GLfloat>{1, 0, 0.5f, 1}));
}

// 2.10.1: the viewport is clamped to the implementation's maximum when it is specified.
TEST_F(QueryConversions, ViewportClamped) {
  const std::vector<GLint> most = integers(GL_MAX_VIEWPORT_DIMS, 2);
  glViewport(-5, -6, std::numeric_limits<GLint>::max(), std::numeric_limits<GLint>::max());
  expectIntegers({{NAMED(GL_VIEWPORT), {-5, -6, most[0], most[1]}}});
  glScissor(-5, -6, std::numeric_limits<GLint>::max(), 7);
  expectIntegers({{NAMED(GL_SCISSOR_BOX), {-5, -6, std::numeric_limits<GLint>::max(), 7}}});
}

// 6.1.2: *_MATRIX_FLOAT_AS_INT_BITS_OES are IEEE single bits.
TEST_F(QueryConversions, MatrixBits) {
  MESA_DISAGREES("6.1.2", "the three names are not accepted");
  std::vector<GLint> identity;
  for (GLfloat value : kIdentity) identity.push_back(std::bit_cast<GLint>(value));
  expectIntegers({{NAMED(GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES), identity},
                  {NAMED(GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES), identity},
                  {NAMED(GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES), identity}});
  GLfloat matrix[16];
  for (int i = 0; i < 16; ++i) matrix[i] = 1.0f / static_cast<GLfloat>(i + 3) - 0.2f;
  const std::array<std::array<GLenum, 2>, 3> stacks = {
      {{GL_MODELVIEW, GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES},
       {GL_PROJECTION, GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES},
       {GL_TEXTURE, GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES}}};
  for (const auto& [mode, name] : stacks) {
    glMatrixMode(mode);
    glLoadMatrixf(matrix);
    const std::vector<GLint> bits = integers(name, 16);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(bits[i], std::bit_cast<GLint>(matrix[i])) << i;
  }
}

}  // namespace
}  // namespace conformance
