#include "layer/vulkan/pipelines/driver_cache.h"

#include <fmt/format.h>

#include <vector>

#include "layer/cache/driver_blob.h"
#include "layer/cache/shader_cache.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"

namespace anteroom::vulkan {
namespace {

constexpr size_t kMostVersions = 3;  // of a device's driver whose files are kept

}  // namespace

DriverCache::~DriverCache() {
  device_.fn().vkDestroyPipelineCache(device_.handle(), handle(), nullptr);
}

void DriverCache::load() {
  const std::lock_guard lock(mutex_);
  const cache::ShaderCache& cache = cache::ShaderCache::process();
  if (!cache.wanted() || handle()) return;
  vkGetPhysicalDeviceProperties(device_.physical(), &properties_);
  folder_ = cache.file().parent_path();
  prefix_ = fmt::format("driver-{:04x}-{:04x}-", properties_.vendorID, properties_.deviceID);
  name_ = fmt::format("{}{:08x}", prefix_, properties_.driverVersion);
  std::vector<std::byte> data = cache::readDriverBlob(folder_ / name_);
  if (!madeBy(data, properties_)) data.clear();
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache made = VK_NULL_HANDLE;
  if (device_.fn().vkCreatePipelineCache(device_.handle(), &info, nullptr, &made) != VK_SUCCESS) return;
  device_.countObject();
  handle_.store(made, std::memory_order_release);
}

// A cache that holds what the file does by now, and what this device made. Others use `own` meanwhile: only
// what is merged into must be left alone (vkMergePipelineCaches).
VkPipelineCache DriverCache::mergedWith(VkPipelineCache own) {
  std::vector<std::byte> data = cache::readDriverBlob(folder_ / name_);
  if (!madeBy(data, properties_)) data.clear();
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache merged = VK_NULL_HANDLE;
  const auto& fn = device_.fn();
  if (fn.vkCreatePipelineCache(device_.handle(), &info, nullptr, &merged) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  fn.vkMergePipelineCaches(device_.handle(), merged, 1, &own);
  return merged;
}

void DriverCache::save() {
  const std::lock_guard lock(mutex_);
  const uint64_t created = device_.pipelines().created();
  if (!handle() || created == saved_) return;
  saved_ = created;
  const auto& fn = device_.fn();
  size_t size = 0;
  if (fn.vkGetPipelineCacheData(device_.handle(), handle(), &size, nullptr) != VK_SUCCESS ||
      size <= sizeof(VkPipelineCacheHeaderVersionOne))
    return;
  const VkPipelineCache merged = mergedWith(handle());
  if (!merged) return;
  std::vector<std::byte> data;
  if (fn.vkGetPipelineCacheData(device_.handle(), merged, &size, nullptr) == VK_SUCCESS) {
    data.resize(size);
    if (fn.vkGetPipelineCacheData(device_.handle(), merged, &size, data.data()) == VK_SUCCESS) {
      data.resize(size);
      if (cache::writeDriverBlob(folder_ / name_, data))
        cache::keepNewestBlobs(folder_, prefix_, kMostVersions);
    }
  }
  fn.vkDestroyPipelineCache(device_.handle(), merged, nullptr);
}

}  // namespace anteroom::vulkan
