// Sampler objects: one for each way of sampling that was ever asked for.
#pragma once

#include <volk.h>

#include <mutex>
#include <vector>

#include "layer/render/state.h"

namespace anteroom::vulkan {

class VulkanDevice;

// Thread-safe. Samplers live as long as the device: there are few.
class SamplerCache {
 public:
  explicit SamplerCache(VulkanDevice& device) : device_(device) {}
  ~SamplerCache();

  // For an image of `levels` levels; `lodBias`: TEXTURE_LOD_BIAS. Null: out of memory.
  VkSampler get(const render::Sampler& sampler, int levels, float lodBias);

 private:
  // What is left of a sampler when all that cannot matter is fixed. Bytes only.
  struct Key {
    uint8_t minLinear = 0, magLinear = 0, mips = 0, mipLinear = 0;
    uint8_t wrap[3]{};
    uint8_t anisotropy = 1;
    uint16_t maxLevel = 0;
    int16_t lodBias = 0;  // 256 is 1
    bool operator==(const Key&) const = default;
  };
  struct Entry {
    Key key;
    VkSampler sampler;
  };
  Key canonical(const render::Sampler& sampler, int levels, float lodBias) const;
  VkSamplerAddressMode wrap(GLenum mode) const;
  VkSampler create(const Key& key);
  void name(VkSampler sampler, const Key& key) const;

  VulkanDevice& device_;
  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace anteroom::vulkan
