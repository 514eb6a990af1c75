// What of Vulkan beyond 1.1 the device has, and how it is switched on.
#pragma once

#include <volk.h>

#include <vector>

#include "layer/vulkan/device/instance.h"

namespace anteroom::vulkan {

struct Features {
  // Core features.
  bool logicOp = false;
  bool wideLines = false;
  bool largePoints = false;
  bool anisotropy = false;
  bool clipDistance = false;
  bool alphaToOne = false;
  bool depthBiasClamp = false;

  // Optional extensions, with the features of theirs that are used.
  bool dynamicRendering = false;
  bool dynamicState1 = false;  // cull, front face, topology, depth and stencil tests
  bool dynamicState2 = false;  // depth bias enable, logic op
  bool dynamicState3 = false;  // blending, masks, multisampling, line mode
  bool dynamicVertexInput = false;
  bool pushDescriptors = false;
  bool provokingVertexLast = false;
  bool bresenhamLines = false;
  bool smoothLines = false;
  bool indexUint8 = false;
  bool timelineSemaphore = false;
  bool mirrorClampToEdge = false;
  bool formats4444 = false;
  bool swapchain = false;
  bool presentRegions = false;  // VK_KHR_incremental_present
  bool triangleFans = true;     // absent on layered devices of the portability subset
};

// Creates a device with every feature that the renderer knows how to use; with `minimal`, with none that is
// optional.
VkResult createLogicalDevice(const Instance& instance, bool minimal, VkDevice& device, Features& features);

}  // namespace anteroom::vulkan
