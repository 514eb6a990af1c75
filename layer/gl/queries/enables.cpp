// Enable, Disable and IsEnabled (tables 6.7 to 6.17). A new capability is a row here.
#include "layer/gl/queries/enables.h"

#include "layer/gl/debug/debug_output.h"
#include "layer/gl/queries/query.h"
#include "layer/gl/vertices/vertex_arrays.h"

namespace anteroom::gl {

namespace {

struct Capability {
  GLenum name;
  gen::Groups groups;  // that it belongs to
  bool* (*enabled)(Context&);
  void (*changed)(Context&) = nullptr;  // what follows from another value; null: nothing
};

// Section 2.12.3: what ambient and diffuse followed stays.
void keepTrackedColor(Context& c) {
  gen::Material& material = c.state.fixed.lighting.material;
  if (!c.state.fixed.lighting.colorMaterial)
    material.ambient = material.diffuse = c.state.fixed.attributes[gen::kColor].current;
}

void showPalette(Context& c) {
  c.state.fixed.palette = c.paletteEnabled ? &c.palette : nullptr;
}

static_assert(gen::kMaxLights == 8 && gen::kMaxClipPlanes == 8, "each has a row");

template <size_t index>
bool* light(Context& c) {
  return &c.state.fixed.lighting.lights[index].enabled;
}
template <size_t index>
bool* clipPlane(Context& c) {
  return &c.state.fixed.clipPlanes[index].enabled;
}

constexpr auto kCapabilities = tableOf<Capability>({
    // Table 6.7, OES_matrix_palette
    {GL_NORMALIZE, gen::kGroupLighting, [](Context& c) { return &c.state.fixed.lighting.normalize; }},
    {GL_RESCALE_NORMAL, gen::kGroupLighting,
     [](Context& c) { return &c.state.fixed.lighting.rescaleNormal; }},
    {GL_CLIP_PLANE0, gen::kGroupClipPlanes, clipPlane<0>},
    {GL_CLIP_PLANE1, gen::kGroupClipPlanes, clipPlane<1>},
    {GL_CLIP_PLANE2, gen::kGroupClipPlanes, clipPlane<2>},
    {GL_CLIP_PLANE3, gen::kGroupClipPlanes, clipPlane<3>},
    {GL_CLIP_PLANE4, gen::kGroupClipPlanes, clipPlane<4>},
    {GL_CLIP_PLANE5, gen::kGroupClipPlanes, clipPlane<5>},
    {GL_CLIP_PLANE0 + 6, gen::kGroupClipPlanes, clipPlane<6>},
    {GL_CLIP_PLANE0 + 7, gen::kGroupClipPlanes, clipPlane<7>},
    {GL_MATRIX_PALETTE_OES, gen::kGroupPalette, [](Context& c) { return &c.paletteEnabled; }, showPalette},

    // Tables 6.8 to 6.10
    {GL_FOG, gen::kGroupFog, [](Context& c) { return &c.state.fixed.fog.enabled; }},
    {GL_LIGHTING, gen::kGroupLighting, [](Context& c) { return &c.state.fixed.lighting.enabled; }},
    {GL_COLOR_MATERIAL, gen::kGroupLighting, [](Context& c) { return &c.state.fixed.lighting.colorMaterial; },
     keepTrackedColor},
    {GL_LIGHT0, gen::kGroupLighting, light<0>},
    {GL_LIGHT1, gen::kGroupLighting, light<1>},
    {GL_LIGHT2, gen::kGroupLighting, light<2>},
    {GL_LIGHT3, gen::kGroupLighting, light<3>},
    {GL_LIGHT4, gen::kGroupLighting, light<4>},
    {GL_LIGHT5, gen::kGroupLighting, light<5>},
    {GL_LIGHT6, gen::kGroupLighting, light<6>},
    {GL_LIGHT7, gen::kGroupLighting, light<7>},

    // Table 6.11
    {GL_POINT_SMOOTH, gen::kGroupPoints, [](Context& c) { return &c.state.fixed.points.smooth; }},
    {GL_POINT_SPRITE_OES, gen::kGroupPoints, [](Context& c) { return &c.state.fixed.points.sprite; }},
    {GL_LINE_SMOOTH, gen::kGroupRaster, [](Context& c) { return &c.state.fixed.lineSmooth; }},
    {GL_CULL_FACE, gen::kGroupRaster, [](Context& c) { return &c.state.raster.cullFace; }},
    {GL_POLYGON_OFFSET_FILL, gen::kGroupRaster, [](Context& c) { return &c.state.raster.polygonOffsetFill; }},

    // Table 6.12
    {GL_MULTISAMPLE, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.multisample; },
     updateMultisample},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, gen::kGroupFragmentOps,
     [](Context& c) { return &c.state.ops.sampleAlphaToCoverage; }},
    {GL_SAMPLE_ALPHA_TO_ONE, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.sampleAlphaToOne; },
     updateMultisample},
    {GL_SAMPLE_COVERAGE, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.sampleCoverage; }},

    // Tables 6.13 and 6.15, OES_texture_cube_map, OES_texture_3D, OES_EGL_image_external
    {GL_TEXTURE_2D, gen::kGroupTextures,
     [](Context& c) { return &c.units[c.activeTexture].enabled[kSlot2D]; }},
    {GL_TEXTURE_CUBE_MAP_OES, gen::kGroupTextures,
     [](Context& c) { return &c.units[c.activeTexture].enabled[kSlotCube]; }},
    {GL_TEXTURE_3D_OES, gen::kGroupTextures,
     [](Context& c) { return &c.units[c.activeTexture].enabled[kSlot3D]; }},
    {GL_TEXTURE_EXTERNAL_OES, gen::kGroupTextures,
     [](Context& c) { return &c.units[c.activeTexture].enabled[kSlotExternal]; }},
    {GL_TEXTURE_GEN_STR_OES, gen::kGroupTextures,
     [](Context& c) { return &c.state.fixed.units[c.activeTexture].texGen; }},

    // Table 6.16
    {GL_SCISSOR_TEST, gen::kGroupViewport, [](Context& c) { return &c.state.scissorTest; }},
    {GL_ALPHA_TEST, gen::kGroupAlphaTest, [](Context& c) { return &c.state.fixed.alphaTest; }},
    {GL_STENCIL_TEST, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.stencilTest; }},
    {GL_DEPTH_TEST, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.depthTest; }},
    {GL_BLEND, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.blend; }},
    {GL_DITHER, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.dither; }},
    {GL_COLOR_LOGIC_OP, gen::kGroupFragmentOps, [](Context& c) { return &c.state.ops.logicOpEnabled; }},

    // KHR_debug. Messages are always synchronous.
    {GL_DEBUG_OUTPUT_KHR, 0, [](Context& c) { return &c.debugOutput; }, updateListener},
    {GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR, 0, [](Context& c) { return &c.debugSynchronous; }},
});

Fault unknownCapability(GLenum name) {
  return wrongEnum("cap", name,
                   "Use a capability such as BLEND, LIGHTING or TEXTURE_2D; arrays have glEnableClientState");
}

void setCapability(GLenum name, bool enable, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const Capability* capability = kCapabilities.find(name);
  if (!capability) return c->setError(GL_INVALID_ENUM, unknownCapability(name), command);
  bool* enabled = capability->enabled(*c);
  if (*enabled == enable) return;
  *enabled = enable;
  c->mark(capability->groups);
  if (capability->changed) capability->changed(*c);
}

}  // namespace

bool isEnabled(Context& c, GLenum name, bool& enabled) {
  if (const Capability* capability = kCapabilities.find(name)) {
    enabled = *capability->enabled(c);
    return true;
  }
  gen::Attribute attribute;
  if (!attributeOf(c, name, attribute)) return false;
  enabled = c.vertexArrays.arrays[attribute].enabled;
  return true;
}

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
