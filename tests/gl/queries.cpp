// Tables 6.3 to 6.23: every state variable can be asked for in every type, and begins with the value of its
// table.

#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

struct Variable {
  const char* name;
  GLenum pname;
  std::vector<double> initial;  // as floats see it
};
#define VARIABLE(pname, ...) \
  {                          \
#pname, pname, {         \
      __VA_ARGS__            \
    }                        \
  }

const std::vector<double> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all = {
      // Table 6.3
      VARIABLE(GL_CURRENT_COLOR, 1, 1, 1, 1),
      VARIABLE(GL_CURRENT_TEXTURE_COORDS, 0, 0, 0, 1),
      VARIABLE(GL_CURRENT_NORMAL, 0, 0, 1),
      // Tables 6.4 and 6.5
      VARIABLE(GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0),
      VARIABLE(GL_VERTEX_ARRAY, 0),
      VARIABLE(GL_VERTEX_ARRAY_SIZE, 4),
      VARIABLE(GL_VERTEX_ARRAY_TYPE, GL_FLOAT),
      VARIABLE(GL_VERTEX_ARRAY_STRIDE, 0),
      VARIABLE(GL_NORMAL_ARRAY, 0),
      VARIABLE(GL_NORMAL_ARRAY_TYPE, GL_FLOAT),
      VARIABLE(GL_NORMAL_ARRAY_STRIDE, 0),
      VARIABLE(GL_COLOR_ARRAY, 0),
      VARIABLE(GL_COLOR_ARRAY_SIZE, 4),
      VARIABLE(GL_COLOR_ARRAY_TYPE, GL_FLOAT),
      VARIABLE(GL_COLOR_ARRAY_STRIDE, 0),
      VARIABLE(GL_TEXTURE_COORD_ARRAY, 0),
      VARIABLE(GL_TEXTURE_COORD_ARRAY_SIZE, 4),
      VARIABLE(GL_TEXTURE_COORD_ARRAY_TYPE, GL_FLOAT),
      VARIABLE(GL_TEXTURE_COORD_ARRAY_STRIDE, 0),
      VARIABLE(GL_POINT_SIZE_ARRAY_OES, 0),
      VARIABLE(GL_POINT_SIZE_ARRAY_TYPE_OES, GL_FLOAT),
      VARIABLE(GL_POINT_SIZE_ARRAY_STRIDE_OES, 0),
      VARIABLE(GL_ARRAY_BUFFER_BINDING, 0),
      VARIABLE(GL_VERTEX_ARRAY_BUFFER_BINDING, 0),
      VARIABLE(GL_NORMAL_ARRAY_BUFFER_BINDING, 0),
      VARIABLE(GL_COLOR_ARRAY_BUFFER_BINDING, 0),
      VARIABLE(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, 0),
      VARIABLE(GL_POINT_SIZE_ARRAY_BUFFER_BINDING_OES, 0),
      VARIABLE(GL_ELEMENT_ARRAY_BUFFER_BINDING, 0),
      // Table 6.7
      {"GL_MODELVIEW_MATRIX", GL_MODELVIEW_MATRIX, kIdentity},
      {"GL_PROJECTION_MATRIX", GL_PROJECTION_MATRIX, kIdentity},
      {"GL_TEXTURE_MATRIX", GL_TEXTURE_MATRIX, kIdentity},
      VARIABLE(GL_VIEWPORT, 0, 0, 64, 48),
      VARIABLE(GL_DEPTH_RANGE, 0, 1),
      VARIABLE(GL_MODELVIEW_STACK_DEPTH, 1),
      VARIABLE(GL_PROJECTION_STACK_DEPTH, 1),
      VARIABLE(GL_TEXTURE_STACK_DEPTH, 1),
      VARIABLE(GL_MATRIX_MODE, GL_MODELVIEW),
      VARIABLE(GL_NORMALIZE, 0),
      VARIABLE(GL_RESCALE_NORMAL, 0),
      VARIABLE(GL_CLIP_PLANE0, 0),
      // Tables 6.8 to 6.10
      VARIABLE(GL_FOG_COLOR, 0, 0, 0, 0),
      VARIABLE(GL_FOG_DENSITY, 1),
      VARIABLE(GL_FOG_START, 0),
      VARIABLE(GL_FOG_END, 1),
      VARIABLE(GL_FOG_MODE, GL_EXP),
      VARIABLE(GL_FOG, 0),
      VARIABLE(GL_SHADE_MODEL, GL_SMOOTH),
      VARIABLE(GL_LIGHTING, 0),
      VARIABLE(GL_COLOR_MATERIAL, 0),
      VARIABLE(GL_LIGHT_MODEL_AMBIENT, 0.2f, 0.2f, 0.2f, 1),
      VARIABLE(GL_LIGHT_MODEL_TWO_SIDE, 0),
      VARIABLE(GL_LIGHT0, 0),
      // Table 6.11
      VARIABLE(GL_POINT_SIZE, 1),
      VARIABLE(GL_POINT_SMOOTH, 0),
      VARIABLE(GL_POINT_SIZE_MIN, 0),
      VARIABLE(GL_POINT_SIZE_MAX, 64),
      VARIABLE(GL_POINT_FADE_THRESHOLD_SIZE, 1),
      VARIABLE(GL_POINT_DISTANCE_ATTENUATION, 1, 0, 0),
      VARIABLE(GL_POINT_SPRITE_OES, 0),
      VARIABLE(GL_LINE_WIDTH, 1),
      VARIABLE(GL_LINE_SMOOTH, 0),
      VARIABLE(GL_CULL_FACE, 0),
      VARIABLE(GL_CULL_FACE_MODE, GL_BACK),
      VARIABLE(GL_FRONT_FACE, GL_CCW),
      VARIABLE(GL_POLYGON_OFFSET_FACTOR, 0),
      VARIABLE(GL_POLYGON_OFFSET_UNITS, 0),
      VARIABLE(GL_POLYGON_OFFSET_FILL, 0),
      // Table 6.12
      VARIABLE(GL_MULTISAMPLE, 1),
      VARIABLE(GL_SAMPLE_ALPHA_TO_COVERAGE, 0),
      VARIABLE(GL_SAMPLE_ALPHA_TO_ONE, 0),
      VARIABLE(GL_SAMPLE_COVERAGE, 0),
      VARIABLE(GL_SAMPLE_COVERAGE_VALUE, 1),
      VARIABLE(GL_SAMPLE_COVERAGE_INVERT, 0),
      // Tables 6.13 and 6.15
      VARIABLE(GL_TEXTURE_2D, 0),
      VARIABLE(GL_TEXTURE_BINDING_2D, 0),
      VARIABLE(GL_ACTIVE_TEXTURE, GL_TEXTURE0),
      // Table 6.16
      VARIABLE(GL_SCISSOR_TEST, 0),
      VARIABLE(GL_SCISSOR_BOX, 0, 0, 64, 48),
      VARIABLE(GL_ALPHA_TEST, 0),
      VARIABLE(GL_ALPHA_TEST_FUNC, GL_ALWAYS),
      VARIABLE(GL_ALPHA_TEST_REF, 0),
      VARIABLE(GL_STENCIL_TEST, 0),
      VARIABLE(GL_STENCIL_FUNC, GL_ALWAYS),
      VARIABLE(GL_STENCIL_VALUE_MASK, -1),
      VARIABLE(GL_STENCIL_REF, 0),
      VARIABLE(GL_STENCIL_FAIL, GL_KEEP),
      VARIABLE(GL_STENCIL_PASS_DEPTH_FAIL, GL_KEEP),
      VARIABLE(GL_STENCIL_PASS_DEPTH_PASS, GL_KEEP),
      VARIABLE(GL_DEPTH_TEST, 0),
      VARIABLE(GL_DEPTH_FUNC, GL_LESS),
      VARIABLE(GL_BLEND, 0),
      VARIABLE(GL_BLEND_SRC, GL_ONE),
      VARIABLE(GL_BLEND_DST, GL_ZERO),
      VARIABLE(GL_DITHER, 1),
      VARIABLE(GL_COLOR_LOGIC_OP, 0),
      VARIABLE(GL_LOGIC_OP_MODE, GL_COPY),
      // Table 6.17
      VARIABLE(GL_COLOR_WRITEMASK, 1, 1, 1, 1),
      VARIABLE(GL_DEPTH_WRITEMASK, 1),
      VARIABLE(GL_STENCIL_WRITEMASK, -1),
      VARIABLE(GL_COLOR_CLEAR_VALUE, 0, 0, 0, 0),
      VARIABLE(GL_DEPTH_CLEAR_VALUE, 1),
      VARIABLE(GL_STENCIL_CLEAR_VALUE, 0),
      // Tables 6.18 and 6.19
      VARIABLE(GL_UNPACK_ALIGNMENT, 4),
      VARIABLE(GL_PACK_ALIGNMENT, 4),
      VARIABLE(GL_PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE),
      VARIABLE(GL_POINT_SMOOTH_HINT, GL_DONT_CARE),
      VARIABLE(GL_LINE_SMOOTH_HINT, GL_DONT_CARE),
      VARIABLE(GL_FOG_HINT, GL_DONT_CARE),
      VARIABLE(GL_GENERATE_MIPMAP_HINT, GL_DONT_CARE),
      // Tables 6.20 to 6.23
      VARIABLE(GL_MAX_LIGHTS, 8),
      VARIABLE(GL_MAX_CLIP_PLANES, 8),
      VARIABLE(GL_MAX_MODELVIEW_STACK_DEPTH, 32),
      VARIABLE(GL_MAX_PROJECTION_STACK_DEPTH, 32),
      VARIABLE(GL_MAX_TEXTURE_STACK_DEPTH, 10),
      VARIABLE(GL_SUBPIXEL_BITS, 4),
      VARIABLE(GL_MAX_TEXTURE_SIZE, 2048),
      VARIABLE(GL_MAX_VIEWPORT_DIMS, 2048, 2048),
      VARIABLE(GL_ALIASED_POINT_SIZE_RANGE, 1, 64),
      VARIABLE(GL_SMOOTH_POINT_SIZE_RANGE, 1, 32),
      VARIABLE(GL_ALIASED_LINE_WIDTH_RANGE, 1, 1),
      VARIABLE(GL_SMOOTH_LINE_WIDTH_RANGE, 1, 1),
      VARIABLE(GL_MAX_TEXTURE_UNITS, 8),
      VARIABLE(GL_SAMPLE_BUFFERS, 0),
      VARIABLE(GL_SAMPLES, 0),
      VARIABLE(GL_NUM_COMPRESSED_TEXTURE_FORMATS, 21),
      VARIABLE(GL_COMPRESSED_TEXTURE_FORMATS, GL_PALETTE4_RGB8_OES, GL_PALETTE4_RGBA8_OES,
               GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES, GL_PALETTE4_RGB5_A1_OES, GL_PALETTE8_RGB8_OES,
               GL_PALETTE8_RGBA8_OES, GL_PALETTE8_R5_G6_B5_OES, GL_PALETTE8_RGBA4_OES,
               GL_PALETTE8_RGB5_A1_OES, GL_ETC1_RGB8_OES, GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
               GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 0x83F2, 0x83F3, GL_3DC_X_AMD, GL_3DC_XY_AMD,
               GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG, GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG,
               GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG),
      VARIABLE(GL_RED_BITS, 8),
      VARIABLE(GL_GREEN_BITS, 8),
      VARIABLE(GL_BLUE_BITS, 8),
      VARIABLE(GL_ALPHA_BITS, 8),
      VARIABLE(GL_DEPTH_BITS, 24),
      VARIABLE(GL_STENCIL_BITS, 8),
  };
  return all;
}
#undef VARIABLE

class Queries : public GlTest {
 protected:
  GLfloat environment(GLenum pname) {
    GLfloat value[4] = {};
    glGetTexEnvfv(GL_TEXTURE_ENV, pname, value);
    return value[0];
  }
};

}  // namespace

TEST_F(Queries, EveryVariableBeginsAsItsTableSays) {
  for (const Variable& variable : variables()) {
    SCOPED_TRACE(variable.name);
    constexpr GLfloat kUntouched = -12345;
    GLfloat floats[24];
    std::fill(std::begin(floats), std::end(floats), kUntouched);
    glGetFloatv(variable.pname, floats);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    const size_t count = variable.initial.size();
    for (size_t i = 0; i < count; ++i) EXPECT_EQ(floats[i], static_cast<GLfloat>(variable.initial[i])) << i;
    EXPECT_EQ(floats[count], kUntouched);

    GLboolean booleans[24];
    glGetBooleanv(variable.pname, booleans);
    for (size_t i = 0; i < count; ++i) EXPECT_EQ(booleans[i] != GL_FALSE, variable.initial[i] != 0) << i;
  }
}

TEST_F(Queries, IntegersAndEnumsReadAsThemselves) {
  for (const Variable& variable : variables()) {
    const bool normalised = variable.pname == GL_CURRENT_COLOR || variable.pname == GL_CURRENT_NORMAL ||
                            variable.pname == GL_DEPTH_RANGE || variable.pname == GL_FOG_COLOR ||
                            variable.pname == GL_LIGHT_MODEL_AMBIENT ||
                            variable.pname == GL_COLOR_CLEAR_VALUE ||
                            variable.pname == GL_DEPTH_CLEAR_VALUE || variable.pname == GL_ALPHA_TEST_REF;
    if (normalised) continue;
    SCOPED_TRACE(variable.name);
    GLint integers[24] = {};
    glGetIntegerv(variable.pname, integers);
    for (size_t i = 0; i < variable.initial.size(); ++i) {
      EXPECT_EQ(integers[i], static_cast<GLint>(variable.initial[i])) << i;
    }
  }
}

TEST_F(Queries, NormalisedValuesFillTheRangeOfInt) {
  for (GLenum name : {GL_DEPTH_CLEAR_VALUE, GL_CURRENT_COLOR}) EXPECT_EQ(integer(name), 0x7FFFFFFF);
  for (GLenum name : {GL_FOG_COLOR, GL_DEPTH_RANGE}) EXPECT_EQ(integer(name), 0);
}

TEST_F(Queries, EnvironmentOfTable615) {
  EXPECT_EQ(environment(GL_TEXTURE_ENV_MODE), GL_MODULATE);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  EXPECT_EQ(environment(GL_COMBINE_ALPHA), GL_MODULATE);
  EXPECT_EQ(environment(GL_SRC0_RGB), GL_TEXTURE);
  EXPECT_EQ(environment(GL_SRC1_ALPHA), GL_PREVIOUS);
  EXPECT_EQ(environment(GL_SRC2_RGB), GL_CONSTANT);
  EXPECT_EQ(environment(GL_OPERAND1_RGB), GL_SRC_COLOR);
  EXPECT_EQ(environment(GL_OPERAND2_RGB), GL_SRC_ALPHA);
  EXPECT_EQ(environment(GL_OPERAND0_ALPHA), GL_SRC_ALPHA);
  EXPECT_EQ(environment(GL_RGB_SCALE), 1);
  EXPECT_EQ(environment(GL_ALPHA_SCALE), 1);
  GLint replace = 7;
  glGetTexEnviv(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, &replace);
  EXPECT_EQ(replace, 0);
}

TEST_F(Queries, EnvironmentsBelongToTheActiveUnit) {
  glActiveTexture(GL_TEXTURE5);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, GL_PRIMARY_COLOR);
  glTexEnvx(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  EXPECT_EQ(state().fixed.units[5].env.srcAlpha[2], GLenum{GL_PRIMARY_COLOR});
  EXPECT_TRUE(state().fixed.units[5].env.coordReplace);
  EXPECT_EQ(state().fixed.units[0].env.srcAlpha[2], GLenum{GL_CONSTANT});
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(environment(GL_SRC2_ALPHA), GL_CONSTANT);
}

TEST_F(Queries, LightsOfTable610) {
  GLfloat value[4];
  glGetLightfv(GL_LIGHT3, GL_SPOT_CUTOFF, value);
  EXPECT_EQ(value[0], 180);
  glGetLightfv(GL_LIGHT3, GL_CONSTANT_ATTENUATION, value);
  EXPECT_EQ(value[0], 1);
  GLfixed fixed[4];
  glGetLightxv(GL_LIGHT0, GL_DIFFUSE, fixed);
  EXPECT_EQ(fixed[0], 65536);
  glGetLightxv(GL_LIGHT1, GL_SPOT_DIRECTION, fixed);
  EXPECT_EQ(fixed[2], -65536);
  glGetMaterialxv(GL_BACK, GL_DIFFUSE, fixed);
  EXPECT_EQ(fixed[0], 52429);  // 0.8
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
