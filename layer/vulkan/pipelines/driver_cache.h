// The driver's own pipeline cache, kept beside the shader cache: a file a device and driver version.
#pragma once

#include <volk.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <span>

namespace anteroom::vulkan {

class VulkanDevice;

// Whether `data` begins as a cache of this device does (VkPipelineCacheHeaderVersionOne): others are for
// others.
bool madeBy(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device);

// Thread-safe.
class DriverCache {
 public:
  explicit DriverCache(VulkanDevice& device) : device_(device) {}
  ~DriverCache();
  DriverCache(const DriverCache&) = delete;
  DriverCache& operator=(const DriverCache&) = delete;

  // From the file, when there is a shader cache. Once.
  void load();
  // Null until then.
  VkPipelineCache handle() const { return handle_.load(std::memory_order_acquire); }
  // What is new, together with what other processes saved. Drivers that keep their caches elsewhere have
  // nothing to say, and get no file.
  void save();

 private:
  VkPipelineCache mergedWith(VkPipelineCache own);

  VulkanDevice& device_;
  std::mutex mutex_;
  std::filesystem::path folder_;
  std::string prefix_, name_;
  VkPhysicalDeviceProperties properties_{};
  std::atomic<VkPipelineCache> handle_{VK_NULL_HANDLE};
  uint64_t saved_ = 0;  // pipelines that were made by then
};

}  // namespace anteroom::vulkan
