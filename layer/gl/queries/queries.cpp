// Section 6.1: GetBooleanv, GetIntegerv, GetFixedv, GetFloatv and GetPointerv. A new query is a row here,
// unless it is a hint or something that Enable switches: those have tables of their own.
#include <bit>
#include <glm/mat4x4.hpp>

#include "layer/gl/debug/debug_output.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/queries/enables.h"
#include "layer/gl/queries/hints.h"
#include "layer/gl/queries/query.h"
#include "layer/gl/textures/compressed.h"
#include "layer/gl/textures/paletted.h"
#include "layer/gl/textures/pixel.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/vertices/buffer.h"

namespace anteroom::gl {

namespace {

template <class Object>
GLuint nameOf(const std::shared_ptr<Object>& object) {
  return object ? object->name : 0;
}

const ClientArray& texCoordArray(const Context& c) {
  return c.vertexArrays.arrays[gen::texCoord(c.clientActiveTexture)];
}

// OES_matrix_get.
std::array<GLint, 16> bitsOf(const glm::dmat4& matrix) {
  return std::bit_cast<std::array<GLint, 16>>(glm::mat4(matrix));
}

std::array<GLint, 4> cornerAndSize(const render::Rect& rect) {
  return {rect.x, rect.y, rect.width, rect.height};
}

std::vector<GLenum> compressedTextureFormats() {
  std::vector<GLenum> names(kPalettedFormats.begin(), kPalettedFormats.end());
  for (const CompressedFormat& format : compressedFormats()) names.push_back(format.name);
  return names;
}

// The framebuffer that is drawn to, as far as it is complete.
const render::Framebuffer& drawFramebuffer(Context& c) {
  if (c.boundFramebuffer || c.boundReadFramebuffer) {
    ShareLock lock(*c.group);
    c.framebufferComplete();
    c.readFramebufferComplete();
  }
  return c.state.framebuffer;
}

render::FormatInfo bitsOf(const render::Attachment& attachment) {
  return attachment.image ? render::info(attachment.image->desc().format) : render::FormatInfo{};
}

int samples(Context& c) {
  const int count = drawFramebuffer(c).samples;
  return c.hasFramebuffer && count > 1 ? count : 0;
}

int maxSamples(const Context& c) {
  const int count = c.device.caps().maxSamples;
  return count > 1 ? count : 0;
}

PixelFormat readFormat(Context& c) {
  drawFramebuffer(c);
  return implementationReadFormat(c.readFramebuffer);
}

constexpr GLenum kContextFlags = 0x821E;  // of OpenGL, as KHR_debug and KHR_no_error use it

using enum Results::Kind;

constexpr auto kQueries = tableOf<Query<Context>>({
    // Table 6.3
    {GL_CURRENT_COLOR, Normalised, [](Context& c) { return c.state.fixed.attributes[gen::kColor].current; }},
    {GL_CURRENT_TEXTURE_COORDS, Number,
     [](Context& c) { return c.state.fixed.attributes[gen::texCoord(c.activeTexture)].current; }},
    {GL_CURRENT_NORMAL, Normalised,
     [](Context& c) { return glm::vec3(c.state.fixed.attributes[gen::kNormal].current); }},

    // Tables 6.4 and 6.5
    {GL_CLIENT_ACTIVE_TEXTURE, Enum, [](Context& c) { return GL_TEXTURE0 + c.clientActiveTexture; }},
    {GL_VERTEX_ARRAY_SIZE, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kPosition].size; }},
    {GL_VERTEX_ARRAY_TYPE, Enum, [](Context& c) { return c.vertexArrays.arrays[gen::kPosition].type; }},
    {GL_VERTEX_ARRAY_STRIDE, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kPosition].stride; }},
    {GL_NORMAL_ARRAY_TYPE, Enum, [](Context& c) { return c.vertexArrays.arrays[gen::kNormal].type; }},
    {GL_NORMAL_ARRAY_STRIDE, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kNormal].stride; }},
    {GL_COLOR_ARRAY_SIZE, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kColor].size; }},
    {GL_COLOR_ARRAY_TYPE, Enum, [](Context& c) { return c.vertexArrays.arrays[gen::kColor].type; }},
    {GL_COLOR_ARRAY_STRIDE, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kColor].stride; }},
    {GL_TEXTURE_COORD_ARRAY_SIZE, Integer, [](Context& c) { return texCoordArray(c).size; }},
    {GL_TEXTURE_COORD_ARRAY_TYPE, Enum, [](Context& c) { return texCoordArray(c).type; }},
    {GL_TEXTURE_COORD_ARRAY_STRIDE, Integer, [](Context& c) { return texCoordArray(c).stride; }},
    {GL_POINT_SIZE_ARRAY_TYPE_OES, Enum, [](Context& c) { return c.vertexArrays.arrays[gen::kPointSize].type; }},
    {GL_POINT_SIZE_ARRAY_STRIDE_OES, Integer,
     [](Context& c) { return c.vertexArrays.arrays[gen::kPointSize].stride; }},
    {GL_POINT_SIZE_ARRAY_BUFFER_BINDING_OES, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kPointSize].buffer); }},
    {GL_ARRAY_BUFFER_BINDING, Integer, [](Context& c) { return nameOf(c.arrayBuffer); }},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kPosition].buffer); }},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kNormal].buffer); }},
    {GL_COLOR_ARRAY_BUFFER_BINDING, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kColor].buffer); }},
    {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, Integer, [](Context& c) { return nameOf(texCoordArray(c).buffer); }},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, Integer, [](Context& c) { return nameOf(c.vertexArrays.elementBuffer); }},

    // OES_matrix_palette, OES_vertex_array_object
    {GL_MATRIX_INDEX_ARRAY_SIZE_OES, Integer,
     [](Context& c) { return c.vertexArrays.arrays[gen::kMatrixIndex].size; }},
    {GL_MATRIX_INDEX_ARRAY_TYPE_OES, Enum,
     [](Context& c) { return c.vertexArrays.arrays[gen::kMatrixIndex].type; }},
    {GL_MATRIX_INDEX_ARRAY_STRIDE_OES, Integer,
     [](Context& c) { return c.vertexArrays.arrays[gen::kMatrixIndex].stride; }},
    {GL_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kMatrixIndex].buffer); }},
    {GL_WEIGHT_ARRAY_SIZE_OES, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kWeight].size; }},
    {GL_WEIGHT_ARRAY_TYPE_OES, Enum, [](Context& c) { return c.vertexArrays.arrays[gen::kWeight].type; }},
    {GL_WEIGHT_ARRAY_STRIDE_OES, Integer, [](Context& c) { return c.vertexArrays.arrays[gen::kWeight].stride; }},
    {GL_WEIGHT_ARRAY_BUFFER_BINDING_OES, Integer,
     [](Context& c) { return nameOf(c.vertexArrays.arrays[gen::kWeight].buffer); }},
    {GL_VERTEX_ARRAY_BINDING_OES, Integer, [](Context& c) { return c.boundVertexArray->name; }},

    // Table 6.7
    {GL_MODELVIEW_MATRIX, Number, [](Context& c) { return glm::mat4(c.state.fixed.modelview); }},
    {GL_PROJECTION_MATRIX, Number, [](Context& c) { return glm::mat4(c.state.fixed.projection); }},
    {GL_TEXTURE_MATRIX, Number, [](Context& c) { return glm::mat4(c.state.fixed.units[c.activeTexture].matrix); }},
    {GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES, Integer,
     [](Context& c) { return bitsOf(c.state.fixed.modelview); }},
    {GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES, Integer,
     [](Context& c) { return bitsOf(c.state.fixed.projection); }},
    {GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES, Integer,
     [](Context& c) { return bitsOf(c.state.fixed.units[c.activeTexture].matrix); }},
    {GL_VIEWPORT, Integer, [](Context& c) { return cornerAndSize(c.state.fixed.viewport); }},
    {GL_DEPTH_RANGE, Normalised, [](Context& c) { return glm::vec2(c.state.depthNear, c.state.depthFar); }},
    {GL_MODELVIEW_STACK_DEPTH, Integer, [](Context& c) { return c.modelviewStack.depth; }},
    {GL_PROJECTION_STACK_DEPTH, Integer, [](Context& c) { return c.projectionStack.depth; }},
    {GL_TEXTURE_STACK_DEPTH, Integer, [](Context& c) { return c.textureStacks[c.activeTexture].depth; }},
    {GL_MATRIX_MODE, Enum, [](Context& c) { return c.matrixMode; }},
    // OES_matrix_palette
    {GL_CURRENT_PALETTE_MATRIX_OES, Integer, [](Context& c) { return c.currentPaletteMatrix; }},

    // Table 6.8
    {GL_FOG_COLOR, Normalised, [](Context& c) { return c.state.fixed.fog.color; }},
    {GL_FOG_DENSITY, Number, [](Context& c) { return c.state.fixed.fog.density; }},
    {GL_FOG_START, Number, [](Context& c) { return c.state.fixed.fog.start; }},
    {GL_FOG_END, Number, [](Context& c) { return c.state.fixed.fog.end; }},
    {GL_FOG_MODE, Enum, [](Context& c) { return c.state.fixed.fog.mode; }},
    {GL_SHADE_MODEL, Enum, [](Context& c) { return c.state.fixed.shadeModel; }},

    // Table 6.9
    {GL_LIGHT_MODEL_AMBIENT, Normalised, [](Context& c) { return c.state.fixed.lighting.modelAmbient; }},
    {GL_LIGHT_MODEL_TWO_SIDE, Boolean, [](Context& c) { return c.state.fixed.lighting.twoSided; }},

    // Table 6.11, EXT_polygon_offset_clamp
    {GL_POINT_SIZE, Number, [](Context& c) { return c.state.fixed.points.size; }},
    {GL_POINT_SIZE_MIN, Number, [](Context& c) { return c.state.fixed.points.sizeMin; }},
    {GL_POINT_SIZE_MAX, Number, [](Context& c) { return c.state.fixed.points.sizeMax; }},
    {GL_POINT_FADE_THRESHOLD_SIZE, Number, [](Context& c) { return c.state.fixed.points.fadeThreshold; }},
    {GL_POINT_DISTANCE_ATTENUATION, Number,
     [](Context& c) { return c.state.fixed.points.distanceAttenuation; }},
    {GL_LINE_WIDTH, Number, [](Context& c) { return c.state.raster.lineWidth; }},
    {GL_CULL_FACE_MODE, Enum, [](Context& c) { return c.state.raster.cullFaceMode; }},
    {GL_FRONT_FACE, Enum, [](Context& c) { return c.state.raster.frontFace; }},
    {GL_POLYGON_OFFSET_FACTOR, Number, [](Context& c) { return c.state.raster.polygonOffsetFactor; }},
    {GL_POLYGON_OFFSET_UNITS, Number, [](Context& c) { return c.state.raster.polygonOffsetUnits; }},
    {GL_POLYGON_OFFSET_CLAMP_EXT, Number, [](Context& c) { return c.state.raster.polygonOffsetClamp; }},

    // Table 6.12
    {GL_SAMPLE_COVERAGE_VALUE, Number, [](Context& c) { return c.state.ops.sampleCoverageValue; }},
    {GL_SAMPLE_COVERAGE_INVERT, Boolean, [](Context& c) { return c.state.ops.sampleCoverageInvert; }},

    // Tables 6.13 and 6.15, OES_texture_cube_map, OES_texture_3D, OES_EGL_image_external
    {GL_TEXTURE_BINDING_2D, Integer, [](Context& c) { return nameOf(c.units[c.activeTexture].bound[kSlot2D]); }},
    {GL_TEXTURE_BINDING_CUBE_MAP_OES, Integer,
     [](Context& c) { return nameOf(c.units[c.activeTexture].bound[kSlotCube]); }},
    {GL_TEXTURE_BINDING_3D_OES, Integer,
     [](Context& c) { return nameOf(c.units[c.activeTexture].bound[kSlot3D]); }},
    {GL_TEXTURE_BINDING_EXTERNAL_OES, Integer,
     [](Context& c) { return nameOf(c.units[c.activeTexture].bound[kSlotExternal]); }},
    {GL_ACTIVE_TEXTURE, Enum, [](Context& c) { return GL_TEXTURE0 + c.activeTexture; }},

    // Table 6.16, OES_blend_func_separate, OES_blend_equation_separate. Masks of all ones read as -1: the bits
    // are what counts.
    {GL_SCISSOR_BOX, Integer, [](Context& c) { return cornerAndSize(c.state.scissor); }},
    {GL_ALPHA_TEST_FUNC, Enum, [](Context& c) { return c.state.fixed.alphaFunc; }},
    {GL_ALPHA_TEST_REF, Normalised, [](Context& c) { return c.state.fixed.alphaRef; }},
    {GL_STENCIL_FUNC, Enum, [](Context& c) { return c.state.ops.stencilFunc; }},
    {GL_STENCIL_VALUE_MASK, Integer, [](Context& c) { return static_cast<GLint>(c.state.ops.stencilValueMask); }},
    {GL_STENCIL_REF, Integer, [](Context& c) { return c.state.ops.stencilRef; }},
    {GL_STENCIL_FAIL, Enum, [](Context& c) { return c.state.ops.stencilFail; }},
    {GL_STENCIL_PASS_DEPTH_FAIL, Enum, [](Context& c) { return c.state.ops.stencilDepthFail; }},
    {GL_STENCIL_PASS_DEPTH_PASS, Enum, [](Context& c) { return c.state.ops.stencilDepthPass; }},
    {GL_DEPTH_FUNC, Enum, [](Context& c) { return c.state.ops.depthFunc; }},
    {GL_BLEND_SRC, Enum, [](Context& c) { return c.state.ops.blendSrcRgb; }},
    {GL_BLEND_DST, Enum, [](Context& c) { return c.state.ops.blendDstRgb; }},
    {GL_BLEND_SRC_RGB_OES, Enum, [](Context& c) { return c.state.ops.blendSrcRgb; }},
    {GL_BLEND_DST_RGB_OES, Enum, [](Context& c) { return c.state.ops.blendDstRgb; }},
    {GL_BLEND_SRC_ALPHA_OES, Enum, [](Context& c) { return c.state.ops.blendSrcAlpha; }},
    {GL_BLEND_DST_ALPHA_OES, Enum, [](Context& c) { return c.state.ops.blendDstAlpha; }},
    {GL_BLEND_EQUATION_RGB_OES, Enum, [](Context& c) { return c.state.ops.blendEquationRgb; }},
    {GL_BLEND_EQUATION_ALPHA_OES, Enum, [](Context& c) { return c.state.ops.blendEquationAlpha; }},
    {GL_LOGIC_OP_MODE, Enum, [](Context& c) { return c.state.ops.logicOp; }},

    // Table 6.17
    {GL_COLOR_WRITEMASK, Boolean, [](Context& c) { return c.state.ops.colorMask; }},
    {GL_DEPTH_WRITEMASK, Boolean, [](Context& c) { return c.state.ops.depthMask; }},
    {GL_STENCIL_WRITEMASK, Integer, [](Context& c) { return static_cast<GLint>(c.state.ops.stencilWriteMask); }},
    {GL_COLOR_CLEAR_VALUE, Normalised, [](Context& c) { return c.state.clear.color; }},
    {GL_DEPTH_CLEAR_VALUE, Normalised, [](Context& c) { return c.state.clear.depth; }},
    {GL_STENCIL_CLEAR_VALUE, Integer, [](Context& c) { return c.state.clear.stencil; }},

    // OES_framebuffer_object, APPLE_framebuffer_multisample
    {GL_FRAMEBUFFER_BINDING_OES, Integer, [](Context& c) { return nameOf(c.boundFramebuffer); }},
    {GL_READ_FRAMEBUFFER_BINDING_APPLE, Integer, [](Context& c) { return nameOf(c.boundReadFramebuffer); }},
    {GL_RENDERBUFFER_BINDING_OES, Integer, [](Context& c) { return nameOf(c.boundRenderbuffer); }},

    // Table 6.18
    {GL_UNPACK_ALIGNMENT, Integer, [](Context& c) { return c.unpackAlignment; }},
    {GL_PACK_ALIGNMENT, Integer, [](Context& c) { return c.packAlignment; }},

    // Tables 6.20 and 6.21
    {GL_MAX_LIGHTS, Integer, [](Context&) { return gen::kMaxLights; }},
    {GL_MAX_CLIP_PLANES, Integer, [](Context&) { return gen::kMaxClipPlanes; }},
    {GL_MAX_MODELVIEW_STACK_DEPTH, Integer, [](Context&) { return kModelviewDepth; }},
    {GL_MAX_PROJECTION_STACK_DEPTH, Integer, [](Context&) { return kProjectionDepth; }},
    {GL_MAX_TEXTURE_STACK_DEPTH, Integer, [](Context&) { return kTextureDepth; }},
    {GL_SUBPIXEL_BITS, Integer, [](Context& c) { return c.device.caps().subpixelBits; }},
    {GL_MAX_TEXTURE_SIZE, Integer, [](Context& c) { return c.device.caps().maxTextureSize; }},
    {GL_MAX_VIEWPORT_DIMS, Integer, [](Context& c) { return std::to_array(c.device.caps().maxViewport); }},
    {GL_ALIASED_POINT_SIZE_RANGE, Number, [](Context& c) { return std::to_array(c.device.caps().pointSizeRange); }},
    {GL_SMOOTH_POINT_SIZE_RANGE, Number,
     [](Context& c) { return std::to_array(c.device.caps().smoothPointSizeRange); }},
    {GL_ALIASED_LINE_WIDTH_RANGE, Number, [](Context& c) { return std::to_array(c.device.caps().lineWidthRange); }},
    {GL_SMOOTH_LINE_WIDTH_RANGE, Number,
     [](Context& c) { return std::to_array(c.device.caps().smoothLineWidthRange); }},

    // Table 6.22
    {GL_MAX_TEXTURE_UNITS, Integer, [](Context&) { return gen::kMaxTextureUnits; }},
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, Integer,
     [](Context&) { return kPalettedFormats.size() + compressedFormats().size(); }},
    {GL_SAMPLE_BUFFERS, Integer, [](Context& c) { return samples(c) != 0; }},
    {GL_SAMPLES, Integer, [](Context& c) { return samples(c); }},
    {GL_COMPRESSED_TEXTURE_FORMATS, Enum, [](Context&) { return compressedTextureFormats(); }},

    // Limits of extensions
    {GL_MAX_PALETTE_MATRICES_OES, Integer, [](Context&) { return gen::kPaletteMatrices; }},
    {GL_MAX_VERTEX_UNITS_OES, Integer, [](Context&) { return gen::kMaxVertexUnits; }},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE_OES, Integer, [](Context& c) { return c.device.caps().maxCubeMapSize; }},
    {GL_MAX_3D_TEXTURE_SIZE_OES, Integer, [](Context& c) { return c.device.caps().maxVolumeSize; }},
    {GL_MAX_RENDERBUFFER_SIZE_OES, Integer, [](Context& c) { return c.device.caps().maxTextureSize; }},
    {GL_MAX_SAMPLES_EXT, Integer, [](Context& c) { return maxSamples(c); }},
    {GL_MAX_SAMPLES_IMG, Integer, [](Context& c) { return maxSamples(c); }},
    {GL_MAX_TEXTURE_LOD_BIAS_EXT, Number, [](Context& c) { return c.device.caps().maxLodBias; }},
    {GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, Number, [](Context& c) { return c.device.caps().maxAnisotropy; }},
    // None: the server waits until the fence has passed.
    {GL_MAX_SERVER_WAIT_TIMEOUT_APPLE, Integer, [](Context&) { return 0x1p62; }},

    // Table 6.23, OES_read_format
    {GL_RED_BITS, Integer, [](Context& c) { return bitsOf(drawFramebuffer(c).color).red; }},
    {GL_GREEN_BITS, Integer, [](Context& c) { return bitsOf(drawFramebuffer(c).color).green; }},
    {GL_BLUE_BITS, Integer, [](Context& c) { return bitsOf(drawFramebuffer(c).color).blue; }},
    {GL_ALPHA_BITS, Integer, [](Context& c) { return bitsOf(drawFramebuffer(c).color).alpha; }},
    {GL_DEPTH_BITS, Integer, [](Context& c) { return bitsOf(drawFramebuffer(c).depth).depth; }},
    {GL_STENCIL_BITS, Integer, [](Context& c) { return drawFramebuffer(c), stencilBits(c); }},
    {GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES, Enum, [](Context& c) { return readFormat(c).format; }},
    {GL_IMPLEMENTATION_COLOR_READ_TYPE_OES, Enum, [](Context& c) { return readFormat(c).type; }},

    // EXT_robustness, KHR_debug, KHR_no_error
    {GL_CONTEXT_ROBUST_ACCESS_EXT, Boolean, [](Context& c) { return c.options.robustAccess; }},
    {GL_RESET_NOTIFICATION_STRATEGY_EXT, Enum,
     [](Context& c) {
       return c.options.loseContextOnReset ? GL_LOSE_CONTEXT_ON_RESET_EXT : GL_NO_RESET_NOTIFICATION_EXT;
     }},
    {kContextFlags, Integer,
     [](Context& c) {
       return (c.options.debug ? GL_CONTEXT_FLAG_DEBUG_BIT_KHR : 0) | (c.options.noError ? GL_CONTEXT_FLAG_NO_ERROR_BIT_KHR : 0);
     }},
    {GL_MAX_DEBUG_MESSAGE_LENGTH_KHR, Integer, [](Context&) { return kMostMessageLength; }},
    {GL_MAX_DEBUG_LOGGED_MESSAGES_KHR, Integer, [](Context&) { return kMostLoggedMessages; }},
    {GL_DEBUG_LOGGED_MESSAGES_KHR, Integer, [](Context& c) { return c.debug->log.size(); }},
    {GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH_KHR, Integer,
     [](Context& c) { return c.debug->log.empty() ? 0 : c.debug->log.front().text.size() + 1; }},
    {GL_MAX_DEBUG_GROUP_STACK_DEPTH_KHR, Integer, [](Context&) { return kDebugGroupDepth; }},
    {GL_DEBUG_GROUP_STACK_DEPTH_KHR, Integer, [](Context& c) { return c.debug->depth(); }},
    {GL_MAX_LABEL_LENGTH_KHR, Integer, [](Context&) { return kMostLabelLength; }},
});

void get(GLenum name, void* out, Results::Form form, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  Results results(out, form);
  if (answer(kQueries, *c, name, results)) return;
  if (const GLenum* hint = hintOf(*c, name)) return results.put(Enum, *hint);  // table 6.19
  bool enabled = false;
  if (!isEnabled(*c, name, enabled))
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("pname", name, "Ask for a name of tables 6.3 to 6.23, or of an extension"),
                       command);
  results.put(Boolean, enabled);
}

struct PointerQuery {
  GLenum name;
  const void* (*get)(Context&);
};

// Tables 6.4 and 6.5, OES_point_size_array, OES_matrix_palette, KHR_debug.
constexpr auto kPointers = tableOf<PointerQuery>({
    {GL_VERTEX_ARRAY_POINTER, [](Context& c) { return c.vertexArrays.arrays[gen::kPosition].pointer; }},
    {GL_NORMAL_ARRAY_POINTER, [](Context& c) { return c.vertexArrays.arrays[gen::kNormal].pointer; }},
    {GL_COLOR_ARRAY_POINTER, [](Context& c) { return c.vertexArrays.arrays[gen::kColor].pointer; }},
    {GL_TEXTURE_COORD_ARRAY_POINTER, [](Context& c) { return texCoordArray(c).pointer; }},
    {GL_POINT_SIZE_ARRAY_POINTER_OES,
     [](Context& c) { return c.vertexArrays.arrays[gen::kPointSize].pointer; }},
    {GL_MATRIX_INDEX_ARRAY_POINTER_OES,
     [](Context& c) { return c.vertexArrays.arrays[gen::kMatrixIndex].pointer; }},
    {GL_WEIGHT_ARRAY_POINTER_OES, [](Context& c) { return c.vertexArrays.arrays[gen::kWeight].pointer; }},
    {GL_DEBUG_CALLBACK_FUNCTION_KHR,
     [](Context& c) { return reinterpret_cast<const void*>(c.debug->callback); }},
    {GL_DEBUG_CALLBACK_USER_PARAM_KHR, [](Context& c) { return c.debug->userParam; }},
});

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glGetBooleanv(GLenum name, GLboolean* data) {
  get(name, data, Results::Form::Boolean);
}
GL_API void GL_APIENTRY glGetIntegerv(GLenum name, GLint* data) {
  get(name, data, Results::Form::Integer);
}
GL_API void GL_APIENTRY glGetInteger64vAPPLE(GLenum name, GLint64* params) {
  get(name, params, Results::Form::Integer64);
}
GL_API void GL_APIENTRY glGetFixedv(GLenum name, GLfixed* data) {
  get(name, data, Results::Form::Fixed);
}
GL_API void GL_APIENTRY glGetFloatv(GLenum name, GLfloat* data) {
  get(name, data, Results::Form::Float);
}

GL_API void GL_APIENTRY glGetPointerv(GLenum name, void** params) {
  Context* c = current();
  if (!c) return;
  const PointerQuery* query = kPointers.find(name);
  if (!query)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("pname", name, "Ask for VERTEX_ARRAY_POINTER or that of another array"));
  if (params) *params = const_cast<void*>(query->get(*c));
}
