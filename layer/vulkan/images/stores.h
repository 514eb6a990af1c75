// The stores of images, made ready for what comes.
#pragma once

#include <memory>

#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

struct DrawPlan;
class Recorder;

// Does the clear that was put off for the image, if there is one. False: out of memory.
bool doPendingClear(Recorder& recorder, VulkanImage& image);

// The store with one sample a pixel that holds all that was done to the image. Null: out of memory.
const std::shared_ptr<ImageStore>* readableStore(Recorder& recorder, VulkanImage& image);

// A mapped store that nothing uses, with the image's contents unless they are about to be overwritten as a
// `whole`: its own, or a new version. Null: the image must be written by commands, or memory is short.
ImageStore* writableMapped(Recorder& recorder, VulkanImage& image, bool whole);

// Makes the images of a plan visible to its draw, and sets their views. May end the pass. False: out of
// memory.
bool prepareTextures(Recorder& recorder, DrawPlan& plan);

// One level of `count` layers of a color image, for commands outside of passes.
inline VkImageSubresourceLayers layersOf(int level, int layer, int count = 1) {
  return {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<uint32_t>(level), static_cast<uint32_t>(layer),
          static_cast<uint32_t>(count)};
}

}  // namespace anteroom::vulkan
