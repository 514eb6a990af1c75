// Sections 4.1 and 4.2.2: per-fragment operations and write masks; 2.10.1: viewport and depth range.
#include <algorithm>

#include "layer/gl/context/params.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

constexpr gen::Groups kOps = gen::kGroupFragmentOps;

bool isCompareFunc(GLenum func) {
  return func >= GL_NEVER && func <= GL_ALWAYS;
}

bool isStencilOp(GLenum op) {
  return op == GL_KEEP || op == GL_ZERO || op == GL_REPLACE || op == GL_INCR || op == GL_DECR ||
         op == GL_INVERT || op == GL_INCR_WRAP_OES || op == GL_DECR_WRAP_OES;
}

// OES_blend_func_separate, whose table 4.blendfunc stands in place of tables 4.1 and 4.2 for glBlendFunc, too.
bool isDestinationFactor(GLenum factor) {
  return factor == GL_ZERO || factor == GL_ONE ||
         (factor >= GL_SRC_COLOR && factor <= GL_ONE_MINUS_DST_COLOR);
}
bool isSourceFactor(GLenum factor) {
  return isDestinationFactor(factor) || factor == GL_SRC_ALPHA_SATURATE;
}

// OES_blend_subtract and EXT_blend_minmax.
bool isBlendEquation(GLenum mode) {
  return mode == GL_FUNC_ADD_OES || mode == GL_FUNC_SUBTRACT_OES || mode == GL_FUNC_REVERSE_SUBTRACT_OES ||
         mode == GL_MIN_EXT || mode == GL_MAX_EXT;
}

void setBlendFunc(Context& c, GLenum srcRgb, GLenum dstRgb, GLenum srcAlpha, GLenum dstAlpha) {
  anteroom::render::FragmentOps& ops = c.state.ops;
  c.set(ops.blendSrcRgb, srcRgb, kOps);
  c.set(ops.blendSrcAlpha, srcAlpha, kOps);
  c.set(ops.blendDstRgb, dstRgb, kOps);
  c.set(ops.blendDstAlpha, dstAlpha, kOps);
}

constexpr const char* kCompareFuncs = "Use NEVER, LESS, EQUAL, LEQUAL, GREATER, NOTEQUAL, GEQUAL or ALWAYS";
constexpr const char* kDestinationFactors =
    "Use ZERO, ONE, SRC_COLOR, ONE_MINUS_SRC_COLOR, DST_COLOR, ONE_MINUS_DST_COLOR, SRC_ALPHA, "
    "ONE_MINUS_SRC_ALPHA, DST_ALPHA or ONE_MINUS_DST_ALPHA";
constexpr const char* kSourceFactors =
    "Use ZERO, ONE, SRC_COLOR, ONE_MINUS_SRC_COLOR, DST_COLOR, ONE_MINUS_DST_COLOR, SRC_ALPHA, "
    "ONE_MINUS_SRC_ALPHA, DST_ALPHA, ONE_MINUS_DST_ALPHA or SRC_ALPHA_SATURATE";
constexpr const char* kEquations =
    "Use FUNC_ADD_OES, FUNC_SUBTRACT_OES, FUNC_REVERSE_SUBTRACT_OES, MIN_EXT or MAX_EXT";

Fault negativeSize(GLsizei width, GLsizei height) {
  return wrongNumber(width < 0 ? "width" : "height", width < 0 ? width : height, "Give a size from 0 on");
}

}  // namespace

GL_API void GL_APIENTRY glViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
  Context* c = current();
  if (!c) return;
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, negativeSize(width, height));
  const int(&limits)[2] = c->device.caps().maxViewport;
  anteroom::render::Rect& viewport = c->state.fixed.viewport;
  c->set(viewport.x, x, gen::kGroupViewport);
  c->set(viewport.y, y, gen::kGroupViewport);
  c->set(viewport.width, std::min(width, limits[0]), gen::kGroupViewport);
  c->set(viewport.height, std::min(height, limits[1]), gen::kGroupViewport);
}

GL_API void GL_APIENTRY glDepthRangef(GLclampf n, GLclampf f) {
  Context* c = current();
  if (!c) return;
  c->set(c->state.depthNear, clamp01(n), gen::kGroupViewport);
  c->set(c->state.depthFar, clamp01(f), gen::kGroupViewport);
}
GL_API void GL_APIENTRY glDepthRangex(GLclampx n, GLclampx f) {
  glDepthRangef(fromFixed(n), fromFixed(f));
}

GL_API void GL_APIENTRY glScissor(GLint x, GLint y, GLsizei width, GLsizei height) {
  Context* c = current();
  if (!c) return;
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE, negativeSize(width, height));
  anteroom::render::Rect& scissor = c->state.scissor;
  c->set(scissor.x, x, gen::kGroupViewport);
  c->set(scissor.y, y, gen::kGroupViewport);
  c->set(scissor.width, width, gen::kGroupViewport);
  c->set(scissor.height, height, gen::kGroupViewport);
}

GL_API void GL_APIENTRY glSampleCoverage(GLclampf value, GLboolean invert) {
  Context* c = current();
  if (!c) return;
  c->set(c->state.ops.sampleCoverageValue, clamp01(value), kOps);
  c->set(c->state.ops.sampleCoverageInvert, invert != GL_FALSE, kOps);
}
GL_API void GL_APIENTRY glSampleCoveragex(GLclampx value, GLboolean invert) {
  glSampleCoverage(fromFixed(value), invert);
}

GL_API void GL_APIENTRY glAlphaFunc(GLenum func, GLclampf ref) {
  Context* c = current();
  if (!c) return;
  if (!isCompareFunc(func)) return c->setError(GL_INVALID_ENUM, wrongEnum("func", func, kCompareFuncs));
  c->set(c->state.fixed.alphaFunc, func, gen::kGroupAlphaTest);
  c->set(c->state.fixed.alphaRef, clamp01(ref), gen::kGroupAlphaTest);
}
GL_API void GL_APIENTRY glAlphaFuncx(GLenum func, GLclampx ref) {
  glAlphaFunc(func, fromFixed(ref));
}

GL_API void GL_APIENTRY glStencilFunc(GLenum func, GLint ref, GLuint mask) {
  Context* c = current();
  if (!c) return;
  if (!isCompareFunc(func)) return c->setError(GL_INVALID_ENUM, wrongEnum("func", func, kCompareFuncs));
  c->set(c->state.ops.stencilFunc, func, kOps);
  c->set(c->state.ops.stencilValueMask, mask, kOps);
  c->stencilRef = ref;
  applyStencilRef(*c);
}

GL_API void GL_APIENTRY glStencilOp(GLenum fail, GLenum depthFail, GLenum depthPass) {
  Context* c = current();
  if (!c) return;
  if (!isStencilOp(fail) || !isStencilOp(depthFail) || !isStencilOp(depthPass)) {
    const char* const which = !isStencilOp(fail) ? "fail" : !isStencilOp(depthFail) ? "zfail" : "zpass";
    const GLenum op = !isStencilOp(fail) ? fail : !isStencilOp(depthFail) ? depthFail : depthPass;
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum(which, op, "Use KEEP, ZERO, REPLACE, INCR, DECR, INVERT, INCR_WRAP_OES or DECR_WRAP_OES"));
  }
  c->set(c->state.ops.stencilFail, fail, kOps);
  c->set(c->state.ops.stencilDepthFail, depthFail, kOps);
  c->set(c->state.ops.stencilDepthPass, depthPass, kOps);
}

GL_API void GL_APIENTRY glDepthFunc(GLenum func) {
  Context* c = current();
  if (!c) return;
  if (!isCompareFunc(func)) return c->setError(GL_INVALID_ENUM, wrongEnum("func", func, kCompareFuncs));
  c->set(c->state.ops.depthFunc, func, kOps);
}

GL_API void GL_APIENTRY glBlendFunc(GLenum source, GLenum destination) {
  Context* c = current();
  if (!c) return;
  if (!isSourceFactor(source))
    return c->setError(GL_INVALID_ENUM, wrongEnum("sfactor", source, kSourceFactors));
  if (!isDestinationFactor(destination))
    return c->setError(GL_INVALID_ENUM, wrongEnum("dfactor", destination, kDestinationFactors));
  setBlendFunc(*c, source, destination, source, destination);
}

GL_API void GL_APIENTRY glBlendFuncSeparateOES(GLenum srcRGB, GLenum dstRGB, GLenum srcAlpha,
                                               GLenum dstAlpha) {
  Context* c = current();
  if (!c) return;
  if (!isSourceFactor(srcRGB))
    return c->setError(GL_INVALID_ENUM, wrongEnum("srcRGB", srcRGB, kSourceFactors));
  if (!isDestinationFactor(dstRGB))
    return c->setError(GL_INVALID_ENUM, wrongEnum("dstRGB", dstRGB, kDestinationFactors));
  if (!isSourceFactor(srcAlpha))
    return c->setError(GL_INVALID_ENUM, wrongEnum("srcAlpha", srcAlpha, kSourceFactors));
  if (!isDestinationFactor(dstAlpha))
    return c->setError(GL_INVALID_ENUM, wrongEnum("dstAlpha", dstAlpha, kDestinationFactors));
  setBlendFunc(*c, srcRGB, dstRGB, srcAlpha, dstAlpha);
}

GL_API void GL_APIENTRY glBlendEquationSeparateOES(GLenum modeRGB, GLenum modeAlpha) {
  Context* c = current();
  if (!c) return;
  if (!isBlendEquation(modeRGB))
    return c->setError(GL_INVALID_ENUM, wrongEnum("modeRGB", modeRGB, kEquations));
  if (!isBlendEquation(modeAlpha))
    return c->setError(GL_INVALID_ENUM, wrongEnum("modeAlpha", modeAlpha, kEquations));
  c->set(c->state.ops.blendEquationRgb, modeRGB, kOps);
  c->set(c->state.ops.blendEquationAlpha, modeAlpha, kOps);
}
GL_API void GL_APIENTRY glBlendEquationOES(GLenum mode) {
  glBlendEquationSeparateOES(mode, mode);
}

GL_API void GL_APIENTRY glLogicOp(GLenum op) {
  Context* c = current();
  if (!c) return;
  if (op < GL_CLEAR || op > GL_SET)
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum("opcode", op,
                  "Use CLEAR, AND, AND_REVERSE, COPY, AND_INVERTED, NOOP, XOR, OR, NOR, EQUIV, INVERT, "
                  "OR_REVERSE, COPY_INVERTED, OR_INVERTED, NAND or SET"));
  c->set(c->state.ops.logicOp, op, kOps);
}

GL_API void GL_APIENTRY glColorMask(GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
  Context* c = current();
  if (!c) return;
  const std::array<bool, 4> mask{r != GL_FALSE, g != GL_FALSE, b != GL_FALSE, a != GL_FALSE};
  c->set(c->state.ops.colorMask, mask, kOps);
}

GL_API void GL_APIENTRY glDepthMask(GLboolean mask) {
  if (Context* c = current()) c->set(c->state.ops.depthMask, mask != GL_FALSE, kOps);
}

GL_API void GL_APIENTRY glStencilMask(GLuint mask) {
  if (Context* c = current()) c->set(c->state.ops.stencilWriteMask, mask, kOps);
}
