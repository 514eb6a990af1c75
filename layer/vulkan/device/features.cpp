#include "layer/vulkan/device/features.h"

#include <cstring>

namespace anteroom::vulkan {
namespace {

// The feature structures of the optional extensions, chained once to ask and once more to switch on.
struct Chain {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceDynamicRenderingFeaturesKHR dynamicRendering{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES_KHR};
  VkPhysicalDeviceExtendedDynamicStateFeaturesEXT dynamicState1{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_FEATURES_EXT};
  VkPhysicalDeviceExtendedDynamicState2FeaturesEXT dynamicState2{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_2_FEATURES_EXT};
  VkPhysicalDeviceExtendedDynamicState3FeaturesEXT dynamicState3{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_3_FEATURES_EXT};
  VkPhysicalDeviceVertexInputDynamicStateFeaturesEXT vertexInput{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VERTEX_INPUT_DYNAMIC_STATE_FEATURES_EXT};
  VkPhysicalDeviceProvokingVertexFeaturesEXT provokingVertex{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT};
  VkPhysicalDeviceIndexTypeUint8FeaturesEXT indexUint8{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_INDEX_TYPE_UINT8_FEATURES_EXT};
  VkPhysicalDeviceTimelineSemaphoreFeaturesKHR timeline{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TIMELINE_SEMAPHORE_FEATURES_KHR};
  VkPhysicalDevice4444FormatsFeaturesEXT formats4444{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_4444_FORMATS_FEATURES_EXT};
};

class DeviceBuilder {
 public:
  DeviceBuilder(const Instance& instance, bool minimal) : instance_(instance), minimal_(minimal) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(instance.physical, nullptr, &count, nullptr);
    available_.resize(count);
    vkEnumerateDeviceExtensionProperties(instance.physical, nullptr, &count, available_.data());
  }

  VkResult build(VkDevice& device, Features& features);

 private:
  bool has(const char* name) const {
    for (const auto& extension : available_)
      if (!std::strcmp(extension.extensionName, name)) return true;
    return false;
  }
  // Switches an extension on, when it may be used and is there.
  bool enable(const char* name) {
    if (minimal_ || !has(name)) return false;
    names_.push_back(name);
    return true;
  }
  template <class Struct>
  bool enable(const char* name, Struct& asked) {
    if (!enable(name)) return false;
    asked.pNext = tail_;
    tail_ = &asked;
    return true;
  }

  void enableExtensions();
  void readFeatures(Features& features);

  const Instance& instance_;
  const bool minimal_;
  std::vector<VkExtensionProperties> available_;
  std::vector<const char*> names_;
  void* tail_ = nullptr;
  Chain chain_;
  bool pushDescriptors_ = false, mirrorClamp_ = false, portability_ = false;
  bool swapchain_ = false, presentRegions_ = false;
};

void DeviceBuilder::enableExtensions() {
  if (has(VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME) && has(VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME) &&
      enable(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME, chain_.dynamicRendering)) {
    enable(VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME);
    enable(VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME);
  }
  enable(VK_EXT_EXTENDED_DYNAMIC_STATE_EXTENSION_NAME, chain_.dynamicState1);
  enable(VK_EXT_EXTENDED_DYNAMIC_STATE_2_EXTENSION_NAME, chain_.dynamicState2);
  enable(VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME, chain_.dynamicState3);
  enable(VK_EXT_VERTEX_INPUT_DYNAMIC_STATE_EXTENSION_NAME, chain_.vertexInput);
  enable(VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME, chain_.provokingVertex);
  enable(VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME, chain_.lines);
  enable(VK_EXT_INDEX_TYPE_UINT8_EXTENSION_NAME, chain_.indexUint8);
  enable(VK_KHR_TIMELINE_SEMAPHORE_EXTENSION_NAME, chain_.timeline);
  enable(VK_EXT_4444_FORMATS_EXTENSION_NAME, chain_.formats4444);
  pushDescriptors_ = enable(VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
  mirrorClamp_ = enable(VK_KHR_SAMPLER_MIRROR_CLAMP_TO_EDGE_EXTENSION_NAME);
  swapchain_ = has(VK_KHR_SWAPCHAIN_EXTENSION_NAME) && instance_.surfaces;
  if (swapchain_) names_.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  presentRegions_ = swapchain_ && enable(VK_KHR_INCREMENTAL_PRESENT_EXTENSION_NAME);
  // A device of the portability subset must be told that its limits are known.
  portability_ = has("VK_KHR_portability_subset");
  if (portability_) names_.push_back("VK_KHR_portability_subset");
  chain_.core.pNext = tail_;
}

void DeviceBuilder::readFeatures(Features& f) {
  const VkPhysicalDeviceFeatures& core = chain_.core.features;
  f.logicOp = core.logicOp;
  f.wideLines = core.wideLines;
  f.largePoints = core.largePoints;
  f.anisotropy = core.samplerAnisotropy;
  f.clipDistance = core.shaderClipDistance;
  f.alphaToOne = core.alphaToOne;
  f.depthBiasClamp = core.depthBiasClamp;
  f.dynamicRendering = chain_.dynamicRendering.dynamicRendering;
  f.dynamicState1 = chain_.dynamicState1.extendedDynamicState;
  f.dynamicState2 =
      chain_.dynamicState2.extendedDynamicState2 && chain_.dynamicState2.extendedDynamicState2LogicOp;
  const auto& three = chain_.dynamicState3;
  f.dynamicState3 = three.extendedDynamicState3AlphaToCoverageEnable &&
                    three.extendedDynamicState3LogicOpEnable && three.extendedDynamicState3ColorBlendEnable &&
                    three.extendedDynamicState3ColorBlendEquation &&
                    three.extendedDynamicState3ColorWriteMask && three.extendedDynamicState3SampleMask &&
                    three.extendedDynamicState3LineRasterizationMode;
  f.dynamicVertexInput = chain_.vertexInput.vertexInputDynamicState;
  f.provokingVertexLast = chain_.provokingVertex.provokingVertexLast;
  f.bresenhamLines = chain_.lines.bresenhamLines;
  f.smoothLines = chain_.lines.smoothLines;
  f.indexUint8 = chain_.indexUint8.indexTypeUint8;
  f.timelineSemaphore = chain_.timeline.timelineSemaphore;
  f.formats4444 = chain_.formats4444.formatA4R4G4B4;
  f.pushDescriptors = pushDescriptors_;
  f.mirrorClampToEdge = mirrorClamp_;
  f.triangleFans = !portability_;
  f.swapchain = swapchain_;
  f.presentRegions = presentRegions_;
  // The line mode is only known to a device with the extension that defines it.
  f.dynamicState3 = f.dynamicState3 && f.bresenhamLines;
}

VkResult DeviceBuilder::build(VkDevice& device, Features& features) {
  enableExtensions();
  vkGetPhysicalDeviceFeatures2(instance_.physical, &chain_.core);
  readFeatures(features);

  VkPhysicalDeviceFeatures& core = chain_.core.features;
  core = {};
  core.logicOp = features.logicOp;
  core.wideLines = features.wideLines;
  core.largePoints = features.largePoints;
  core.samplerAnisotropy = features.anisotropy;
  core.shaderClipDistance = features.clipDistance;
  core.alphaToOne = features.alphaToOne;
  core.depthBiasClamp = features.depthBiasClamp;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = instance_.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &chain_.core;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<uint32_t>(names_.size());
  info.ppEnabledExtensionNames = names_.data();
  return vkCreateDevice(instance_.physical, &info, nullptr, &device);
}

}  // namespace

VkResult createLogicalDevice(const Instance& instance, bool minimal, VkDevice& device, Features& features) {
  return DeviceBuilder(instance, minimal).build(device, features);
}

}  // namespace anteroom::vulkan
