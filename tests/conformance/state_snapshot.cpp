#include "state_snapshot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <span>

#include "harness.h"

namespace conformance {

namespace {

struct Entry {
  GLenum name;
  int count;
};

constexpr Entry kSimple[] = {
    {GL_CURRENT_COLOR, 4},
    {GL_CURRENT_NORMAL, 3},
    {GL_CLIENT_ACTIVE_TEXTURE, 1},
    {GL_ACTIVE_TEXTURE, 1},
    {GL_VERTEX_ARRAY, 1},
    {GL_VERTEX_ARRAY_SIZE, 1},
    {GL_VERTEX_ARRAY_TYPE, 1},
    {GL_VERTEX_ARRAY_STRIDE, 1},
    {GL_NORMAL_ARRAY, 1},
    {GL_NORMAL_ARRAY_TYPE, 1},
    {GL_NORMAL_ARRAY_STRIDE, 1},
    {GL_COLOR_ARRAY, 1},
    {GL_COLOR_ARRAY_SIZE, 1},
    {GL_COLOR_ARRAY_TYPE, 1},
    {GL_COLOR_ARRAY_STRIDE, 1},
    {GL_POINT_SIZE_ARRAY_OES, 1},
    {GL_POINT_SIZE_ARRAY_TYPE_OES, 1},
    {GL_POINT_SIZE_ARRAY_STRIDE_OES, 1},
    {GL_ARRAY_BUFFER_BINDING, 1},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, 1},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, 1},
    {GL_COLOR_ARRAY_BUFFER_BINDING, 1},
    {GL_POINT_SIZE_ARRAY_BUFFER_BINDING_OES, 1},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, 1},
    {GL_MODELVIEW_MATRIX, 16},
    {GL_PROJECTION_MATRIX, 16},
    {GL_VIEWPORT, 4},
    {GL_DEPTH_RANGE, 2},
    {GL_MODELVIEW_STACK_DEPTH, 1},
    {GL_PROJECTION_STACK_DEPTH, 1},
    {GL_MATRIX_MODE, 1},
    {GL_NORMALIZE, 1},
    {GL_RESCALE_NORMAL, 1},
    {GL_FOG_COLOR, 4},
    {GL_FOG_DENSITY, 1},
    {GL_FOG_START, 1},
    {GL_FOG_END, 1},
    {GL_FOG_MODE, 1},
    {GL_FOG, 1},
    {GL_SHADE_MODEL, 1},
    {GL_LIGHTING, 1},
    {GL_COLOR_MATERIAL, 1},
    {GL_LIGHT_MODEL_AMBIENT, 4},
    {GL_LIGHT_MODEL_TWO_SIDE, 1},
    {GL_POINT_SIZE, 1},
    {GL_POINT_SMOOTH, 1},
    {GL_POINT_SIZE_MIN, 1},
    {GL_POINT_SIZE_MAX, 1},
    {GL_POINT_FADE_THRESHOLD_SIZE, 1},
    {GL_POINT_DISTANCE_ATTENUATION, 3},
    {GL_POINT_SPRITE_OES, 1},
    {GL_LINE_WIDTH, 1},
    {GL_LINE_SMOOTH, 1},
    {GL_CULL_FACE, 1},
    {GL_CULL_FACE_MODE, 1},
    {GL_FRONT_FACE, 1},
    {GL_POLYGON_OFFSET_FACTOR, 1},
    {GL_POLYGON_OFFSET_UNITS, 1},
    {GL_POLYGON_OFFSET_FILL, 1},
    {GL_MULTISAMPLE, 1},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 1},
    {GL_SAMPLE_ALPHA_TO_ONE, 1},
    {GL_SAMPLE_COVERAGE, 1},
    {GL_SAMPLE_COVERAGE_VALUE, 1},
    {GL_SAMPLE_COVERAGE_INVERT, 1},
    {GL_SCISSOR_TEST, 1},
    {GL_SCISSOR_BOX, 4},
    {GL_ALPHA_TEST, 1},
    {GL_ALPHA_TEST_FUNC, 1},
    {GL_ALPHA_TEST_REF, 1},
    {GL_STENCIL_TEST, 1},
    {GL_STENCIL_FUNC, 1},
    {GL_STENCIL_VALUE_MASK, 1},
    {GL_STENCIL_REF, 1},
    {GL_STENCIL_FAIL, 1},
    {GL_STENCIL_PASS_DEPTH_FAIL, 1},
    {GL_STENCIL_PASS_DEPTH_PASS, 1},
    {GL_DEPTH_TEST, 1},
    {GL_DEPTH_FUNC, 1},
    {GL_BLEND, 1},
    {GL_BLEND_SRC, 1},
    {GL_BLEND_DST, 1},
    {GL_DITHER, 1},
    {GL_COLOR_LOGIC_OP, 1},
    {GL_LOGIC_OP_MODE, 1},
    {GL_COLOR_WRITEMASK, 4},
    {GL_DEPTH_WRITEMASK, 1},
    {GL_STENCIL_WRITEMASK, 1},
    {GL_COLOR_CLEAR_VALUE, 4},
    {GL_DEPTH_CLEAR_VALUE, 1},
    {GL_STENCIL_CLEAR_VALUE, 1},
    {GL_UNPACK_ALIGNMENT, 1},
    {GL_PACK_ALIGNMENT, 1},
    {GL_PERSPECTIVE_CORRECTION_HINT, 1},
    {GL_POINT_SMOOTH_HINT, 1},
    {GL_LINE_SMOOTH_HINT, 1},
    {GL_FOG_HINT, 1},
    {GL_GENERATE_MIPMAP_HINT, 1},
};
constexpr Entry kPerUnit[] = {{GL_CURRENT_TEXTURE_COORDS, 4},
                              {GL_TEXTURE_MATRIX, 16},
                              {GL_TEXTURE_STACK_DEPTH, 1},
                              {GL_TEXTURE_2D, 1},
                              {GL_TEXTURE_BINDING_2D, 1}};
constexpr Entry kEnvironment[] = {{GL_TEXTURE_ENV_MODE, 1}, {GL_TEXTURE_ENV_COLOR, 4}, {GL_COMBINE_RGB, 1},
                                  {GL_COMBINE_ALPHA, 1},    {GL_SRC0_RGB, 1},          {GL_SRC1_RGB, 1},
                                  {GL_SRC2_RGB, 1},         {GL_SRC0_ALPHA, 1},        {GL_SRC1_ALPHA, 1},
                                  {GL_SRC2_ALPHA, 1},       {GL_OPERAND0_RGB, 1},      {GL_OPERAND1_RGB, 1},
                                  {GL_OPERAND2_RGB, 1},     {GL_OPERAND0_ALPHA, 1},    {GL_OPERAND1_ALPHA, 1},
                                  {GL_OPERAND2_ALPHA, 1},   {GL_RGB_SCALE, 1},         {GL_ALPHA_SCALE, 1}};
constexpr Entry kTexture[] = {{GL_TEXTURE_MIN_FILTER, 1},
                              {GL_TEXTURE_MAG_FILTER, 1},
                              {GL_TEXTURE_WRAP_S, 1},
                              {GL_TEXTURE_WRAP_T, 1},
                              {GL_GENERATE_MIPMAP, 1}};
constexpr Entry kClientUnit[] = {{GL_TEXTURE_COORD_ARRAY, 1},
                                 {GL_TEXTURE_COORD_ARRAY_SIZE, 1},
                                 {GL_TEXTURE_COORD_ARRAY_TYPE, 1},
                                 {GL_TEXTURE_COORD_ARRAY_STRIDE, 1},
                                 {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, 1}};
constexpr Entry kLight[] = {{GL_AMBIENT, 4},
                            {GL_DIFFUSE, 4},
                            {GL_SPECULAR, 4},
                            {GL_POSITION, 4},
                            {GL_SPOT_DIRECTION, 3},
                            {GL_SPOT_EXPONENT, 1},
                            {GL_SPOT_CUTOFF, 1},
                            {GL_CONSTANT_ATTENUATION, 1},
                            {GL_LINEAR_ATTENUATION, 1},
                            {GL_QUADRATIC_ATTENUATION, 1}};
constexpr Entry kMaterial[] = {
    {GL_AMBIENT, 4}, {GL_DIFFUSE, 4}, {GL_SPECULAR, 4}, {GL_EMISSION, 4}, {GL_SHININESS, 1}};

GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

class Taker {
 public:
  template <class Get>
  void take(const std::string& prefix, std::span<const Entry> entries, Get&& get) {
    for (const Entry& entry : entries) {
      GLfloat values[16] = {};
      get(entry.name, values);
      result_.emplace(fmt::format("{}{:#06x}", prefix, entry.name),
                      std::vector<double>(values, values + entry.count));
    }
  }
  void add(std::string name, double value) { result_.emplace(std::move(name), std::vector<double>{value}); }
  StateSnapshot finish() { return std::move(result_); }

 private:
  StateSnapshot result_;
};

void takeUnits(Taker& taker) {
  const GLenum active = static_cast<GLenum>(integer(GL_ACTIVE_TEXTURE));
  const GLenum clientActive = static_cast<GLenum>(integer(GL_CLIENT_ACTIVE_TEXTURE));
  for (int unit = 0; unit < integer(GL_MAX_TEXTURE_UNITS); ++unit) {
    const std::string prefix = fmt::format("unit {} ", unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    taker.take(prefix, kPerUnit, [](GLenum name, GLfloat* values) { glGetFloatv(name, values); });
    taker.take(prefix, kClientUnit, [](GLenum name, GLfloat* values) { glGetFloatv(name, values); });
    taker.take(prefix, kEnvironment,
               [](GLenum name, GLfloat* values) { glGetTexEnvfv(GL_TEXTURE_ENV, name, values); });
    taker.take(prefix, kTexture,
               [](GLenum name, GLfloat* values) { glGetTexParameterfv(GL_TEXTURE_2D, name, values); });
    GLfloat replace = 0;
    glGetTexEnvfv(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, &replace);
    taker.add(prefix + "COORD_REPLACE", replace);
  }
  glActiveTexture(active);
  glClientActiveTexture(clientActive);
}

}  // namespace

StateSnapshot takeSnapshot() {
  Taker taker;
  taker.take("", kSimple, [](GLenum name, GLfloat* values) { glGetFloatv(name, values); });
  takeUnits(taker);
  for (int i = 0; i < 8; ++i) {
    const GLenum light = GL_LIGHT0 + static_cast<GLenum>(i);
    taker.take(fmt::format("light {} ", i), kLight,
               [&](GLenum name, GLfloat* values) { glGetLightfv(light, name, values); });
    taker.add(fmt::format("light {} on", i), glIsEnabled(light));
  }
  taker.take("material ", kMaterial,
             [](GLenum name, GLfloat* values) { glGetMaterialfv(GL_FRONT, name, values); });
  for (int i = 0; i < integer(GL_MAX_CLIP_PLANES); ++i) {
    const GLenum plane = GL_CLIP_PLANE0 + static_cast<GLenum>(i);
    taker.take(fmt::format("plane {} ", i), std::array{Entry{plane, 4}},
               [](GLenum name, GLfloat* values) { glGetClipPlanef(name, values); });
    taker.add(fmt::format("plane {} on", i), glIsEnabled(plane));
  }
  for (GLenum name : {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER,
                      GL_TEXTURE_COORD_ARRAY_POINTER, GL_POINT_SIZE_ARRAY_POINTER_OES}) {
    void* pointer = nullptr;
    glGetPointerv(name, &pointer);
    taker.add(fmt::format("pointer {:#06x}", name),
              static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)));
  }
  return taker.finish();
}

std::string difference(const StateSnapshot& before, const StateSnapshot& after) {
  std::string text;
  for (const auto& [name, values] : before) {
    const auto found = after.find(name);
    if (found == after.end() || found->second != values) {
      text += fmt::format(
          "{}: {} became {}\n", name, fmt::join(values, " "),
          found == after.end() ? std::string("nothing") : fmt::format("{}", fmt::join(found->second, " ")));
    }
  }
  return text;
}

}  // namespace conformance
