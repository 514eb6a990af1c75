// Buffer objects: device memory that the CPU reads and writes, replaced while the device still reads it.
#pragma once

#include <memory>
#include <vector>

#include "layer/render/renderer.h"
#include "layer/vulkan/device/memory.h"
#include "layer/vulkan/resources/indices.h"

namespace anteroom::vulkan {

class VulkanDevice;

// One version of a buffer's contents. Recordings that use it hold a reference.
struct BufferStore {
  explicit BufferStore(VulkanDevice& owner) : device(owner) {}
  ~BufferStore();
  BufferStore(const BufferStore&) = delete;
  BufferStore& operator=(const BufferStore&) = delete;

  VulkanDevice& device;
  Allocation memory;
  uint64_t recording = 0;
};

class VulkanBuffer final : public render::Buffer {
 public:
  // Null: out of memory.
  static std::shared_ptr<VulkanBuffer> create(VulkanDevice& device, size_t size, const void* data);

  const std::byte* contents() const override;
  bool write(size_t offset, const void* data, size_t size) override;

  const std::shared_ptr<BufferStore>& store() const { return store_; }
  // The least and the greatest of `count` > 0 indices at `offset`, all inside the buffer. Remembered until a
  // write.
  IndexRange indexRange(GLenum type, size_t offset, uint32_t count);

 private:
  struct KnownRange {
    GLenum type = 0;
    size_t offset = 0;
    uint32_t count = 0;
    IndexRange range{};
  };
  VulkanBuffer(VulkanDevice& device, size_t size) : render::Buffer(size), device_(device) {}
  std::shared_ptr<BufferStore> createStore();

  VulkanDevice& device_;
  std::shared_ptr<BufferStore> store_;
  std::vector<std::byte> shadow_;  // where the CPU reads device memory slowly
  KnownRange known_[16];
  uint32_t nextKnown_ = 0;
};

inline VulkanBuffer& vulkan(render::Buffer& buffer) {
  return static_cast<VulkanBuffer&>(buffer);
}

}  // namespace anteroom::vulkan
