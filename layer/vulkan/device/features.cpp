#include "layer/vulkan/device/features.h"

#include <cstring>
#include <initializer_list>

namespace anteroom::vulkan {
namespace {

// The feature structures of the optional extensions, chained once to ask and once more to switch on.
struct Chain {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
#define EXTENSION(structure, extension, type, sType, ...) \
  type structure{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_##sType};
#include "layer/vulkan/device/features.inc"
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
  void enable(const char* name, Struct& asked, std::initializer_list<const char*> needed) {
    for (const char* other : needed)
      if (!has(other)) return;
    if (!enable(name)) return;
    for (const char* other : needed) enable(other);
    asked.pNext = tail_;
    tail_ = &asked;
  }

  void enableExtensions(Features& features);
  void readFeatures(Features& features);

  const Instance& instance_;
  const bool minimal_;
  std::vector<VkExtensionProperties> available_;
  std::vector<const char*> names_;
  void* tail_ = nullptr;
  Chain chain_;
  bool swapchain_ = false;
};

void DeviceBuilder::enableExtensions(Features& features) {
  swapchain_ = has(VK_KHR_SWAPCHAIN_EXTENSION_NAME) && instance_.surfaces;
  if (swapchain_) names_.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  features.swapchain = swapchain_;
#define EXTENSION(structure, extension, type, sType, ...) enable(extension, chain_.structure, {__VA_ARGS__});
#define PLAIN(member, extension, condition, purpose) features.member = (condition) && enable(extension);
#include "layer/vulkan/device/features.inc"
  // A device of the portability subset must be told that its limits are known.
  features.triangleFans = !has("VK_KHR_portability_subset");
  if (!features.triangleFans) names_.push_back("VK_KHR_portability_subset");
  chain_.core.pNext = tail_;
}

void DeviceBuilder::readFeatures(Features& features) {
  const Chain& c = chain_;
#define CORE(member, feature, purpose) features.member = c.core.features.feature;
#define FEATURE(member, condition, purpose) features.member = condition;
#include "layer/vulkan/device/features.inc"
}

VkResult DeviceBuilder::build(VkDevice& device, Features& features) {
  enableExtensions(features);
  vkGetPhysicalDeviceFeatures2(instance_.physical, &chain_.core);
  readFeatures(features);
  chain_.core.features = {};
#define CORE(member, feature, purpose) chain_.core.features.feature = features.member;
#include "layer/vulkan/device/features.inc"

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
