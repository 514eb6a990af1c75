#include "layer/vulkan/driver_cache.h"

#include <fmt/format.h>

#include <vector>

#include "gen/cache/driver_blob.h"
#include "gen/cache/shader_cache.h"
#include "layer/vulkan/device.h"
#include "layer/vulkan/pipeline_cache.h"

namespace anteroom::vulkan {
namespace {

constexpr size_t kMostVersions = 3;  // of a device's driver whose files are kept

}  // namespace

DriverCache::~DriverCache() {
  device_.fn().vkDestroyPipelineCache(device_.handle(), handle(), nullptr);
}

void DriverCache::load() {
  const std::lock_guard lock(mutex_);
  const gen::ShaderCache& cache = gen::ShaderCache::process();
  if (!cache.wanted() || handle()) return;
  vkGetPhysicalDeviceProperties(device_.physical(), &properties_);
  folder_ = cache.file().parent_path();
  prefix_ = fmt::format("driver-{:04x}-{:04x}-", properties_.vendorID, properties_.deviceID);
  name_ = fmt::format("{}{:08x}", prefix_, properties_.driverVersion);
  std::vector<std::byte> data = gen::readDriverBlob(folder_ / name_);
  if (!madeBy(data, properties_)) data.clear();
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache made = VK_NULL_HANDLE;
  if (device_.fn().vkCreatePipelineCache(device_.handle(), &info, nullptr, &made) != VK_SUCCESS) return;
  device_.countObject();
  handle_.store(made, std::memory_order_release);
}

// Adds what the file holds by now.
void DriverCache::merge(VkPipelineCache cache) {
  const std::vector<std::byte> data = gen::readDriverBlob(folder_ / name_);
  if (!madeBy(data, properties_)) return;
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache others = VK_NULL_HANDLE;
  const auto& fn = device_.fn();
  if (fn.vkCreatePipelineCache(device_.handle(), &info, nullptr, &others) != VK_SUCCESS) return;
  fn.vkMergePipelineCaches(device_.handle(), cache, 1, &others);
  fn.vkDestroyPipelineCache(device_.handle(), others, nullptr);
}

void DriverCache::save() {
  const std::lock_guard lock(mutex_);
  const VkPipelineCache cache = handle();
  const uint64_t created = device_.pipelines().created();
  if (!cache || created == saved_) return;
  saved_ = created;
  const auto& fn = device_.fn();
  size_t size = 0;
  if (fn.vkGetPipelineCacheData(device_.handle(), cache, &size, nullptr) != VK_SUCCESS ||
      size <= sizeof(VkPipelineCacheHeaderVersionOne))
    return;
  merge(cache);
  std::vector<std::byte> data;
  // Other threads may add to it meanwhile.
  for (int i = 0; i < 3; ++i) {
    if (fn.vkGetPipelineCacheData(device_.handle(), cache, &size, nullptr) != VK_SUCCESS) return;
    data.resize(size);
    if (fn.vkGetPipelineCacheData(device_.handle(), cache, &size, data.data()) != VK_SUCCESS) continue;
    data.resize(size);
    if (gen::writeDriverBlob(folder_ / name_, data)) gen::keepNewestBlobs(folder_, prefix_, kMostVersions);
    return;
  }
}

}  // namespace anteroom::vulkan
