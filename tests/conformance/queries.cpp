// Chapter 6: the initial value of every query of tables 6.3-6.24.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "harness.h"
#include "state_tables.h"

namespace conformance {
namespace {

class Queries : public GlTest {};

// Table 6.3
TEST_F(Queries, CurrentValues) {
  expectFloats({{NAMED(GL_CURRENT_COLOR), {1, 1, 1, 1}}, {NAMED(GL_CURRENT_NORMAL), {0, 0, 1}}});
  for (int unit = 0; unit < integer(GL_MAX_TEXTURE_UNITS); ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    expectFloats({{NAMED(GL_CURRENT_TEXTURE_COORDS), {0, 0, 0, 1}}});
  }
}

// Tables 6.4, 6.5
TEST_F(Queries, VertexArrays) {
  expectIntegers({{NAMED(GL_CLIENT_ACTIVE_TEXTURE), {GL_TEXTURE0}},
                  {NAMED(GL_VERTEX_ARRAY_SIZE), {4}},
                  {NAMED(GL_VERTEX_ARRAY_TYPE), {GL_FLOAT}},
                  {NAMED(GL_VERTEX_ARRAY_STRIDE), {0}},
                  {NAMED(GL_NORMAL_ARRAY_TYPE), {GL_FLOAT}},
                  {NAMED(GL_NORMAL_ARRAY_STRIDE), {0}},
                  {NAMED(GL_COLOR_ARRAY_SIZE), {4}},
                  {NAMED(GL_COLOR_ARRAY_TYPE), {GL_FLOAT}},
                  {NAMED(GL_COLOR_ARRAY_STRIDE), {0}},
                  {NAMED(GL_POINT_SIZE_ARRAY_TYPE_OES), {GL_FLOAT}},
                  {NAMED(GL_POINT_SIZE_ARRAY_STRIDE_OES), {0}},
                  {NAMED(GL_ARRAY_BUFFER_BINDING), {0}},
                  {NAMED(GL_VERTEX_ARRAY_BUFFER_BINDING), {0}},
                  {NAMED(GL_NORMAL_ARRAY_BUFFER_BINDING), {0}},
                  {NAMED(GL_COLOR_ARRAY_BUFFER_BINDING), {0}},
                  {NAMED(GL_POINT_SIZE_ARRAY_BUFFER_BINDING_OES), {0}},
                  {NAMED(GL_ELEMENT_ARRAY_BUFFER_BINDING), {0}}});
  expectEnables({{NAMED(GL_VERTEX_ARRAY), GL_FALSE},
                 {NAMED(GL_NORMAL_ARRAY), GL_FALSE},
                 {NAMED(GL_COLOR_ARRAY), GL_FALSE},
                 {NAMED(GL_POINT_SIZE_ARRAY_OES), GL_FALSE}});
  for (GLenum name : {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER,
                      GL_TEXTURE_COORD_ARRAY_POINTER, GL_POINT_SIZE_ARRAY_POINTER_OES}) {
    void* pointer = &name;
    glGetPointerv(name, &pointer);
    EXPECT_EQ(pointer, nullptr) << name;
  }
}

// Tables 6.4, 6.5: the texture coordinate arrays follow CLIENT_ACTIVE_TEXTURE (6.1.2).
TEST_F(Queries, TextureCoordinateArrays) {
  for (int unit = 0; unit < integer(GL_MAX_TEXTURE_UNITS); ++unit) {
    SCOPED_TRACE(unit);
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    expectIntegers({{NAMED(GL_TEXTURE_COORD_ARRAY_SIZE), {4}},
                    {NAMED(GL_TEXTURE_COORD_ARRAY_TYPE), {GL_FLOAT}},
                    {NAMED(GL_TEXTURE_COORD_ARRAY_STRIDE), {0}},
                    {NAMED(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING), {0}}});
    expectEnables({{NAMED(GL_TEXTURE_COORD_ARRAY), GL_FALSE}});
  }
  const GLshort data[4] = {};
  glClientActiveTexture(GL_TEXTURE1);
  glTexCoordPointer(2, GL_SHORT, 12, data);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  expectIntegers({{NAMED(GL_TEXTURE_COORD_ARRAY_SIZE), {2}},
                  {NAMED(GL_TEXTURE_COORD_ARRAY_TYPE), {GL_SHORT}},
                  {NAMED(GL_TEXTURE_COORD_ARRAY_STRIDE), {12}}});
  expectEnables({{NAMED(GL_TEXTURE_COORD_ARRAY), GL_TRUE}});
  void* pointer = nullptr;
  glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
  EXPECT_EQ(pointer, data);
  glClientActiveTexture(GL_TEXTURE0);
  expectIntegers({{NAMED(GL_TEXTURE_COORD_ARRAY_SIZE), {4}}});
  expectEnables({{NAMED(GL_TEXTURE_COORD_ARRAY), GL_FALSE}});
}

// Table 6.6
TEST_F(Queries, BufferObjects) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  EXPECT_FALSE(glIsBuffer(name)) << "a name is a buffer only once it is bound (6.1.6)";
  EXPECT_FALSE(glIsBuffer(0));
  for (GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
    glBindBuffer(target, name);
    EXPECT_TRUE(glIsBuffer(name));
    GLint value = -1;
    glGetBufferParameteriv(target, GL_BUFFER_SIZE, &value);
    EXPECT_EQ(value, 0);
    glGetBufferParameteriv(target, GL_BUFFER_USAGE, &value);
    EXPECT_EQ(value, GL_STATIC_DRAW);
  }
  glBufferData(GL_ARRAY_BUFFER, 24, nullptr, GL_DYNAMIC_DRAW);
  GLint value = -1;
  glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
  EXPECT_EQ(value, 24) << "one object bound to both targets";
  glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_USAGE, &value);
  EXPECT_EQ(value, GL_DYNAMIC_DRAW);
  glDeleteBuffers(1, &name);
  EXPECT_FALSE(glIsBuffer(name));
  EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), 0) << "deleting unbinds (2.9)";
  EXPECT_EQ(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
}

// Table 6.7
TEST_F(Queries, Transformation) {
  expectFloats({{NAMED(GL_MODELVIEW_MATRIX), kIdentity},
                {NAMED(GL_PROJECTION_MATRIX), kIdentity},
                {NAMED(GL_TEXTURE_MATRIX), kIdentity},
                {NAMED(GL_DEPTH_RANGE), {0, 1}}});
  expectIntegers({{NAMED(GL_VIEWPORT), {0, 0, width(), height()}},
                  {NAMED(GL_MODELVIEW_STACK_DEPTH), {1}},
                  {NAMED(GL_PROJECTION_STACK_DEPTH), {1}},
                  {NAMED(GL_TEXTURE_STACK_DEPTH), {1}},
                  {NAMED(GL_MATRIX_MODE), {GL_MODELVIEW}}});
  expectEnables({{NAMED(GL_NORMALIZE), GL_FALSE}, {NAMED(GL_RESCALE_NORMAL), GL_FALSE}});
  for (int i = 0; i < integer(GL_MAX_CLIP_PLANES); ++i) {
    const GLenum plane = GL_CLIP_PLANE0 + static_cast<GLenum>(i);
    GLfloat equation[4] = {9, 9, 9, 9};
    glGetClipPlanef(plane, equation);
    EXPECT_EQ(std::vector<GLfloat>(equation, equation + 4), (std::vector<GLfloat>{0, 0, 0, 0})) << i;
    GLfixed fixed[4] = {9, 9, 9, 9};
    glGetClipPlanex(plane, fixed);
    EXPECT_EQ(std::vector<GLfixed>(fixed, fixed + 4), (std::vector<GLfixed>{0, 0, 0, 0})) << i;
    EXPECT_FALSE(glIsEnabled(plane)) << i;
  }
}

// Table 6.8
TEST_F(Queries, FogAndShading) {
  expectFloats({{NAMED(GL_FOG_COLOR), {0, 0, 0, 0}},
                {NAMED(GL_FOG_DENSITY), {1}},
                {NAMED(GL_FOG_START), {0}},
                {NAMED(GL_FOG_END), {1}}});
  expectIntegers({{NAMED(GL_FOG_MODE), {GL_EXP}}, {NAMED(GL_SHADE_MODEL), {GL_SMOOTH}}});
  expectEnables({{NAMED(GL_FOG), GL_FALSE}});
}

// Tables 6.9, 6.10, 2.8
TEST_F(Queries, Lighting) {
  expectEnables({{NAMED(GL_LIGHTING), GL_FALSE}, {NAMED(GL_COLOR_MATERIAL), GL_FALSE}});
  expectIntegers({{NAMED(GL_LIGHT_MODEL_TWO_SIDE), {GL_FALSE}}});
  expectFloats({{NAMED(GL_LIGHT_MODEL_AMBIENT), {0.2f, 0.2f, 0.2f, 1}}});
  for (GLenum face : {GL_FRONT, GL_BACK}) {
    auto material = [&](GLenum name, std::vector<GLfloat> initial) {
      std::vector<GLfloat> values(initial.size(), kUntouchedFloat);
      glGetMaterialfv(face, name, values.data());
      EXPECT_EQ(values, initial) << name;
    };
    material(GL_AMBIENT, {0.2f, 0.2f, 0.2f, 1});
    material(GL_DIFFUSE, {0.8f, 0.8f, 0.8f, 1});
    material(GL_SPECULAR, {0, 0, 0, 1});
    material(GL_EMISSION, {0, 0, 0, 1});
    material(GL_SHININESS, {0});
  }
  for (int i = 0; i < integer(GL_MAX_LIGHTS); ++i) {
    SCOPED_TRACE(i);
    const GLenum light = GL_LIGHT0 + static_cast<GLenum>(i);
    const GLfloat on = i == 0 ? 1.0f : 0.0f;
    auto parameter = [&](GLenum name, std::vector<GLfloat> initial) {
      std::vector<GLfloat> values(initial.size() + 1, kUntouchedFloat);
      glGetLightfv(light, name, values.data());
      EXPECT_EQ(values.back(), kUntouchedFloat) << name;
      values.pop_back();
      EXPECT_EQ(values, initial) << name;
      std::vector<GLfixed> fixed(initial.size());
      glGetLightxv(light, name, fixed.data());
      for (std::size_t k = 0; k < fixed.size(); ++k)
        EXPECT_EQ(fixed[k], std::lround(initial[k] * 65536.0)) << name;
    };
    parameter(GL_AMBIENT, {0, 0, 0, 1});
    parameter(GL_DIFFUSE, {on, on, on, 1});
    parameter(GL_SPECULAR, {on, on, on, 1});
    parameter(GL_POSITION, {0, 0, 1, 0});
    parameter(GL_SPOT_DIRECTION, {0, 0, -1});
    parameter(GL_SPOT_EXPONENT, {0});
    parameter(GL_SPOT_CUTOFF, {180});
    parameter(GL_CONSTANT_ATTENUATION, {1});
    parameter(GL_LINEAR_ATTENUATION, {0});
    parameter(GL_QUADRATIC_ATTENUATION, {0});
    EXPECT_FALSE(glIsEnabled(light));
  }
}

// Tables 6.11, 6.12
TEST_F(Queries, Rasterization) {
  const GLfloat largest =
      std::max(floats(GL_ALIASED_POINT_SIZE_RANGE, 2)[1], floats(GL_SMOOTH_POINT_SIZE_RANGE, 2)[1]);
  expectFloats({{NAMED(GL_POINT_SIZE), {1}},
                {NAMED(GL_POINT_SIZE_MIN), {0}},
                {NAMED(GL_POINT_SIZE_MAX), {largest}},
                {NAMED(GL_POINT_FADE_THRESHOLD_SIZE), {1}},
                {NAMED(GL_POINT_DISTANCE_ATTENUATION), {1, 0, 0}},
                {NAMED(GL_LINE_WIDTH), {1}},
                {NAMED(GL_POLYGON_OFFSET_FACTOR), {0}},
                {NAMED(GL_POLYGON_OFFSET_UNITS), {0}},
                {NAMED(GL_SAMPLE_COVERAGE_VALUE), {1}}});
  expectIntegers({{NAMED(GL_CULL_FACE_MODE), {GL_BACK}}, {NAMED(GL_FRONT_FACE), {GL_CCW}}});
  expectEnables({{NAMED(GL_POINT_SMOOTH), GL_FALSE},
                 {NAMED(GL_POINT_SPRITE_OES), GL_FALSE},
                 {NAMED(GL_LINE_SMOOTH), GL_FALSE},
                 {NAMED(GL_CULL_FACE), GL_FALSE},
                 {NAMED(GL_POLYGON_OFFSET_FILL), GL_FALSE},
                 {NAMED(GL_MULTISAMPLE), GL_TRUE},
                 {NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE), GL_FALSE},
                 {NAMED(GL_SAMPLE_ALPHA_TO_ONE), GL_FALSE},
                 {NAMED(GL_SAMPLE_COVERAGE), GL_FALSE}});
  EXPECT_EQ(integer(GL_SAMPLE_COVERAGE_INVERT), GL_FALSE);
}

// Tables 6.13, 6.14
TEST_F(Queries, Textures) {
  for (int unit = 0; unit < integer(GL_MAX_TEXTURE_UNITS); ++unit) {
    SCOPED_TRACE(unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    expectEnables({{NAMED(GL_TEXTURE_2D), GL_FALSE}});
    expectIntegers({{NAMED(GL_TEXTURE_BINDING_2D), {0}}});
  }
  auto parameter = [](GLenum name, GLint initial) {
    GLint whole = -1;
    GLfixed fixed = -1;
    GLfloat real = -1;
    glGetTexParameteriv(GL_TEXTURE_2D, name, &whole);
    glGetTexParameterxv(GL_TEXTURE_2D, name, &fixed);
    glGetTexParameterfv(GL_TEXTURE_2D, name, &real);
    EXPECT_EQ(whole, initial) << name;
    // Enumerated values are not scaled (6.1.2); GENERATE_MIPMAP is FALSE.
    EXPECT_EQ(fixed, initial) << name;
    EXPECT_EQ(real, static_cast<GLfloat>(initial)) << name;
  };
  GLuint name = 0;
  glGenTextures(1, &name);
  EXPECT_FALSE(glIsTexture(name)) << "6.1.4: not before it is bound";
  EXPECT_FALSE(glIsTexture(0));
  for (GLuint texture : {GLuint{0}, name}) {
    glBindTexture(GL_TEXTURE_2D, texture);
    parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    parameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    parameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
    parameter(GL_TEXTURE_WRAP_T, GL_REPEAT);
    parameter(GL_GENERATE_MIPMAP, GL_FALSE);
  }
  EXPECT_TRUE(glIsTexture(name));
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), static_cast<GLint>(name));
  glDeleteTextures(1, &name);
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 0);
  EXPECT_FALSE(glIsTexture(name));
}

// Table 6.15
TEST_F(Queries, TextureEnvironment) {
  const std::vector<IntegerRow> rows = {
      {NAMED(GL_TEXTURE_ENV_MODE), {GL_MODULATE}}, {NAMED(GL_COMBINE_RGB), {GL_MODULATE}},
      {NAMED(GL_COMBINE_ALPHA), {GL_MODULATE}},    {NAMED(GL_SRC0_RGB), {GL_TEXTURE}},
      {NAMED(GL_SRC1_RGB), {GL_PREVIOUS}},         {NAMED(GL_SRC2_RGB), {GL_CONSTANT}},
      {NAMED(GL_SRC0_ALPHA), {GL_TEXTURE}},        {NAMED(GL_SRC1_ALPHA), {GL_PREVIOUS}},
      {NAMED(GL_SRC2_ALPHA), {GL_CONSTANT}},       {NAMED(GL_OPERAND0_RGB), {GL_SRC_COLOR}},
      {NAMED(GL_OPERAND1_RGB), {GL_SRC_COLOR}},    {NAMED(GL_OPERAND2_RGB), {GL_SRC_ALPHA}},
      {NAMED(GL_OPERAND0_ALPHA), {GL_SRC_ALPHA}},  {NAMED(GL_OPERAND1_ALPHA), {GL_SRC_ALPHA}},
      {NAMED(GL_OPERAND2_ALPHA), {GL_SRC_ALPHA}},
  };
  for (int unit = 0; unit < integer(GL_MAX_TEXTURE_UNITS); ++unit) {
    SCOPED_TRACE(unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    for (const IntegerRow& row : rows) {
      GLint whole = -1;
      GLfixed fixed = -1;
      GLfloat real = -1;
      glGetTexEnviv(GL_TEXTURE_ENV, row.value, &whole);
      glGetTexEnvxv(GL_TEXTURE_ENV, row.value, &fixed);
      glGetTexEnvfv(GL_TEXTURE_ENV, row.value, &real);
      EXPECT_EQ(whole, row.initial[0]) << row.name;
      EXPECT_EQ(fixed, row.initial[0]) << row.name;
      EXPECT_EQ(real, static_cast<GLfloat>(row.initial[0])) << row.name;
    }
    GLfloat color[4] = {9, 9, 9, 9}, scale = 9;
    glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    EXPECT_EQ(std::vector<GLfloat>(color, color + 4), (std::vector<GLfloat>{0, 0, 0, 0}));
    for (GLenum name : {GL_RGB_SCALE, GL_ALPHA_SCALE}) {
      GLfixed fixed = 9;
      glGetTexEnvfv(GL_TEXTURE_ENV, name, &scale);
      glGetTexEnvxv(GL_TEXTURE_ENV, name, &fixed);
      EXPECT_EQ(scale, 1.0f);
      EXPECT_EQ(fixed, 65536);
    }
    GLint replace = -1;
    glGetTexEnviv(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, &replace);
    EXPECT_EQ(replace, GL_FALSE);
  }
  expectIntegers({{NAMED(GL_ACTIVE_TEXTURE), {GL_TEXTURE0 + integer(GL_MAX_TEXTURE_UNITS) - 1}}});
  glActiveTexture(GL_TEXTURE0);
  expectIntegers({{NAMED(GL_ACTIVE_TEXTURE), {GL_TEXTURE0}}});
}

// Table 6.16
TEST_F(Queries, PixelOperations) {
  expectIntegers({{NAMED(GL_SCISSOR_BOX), {0, 0, width(), height()}},
                  {NAMED(GL_ALPHA_TEST_FUNC), {GL_ALWAYS}},
                  {NAMED(GL_ALPHA_TEST_REF), {0}},
                  {NAMED(GL_STENCIL_FUNC), {GL_ALWAYS}},
                  {NAMED(GL_STENCIL_REF), {0}},
                  {NAMED(GL_STENCIL_FAIL), {GL_KEEP}},
                  {NAMED(GL_STENCIL_PASS_DEPTH_FAIL), {GL_KEEP}},
                  {NAMED(GL_STENCIL_PASS_DEPTH_PASS), {GL_KEEP}},
                  {NAMED(GL_DEPTH_FUNC), {GL_LESS}},
                  {NAMED(GL_BLEND_SRC), {GL_ONE}},
                  {NAMED(GL_BLEND_DST), {GL_ZERO}},
                  {NAMED(GL_LOGIC_OP_MODE), {GL_COPY}}});
  // "1's": at least the bits of the stencil buffer.
  EXPECT_EQ(integer(GL_STENCIL_VALUE_MASK) & 0xff, 0xff);
  expectEnables({{NAMED(GL_SCISSOR_TEST), GL_FALSE},
                 {NAMED(GL_ALPHA_TEST), GL_FALSE},
                 {NAMED(GL_STENCIL_TEST), GL_FALSE},
                 {NAMED(GL_DEPTH_TEST), GL_FALSE},
                 {NAMED(GL_BLEND), GL_FALSE},
                 {NAMED(GL_DITHER), GL_TRUE},
                 {NAMED(GL_COLOR_LOGIC_OP), GL_FALSE}});
}

// Tables 6.17, 6.18, 6.19, 6.24
TEST_F(Queries, FramebufferControlPixelsHints) {
  GLboolean mask[4] = {};
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  for (GLboolean bit : mask) EXPECT_EQ(bit, GL_TRUE);
  GLboolean depthMask = GL_FALSE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask);
  EXPECT_EQ(depthMask, GL_TRUE);
  EXPECT_EQ(integer(GL_STENCIL_WRITEMASK) & 0xff, 0xff);
  expectFloats({{NAMED(GL_COLOR_CLEAR_VALUE), {0, 0, 0, 0}}, {NAMED(GL_DEPTH_CLEAR_VALUE), {1}}});
  expectIntegers({{NAMED(GL_STENCIL_CLEAR_VALUE), {0}},
                  {NAMED(GL_UNPACK_ALIGNMENT), {4}},
                  {NAMED(GL_PACK_ALIGNMENT), {4}},
                  {NAMED(GL_PERSPECTIVE_CORRECTION_HINT), {GL_DONT_CARE}},
                  {NAMED(GL_POINT_SMOOTH_HINT), {GL_DONT_CARE}},
                  {NAMED(GL_LINE_SMOOTH_HINT), {GL_DONT_CARE}},
                  {NAMED(GL_FOG_HINT), {GL_DONT_CARE}},
                  {NAMED(GL_GENERATE_MIPMAP_HINT), {GL_DONT_CARE}}});
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Tables 6.20-6.23
TEST_F(Queries, Limits) {
  EXPECT_GE(integer(GL_MAX_LIGHTS), 8);
  EXPECT_GE(integer(GL_MAX_CLIP_PLANES), 1);
  EXPECT_GE(integer(GL_MAX_MODELVIEW_STACK_DEPTH), 16);
  EXPECT_GE(integer(GL_MAX_PROJECTION_STACK_DEPTH), 2);
  EXPECT_GE(integer(GL_MAX_TEXTURE_STACK_DEPTH), 2);
  EXPECT_GE(integer(GL_SUBPIXEL_BITS), 4);
  EXPECT_GE(integer(GL_MAX_TEXTURE_SIZE), 64);
  EXPECT_GE(integer(GL_MAX_TEXTURE_UNITS), 2);
  EXPECT_LE(integer(GL_MAX_TEXTURE_UNITS), 32);
  for (GLint side : integers(GL_MAX_VIEWPORT_DIMS, 2)) EXPECT_GE(side, width());
  for (GLenum name : {GL_ALIASED_POINT_SIZE_RANGE, GL_SMOOTH_POINT_SIZE_RANGE, GL_ALIASED_LINE_WIDTH_RANGE,
                      GL_SMOOTH_LINE_WIDTH_RANGE}) {
    const std::vector<GLfloat> range = floats(name, 2);
    EXPECT_GT(range[0], 0) << name;
    EXPECT_LE(range[0], 1) << name;
    EXPECT_GE(range[1], 1) << name;
  }
  EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 0);
  EXPECT_EQ(integer(GL_SAMPLES), 0);
  for (GLenum name : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS}) EXPECT_EQ(integer(name), 8);
  EXPECT_GE(integer(GL_DEPTH_BITS), 24);
  EXPECT_GE(integer(GL_STENCIL_BITS), 8);
}

// The limits that this implementation promises (8 units, 8 planes, stacks of 32/4/10).
TEST_F(Queries, PromisedLimits) {
  MESA_DISAGREES("6.20", "the minima hold there, these are our own promises");
  EXPECT_EQ(integer(GL_MAX_TEXTURE_UNITS), 8);
  EXPECT_EQ(integer(GL_MAX_CLIP_PLANES), 8);
  EXPECT_GE(integer(GL_MAX_MODELVIEW_STACK_DEPTH), 32);
  EXPECT_GE(integer(GL_MAX_PROJECTION_STACK_DEPTH), 4);
  EXPECT_GE(integer(GL_MAX_TEXTURE_STACK_DEPTH), 10);
}

// Table 6.22, 3.7.3: the ten paletted formats are listed.
TEST_F(Queries, CompressedFormats) {
  const GLint count = integer(GL_NUM_COMPRESSED_TEXTURE_FORMATS);
  ASSERT_GE(count, 10);
  std::vector<GLint> listed = integers(GL_COMPRESSED_TEXTURE_FORMATS, static_cast<std::size_t>(count));
  for (GLint format = GL_PALETTE4_RGB8_OES; format <= GL_PALETTE8_RGB5_A1_OES; ++format) {
    EXPECT_NE(std::find(listed.begin(), listed.end(), format), listed.end()) << std::hex << format;
  }
}

// OES_read_format: the second pair is one of table 3.4.
TEST_F(Queries, ReadFormat) {
  const GLint format = integer(GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES);
  const GLint type = integer(GL_IMPLEMENTATION_COLOR_READ_TYPE_OES);
  std::vector<GLubyte> pixels(static_cast<std::size_t>(width()) * height() * 4);
  glReadPixels(0, 0, width(), height(), static_cast<GLenum>(format), static_cast<GLenum>(type),
               pixels.data());
  EXPECT_GL_ERROR(GL_NO_ERROR) << std::hex << format << " " << type;
}

// 6.1.5
TEST_F(Queries, Strings) {
  auto string = [](GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? std::string(reinterpret_cast<const char*>(text)) : std::string();
  };
  EXPECT_EQ(string(GL_VERSION).substr(0, 16), "OpenGL ES-CM 1.1");
  EXPECT_FALSE(string(GL_VENDOR).empty());
  EXPECT_FALSE(string(GL_RENDERER).empty());
  EXPECT_EQ(glGetString(GL_VERSION), glGetString(GL_VERSION)) << "a static string";
  for (const char* required :
       {"GL_OES_byte_coordinates", "GL_OES_fixed_point", "GL_OES_single_precision", "GL_OES_read_format",
        "GL_OES_query_matrix", "GL_OES_compressed_paletted_texture", "GL_OES_point_size_array",
        "GL_OES_point_sprite"}) {
    EXPECT_TRUE(hasExtension(required)) << required;
  }
}

// OES_query_matrix: mantissas and exponents give back the current matrix.
TEST_F(Queries, QueryMatrix) {
  const auto queryMatrix = reinterpret_cast<PFNGLQUERYMATRIXXOESPROC>(eglGetProcAddress("glQueryMatrixxOES"));
  ASSERT_NE(queryMatrix, nullptr);
  GLfloat matrix[16];
  for (int i = 0; i < 16; ++i)
    matrix[i] = static_cast<GLfloat>(std::ldexp(1.0 + i / 16.0, i * 3 - 20) * (i % 2 ? -1 : 1));
  matrix[5] = 0;
  glLoadMatrixf(matrix);
  GLfixed mantissa[16];
  GLint exponent[16];
  const GLbitfield status = queryMatrix(mantissa, exponent);
  EXPECT_EQ(status, 0u);
  for (int i = 0; i < 16; ++i) {
    const double value = std::ldexp(mantissa[i] / 65536.0, exponent[i]);
    EXPECT_NEAR(value, matrix[i], std::abs(matrix[i]) / 16384) << i;
  }
}

// OES_query_matrix: bit i of the status is set when component i is not a number that can be given.
TEST_F(Queries, QueryMatrixStatus) {
  const auto queryMatrix = reinterpret_cast<PFNGLQUERYMATRIXXOESPROC>(eglGetProcAddress("glQueryMatrixxOES"));
  ASSERT_NE(queryMatrix, nullptr);
  GLfloat matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  matrix[3] = std::numeric_limits<GLfloat>::quiet_NaN();
  matrix[9] = std::numeric_limits<GLfloat>::infinity();
  glLoadMatrixf(matrix);
  GLfixed mantissa[16];
  GLint exponent[16];
  EXPECT_EQ(queryMatrix(mantissa, exponent), (1u << 3) | (1u << 9));
}

// 6.1.3: GetLight gives eye coordinates, as the modelview of the time made them.
TEST_F(Queries, LightPositionInEyeCoordinates) {
  glTranslatef(10, 20, 30);
  glScalef(2, 2, 2);
  const GLfloat position[] = {1, 2, 3, 1}, direction[] = {0, 1, 0};
  glLightfv(GL_LIGHT3, GL_POSITION, position);
  glLightfv(GL_LIGHT3, GL_SPOT_DIRECTION, direction);
  glLoadIdentity();
  GLfloat values[4] = {};
  glGetLightfv(GL_LIGHT3, GL_POSITION, values);
  EXPECT_EQ(std::vector<GLfloat>(values, values + 4), (std::vector<GLfloat>{12, 24, 36, 1}));
  glGetLightfv(GL_LIGHT3, GL_SPOT_DIRECTION, values);
  // 2.12.2: the direction goes through the upper 3x3.
  EXPECT_EQ(std::vector<GLfloat>(values, values + 3), (std::vector<GLfloat>{0, 2, 0}));
}

// 2.11, 6.1.3: a plane is transformed by the inverse of the modelview when it is specified.
TEST_F(Queries, ClipPlaneInEyeCoordinates) {
  glTranslatef(1, 2, 3);
  const GLfloat plane[] = {1, 0, 0, 5};
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glLoadIdentity();
  GLfloat values[4] = {};
  glGetClipPlanef(GL_CLIP_PLANE0, values);
  EXPECT_EQ(std::vector<GLfloat>(values, values + 4), (std::vector<GLfloat>{1, 0, 0, 4}));
  GLfixed fixed[4] = {};
  glGetClipPlanex(GL_CLIP_PLANE0, fixed);
  EXPECT_EQ(std::vector<GLfixed>(fixed, fixed + 4), (std::vector<GLfixed>{65536, 0, 0, 4 * 65536}));
}

// 2.5: GetError gives the recorded code once; further errors do not change it.
TEST_F(Queries, FirstErrorIsKept) {
  glEnable(GL_POINTS);
  glLineWidth(-1);
  const GLenum first = glGetError();
  EXPECT_TRUE(first == GL_INVALID_ENUM || first == GL_INVALID_VALUE);
  while (glGetError() != GL_NO_ERROR) {
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
