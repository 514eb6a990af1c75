// Texels between images.
#pragma once

#include <memory>

#include "layer/render/renderer.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

class Recorder;

// As render::Context::copyFromFramebuffer and copyLevel.
bool copyFromFramebuffer(Recorder& recorder, VulkanImage& image, const render::Region& region,
                         const render::Framebuffer& source, int x, int y);
bool copyLevel(Recorder& recorder, VulkanImage& image, int level, VulkanImage& source, int sourceLevel);

// Level 0 of stores of one format, `extent` in texels. False: out of memory.
bool copyStore(Recorder& recorder, const std::shared_ptr<ImageStore>& from,
               const std::shared_ptr<ImageStore>& to, VkExtent2D extent);

}  // namespace anteroom::vulkan
