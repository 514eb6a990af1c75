#include "layer/vulkan/device/memory.h"

#include <algorithm>
#include <string>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {

struct MemoryBlock {
  MemoryKind kind;
  uint32_t type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize size = 0;
  std::byte* mapped = nullptr;
  std::vector<MemoryPool::Range> free;  // by offset, never adjacent
};

namespace {

// The first block of a kind is small, for programs that need little; later ones double.
constexpr VkDeviceSize kSmallestBlock = 1 << 20;
constexpr VkDeviceSize kLargestBlock = 32 << 20;
constexpr VkDeviceSize kBufferAlignment = 256;  // serves uniform offsets, vertex and index data

constexpr VkBufferUsageFlags kBufferUsage =
    VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
    VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;

VkDeviceSize alignUp(VkDeviceSize value, VkDeviceSize alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

void nameBlock(const VulkanDevice& device, const MemoryBlock& block) {
  const Labels& labels = device.labels();
  if (!labels.nameAll()) return;
  constexpr const char* kKinds[] = {"buffers and streams", "linear images", "images"};
  const std::string text = std::string("block of ") + kKinds[static_cast<int>(block.kind)] + ", " +
                           std::to_string(block.size >> 10) + " KiB, memory type " +
                           std::to_string(block.type);
  labels.name(VK_OBJECT_TYPE_DEVICE_MEMORY, block.memory, text);
  if (block.buffer) labels.name(VK_OBJECT_TYPE_BUFFER, block.buffer, text);
}

}  // namespace

MemoryPool::MemoryPool(VulkanDevice& device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(device.physical(), &properties_);
}

MemoryPool::~MemoryPool() {
  for (auto& block : blocks_) destroyBlock(*block);
}

int MemoryPool::memoryType(MemoryUse use, uint32_t allowed) const {
  constexpr VkMemoryPropertyFlags host =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const VkMemoryPropertyFlags needed = use == MemoryUse::Device ? 0 : host;
  const VkMemoryPropertyFlags wanted =
      use == MemoryUse::ReadBack ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  int best = -1;
  for (uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
    const VkMemoryPropertyFlags flags = properties_.memoryTypes[i].propertyFlags;
    if (!(allowed & (1u << i)) || (flags & needed) != needed) continue;
    if ((flags & wanted) == wanted) return static_cast<int>(i);
    if (best < 0) best = static_cast<int>(i);
  }
  return best;
}

bool MemoryPool::cached(MemoryUse use) const {
  const int type = memoryType(use, ~0u);
  return type >= 0 && properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
}

bool MemoryPool::take(MemoryBlock& block, VkDeviceSize size, VkDeviceSize alignment, VkDeviceSize& offset) {
  size_t best = block.free.size();
  for (size_t i = 0; i < block.free.size(); ++i) {
    const Range& range = block.free[i];
    const VkDeviceSize start = alignUp(range.offset, alignment);
    if (start + size > range.offset + range.size) continue;
    if (best == block.free.size() || range.size < block.free[best].size) best = i;
  }
  if (best == block.free.size()) return false;
  const Range range = block.free[best];
  offset = alignUp(range.offset, alignment);
  const Range before{range.offset, offset - range.offset};
  const Range after{offset + size, range.offset + range.size - offset - size};
  const auto at = block.free.begin() + static_cast<ptrdiff_t>(best);
  if (before.size && after.size) {
    *at = before;
    block.free.insert(at + 1, after);
  } else if (before.size || after.size) {
    *at = before.size ? before : after;
  } else {
    block.free.erase(at);
  }
  return true;
}

Allocation MemoryPool::allocate(MemoryKind kind, MemoryUse use, const VkMemoryRequirements& requirements) {
  const int type = memoryType(use, requirements.memoryTypeBits);
  if (type < 0 || requirements.size == 0) return {};
  const std::lock_guard lock(mutex_);
  const auto piece = [&](MemoryBlock& block, VkDeviceSize offset) {
    return Allocation{&block, block.memory,      block.buffer,
                      offset, requirements.size, block.mapped ? block.mapped + offset : nullptr};
  };
  VkDeviceSize largest = kSmallestBlock / 2;
  for (auto& block : blocks_) {
    if (block->kind != kind || block->type != static_cast<uint32_t>(type)) continue;
    largest = std::max(largest, std::min(block->size, kLargestBlock));
    VkDeviceSize offset;
    if (take(*block, requirements.size, requirements.alignment, offset)) return piece(*block, offset);
  }
  VkDeviceSize size = std::min(largest * 2, kLargestBlock);
  if (requirements.size * 4 > size) size = requirements.size;  // a block of its own, given back with it
  MemoryBlock* block = createBlock(kind, static_cast<uint32_t>(type), size);
  if (!block) return {};
  VkDeviceSize offset;
  if (!take(*block, requirements.size, requirements.alignment, offset)) return {};
  return piece(*block, offset);
}

Allocation MemoryPool::allocateBuffer(MemoryUse use, VkDeviceSize size) {
  VkMemoryRequirements requirements{alignUp(std::max<VkDeviceSize>(size, 1), kBufferAlignment),
                                    kBufferAlignment, ~0u};
  return allocate(MemoryKind::Buffer, use, requirements);
}

MemoryBlock* MemoryPool::createBlock(MemoryKind kind, uint32_t type, VkDeviceSize size) {
  const auto& fn = device_.fn();
  auto block = std::make_unique<MemoryBlock>();
  block->kind = kind;
  block->type = type;
  block->size = size;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = size;
  info.memoryTypeIndex = type;
  if (kind == MemoryKind::Buffer) {
    VkBufferCreateInfo buffer{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    buffer.size = size;
    buffer.usage = kBufferUsage;
    if (fn.vkCreateBuffer(device_.handle(), &buffer, nullptr, &block->buffer) != VK_SUCCESS) return nullptr;
    device_.countObject();
    VkMemoryRequirements requirements;
    fn.vkGetBufferMemoryRequirements(device_.handle(), block->buffer, &requirements);
    info.allocationSize = requirements.size;
  }
  bool done = fn.vkAllocateMemory(device_.handle(), &info, nullptr, &block->memory) == VK_SUCCESS;
  if (done) {
    device_.countMemory();
    device_.countMemoryBytes(static_cast<int64_t>(size));
    nameBlock(device_, *block);
  }
  if (done && block->buffer)
    done = fn.vkBindBufferMemory(device_.handle(), block->buffer, block->memory, 0) == VK_SUCCESS;
  if (done && properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) {
    void* mapped = nullptr;
    done = fn.vkMapMemory(device_.handle(), block->memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS;
    block->mapped = static_cast<std::byte*>(mapped);
  }
  if (!done) {
    destroyBlock(*block);
    return nullptr;
  }
  block->free.push_back({0, size});
  blocks_.push_back(std::move(block));
  return blocks_.back().get();
}

void MemoryPool::destroyBlock(MemoryBlock& block) {
  device_.fn().vkDestroyBuffer(device_.handle(), block.buffer, nullptr);
  if (block.memory) device_.countMemoryBytes(-static_cast<int64_t>(block.size));
  device_.fn().vkFreeMemory(device_.handle(), block.memory, nullptr);
}

void MemoryPool::free(Allocation& allocation) {
  if (!allocation) return;
  const std::lock_guard lock(mutex_);
  MemoryBlock& block = *allocation.block;
  auto next = std::lower_bound(block.free.begin(), block.free.end(), allocation.offset,
                               [](const Range& range, VkDeviceSize offset) { return range.offset < offset; });
  next = block.free.insert(next, {allocation.offset, allocation.size});
  allocation = {};
  if (const auto after = next + 1; after != block.free.end() && next->offset + next->size == after->offset) {
    next->size += after->size;
    block.free.erase(after);
  }
  if (next != block.free.begin()) {
    if (const auto before = next - 1; before->offset + before->size == next->offset) {
      before->size += next->size;
      block.free.erase(next);
    }
  }
  // An empty block is kept when it has the common size, to be filled again.
  if (block.free.size() == 1 && block.free[0].size == block.size && block.size > kLargestBlock) {
    destroyBlock(block);
    std::erase_if(blocks_, [&](const auto& held) { return held.get() == &block; });
  }
}

}  // namespace anteroom::vulkan
