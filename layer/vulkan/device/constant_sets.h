#pragma once

#include <volk.h>

namespace anteroom::vulkan {

// The descriptor sets of a buffer of constants: for each stage the one that it looks into.
struct ConstantSets {
  VkDescriptorSet vertex = VK_NULL_HANDLE, fragment = VK_NULL_HANDLE;
};

}  // namespace anteroom::vulkan
