// What a draw sends as dynamic state.
#pragma once

#include <volk.h>

#include "layer/vulkan/pipelines/draw_state.h"

namespace anteroom::vulkan {

class VulkanDevice;

// Sends what differs from what was sent before, or all of it.
void emit(const VulkanDevice& device, VkCommandBuffer commands, uint32_t samples, const DrawState& wanted,
          DrawState& sent, bool all);

}  // namespace anteroom::vulkan
