// Every enumerated value of every command is accepted and given back by its query; every switch goes on and
// off.
#include <fmt/format.h>

#include <functional>

#include "harness.h"

namespace conformance {
namespace {

class StateSetting : public GlTest {
 protected:
  // set(value), then get() must give it; in the end the value that was there is set again.
  void roundTrip(const char* what, const std::vector<GLenum>& values, const std::function<void(GLenum)>& set,
                 const std::function<GLint()>& get) {
    const GLenum initial = static_cast<GLenum>(get());
    for (GLenum value : values) {
      set(value);
      EXPECT_EQ(get(), static_cast<GLint>(value)) << what << std::hex << " " << value;
      EXPECT_GL_ERROR(GL_NO_ERROR) << what << std::hex << " " << value;
    }
    set(initial);
    EXPECT_EQ(get(), static_cast<GLint>(initial)) << what;
  }
  static std::function<GLint()> query(GLenum name) {
    return [name] {
      GLint value = -1;
      glGetIntegerv(name, &value);
      return value;
    };
  }
};

const std::vector<GLenum> kComparisons = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                          GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
const std::vector<GLenum> kStencilOperations = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};

TEST_F(StateSetting, Fragments) {
  roundTrip(
      "AlphaFunc", kComparisons, [](GLenum v) { glAlphaFunc(v, 0.5f); }, query(GL_ALPHA_TEST_FUNC));
  roundTrip(
      "AlphaFuncx", kComparisons, [](GLenum v) { glAlphaFuncx(v, 32768); }, query(GL_ALPHA_TEST_FUNC));
  roundTrip(
      "DepthFunc", kComparisons, [](GLenum v) { glDepthFunc(v); }, query(GL_DEPTH_FUNC));
  roundTrip(
      "StencilFunc", kComparisons, [](GLenum v) { glStencilFunc(v, 3, 7); }, query(GL_STENCIL_FUNC));
  roundTrip(
      "StencilOp fail", kStencilOperations, [](GLenum v) { glStencilOp(v, GL_KEEP, GL_ZERO); },
      query(GL_STENCIL_FAIL));
  roundTrip(
      "StencilOp depth fail", kStencilOperations, [](GLenum v) { glStencilOp(GL_KEEP, v, GL_ZERO); },
      query(GL_STENCIL_PASS_DEPTH_FAIL));
  roundTrip(
      "StencilOp pass", kStencilOperations, [](GLenum v) { glStencilOp(GL_KEEP, GL_ZERO, v); },
      query(GL_STENCIL_PASS_DEPTH_PASS));
  roundTrip(
      "BlendFunc source",
      {GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
       GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA_SATURATE},
      [](GLenum v) { glBlendFunc(v, GL_ONE); }, query(GL_BLEND_SRC));
  roundTrip(
      "BlendFunc destination",
      {GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
       GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA},
      [](GLenum v) { glBlendFunc(GL_ONE, v); }, query(GL_BLEND_DST));
  std::vector<GLenum> operations;
  for (GLenum operation = GL_CLEAR; operation <= GL_SET; ++operation) operations.push_back(operation);
  roundTrip(
      "LogicOp", operations, [](GLenum v) { glLogicOp(v); }, query(GL_LOGIC_OP_MODE));
}

TEST_F(StateSetting, RasterizationAndHints) {
  roundTrip(
      "CullFace", {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}, [](GLenum v) { glCullFace(v); },
      query(GL_CULL_FACE_MODE));
  roundTrip(
      "FrontFace", {GL_CW, GL_CCW}, [](GLenum v) { glFrontFace(v); }, query(GL_FRONT_FACE));
  roundTrip(
      "ShadeModel", {GL_FLAT, GL_SMOOTH}, [](GLenum v) { glShadeModel(v); }, query(GL_SHADE_MODEL));
  roundTrip(
      "MatrixMode", {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}, [](GLenum v) { glMatrixMode(v); },
      query(GL_MATRIX_MODE));
  roundTrip(
      "Fogf", {GL_LINEAR, GL_EXP, GL_EXP2}, [](GLenum v) { glFogf(GL_FOG_MODE, static_cast<GLfloat>(v)); },
      query(GL_FOG_MODE));
  roundTrip(
      "Fogx", {GL_LINEAR, GL_EXP, GL_EXP2}, [](GLenum v) { glFogx(GL_FOG_MODE, static_cast<GLfixed>(v)); },
      query(GL_FOG_MODE));
  for (GLenum hint : {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_FOG_HINT,
                      GL_GENERATE_MIPMAP_HINT}) {
    roundTrip(
        "Hint", {GL_FASTEST, GL_NICEST, GL_DONT_CARE}, [=](GLenum v) { glHint(hint, v); }, query(hint));
  }
  for (GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) {
    roundTrip(
        "PixelStorei", {1, 2, 4, 8}, [=](GLenum v) { glPixelStorei(name, static_cast<GLint>(v)); },
        query(name));
  }
}

TEST_F(StateSetting, Textures) {
  const auto environment = [](GLenum name) {
    return [name] {
      GLint value = -1;
      glGetTexEnviv(GL_TEXTURE_ENV, name, &value);
      return value;
    };
  };
  const auto set = [](GLenum name) {
    return [name](GLenum v) { glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(v)); };
  };
  const auto setFixed = [](GLenum name) {
    return [name](GLenum v) { glTexEnvx(GL_TEXTURE_ENV, name, static_cast<GLfixed>(v)); };
  };
  const std::vector<GLenum> modes = {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE};
  const std::vector<GLenum> alphaFunctions = {GL_REPLACE,    GL_MODULATE,    GL_ADD,
                                              GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
  std::vector<GLenum> colorFunctions = alphaFunctions;
  colorFunctions.insert(colorFunctions.end(), {GL_DOT3_RGB, GL_DOT3_RGBA});
  roundTrip("mode", modes, set(GL_TEXTURE_ENV_MODE), environment(GL_TEXTURE_ENV_MODE));
  roundTrip("mode, fixed", modes, setFixed(GL_TEXTURE_ENV_MODE), environment(GL_TEXTURE_ENV_MODE));
  roundTrip("COMBINE_RGB", colorFunctions, set(GL_COMBINE_RGB), environment(GL_COMBINE_RGB));
  roundTrip("COMBINE_ALPHA", alphaFunctions, set(GL_COMBINE_ALPHA), environment(GL_COMBINE_ALPHA));
  for (GLenum i = 0; i < 3; ++i) {
    for (GLenum name : {GL_SRC0_RGB + i, GL_SRC0_ALPHA + i}) {
      roundTrip("source", {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}, set(name),
                environment(name));
    }
    roundTrip("operand", {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
              set(GL_OPERAND0_RGB + i), environment(GL_OPERAND0_RGB + i));
    roundTrip("alpha operand", {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}, set(GL_OPERAND0_ALPHA + i),
              environment(GL_OPERAND0_ALPHA + i));
  }
  for (GLenum name : {GL_RGB_SCALE, GL_ALPHA_SCALE})
    roundTrip("scale", {1, 2, 4}, set(name), environment(name));
  const auto parameter = [](GLenum name) {
    return [name] {
      GLint value = -1;
      glGetTexParameteriv(GL_TEXTURE_2D, name, &value);
      return value;
    };
  };
  const std::vector<GLenum> filters = {GL_NEAREST,
                                       GL_LINEAR,
                                       GL_NEAREST_MIPMAP_NEAREST,
                                       GL_LINEAR_MIPMAP_NEAREST,
                                       GL_NEAREST_MIPMAP_LINEAR,
                                       GL_LINEAR_MIPMAP_LINEAR};
  const struct {
    GLenum name;
    std::vector<GLenum> values;
  } rows[] = {{GL_TEXTURE_MIN_FILTER, filters},
              {GL_TEXTURE_MAG_FILTER, {GL_NEAREST, GL_LINEAR}},
              {GL_TEXTURE_WRAP_S, {GL_REPEAT, GL_CLAMP_TO_EDGE}},
              {GL_TEXTURE_WRAP_T, {GL_REPEAT, GL_CLAMP_TO_EDGE}},
              {GL_GENERATE_MIPMAP, {GL_TRUE, GL_FALSE}}};
  for (const auto& row : rows) {
    const GLenum name = row.name;
    roundTrip(
        "TexParameteri", row.values,
        [=](GLenum v) { glTexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(v)); }, parameter(name));
    roundTrip(
        "TexParameterf", row.values,
        [=](GLenum v) { glTexParameterf(GL_TEXTURE_2D, name, static_cast<GLfloat>(v)); }, parameter(name));
    roundTrip(
        "TexParameterx", row.values,
        [=](GLenum v) { glTexParameterx(GL_TEXTURE_2D, name, static_cast<GLfixed>(v)); }, parameter(name));
  }
}

TEST_F(StateSetting, Switches) {
  std::vector<GLenum> names = {GL_ALPHA_TEST,
                               GL_BLEND,
                               GL_COLOR_LOGIC_OP,
                               GL_COLOR_MATERIAL,
                               GL_CULL_FACE,
                               GL_DEPTH_TEST,
                               GL_DITHER,
                               GL_FOG,
                               GL_LIGHTING,
                               GL_LINE_SMOOTH,
                               GL_MULTISAMPLE,
                               GL_NORMALIZE,
                               GL_POINT_SMOOTH,
                               GL_POINT_SPRITE_OES,
                               GL_POLYGON_OFFSET_FILL,
                               GL_RESCALE_NORMAL,
                               GL_SAMPLE_ALPHA_TO_COVERAGE,
                               GL_SAMPLE_ALPHA_TO_ONE,
                               GL_SAMPLE_COVERAGE,
                               GL_SCISSOR_TEST,
                               GL_STENCIL_TEST,
                               GL_TEXTURE_2D};
  GLint planes = 0;
  glGetIntegerv(GL_MAX_CLIP_PLANES, &planes);
  for (GLenum i = 0; i < 8; ++i) names.push_back(GL_LIGHT0 + i);
  for (GLint i = 0; i < planes; ++i) names.push_back(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
  const auto states = [&] {
    std::vector<GLboolean> result;
    for (GLenum name : names) result.push_back(glIsEnabled(name));
    return result;
  };
  // Each changes itself and no other.
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<GLboolean> expected = states();
    for (GLboolean on : {GL_TRUE, GL_FALSE, GL_TRUE}) {
      (on ? glEnable : glDisable)(names[i]);
      expected[i] = on;
      EXPECT_EQ(states(), expected) << std::hex << names[i];
    }
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// 2.8: the client's switches, the texture coordinates' for every unit.
TEST_F(StateSetting, ClientSwitches) {
  for (GLenum array :
       {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_POINT_SIZE_ARRAY_OES}) {
    for (GLboolean on : {GL_TRUE, GL_FALSE}) {
      (on ? glEnableClientState : glDisableClientState)(static_cast<GLenum>(array));
      EXPECT_EQ(glIsEnabled(static_cast<GLenum>(array)), on) << std::hex << array;
    }
  }
}

}  // namespace
}  // namespace conformance
