// Device memory: large blocks, handed out in pieces. Host-visible memory is coherent and mapped for good.
#pragma once

#include <volk.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace anteroom::vulkan {

class VulkanDevice;

enum class MemoryUse : uint8_t {
  Upload,    // written by the CPU, read by the device
  ReadBack,  // read by the CPU too
  Device,    // seen by the device only
};
// Things of different kinds never share a block (bufferImageGranularity). A block of buffers is one VkBuffer.
enum class MemoryKind : uint8_t { Buffer, LinearImage, OptimalImage };

struct MemoryBlock;

// A piece of a block. Empty: out of memory.
struct Allocation {
  MemoryBlock* block = nullptr;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  VkDeviceSize size = 0;
  std::byte* mapped = nullptr;  // the piece's first byte; null for MemoryUse::Device
  explicit operator bool() const { return block != nullptr; }
};

// Thread-safe.
class MemoryPool {
 public:
  explicit MemoryPool(VulkanDevice& device);
  ~MemoryPool();

  Allocation allocate(MemoryKind kind, MemoryUse use, const VkMemoryRequirements& requirements);
  Allocation allocateBuffer(MemoryUse use, VkDeviceSize size);
  void free(Allocation& allocation);
  // Whether the CPU reads memory for `use` at full speed.
  bool cached(MemoryUse use) const;

 private:
  struct Range {
    VkDeviceSize offset, size;
  };
  friend struct MemoryBlock;

  int memoryType(MemoryUse use, uint32_t allowed) const;
  MemoryBlock* createBlock(MemoryKind kind, uint32_t type, VkDeviceSize size);
  void destroyBlock(MemoryBlock& block);
  static bool take(MemoryBlock& block, VkDeviceSize size, VkDeviceSize alignment, VkDeviceSize& offset);

  VulkanDevice& device_;
  VkPhysicalDeviceMemoryProperties properties_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<MemoryBlock>> blocks_;
};

}  // namespace anteroom::vulkan
