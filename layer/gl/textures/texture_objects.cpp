// Texture names and bindings (section 3.7.11), images of EGL, and what a draw samples (section 3.7.13).
#include "gen/ati.h"
#include "layer/gl/context/object_commands.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/texture.h"

namespace anteroom::gl {
namespace {

struct Target {
  TextureSlot slot;
  gen::TextureTarget target;
};

// OES_texture_cube_map: when both are enabled, the cube map is used, and when it is not complete the unit is
// off.
constexpr Target kByPriority[] = {
    {kSlotExternal, gen::TextureTarget::Texture2D},  // OES_EGL_image_external: before all others
    {kSlotCube, gen::TextureTarget::CubeMap},
    {kSlot3D, gen::TextureTarget::Texture3D},  // as in EXT_texture3D: before TEXTURE_2D
    {kSlot2D, gen::TextureTarget::Texture2D},
};

void bind(Context& c, UnitBindings& unit, TextureSlot slot, std::shared_ptr<Texture> texture) {
  if (unit.bound[slot] == texture) return;
  unit.bound[slot] = std::move(texture);
  if (unit.enabled[slot]) c.mark(gen::kGroupTextures);
}

void unbind(Context& c, const std::shared_ptr<Texture>& texture) {
  const TextureSlot slot = texture->slot;
  detach(c, texture.get(), nullptr);
  for (UnitBindings& unit : c.units) {
    if (unit.bound[slot] == texture) bind(c, unit, slot, c.defaultTextures[slot]);
  }
}

// EXT_texture_mirror_clamp; the border shows where a filter is linear.
gen::MirroredEdge edgeOf(GLenum wrap, const render::Sampler& sampler) {
  const bool linear = sampler.magFilter == GL_LINEAR || sampler.minFilter == GL_LINEAR ||
                      sampler.minFilter == GL_LINEAR_MIPMAP_NEAREST ||
                      sampler.minFilter == GL_LINEAR_MIPMAP_LINEAR;
  switch (wrap) {
    case gen::kMirrorClamp:
      return linear ? gen::MirroredEdge::Half : gen::MirroredEdge::Texel;
    case gen::kMirrorClampToEdge:
      return gen::MirroredEdge::Texel;
    case gen::kMirrorClampToBorder:
      return linear ? gen::MirroredEdge::Whole : gen::MirroredEdge::Hard;
    default:
      return gen::MirroredEdge::None;
  }
}

// False: out of memory.
bool updateUnit(Context& c, UnitBindings& unit, gen::TextureUnit& fixed, render::TextureBinding& binding) {
  fixed.target = gen::TextureTarget::None;
  unit.sampled = kSlotCount;
  binding.image = nullptr;
  for (const Target& candidate : kByPriority) {
    if (!unit.enabled[candidate.slot]) continue;
    Texture& texture = *unit.bound[candidate.slot];
    if (!texture.complete()) return true;
    binding.image = texture.sampled(c).get();
    if (!binding.image) return false;
    binding.sampler = texture.sampler;
    const SharedImage* part = texture.sampledPart();
    binding.onlyLevel = part ? part->level : -1;
    binding.onlyLayer = part ? part->layer : 0;
    unit.sampled = candidate.slot;
    fixed.target = candidate.target;
    fixed.baseFormat = texture.baseFormat();
    fixed.edges = {edgeOf(texture.sampler.wrapS, texture.sampler),
                   edgeOf(texture.sampler.wrapT, texture.sampler),
                   edgeOf(texture.sampler.wrapR, texture.sampler)};
    fixed.lateSwitchOver = texture.switchesLate();
    return true;
  }
  return true;
}

}  // namespace

TextureSlot bindingSlot(GLenum target) {
  switch (target) {
    case GL_TEXTURE_2D:
      return kSlot2D;
    case GL_TEXTURE_CUBE_MAP_OES:
      return kSlotCube;
    case GL_TEXTURE_3D_OES:
      return kSlot3D;
    case GL_TEXTURE_EXTERNAL_OES:
      return kSlotExternal;
    default:
      return kSlotCount;
  }
}

TextureSlot slotForCommand(Context& c, GLenum target, const char* command) {
  const TextureSlot slot = bindingSlot(target);
  if (slot == kSlotCount)
    c.setError(
        GL_INVALID_ENUM,
        wrongEnum("target", target, "Use TEXTURE_2D, TEXTURE_CUBE_MAP_OES or another target of an extension"),
        command);
  return slot;
}

ImageTarget imageTarget(GLenum target) {
  if (target == GL_TEXTURE_2D) return {kSlot2D, 0};
  if (target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_OES) {
    return {kSlotCube, static_cast<int>(target - GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES)};
  }
  return {};
}

void initTextures(Context& c) {
  for (int slot = 0; slot < kSlotCount; ++slot) {
    const auto at = static_cast<size_t>(slot);
    c.defaultTextures[at] = std::make_shared<Texture>(0, static_cast<TextureSlot>(slot), c.device.caps());
    for (UnitBindings& unit : c.units) unit.bound[at] = c.defaultTextures[at];
  }
}

bool updateTextureUnits(Context& c) {
  bool updated = true;
  for (size_t i = 0; i < c.units.size(); ++i) {
    updated = updateUnit(c, c.units[i], c.state.fixed.units[i], c.state.textures[i]) && updated;
  }
  if (!updated) c.setError(GL_OUT_OF_MEMORY);
  return updated;
}

bool bindTexImage(Context& c, GLenum target, const std::shared_ptr<render::Image>& image, bool alpha) {
  if (target != GL_TEXTURE_2D || !image || image->desc().dimension != render::Dimension::Flat) return false;
  ShareLock lock(*c.group);
  Texture& texture = boundTexture(c, kSlot2D);
  if (texture.immutable()) return false;  // EXT_texture_storage
  const GLenum linear = alpha ? GL_RGBA : GL_RGB, encoded = alpha ? GL_SRGB_ALPHA_EXT : GL_SRGB_EXT;
  texture.import(c, image, render::isSrgb(image->desc().format) ? encoded : linear);
  return true;
}

void releaseTexImage(Context& c, const std::shared_ptr<render::Image>& image) {
  ShareLock lock(*c.group);
  const auto release = [&](Texture& texture) {
    if (texture.imported(image)) texture.releaseImport(c);
  };
  c.group->textures.forEach(release);
  for (const std::shared_ptr<Texture>& texture : c.defaultTextures) release(*texture);
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glGenTextures(GLsizei n, GLuint* textures) {
  generateNames(&ShareGroup::textures, n, textures);
}

GL_API void GL_APIENTRY glDeleteTextures(GLsizei n, const GLuint* textures) {
  deleteObjects(&ShareGroup::textures, n, textures, unbind);
}

GL_API GLboolean GL_APIENTRY glIsTexture(GLuint texture) {
  return isObject(&ShareGroup::textures, texture);
}

GL_API void GL_APIENTRY glBindTexture(GLenum target, GLuint name) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = slotForCommand(*c, target);
  if (slot == kSlotCount) return;
  UnitBindings& unit = c->units[static_cast<size_t>(c->activeTexture)];
  ShareLock lock(*c->group);
  if (name == 0) return bind(*c, unit, slot, c->defaultTextures[slot]);

  std::shared_ptr<Texture> texture = obtain(c->group->textures, name, slot, c->device.caps());
  if (!texture) return c->setError(GL_OUT_OF_MEMORY);
  if (texture->slot != slot)
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("texture", name, "Bind it to the target that it was bound to first"));
  bind(*c, unit, slot, std::move(texture));
}
