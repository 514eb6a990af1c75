#include <cstring>

#include "layer/vulkan/pipelines/driver_cache.h"

namespace anteroom::vulkan {

namespace {

// VkPipelineCacheHeaderVersionOne as it may be in a file: its version is any number, and not yet one of the
// enum's.
struct Header {
  uint32_t size, version, vendor, device;
  uint8_t uuid[VK_UUID_SIZE];
};
static_assert(sizeof(Header) == sizeof(VkPipelineCacheHeaderVersionOne));

}  // namespace

bool madeBy(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device) {
  Header header;
  if (data.size() <= sizeof header) return false;
  std::memcpy(&header, data.data(), sizeof header);
  return header.size == sizeof header && header.version == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
         header.vendor == device.vendorID && header.device == device.deviceID &&
         !std::memcmp(header.uuid, device.pipelineCacheUUID, VK_UUID_SIZE);
}

}  // namespace anteroom::vulkan
