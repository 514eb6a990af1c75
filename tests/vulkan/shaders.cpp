// Shaders that could not be made.
#include <gtest/gtest.h>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/shader_library.h"

namespace anteroom::test {
namespace {

VkResult answer = VK_SUCCESS;
int asked = 0;
PFN_vkCreateShaderModule real = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL create(VkDevice device, const VkShaderModuleCreateInfo* info,
                                      const VkAllocationCallbacks* allocator, VkShaderModule* out) {
  ++asked;
  return answer == VK_SUCCESS ? real(device, info, allocator, out) : answer;
}

// Memory comes back: a shader that found none is tried again by the next draw that wants it.
TEST(Shaders, AreTriedAgainWhenMemoryCameBack) {
  std::string error;
  const auto device = vulkan::VulkanDevice::create({}, error);
  ASSERT_NE(device, nullptr) << error;
  // The device's own table of commands, with one that fails when it is told to.
  auto& commands = const_cast<VolkDeviceTable&>(device->fn());
  real = commands.vkCreateShaderModule;
  commands.vkCreateShaderModule = create;
  const gen::State state;
  const gen::FragmentKey key = gen::canonicaliseFragment(state, {});
  for (const VkResult passing : {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}) {
    answer = passing;
    EXPECT_EQ(device->shaders().get(key), nullptr);
  }
  EXPECT_EQ(asked, 2);
  answer = VK_SUCCESS;
  EXPECT_NE(device->shaders().get(key), nullptr);
  EXPECT_NE(device->shaders().get(key), nullptr);
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace anteroom::test
