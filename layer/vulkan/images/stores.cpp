#include "layer/vulkan/images/stores.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

// A larger image that is in use is not replaced for the sake of a part of it.
constexpr size_t kMostVersioned = 1 << 20;

}  // namespace

bool doPendingClear(Recorder& recorder, VulkanImage& image) {
  const PendingClear& pending = image.pending;
  if (!pending.aspects) return true;
  Target target;
  target.width = image.levelWidth(pending.level);
  target.height = image.levelHeight(pending.level);
  target.samples = image.desc().samples;
  const bool color = pending.aspects & VK_IMAGE_ASPECT_COLOR_BIT;
  (color ? target.color : target.depth) = &image;
  (color ? target.colorLevel : target.depthLevel) = pending.level;
  (color ? target.colorLayer : target.depthLayer) = pending.layer;
  recorder.endPass();
  if (!recorder.openPass(target, !color)) return false;
  recorder.endPass();
  return true;
}

const std::shared_ptr<ImageStore>* readableStore(Recorder& recorder, VulkanImage& image) {
  if (!doPendingClear(recorder, image) || !image.store()) return nullptr;
  if (image.desc().samples == 1) return &image.held();
  if (!image.averaged()) return nullptr;
  if (!image.averageStale) return &image.heldAveraged();
  const VkCommandBuffer commands = recorder.beginTransfer(&image.held(), &image.heldAveraged());
  if (!commands) return nullptr;
  VkImageResolve region{};
  region.srcSubresource = region.dstSubresource = layersOf(0, 0);
  region.extent = {static_cast<uint32_t>(image.desc().width), static_cast<uint32_t>(image.desc().height), 1};
  recorder.device().fn().vkCmdResolveImage(commands, image.held()->image, VK_IMAGE_LAYOUT_GENERAL,
                                           image.heldAveraged()->image, VK_IMAGE_LAYOUT_GENERAL, 1, &region);
  image.averageStale = false;
  return &image.heldAveraged();
}

ImageStore* writableMapped(Recorder& recorder, VulkanImage& image, bool whole) {
  ImageStore* store = image.store(whole);
  if (!store || !store->mapped) return nullptr;
  if (image.held().use_count() > 1) recorder.retire();
  if (image.held().use_count() == 1) {
    store->written = false;
    ++store->version;
    return store;
  }
  if (!whole && (store->written || image.bytes() > kMostVersioned)) return nullptr;
  if (recorder.passAttaches(*store)) recorder.endPass();
  const std::shared_ptr<ImageStore> former = image.replaceStore();
  if (!former) return nullptr;
  store = image.store();
  ++store->version;
  if (!whole) std::memcpy(store->mapped, former->mapped, std::min(store->memory.size, former->memory.size));
  return store;
}

bool prepareTextures(Recorder& recorder, DrawPlan& plan) {
  for (uint32_t units = plan.units; units; units &= units - 1) {
    const int unit = std::countr_zero(units);
    const SampledImage& sampled = plan.sampled[unit];
    if (!sampled.image || !plan.textures[unit].sampler) return false;
    VulkanImage& image = *sampled.image;
    const std::shared_ptr<ImageStore>* const store = readableStore(recorder, image);
    if (!store || !recorder.beginSampling(*store)) return false;
    VkImageView& view = plan.textures[unit].view;
    view = sampled.onlyLevel < 0
               ? (*store)->view
               : (*store)->partView(sampled.onlyLevel, sampled.onlyLayer, image.format().swizzle);
    if (!view) return false;
  }
  return true;
}

}  // namespace anteroom::vulkan
