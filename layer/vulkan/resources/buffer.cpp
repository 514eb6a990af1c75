#include "layer/vulkan/resources/buffer.h"

#include <cstring>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

// A format of four components may stand for one of three: the last vertex is then read past its end.
constexpr size_t kPadding = 16;

}  // namespace

BufferStore::~BufferStore() {
  device.memory().free(memory);
}

std::shared_ptr<VulkanBuffer> VulkanBuffer::create(VulkanDevice& device, size_t size, const void* data) {
  std::shared_ptr<VulkanBuffer> buffer(new VulkanBuffer(device, size));
  buffer->store_ = buffer->createStore();
  if (!buffer->store_) return nullptr;
  if (!device.memory().cached(MemoryUse::Upload)) buffer->shadow_.resize(size);
  std::byte* to = buffer->store_->memory.mapped;
  if (data)
    std::memcpy(to, data, size);
  else
    std::memset(to, 0, size);
  std::memset(to + size, 0, kPadding);
  if (data && !buffer->shadow_.empty()) std::memcpy(buffer->shadow_.data(), data, size);
  return buffer;
}

std::shared_ptr<BufferStore> VulkanBuffer::createStore() {
  auto store = std::make_shared<BufferStore>(device_);
  store->memory = device_.memory().allocateBuffer(MemoryUse::Upload, size_ + kPadding);
  return store->memory ? store : nullptr;
}

const std::byte* VulkanBuffer::contents() const {
  return shadow_.empty() ? store_->memory.mapped : shadow_.data();
}

bool VulkanBuffer::write(size_t offset, const void* data, size_t size) {
  if (store_.use_count() > 1) {
    std::shared_ptr<BufferStore> next = createStore();
    if (!next) return false;
    if (size < size_) std::memcpy(next->memory.mapped, contents(), size_);
    std::memset(next->memory.mapped + size_, 0, kPadding);
    store_ = std::move(next);
  }
  std::memcpy(store_->memory.mapped + offset, data, size);
  if (!shadow_.empty()) std::memcpy(shadow_.data() + offset, data, size);
  for (KnownRange& known : known_) known = {};
  return true;
}

IndexRange VulkanBuffer::indexRange(GLenum type, size_t offset, uint32_t count) {
  for (const KnownRange& known : known_)
    if (known.count == count && known.offset == offset && known.type == type) return known.range;
  KnownRange& known = known_[nextKnown_++ % std::size(known_)];
  known = {type, offset, count, scanIndices(type, contents() + offset, count)};
  return known.range;
}

}  // namespace anteroom::vulkan
