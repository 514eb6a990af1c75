// Section 6.1: GetBooleanv, GetIntegerv, GetFixedv, GetFloatv, GetPointerv over tables 6.3 to 6.23. One
// function a group of tables; each says whether it knew the name.
#include <bit>
#include <glm/gtc/type_ptr.hpp>

#include "layer/gl/buffer.h"
#include "layer/gl/compressed.h"
#include "layer/gl/debug_output.h"
#include "layer/gl/enables.h"
#include "layer/gl/framebuffer_object.h"
#include "layer/gl/hints.h"
#include "layer/gl/missing_enums.h"
#include "layer/gl/paletted.h"
#include "layer/gl/params.h"
#include "layer/gl/pixel.h"
#include "layer/gl/texture.h"
#include "layer/gl/vertex_arrays.h"

namespace anteroom::gl {

namespace {

GLuint nameOf(const std::shared_ptr<BufferObject>& buffer) {
  return buffer ? buffer->name : 0;
}

// Table 6.3.
bool getCurrentValues(Context& c, GLenum name, Results& results) {
  const auto& attributes = c.state.fixed.attributes;
  switch (name) {
    case GL_CURRENT_COLOR:
      results.normaliseds(attributes[gen::kColor].current);
      return true;
    case GL_CURRENT_NORMAL:
      results.normaliseds(glm::vec3(attributes[gen::kNormal].current));
      return true;
    case GL_CURRENT_TEXTURE_COORDS:
      results.numbers(attributes[gen::texCoord(c.activeTexture)].current);
      return true;
    default:
      return false;
  }
}

// Tables 6.4 and 6.5.
bool getArrays(Context& c, GLenum name, Results& results) {
  const auto& arrays = c.vertexArrays.arrays;
  const ClientArray& texCoords = arrays[gen::texCoord(c.clientActiveTexture)];
  switch (name) {
    case GL_CLIENT_ACTIVE_TEXTURE:
      results.enumerant(GL_TEXTURE0 + static_cast<GLenum>(c.clientActiveTexture));
      break;
    case GL_VERTEX_ARRAY_SIZE:
      results.integer(arrays[gen::kPosition].size);
      break;
    case GL_VERTEX_ARRAY_TYPE:
      results.enumerant(arrays[gen::kPosition].type);
      break;
    case GL_VERTEX_ARRAY_STRIDE:
      results.integer(arrays[gen::kPosition].stride);
      break;
    case GL_VERTEX_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(arrays[gen::kPosition].buffer));
      break;
    case GL_NORMAL_ARRAY_TYPE:
      results.enumerant(arrays[gen::kNormal].type);
      break;
    case GL_NORMAL_ARRAY_STRIDE:
      results.integer(arrays[gen::kNormal].stride);
      break;
    case GL_NORMAL_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(arrays[gen::kNormal].buffer));
      break;
    case GL_COLOR_ARRAY_SIZE:
      results.integer(arrays[gen::kColor].size);
      break;
    case GL_COLOR_ARRAY_TYPE:
      results.enumerant(arrays[gen::kColor].type);
      break;
    case GL_COLOR_ARRAY_STRIDE:
      results.integer(arrays[gen::kColor].stride);
      break;
    case GL_COLOR_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(arrays[gen::kColor].buffer));
      break;
    case GL_POINT_SIZE_ARRAY_TYPE_OES:
      results.enumerant(arrays[gen::kPointSize].type);
      break;
    case GL_POINT_SIZE_ARRAY_STRIDE_OES:
      results.integer(arrays[gen::kPointSize].stride);
      break;
    case GL_POINT_SIZE_ARRAY_BUFFER_BINDING_OES:
      results.integer(nameOf(arrays[gen::kPointSize].buffer));
      break;
    case GL_MATRIX_INDEX_ARRAY_SIZE_OES:
      results.integer(arrays[gen::kMatrixIndex].size);
      break;
    case GL_MATRIX_INDEX_ARRAY_TYPE_OES:
      results.enumerant(arrays[gen::kMatrixIndex].type);
      break;
    case GL_MATRIX_INDEX_ARRAY_STRIDE_OES:
      results.integer(arrays[gen::kMatrixIndex].stride);
      break;
    case GL_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES:
      results.integer(nameOf(arrays[gen::kMatrixIndex].buffer));
      break;
    case GL_WEIGHT_ARRAY_SIZE_OES:
      results.integer(arrays[gen::kWeight].size);
      break;
    case GL_WEIGHT_ARRAY_TYPE_OES:
      results.enumerant(arrays[gen::kWeight].type);
      break;
    case GL_WEIGHT_ARRAY_STRIDE_OES:
      results.integer(arrays[gen::kWeight].stride);
      break;
    case GL_WEIGHT_ARRAY_BUFFER_BINDING_OES:
      results.integer(nameOf(arrays[gen::kWeight].buffer));
      break;
    case GL_TEXTURE_COORD_ARRAY_SIZE:
      results.integer(texCoords.size);
      break;
    case GL_TEXTURE_COORD_ARRAY_TYPE:
      results.enumerant(texCoords.type);
      break;
    case GL_TEXTURE_COORD_ARRAY_STRIDE:
      results.integer(texCoords.stride);
      break;
    case GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(texCoords.buffer));
      break;
    case GL_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(c.arrayBuffer));
      break;
    case GL_VERTEX_ARRAY_BINDING_OES:
      results.integer(c.boundVertexArray->name);
      break;
    case GL_ELEMENT_ARRAY_BUFFER_BINDING:
      results.integer(nameOf(c.vertexArrays.elementBuffer));
      break;
    default:
      return false;
  }
  return true;
}

void putMatrix(const glm::dmat4& matrix, Results& results) {
  for (int i = 0; i < 16; ++i) results.number(static_cast<float>(glm::value_ptr(matrix)[i]));
}

void putMatrixBits(const glm::dmat4& matrix, Results& results) {
  for (int i = 0; i < 16; ++i) {
    results.integer(std::bit_cast<GLint>(static_cast<float>(glm::value_ptr(matrix)[i])));
  }
}

// Table 6.7.
bool getTransformation(Context& c, GLenum name, Results& results) {
  const gen::State& fixed = c.state.fixed;
  const render::Rect& viewport = c.state.viewport;
  const glm::dmat4& textureMatrix = fixed.units[c.activeTexture].matrix;
  switch (name) {
    case GL_MODELVIEW_MATRIX:
      putMatrix(fixed.modelview, results);
      break;
    case GL_PROJECTION_MATRIX:
      putMatrix(fixed.projection, results);
      break;
    case GL_TEXTURE_MATRIX:
      putMatrix(textureMatrix, results);
      break;
    case GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES:
      putMatrixBits(fixed.modelview, results);
      break;
    case GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES:
      putMatrixBits(fixed.projection, results);
      break;
    case GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES:
      putMatrixBits(textureMatrix, results);
      break;
    case GL_VIEWPORT:
      results.numbers(glm::dvec4(viewport.x, viewport.y, viewport.width, viewport.height));
      break;
    case GL_DEPTH_RANGE:
      results.normaliseds(glm::vec2(c.state.depthNear, c.state.depthFar));
      break;
    case GL_MODELVIEW_STACK_DEPTH:
      results.integer(c.modelviewStack.depth);
      break;
    case GL_PROJECTION_STACK_DEPTH:
      results.integer(c.projectionStack.depth);
      break;
    case GL_TEXTURE_STACK_DEPTH:
      results.integer(c.textureStacks[c.activeTexture].depth);
      break;
    case GL_MATRIX_MODE:
      results.enumerant(c.matrixMode);
      break;
    case GL_CURRENT_PALETTE_MATRIX_OES:
      results.integer(c.currentPaletteMatrix);
      break;
    default:
      return false;
  }
  return true;
}

// Tables 6.8, 6.9, 6.11 and 6.12.
bool getColoringAndRasterization(Context& c, GLenum name, Results& results) {
  const gen::State& fixed = c.state.fixed;
  const render::Raster& raster = c.state.raster;
  switch (name) {
    case GL_FOG_COLOR:
      results.normaliseds(fixed.fog.color);
      break;
    case GL_FOG_DENSITY:
      results.number(fixed.fog.density);
      break;
    case GL_FOG_START:
      results.number(fixed.fog.start);
      break;
    case GL_FOG_END:
      results.number(fixed.fog.end);
      break;
    case GL_FOG_MODE:
      results.enumerant(fixed.fog.mode);
      break;
    case GL_SHADE_MODEL:
      results.enumerant(fixed.shadeModel);
      break;
    case GL_LIGHT_MODEL_AMBIENT:
      results.normaliseds(fixed.lighting.modelAmbient);
      break;
    case GL_LIGHT_MODEL_TWO_SIDE:
      results.boolean(fixed.lighting.twoSided);
      break;
    case GL_POINT_SIZE:
      results.number(fixed.points.size);
      break;
    case GL_POINT_SIZE_MIN:
      results.number(fixed.points.sizeMin);
      break;
    case GL_POINT_SIZE_MAX:
      results.number(fixed.points.sizeMax);
      break;
    case GL_POINT_FADE_THRESHOLD_SIZE:
      results.number(fixed.points.fadeThreshold);
      break;
    case GL_POINT_DISTANCE_ATTENUATION:
      results.numbers(fixed.points.distanceAttenuation);
      break;
    case GL_LINE_WIDTH:
      results.number(raster.lineWidth);
      break;
    case GL_CULL_FACE_MODE:
      results.enumerant(raster.cullFaceMode);
      break;
    case GL_FRONT_FACE:
      results.enumerant(raster.frontFace);
      break;
    case GL_POLYGON_OFFSET_FACTOR:
      results.number(raster.polygonOffsetFactor);
      break;
    case GL_POLYGON_OFFSET_UNITS:
      results.number(raster.polygonOffsetUnits);
      break;
    case GL_POLYGON_OFFSET_CLAMP_EXT:
      results.number(raster.polygonOffsetClamp);
      break;
    case GL_SAMPLE_COVERAGE_VALUE:
      results.number(c.state.ops.sampleCoverageValue);
      break;
    case GL_SAMPLE_COVERAGE_INVERT:
      results.boolean(c.state.ops.sampleCoverageInvert);
      break;
    default:
      return false;
  }
  return true;
}

// Tables 6.16 and 6.17. Masks of all ones read as -1: the bits are what counts.
bool getFragmentOperations(Context& c, GLenum name, Results& results) {
  const render::FragmentOps& ops = c.state.ops;
  const render::Rect& scissor = c.state.scissor;
  switch (name) {
    case GL_SCISSOR_BOX:
      results.numbers(glm::dvec4(scissor.x, scissor.y, scissor.width, scissor.height));
      break;
    case GL_ALPHA_TEST_FUNC:
      results.enumerant(c.state.fixed.alphaFunc);
      break;
    case GL_ALPHA_TEST_REF:
      results.number(c.state.fixed.alphaRef);
      break;
    case GL_STENCIL_FUNC:
      results.enumerant(ops.stencilFunc);
      break;
    case GL_STENCIL_VALUE_MASK:
      results.integer(static_cast<GLint>(ops.stencilValueMask));
      break;
    case GL_STENCIL_REF:
      results.integer(ops.stencilRef);
      break;
    case GL_STENCIL_FAIL:
      results.enumerant(ops.stencilFail);
      break;
    case GL_STENCIL_PASS_DEPTH_FAIL:
      results.enumerant(ops.stencilDepthFail);
      break;
    case GL_STENCIL_PASS_DEPTH_PASS:
      results.enumerant(ops.stencilDepthPass);
      break;
    case GL_DEPTH_FUNC:
      results.enumerant(ops.depthFunc);
      break;
    case GL_BLEND_SRC:
    case GL_BLEND_SRC_RGB_OES:
      results.enumerant(ops.blendSrcRgb);
      break;
    case GL_BLEND_DST:
    case GL_BLEND_DST_RGB_OES:
      results.enumerant(ops.blendDstRgb);
      break;
    case GL_BLEND_SRC_ALPHA_OES:
      results.enumerant(ops.blendSrcAlpha);
      break;
    case GL_BLEND_DST_ALPHA_OES:
      results.enumerant(ops.blendDstAlpha);
      break;
    case GL_BLEND_EQUATION_RGB_OES:
      results.enumerant(ops.blendEquationRgb);
      break;
    case GL_BLEND_EQUATION_ALPHA_OES:
      results.enumerant(ops.blendEquationAlpha);
      break;
    case GL_LOGIC_OP_MODE:
      results.enumerant(ops.logicOp);
      break;
    case GL_COLOR_WRITEMASK:
      for (bool component : ops.colorMask) results.boolean(component);
      break;
    case GL_DEPTH_WRITEMASK:
      results.boolean(ops.depthMask);
      break;
    case GL_STENCIL_WRITEMASK:
      results.integer(static_cast<GLint>(ops.stencilWriteMask));
      break;
    case GL_COLOR_CLEAR_VALUE:
      results.normaliseds(c.state.clear.color);
      break;
    case GL_DEPTH_CLEAR_VALUE:
      results.normalised(c.state.clear.depth);
      break;
    case GL_STENCIL_CLEAR_VALUE:
      results.integer(c.state.clear.stencil);
      break;
    default:
      return false;
  }
  return true;
}

// Tables 6.13, 6.15, 6.18 and 6.19.
bool getTexturesPixelsAndHints(Context& c, GLenum name, Results& results) {
  const UnitBindings& unit = c.units[c.activeTexture];
  switch (name) {
    case GL_TEXTURE_BINDING_2D:
      results.integer(unit.bound[kSlot2D]->name);
      return true;
    case GL_TEXTURE_BINDING_CUBE_MAP_OES:
      results.integer(unit.bound[kSlotCube]->name);
      return true;
    case GL_TEXTURE_BINDING_3D_OES:
      results.integer(unit.bound[kSlot3D]->name);
      return true;
    case GL_TEXTURE_BINDING_EXTERNAL_OES:
      results.integer(unit.bound[kSlotExternal]->name);
      return true;
    case GL_ACTIVE_TEXTURE:
      results.enumerant(GL_TEXTURE0 + static_cast<GLenum>(c.activeTexture));
      return true;
    case GL_UNPACK_ALIGNMENT:
      results.integer(c.unpackAlignment);
      return true;
    case GL_PACK_ALIGNMENT:
      results.integer(c.packAlignment);
      return true;
    default:
      break;
  }
  const GLenum* hint = hintOf(c, name);
  if (hint) results.enumerant(*hint);
  return hint != nullptr;
}

// KHR_debug and KHR_no_error; the header of ES 1.x does not have them.
constexpr GLenum kContextFlags = 0x821E;
constexpr GLint kContextFlagDebugBit = 0x2, kContextFlagNoErrorBit = 0x8;

// Tables 6.20 to 6.22.
bool getLimits(Context& c, GLenum name, Results& results) {
  const render::Caps& caps = c.device.caps();
  const auto range = [&](const float(&r)[2]) { results.numbers(glm::vec2(r[0], r[1])); };
  switch (name) {
    case GL_MAX_LIGHTS:
      results.integer(gen::kMaxLights);
      break;
    case GL_MAX_CLIP_PLANES:
      results.integer(gen::kMaxClipPlanes);
      break;
    case GL_MAX_MODELVIEW_STACK_DEPTH:
      results.integer(kModelviewDepth);
      break;
    case GL_MAX_PROJECTION_STACK_DEPTH:
      results.integer(kProjectionDepth);
      break;
    case GL_MAX_TEXTURE_STACK_DEPTH:
      results.integer(kTextureDepth);
      break;
    case GL_MAX_PALETTE_MATRICES_OES:
      results.integer(gen::kPaletteMatrices);
      break;
    case GL_MAX_VERTEX_UNITS_OES:
      results.integer(gen::kMaxVertexUnits);
      break;
    case GL_SUBPIXEL_BITS:
      results.integer(caps.subpixelBits);
      break;
    case GL_MAX_TEXTURE_SIZE:
      results.integer(caps.maxTextureSize);
      break;
    case GL_MAX_CUBE_MAP_TEXTURE_SIZE_OES:
      results.integer(caps.maxCubeMapSize);
      break;
    case GL_MAX_3D_TEXTURE_SIZE_OES:
      results.integer(caps.maxVolumeSize);
      break;
    case kContextFlags:
      results.integer((c.options.debug ? kContextFlagDebugBit : 0) |
                      (c.options.noError ? kContextFlagNoErrorBit : 0));
      break;
    case GL_MAX_SERVER_WAIT_TIMEOUT_APPLE:
      results.integer(0x1p62);  // none: the server waits until the fence has passed
      break;
    case GL_MAX_TEXTURE_LOD_BIAS_EXT:
      results.number(caps.maxLodBias);
      break;
    case GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT:
      results.number(caps.maxAnisotropy);
      break;
    case GL_MAX_RENDERBUFFER_SIZE_OES:
      results.integer(caps.maxTextureSize);
      break;
    case GL_FRAMEBUFFER_BINDING_OES:
      results.integer(c.boundFramebuffer ? c.boundFramebuffer->name : 0);
      break;
    case GL_READ_FRAMEBUFFER_BINDING_APPLE:
      results.integer(c.boundReadFramebuffer ? c.boundReadFramebuffer->name : 0);
      break;
    case GL_MAX_SAMPLES_EXT:
    case GL_MAX_SAMPLES_IMG:
      results.integer(caps.maxSamples > 1 ? caps.maxSamples : 0);
      break;
    case GL_CONTEXT_ROBUST_ACCESS_EXT:
      results.boolean(c.options.robustAccess);
      break;
    case GL_RESET_NOTIFICATION_STRATEGY_EXT:
      results.enumerant(c.options.loseContextOnReset ? GL_LOSE_CONTEXT_ON_RESET_EXT
                                                     : GL_NO_RESET_NOTIFICATION_EXT);
      break;
    case GL_RENDERBUFFER_BINDING_OES:
      results.integer(c.boundRenderbuffer ? c.boundRenderbuffer->name : 0);
      break;
    case GL_MAX_VIEWPORT_DIMS:
      results.integer(caps.maxViewport[0]), results.integer(caps.maxViewport[1]);
      break;
    case GL_ALIASED_POINT_SIZE_RANGE:
      range(caps.pointSizeRange);
      break;
    case GL_SMOOTH_POINT_SIZE_RANGE:
      range(caps.smoothPointSizeRange);
      break;
    case GL_ALIASED_LINE_WIDTH_RANGE:
      range(caps.lineWidthRange);
      break;
    case GL_SMOOTH_LINE_WIDTH_RANGE:
      range(caps.smoothLineWidthRange);
      break;
    case GL_MAX_TEXTURE_UNITS:
      results.integer(gen::kMaxTextureUnits);
      break;
    case GL_NUM_COMPRESSED_TEXTURE_FORMATS:
      results.integer(static_cast<double>(kPalettedFormats.size() + compressedFormats().size()));
      break;
    case GL_COMPRESSED_TEXTURE_FORMATS:
      for (const GLenum format : kPalettedFormats) results.enumerant(format);
      for (const CompressedFormat& format : compressedFormats()) results.enumerant(format.name);
      break;
    default:
      return false;
  }
  return true;
}

// Table 6.23, and OES_read_format.
bool getPixelDepths(Context& c, GLenum name, Results& results) {
  if (c.boundFramebuffer || c.boundReadFramebuffer) {
    ShareLock lock(*c.group);
    c.framebufferComplete();
    c.readFramebufferComplete();
  }
  const render::Framebuffer& framebuffer = c.state.framebuffer;
  const auto infoOf = [](const render::Attachment& attachment) {
    return attachment.image ? render::info(attachment.image->desc().format) : render::FormatInfo{};
  };
  const int samples = c.hasFramebuffer && framebuffer.samples > 1 ? framebuffer.samples : 0;
  switch (name) {
    case GL_SAMPLE_BUFFERS:
      results.integer(samples > 0 ? 1 : 0);
      break;
    case GL_SAMPLES:
      results.integer(samples);
      break;
    case GL_RED_BITS:
      results.integer(infoOf(framebuffer.color).red);
      break;
    case GL_GREEN_BITS:
      results.integer(infoOf(framebuffer.color).green);
      break;
    case GL_BLUE_BITS:
      results.integer(infoOf(framebuffer.color).blue);
      break;
    case GL_ALPHA_BITS:
      results.integer(infoOf(framebuffer.color).alpha);
      break;
    case GL_DEPTH_BITS:
      results.integer(infoOf(framebuffer.depth).depth);
      break;
    case GL_STENCIL_BITS:
      results.integer(stencilBits(c));
      break;
    case GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES:
      results.enumerant(implementationReadFormat(c.readFramebuffer).format);
      break;
    case GL_IMPLEMENTATION_COLOR_READ_TYPE_OES:
      results.enumerant(implementationReadFormat(c.readFramebuffer).type);
      break;
    default:
      return false;
  }
  return true;
}

void get(GLenum name, void* out, Results::Form form, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c || !out) return;
  Results results(out, form);
  if (getTransformation(*c, name, results) || getFragmentOperations(*c, name, results) ||
      getLimits(*c, name, results) || getColoringAndRasterization(*c, name, results) ||
      getTexturesPixelsAndHints(*c, name, results) || getArrays(*c, name, results) ||
      getCurrentValues(*c, name, results) || getPixelDepths(*c, name, results) ||
      getDebugOutput(*c, name, results)) {
    return;
  }
  bool enabled = false;
  if (!isEnabled(*c, name, enabled))
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("pname", name, "Ask for a name of tables 6.3 to 6.23, or of an extension"),
                       command);
  results.boolean(enabled);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;
namespace gen = anteroom::gen;

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
  if (!c || !params) return;
  int index = 0;
  switch (name) {
    case GL_VERTEX_ARRAY_POINTER:
      index = gen::kPosition;
      break;
    case GL_NORMAL_ARRAY_POINTER:
      index = gen::kNormal;
      break;
    case GL_COLOR_ARRAY_POINTER:
      index = gen::kColor;
      break;
    case GL_POINT_SIZE_ARRAY_POINTER_OES:
      index = gen::kPointSize;
      break;
    case GL_MATRIX_INDEX_ARRAY_POINTER_OES:
      index = gen::kMatrixIndex;
      break;
    case GL_WEIGHT_ARRAY_POINTER_OES:
      index = gen::kWeight;
      break;
    case GL_TEXTURE_COORD_ARRAY_POINTER:
      index = gen::texCoord(c->clientActiveTexture);
      break;
    default:
      if (getDebugPointer(*c, name, params)) return;
      return c->setError(GL_INVALID_ENUM,
                         wrongEnum("pname", name, "Ask for VERTEX_ARRAY_POINTER or that of another array"));
  }
  *params = const_cast<void*>(c->vertexArrays.arrays[static_cast<size_t>(index)].pointer);
}
