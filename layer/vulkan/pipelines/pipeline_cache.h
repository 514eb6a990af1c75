// Pipelines by key.
#pragma once

#include <volk.h>

#include <atomic>
#include <string>

#include "layer/vulkan/pipelines/made_once.h"
#include "layer/vulkan/pipelines/pipeline_key.h"
#include "layer/vulkan/pipelines/shader_library.h"

namespace anteroom::vulkan {

class VulkanDevice;

// Thread-safe. Pipelines live as long as the device.
class PipelineCache {
 public:
  explicit PipelineCache(VulkanDevice& device) : device_(device) {}
  ~PipelineCache();

  // For a draw: waits when another thread is making this one. Null: out of memory.
  VkPipeline get(const PipelineKey& key, const Shader& vertex, const Shader& fragment,
                 Counted counted = Counted::Yes);
  // Before any draw asks; the program is not said to need it. False: out of memory.
  bool makeAhead(const PipelineKey& key, const Shader& vertex, const Shader& fragment);

  uint64_t created() const { return created_; }
  uint64_t ahead() const { return ahead_; }
  // Those that a draw had to make itself.
  uint64_t awaited() const { return awaited_; }

 private:
  struct Hash {
    size_t operator()(const PipelineKey& key) const;
  };
  struct Made {
    VkPipeline pipeline = VK_NULL_HANDLE;
    int64_t microseconds = 0;
    std::atomic<bool> used{false};
  };
  bool create(const PipelineKey& key, const Shader& vertex, const Shader& fragment, Made& made);
  VkPipeline create(const PipelineKey& key, const Shader& vertex, const Shader& fragment);
  void report(const std::string& fault, const PipelineKey& key, const Shader& vertex, const Shader& fragment,
              const std::string& log) const;
  void noteUse(const PipelineKey& key, const Shader& vertex, const Shader& fragment, int64_t microseconds);

  VulkanDevice& device_;
  MadeOnce<PipelineKey, Made, Hash> pipelines_;
  std::atomic<uint64_t> created_{0}, ahead_{0}, awaited_{0};
};

}  // namespace anteroom::vulkan
