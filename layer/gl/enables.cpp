#include "layer/gl/enables.h"
#include "layer/gl/debug_output.h"
#include "layer/gl/missing_enums.h"

#include "layer/gl/vertex_arrays.h"

namespace anteroom::gl {

namespace {

template <class Array>
bool* nth(Array& array, GLenum index) {
  return index < array.size() ? &array[index].enabled : nullptr;
}

}  // namespace

Capability capabilityOf(Context& c, GLenum name) {
  gen::State& fixed = c.state.fixed;
  gen::Lighting& lighting = fixed.lighting;
  render::Raster& raster = c.state.raster;
  render::FragmentOps& ops = c.state.ops;
  UnitBindings& unit = c.units[c.activeTexture];
  switch (name) {
    case GL_LIGHTING:
      return {&lighting.enabled, gen::kGroupLighting};
    case GL_COLOR_MATERIAL:
      return {&lighting.colorMaterial, gen::kGroupLighting};
    case GL_NORMALIZE:
      return {&lighting.normalize, gen::kGroupLighting};
    case GL_MATRIX_PALETTE_OES:
      return {&c.paletteEnabled, gen::kGroupPalette};
    case GL_RESCALE_NORMAL:
      return {&lighting.rescaleNormal, gen::kGroupLighting};
    case GL_TEXTURE_2D:
      return {&unit.enabled[kSlot2D], gen::kGroupTextures};
    case GL_TEXTURE_CUBE_MAP_OES:
      return {&unit.enabled[kSlotCube], gen::kGroupTextures};
    case GL_TEXTURE_3D_OES:
      return {&unit.enabled[kSlot3D], gen::kGroupTextures};
    case GL_TEXTURE_EXTERNAL_OES:
      return {&unit.enabled[kSlotExternal], gen::kGroupTextures};
    case GL_TEXTURE_GEN_STR_OES:
      return {&fixed.units[c.activeTexture].texGen, gen::kGroupTextures};
    case GL_FOG:
      return {&fixed.fog.enabled, gen::kGroupFog};
    case GL_POINT_SMOOTH:
      return {&fixed.points.smooth, gen::kGroupPoints};
    case GL_POINT_SPRITE_OES:
      return {&fixed.points.sprite, gen::kGroupPoints};
    case GL_LINE_SMOOTH:
      return {&fixed.lineSmooth, gen::kGroupRaster};
    case GL_CULL_FACE:
      return {&raster.cullFace, gen::kGroupRaster};
    case GL_POLYGON_OFFSET_FILL:
      return {&raster.polygonOffsetFill, gen::kGroupRaster};
    case GL_ALPHA_TEST:
      return {&fixed.alphaTest, gen::kGroupAlphaTest};
    case GL_SCISSOR_TEST:
      return {&c.state.scissorTest, gen::kGroupViewport};
    case GL_STENCIL_TEST:
      return {&ops.stencilTest, gen::kGroupFragmentOps};
    case GL_DEPTH_TEST:
      return {&ops.depthTest, gen::kGroupFragmentOps};
    case GL_BLEND:
      return {&ops.blend, gen::kGroupFragmentOps};
    case GL_DITHER:
      return {&ops.dither, gen::kGroupFragmentOps};
    case GL_COLOR_LOGIC_OP:
      return {&ops.logicOpEnabled, gen::kGroupFragmentOps};
    case GL_MULTISAMPLE:
      return {&ops.multisample, gen::kGroupFragmentOps};
    case GL_SAMPLE_ALPHA_TO_COVERAGE:
      return {&ops.sampleAlphaToCoverage, gen::kGroupFragmentOps};
    case GL_SAMPLE_ALPHA_TO_ONE:
      return {&ops.sampleAlphaToOne, gen::kGroupFragmentOps};
    case GL_SAMPLE_COVERAGE:
      return {&ops.sampleCoverage, gen::kGroupFragmentOps};
    case GL_DEBUG_OUTPUT_KHR:
      return {&c.debugOutput, 0};
    case GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR:  // messages always are
      return {&c.debugSynchronous, 0};
    default:
      break;
  }
  if (bool* light = nth(lighting.lights, name - GL_LIGHT0)) return {light, gen::kGroupLighting};
  return {nth(fixed.clipPlanes, name - GL_CLIP_PLANE0), gen::kGroupClipPlanes};
}

bool isEnabled(Context& c, GLenum name, bool& enabled) {
  if (const bool* capability = capabilityOf(c, name).enabled) {
    enabled = *capability;
    return true;
  }
  gen::Attribute attribute;
  if (!attributeOf(c, name, attribute)) return false;
  enabled = c.vertexArrays.arrays[attribute].enabled;
  return true;
}

namespace {

Fault unknownCapability(GLenum name) {
  return wrongEnum("cap", name,
                   "Use a capability such as BLEND, LIGHTING or TEXTURE_2D; arrays have glEnableClientState");
}

void setCapability(GLenum name, bool enable, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const Capability capability = capabilityOf(*c, name);
  if (!capability.enabled) return c->setError(GL_INVALID_ENUM, unknownCapability(name), command);
  if (*capability.enabled == enable) return;
  *capability.enabled = enable;
  c->mark(capability.groups);

  if (name == GL_COLOR_MATERIAL && !enable) {
    // Section 2.12.3: what ambient and diffuse followed stays.
    gen::Material& material = c->state.fixed.lighting.material;
    material.ambient = material.diffuse = c->state.fixed.attributes[gen::kColor].current;
  }
  if (name == GL_MATRIX_PALETTE_OES) c->state.fixed.palette = enable ? &c->palette : nullptr;
  if (name == GL_DEBUG_OUTPUT_KHR) updateListener(*c);
  if (name == GL_MULTISAMPLE || name == GL_SAMPLE_ALPHA_TO_ONE) updateMultisample(*c);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glEnable(GLenum cap) {
  setCapability(cap, true);
}
GL_API void GL_APIENTRY glDisable(GLenum cap) {
  setCapability(cap, false);
}

GL_API GLboolean GL_APIENTRY glIsEnabled(GLenum cap) {
  Context* c = current();
  if (!c) return GL_FALSE;
  bool enabled = false;
  if (!isEnabled(*c, cap, enabled)) c->setError(GL_INVALID_ENUM, unknownCapability(cap));
  return enabled ? GL_TRUE : GL_FALSE;
}
