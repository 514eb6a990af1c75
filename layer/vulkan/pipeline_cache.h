// Pipelines: little more than pairs of shaders where the device takes the rest as dynamic state.
#pragma once

#include <volk.h>

#include <array>
#include <atomic>
#include <cstring>
#include <mutex>
#include <unordered_map>

#include "layer/vulkan/draw_state.h"
#include "layer/vulkan/shader_library.h"

namespace anteroom::vulkan {

// GL's arrays, and what else each vertex may bring.
inline constexpr uint32_t kMostArrays = gen::kAttributeCount + gen::kMostOwnValues;

// The arrays that a draw reads: one binding an array, at offset 0.
struct VertexLayout {
  struct Array {
    uint32_t location = 0, format = 0, stride = 0;
    bool operator==(const Array&) const = default;
  };
  uint32_t count = 0;
  std::array<Array, kMostArrays> arrays{};
  bool operator==(const VertexLayout&) const = default;
};

struct PipelineKey {
  uint32_t vertexShader = 0, fragmentShader = 0;
  uint32_t colorFormat = 0, depthFormat = 0, samples = 1;
  VertexLayout layout;  // empty where vertex input is dynamic state
  BakedState state;
  uint8_t unused[2]{};
  bool operator==(const PipelineKey& other) const { return !std::memcmp(this, &other, sizeof other); }
};
static_assert(std::has_unique_object_representations_v<PipelineKey>);

// Thread-safe. Pipelines live as long as the device.
class PipelineCache {
 public:
  explicit PipelineCache(VulkanDevice& device) : device_(device) {}
  ~PipelineCache();

  // Null: out of memory.
  VkPipeline get(const PipelineKey& key, const Shader& vertex, const Shader& fragment);
  uint64_t created() const { return created_; }

 private:
  struct Hash {
    size_t operator()(const PipelineKey& key) const;
  };
  VkPipeline create(const PipelineKey& key, const Shader& vertex, const Shader& fragment);

  VulkanDevice& device_;
  std::mutex mutex_;
  std::unordered_map<PipelineKey, VkPipeline, Hash> pipelines_;
  std::atomic<uint64_t> created_{0};
};

}  // namespace anteroom::vulkan
