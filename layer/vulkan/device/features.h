// What of Vulkan beyond 1.1 the device has, and how it is switched on.
#pragma once

#include <volk.h>

#include <vector>

#include "layer/vulkan/device/instance.h"

namespace anteroom::vulkan {

struct Features {
#define CORE(member, feature, purpose) bool member = false;
#define FEATURE(member, condition, purpose) bool member = false;
#define PLAIN(member, extension, condition, purpose) bool member = false;
#include "layer/vulkan/device/features.inc"
  bool swapchain = false;    // windows of the window system that was asked for
  bool triangleFans = true;  // absent on layered devices of the portability subset
};

// Creates a device with every feature that the renderer knows how to use; with `minimal`, with none that is
// optional.
VkResult createLogicalDevice(const Instance& instance, bool minimal, VkDevice& device, Features& features);

}  // namespace anteroom::vulkan
