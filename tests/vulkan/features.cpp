// What of Vulkan is used, by the rows of features.inc.
#include "layer/vulkan/device/features.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

TEST(Features, AMinimalDeviceUsesNoExtension) {
  std::string error;
  const auto device = VulkanDevice::create({.preferred = {}, .minimal = true}, error);
  ASSERT_NE(device, nullptr) << error;
  const Features& f = device->features();
#define FEATURE(member, condition, purpose) EXPECT_FALSE(f.member) << #member;
#define PLAIN(member, extension, condition, purpose) EXPECT_FALSE(f.member) << #member;
#include "layer/vulkan/device/features.inc"
}

// Windows are not asked for, and so nothing of theirs is there.
TEST(Features, ADeviceUsesWhatItsDriverHas) {
  std::string error;
  const auto device = VulkanDevice::create({}, error);
  ASSERT_NE(device, nullptr) << error;
  const Features& f = device->features();
  EXPECT_FALSE(f.swapchain || f.presentRegions);
  VkPhysicalDeviceFeatures core;
  vkGetPhysicalDeviceFeatures(device->physical(), &core);
#define CORE(member, feature, purpose) EXPECT_EQ(f.member, core.feature == VK_TRUE) << #member;
#include "layer/vulkan/device/features.inc"
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(device->physical(), nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(device->physical(), nullptr, &count, extensions.data());
  std::set<std::string_view> names;
  for (const VkExtensionProperties& extension : extensions) names.insert(extension.extensionName);
  EXPECT_EQ(f.pushDescriptors, names.contains(VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME));
  EXPECT_EQ(f.mirrorClampToEdge, names.contains(VK_KHR_SAMPLER_MIRROR_CLAMP_TO_EDGE_EXTENSION_NAME));
}

TEST(Features, EachIsForSomething) {
#define CORE(member, feature, purpose) EXPECT_STRNE(purpose, "") << #member;
#define FEATURE(member, condition, purpose) EXPECT_STRNE(purpose, "") << #member;
#define PLAIN(member, extension, condition, purpose) EXPECT_STRNE(purpose, "") << #member;
#include "layer/vulkan/device/features.inc"
}

}  // namespace
}  // namespace anteroom::vulkan
