#include "layer/vulkan/plan/translate.h"

#include <algorithm>
#include <cmath>

namespace anteroom::vulkan {
namespace {

uint8_t compareOp(GLenum function) {
  return static_cast<uint8_t>(function - GL_NEVER);
}
static_assert(VK_COMPARE_OP_NEVER == 0 && VK_COMPARE_OP_LESS == GL_LESS - GL_NEVER &&
              VK_COMPARE_OP_ALWAYS == GL_ALWAYS - GL_NEVER);

uint8_t stencilOp(GLenum op) {
  switch (op) {
    case GL_ZERO:
      return VK_STENCIL_OP_ZERO;
    case GL_REPLACE:
      return VK_STENCIL_OP_REPLACE;
    case GL_INCR:
      return VK_STENCIL_OP_INCREMENT_AND_CLAMP;
    case GL_DECR:
      return VK_STENCIL_OP_DECREMENT_AND_CLAMP;
    case GL_INVERT:
      return VK_STENCIL_OP_INVERT;
    case GL_INCR_WRAP_OES:
      return VK_STENCIL_OP_INCREMENT_AND_WRAP;
    case GL_DECR_WRAP_OES:
      return VK_STENCIL_OP_DECREMENT_AND_WRAP;
    default:
      return VK_STENCIL_OP_KEEP;
  }
}

uint8_t blendFactor(GLenum factor) {
  switch (factor) {
    case GL_ZERO:
      return VK_BLEND_FACTOR_ZERO;
    case GL_SRC_COLOR:
      return VK_BLEND_FACTOR_SRC_COLOR;
    case GL_ONE_MINUS_SRC_COLOR:
      return VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR;
    case GL_DST_COLOR:
      return VK_BLEND_FACTOR_DST_COLOR;
    case GL_ONE_MINUS_DST_COLOR:
      return VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR;
    case GL_SRC_ALPHA:
      return VK_BLEND_FACTOR_SRC_ALPHA;
    case GL_ONE_MINUS_SRC_ALPHA:
      return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    case GL_DST_ALPHA:
      return VK_BLEND_FACTOR_DST_ALPHA;
    case GL_ONE_MINUS_DST_ALPHA:
      return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
    case GL_SRC_ALPHA_SATURATE:
      return VK_BLEND_FACTOR_SRC_ALPHA_SATURATE;
    default:
      return VK_BLEND_FACTOR_ONE;
  }
}

uint8_t blendOp(GLenum equation) {
  switch (equation) {
    case GL_FUNC_SUBTRACT_OES:
      return VK_BLEND_OP_SUBTRACT;
    case GL_FUNC_REVERSE_SUBTRACT_OES:
      return VK_BLEND_OP_REVERSE_SUBTRACT;
    case GL_MIN_EXT:
      return VK_BLEND_OP_MIN;
    case GL_MAX_EXT:
      return VK_BLEND_OP_MAX;
    default:
      return VK_BLEND_OP_ADD;
  }
}

uint8_t logicOp(GLenum op) {
  switch (op) {
    case GL_CLEAR:
      return VK_LOGIC_OP_CLEAR;
    case GL_AND:
      return VK_LOGIC_OP_AND;
    case GL_AND_REVERSE:
      return VK_LOGIC_OP_AND_REVERSE;
    case GL_AND_INVERTED:
      return VK_LOGIC_OP_AND_INVERTED;
    case GL_NOOP:
      return VK_LOGIC_OP_NO_OP;
    case GL_XOR:
      return VK_LOGIC_OP_XOR;
    case GL_OR:
      return VK_LOGIC_OP_OR;
    case GL_NOR:
      return VK_LOGIC_OP_NOR;
    case GL_EQUIV:
      return VK_LOGIC_OP_EQUIVALENT;
    case GL_INVERT:
      return VK_LOGIC_OP_INVERT;
    case GL_OR_REVERSE:
      return VK_LOGIC_OP_OR_REVERSE;
    case GL_COPY_INVERTED:
      return VK_LOGIC_OP_COPY_INVERTED;
    case GL_OR_INVERTED:
      return VK_LOGIC_OP_OR_INVERTED;
    case GL_NAND:
      return VK_LOGIC_OP_NAND;
    case GL_SET:
      return VK_LOGIC_OP_SET;
    default:
      return VK_LOGIC_OP_COPY;
  }
}

// Section 4.1.3: a mask whose share of ones is the coverage value.
uint8_t sampleMask(const render::FragmentOps& ops, int samples) {
  const uint32_t all = (1u << samples) - 1;
  if (!ops.sampleCoverage) return static_cast<uint8_t>(all);
  const float value = std::clamp(ops.sampleCoverageValue, 0.0f, 1.0f);
  const uint32_t mask = (1u << std::lround(value * static_cast<float>(samples))) - 1;
  return static_cast<uint8_t>(ops.sampleCoverageInvert ? all & ~mask : mask);
}

void translateDepthStencil(const render::FragmentOps& ops, const Target& target, DrawState& out) {
  BakedState& fixed = out.fixed;
  fixed.depthTest = ops.depthTest && target.hasDepth;
  fixed.depthWrite = fixed.depthTest && ops.depthMask;
  fixed.depthCompare = fixed.depthTest ? compareOp(ops.depthFunc) : uint8_t{VK_COMPARE_OP_ALWAYS};
  // A test that always passes and writes nothing is none.
  if (fixed.depthCompare == VK_COMPARE_OP_ALWAYS && !fixed.depthWrite) fixed.depthTest = 0;
  fixed.stencilTest = ops.stencilTest && target.hasStencil;
  if (fixed.stencilTest) {
    fixed.stencilCompare = compareOp(ops.stencilFunc);
    fixed.stencilFail = stencilOp(ops.stencilFail);
    fixed.stencilPass = stencilOp(ops.stencilDepthPass);
    fixed.stencilDepthFail = stencilOp(ops.stencilDepthFail);
    out.stencilCompareMask = ops.stencilValueMask & 0xff;
    out.stencilWriteMask = ops.stencilWriteMask & 0xff;
    out.stencilReference = static_cast<uint32_t>(std::clamp(ops.stencilRef, 0, 255));
  } else {
    fixed.stencilCompare = VK_COMPARE_OP_ALWAYS;
    fixed.stencilFail = fixed.stencilPass = fixed.stencilDepthFail = VK_STENCIL_OP_KEEP;
    out.stencilCompareMask = out.stencilWriteMask = 0xff;
    out.stencilReference = 0;
  }
}

void translateBlending(const render::FragmentOps& ops, const Target& target, const Features& features,
                       BakedState& fixed) {
  fixed.writeMask = writeMask(ops.colorMask, target);
  fixed.logicOpEnable = ops.logicOpEnabled && ops.logicOp != GL_COPY && features.logicOp;
  fixed.logicOp = fixed.logicOpEnable ? logicOp(ops.logicOp) : uint8_t{VK_LOGIC_OP_COPY};
  fixed.blend = ops.blend && !ops.logicOpEnabled && target.color;
  fixed.srcRgb = fixed.srcAlpha = VK_BLEND_FACTOR_ONE;
  fixed.dstRgb = fixed.dstAlpha = VK_BLEND_FACTOR_ZERO;
  fixed.opRgb = fixed.opAlpha = VK_BLEND_OP_ADD;
  if (fixed.blend) {
    fixed.srcRgb = blendFactor(ops.blendSrcRgb);
    fixed.dstRgb = blendFactor(ops.blendDstRgb);
    fixed.opRgb = blendOp(ops.blendEquationRgb);
    if (fixed.writeMask & VK_COLOR_COMPONENT_A_BIT) {
      fixed.srcAlpha = blendFactor(ops.blendSrcAlpha);
      fixed.dstAlpha = blendFactor(ops.blendDstAlpha);
      fixed.opAlpha = blendOp(ops.blendEquationAlpha);
    }
  }
  const bool multisample = ops.multisample && target.samples > 1;
  fixed.alphaToCoverage = multisample && ops.sampleAlphaToCoverage;
  fixed.alphaToOne = multisample && ops.sampleAlphaToOne && features.alphaToOne;
  fixed.sampleMask =
      multisample ? sampleMask(ops, target.samples) : static_cast<uint8_t>((1u << target.samples) - 1);
}

// Images hold GL's row 0 first, and Vulkan's window coordinates then are GL's: the sign of a polygon's area,
// which the two define alike but for the direction of y, is turned.
uint8_t frontFace(GLenum face, bool yDown) {
  return (face == GL_CCW) == yDown ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
}

uint8_t cullMode(const render::Raster& raster) {
  if (!raster.cullFace) return VK_CULL_MODE_NONE;
  if (raster.cullFaceMode == GL_FRONT) return VK_CULL_MODE_FRONT_BIT;
  return raster.cullFaceMode == GL_BACK ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_FRONT_AND_BACK;
}

void translateRaster(const render::State& state, const Target& target, const Features& features,
                     const VkPhysicalDeviceLimits& limits, DrawState& out) {
  const render::Raster& raster = state.raster;
  BakedState& fixed = out.fixed;
  fixed.cullMode = cullMode(raster);
  fixed.frontFace = frontFace(raster.frontFace, target.yDown);
  fixed.depthBias = raster.polygonOffsetFill && target.hasDepth &&
                    (raster.polygonOffsetFactor != 0 || raster.polygonOffsetUnits != 0);
  out.biasFactor = fixed.depthBias ? raster.polygonOffsetFactor : 0;
  out.biasUnits = fixed.depthBias ? raster.polygonOffsetUnits : 0;
  if (!std::isfinite(out.biasFactor)) out.biasFactor = 0;
  if (!std::isfinite(out.biasUnits)) out.biasUnits = 0;
  const float clamp = raster.polygonOffsetClamp;
  out.biasClamp = fixed.depthBias && features.depthBiasClamp && std::isfinite(clamp) ? clamp : 0;

  const bool smooth = state.fixed.lineSmooth && target.samples == 1 && features.smoothLines;
  fixed.lineMode = VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT;
  if (smooth)
    fixed.lineMode = VK_LINE_RASTERIZATION_MODE_RECTANGULAR_SMOOTH_EXT;
  else if (features.bresenhamLines && target.samples == 1)
    fixed.lineMode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  // Section 3.4.1: the width of lines that are not smooth is rounded.
  const bool rounded = !state.fixed.lineSmooth && target.samples == 1;
  const float width = rounded ? std::max(1.0f, std::round(raster.lineWidth)) : raster.lineWidth;
  out.lineWidth =
      features.wideLines ? std::clamp(width, limits.lineWidthRange[0], limits.lineWidthRange[1]) : 1;
}

bool translateViewport(const render::State& state, const Target& target, const VkPhysicalDeviceLimits& limits,
                       DrawState& out) {
  const render::Rect& v = state.fixed.viewport;
  const render::Rect window =
      clipped(state.scissorTest ? state.scissor : render::Rect{0, 0, target.width, target.height}, target);
  out.scissor = flipped(window, target);
  if (v.width <= 0 || v.height <= 0 || window.width <= 0 || window.height <= 0) return false;
  const float low = limits.viewportBoundsRange[0], high = limits.viewportBoundsRange[1];
  const float width =
      std::min(static_cast<float>(v.width), static_cast<float>(limits.maxViewportDimensions[0]));
  const float height =
      std::min(static_cast<float>(v.height), static_cast<float>(limits.maxViewportDimensions[1]));
  const float x = std::clamp(static_cast<float>(v.x), low, high - width);
  float y = std::clamp(static_cast<float>(v.y), low, high - height);
  // Section 3.4.1 lets the ends of lines be moved a little, so that none lies on a corner of a diamond: drivers lose or
  // double a pixel where lines meet on pixel centres.
  if (state.fixed.primitive == gen::PrimitiveClass::Lines &&
      out.fixed.lineMode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT)
    y = std::max(low, y - std::ldexp(1.0f, -static_cast<int>(limits.subPixelPrecisionBits)));
  out.viewport = {
      x, y, width, height, std::clamp(state.depthNear, 0.0f, 1.0f), std::clamp(state.depthFar, 0.0f, 1.0f)};
  if (target.yDown) {
    out.viewport.y = static_cast<float>(target.height) - y;
    out.viewport.height = -height;
  }
  return true;
}

}  // namespace

bool translate(const render::State& state, const Target& target, const Features& features,
               const VkPhysicalDeviceLimits& limits, DrawState& out) {
  translateDepthStencil(state.ops, target, out);
  translateBlending(state.ops, target, features, out.fixed);
  translateRaster(state, target, features, limits, out);
  const bool culled = out.fixed.cullMode == VK_CULL_MODE_FRONT_AND_BACK &&
                      state.fixed.primitive == gen::PrimitiveClass::Triangles;
  return translateViewport(state, target, limits, out) && !culled;
}

}  // namespace anteroom::vulkan
