// Whose cache a driver is handed.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "layer/vulkan/pipelines/driver_cache.h"

namespace anteroom::test {
namespace {

VkPhysicalDeviceProperties device() {
  VkPhysicalDeviceProperties properties{};
  properties.vendorID = 0x1234;
  properties.deviceID = 0x5678;
  for (uint32_t i = 0; i < VK_UUID_SIZE; ++i) properties.pipelineCacheUUID[i] = static_cast<uint8_t>(i);
  return properties;
}

std::vector<std::byte> cacheOf(const VkPhysicalDeviceProperties& device) {
  VkPipelineCacheHeaderVersionOne header{};
  header.headerSize = sizeof header;
  header.headerVersion = VK_PIPELINE_CACHE_HEADER_VERSION_ONE;
  header.vendorID = device.vendorID;
  header.deviceID = device.deviceID;
  std::memcpy(header.pipelineCacheUUID, device.pipelineCacheUUID, VK_UUID_SIZE);
  std::vector<std::byte> bytes(sizeof header + 100);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

TEST(DriverCache, TakesOnlyItsOwn) {
  const std::vector<std::byte> good = cacheOf(device());
  EXPECT_TRUE(vulkan::madeBy(good, device()));
  for (size_t at = 0; at < sizeof(VkPipelineCacheHeaderVersionOne); ++at) {
    std::vector<std::byte> bad = good;
    bad[at] ^= std::byte{1};
    EXPECT_FALSE(vulkan::madeBy(bad, device())) << "byte " << at;
    EXPECT_FALSE(vulkan::madeBy(std::span(good).first(at), device())) << "cut to " << at;
  }
  VkPhysicalDeviceProperties newer = device();
  newer.pipelineCacheUUID[15] ^= 1;
  EXPECT_FALSE(vulkan::madeBy(good, newer));
}

}  // namespace
}  // namespace anteroom::test
