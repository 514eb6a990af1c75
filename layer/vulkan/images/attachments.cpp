#include "layer/vulkan/images/attachments.h"

#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

constexpr uint8_t kAllComponents =
    VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;

bool makeOpaque(Recorder& recorder, VulkanImage& image, int level, int layer, Counted counted) {
  Target target;
  target.color = &image;
  target.colorLevel = level;
  target.colorLayer = layer;
  target.width = image.levelWidth(level);
  target.height = image.levelHeight(level);
  target.samples = image.desc().samples;
  Quad quad(target);
  quad.state.fixed.writeMask = VK_COLOR_COMPONENT_A_BIT;
  quad.color[3] = 1;
  quad.counted = counted;
  image.alphaStale = false;
  return recorder.quad(target, quad);
}

}  // namespace

bool loadSamples(Recorder& recorder, const Target& target, Counted counted) {
  if (!target.resolve || recorder.passIsOn(target)) return true;
  VulkanImage& texture = *target.resolve;
  const bool cleared = target.color->pending.aspects != 0;
  if (texture.pending.aspects) {
    const PendingClear& pending = texture.pending;
    const bool here = pending.level == target.resolveLevel && pending.layer == target.resolveLayer;
    if (!(here && cleared) && !doPendingClear(recorder, texture)) return false;
    texture.pending.aspects = 0;
  }
  ImageStore* const store = texture.store();
  if (!store) return false;
  const Contents now{store->id, store->version, target.resolveLevel, target.resolveLayer};
  if (cleared || target.color->resolvedInto == now) return true;
  if (texture.alphaStale && !makeOpaque(recorder, texture, target.resolveLevel, target.resolveLayer, counted))
    return false;
  const VkImageView texels = store->attachmentView(target.resolveLevel, target.resolveLayer);
  if (!texels || !recorder.beginSampling(texture.held())) return false;

  Target samples = target;
  samples.depth = samples.resolve = nullptr;
  samples.hasDepth = samples.hasStencil = false;
  Quad quad(samples);
  quad.fragment = &kCopyFragment;
  quad.texels = texels;
  quad.counted = counted;
  quad.state.fixed.writeMask = kAllComponents;
  if (!recorder.quad(samples, quad)) return false;
  recorder.endPass();
  return true;
}

bool prepareAttachments(Recorder& recorder, const Target& target) {
  if (target.color && target.color->alphaStale && !recorder.passIsOn(target))
    if (!makeOpaque(recorder, *target.color, target.colorLevel, target.colorLayer, Counted::Yes))
      return false;
  return loadSamples(recorder, target);
}

}  // namespace anteroom::vulkan
