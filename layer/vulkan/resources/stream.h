// Memory for what lives one submission: vertices, indices, constants, texels on their way. Mapped for good,
// and used again as soon as the submissions that read it are complete.
#pragma once

#include <volk.h>

#include <memory>
#include <vector>

#include "layer/vulkan/device/constant_sets.h"
#include "layer/vulkan/device/memory.h"

namespace anteroom::vulkan {

class VulkanDevice;

// A piece of a stream. Empty: out of memory.
struct StreamPiece {
  std::byte* mapped = nullptr;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  ConstantSets constants;  // of a stream of constants
  explicit operator bool() const { return mapped != nullptr; }
};

class Stream {
 public:
  enum class Purpose : uint8_t { Vertices, Constants, ReadBack };

  Stream(VulkanDevice& device, Purpose purpose, VkDeviceSize blockSize);
  ~Stream();

  StreamPiece allocate(VkDeviceSize size, VkDeviceSize alignment);
  // Whether `piece`, the last one, can grow in place by `size` bytes; then it has.
  bool extend(const StreamPiece& piece, VkDeviceSize pieceSize, VkDeviceSize size);
  // What was allocated since the last call belongs to submission `serial`.
  void submitted(uint64_t serial);

 private:
  struct Block {
    Allocation memory;
    ConstantSets constants;
    VkDeviceSize head = 0;
    uint64_t serial = 0;     // of the last submission that reads it
    bool recording = false;  // used since the last submission
  };

  bool nextBlock(VkDeviceSize size);
  VkDeviceSize capacity(const Block& block) const;

  VulkanDevice& device_;
  const Purpose purpose_;
  const VkDeviceSize blockSize_;
  VkDeviceSize total_ = 0;
  std::vector<Block> blocks_;
  size_t current_ = 0;
};

}  // namespace anteroom::vulkan
