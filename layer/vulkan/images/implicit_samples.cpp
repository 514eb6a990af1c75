// Samples that belong to a level of a texture (EXT_multisampled_render_to_texture): every pass on them
// resolves into it at its end, and they are kept, so that a pass may be interrupted anywhere. When something
// else has written to the texture they start again with what it holds.
#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {

// A pass on `target` with the contents that it should have. False: out of memory.
bool VulkanContext::openPass(const Target& target, bool withDepth) {
  if (target.resolve && !pass_.activeOn(target) && !loadSamples(target)) return false;
  return pass_.require(target, withDepth);
}

bool VulkanContext::loadSamples(const Target& target) {
  VulkanImage& texture = *target.resolve;
  const bool cleared = target.color->pending.aspects != 0;
  if (texture.pending.aspects) {
    const PendingClear& pending = texture.pending;
    const bool here = pending.level == target.resolveLevel && pending.layer == target.resolveLayer;
    if (!(here && cleared) && !materialise(texture)) return false;
    texture.pending.aspects = 0;
  }
  ImageStore* const store = texture.store();
  if (!store) return false;
  const Contents now{store->id, store->version, target.resolveLevel, target.resolveLayer};
  if (cleared || target.color->follows == now) return true;
  if (texture.alphaStale && !opaqueAlpha(texture, target.resolveLevel, target.resolveLayer)) return false;
  leavePass(*store, false);
  const VkImageView texels = store->attachmentView(target.resolveLevel, target.resolveLayer);
  if (!texels) return false;
  commands_.read(texture.held());

  Target samples = target;
  samples.depth = samples.resolve = nullptr;
  samples.hasDepth = samples.hasStencil = false;
  DrawState quad = plainQuad(samples);
  quad.fixed.writeMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                         VK_COLOR_COMPONENT_A_BIT;
  if (!drawQuad(samples, quad, {}, false, texels)) return false;
  pass_.end();
  return true;
}

}  // namespace anteroom::vulkan
