#include "layer/vulkan/resources/stream.h"

#include <algorithm>
#include <bit>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"

namespace anteroom::vulkan {
namespace {

// Beyond this a stream waits for the device instead of growing.
constexpr VkDeviceSize kMostBytes = 256 << 20;

}  // namespace

Stream::Stream(VulkanDevice& device, Purpose purpose, VkDeviceSize blockSize)
    : device_(device), purpose_(purpose), blockSize_(blockSize) {}

Stream::~Stream() {
  for (Block& block : blocks_) {
    if (block.constants.vertex) device_.freeConstantSets(block.constants);
    device_.memory().free(block.memory);
  }
}

VkDeviceSize Stream::capacity(const Block& block) const {
  // A descriptor shows a fixed range from the dynamic offset on: it must end inside the buffer.
  return purpose_ == Purpose::Constants ? block.memory.size - kConstantRange : block.memory.size;
}

bool Stream::nextBlock(VkDeviceSize size) {
  const uint64_t completed = device_.timeline().completed();
  const auto reuse = [&](uint64_t done) {
    for (size_t i = 0; i < blocks_.size(); ++i) {
      Block& block = blocks_[i];
      if (block.recording || block.serial > done || capacity(block) < size) continue;
      block.head = 0;
      current_ = i;
      return true;
    }
    return false;
  };
  if (reuse(completed)) return true;
  if (total_ + size > kMostBytes) {
    uint64_t newest = 0;
    for (const Block& block : blocks_) newest = std::max(newest, block.recording ? 0 : block.serial);
    if (newest > completed && device_.timeline().wait(newest, UINT64_MAX) && reuse(newest)) return true;
  }
  Block block;
  const VkDeviceSize extra = purpose_ == Purpose::Constants ? kConstantRange : 0;
  const MemoryUse use = purpose_ == Purpose::ReadBack ? MemoryUse::ReadBack : MemoryUse::Upload;
  block.memory = device_.memory().allocateBuffer(use, std::max(blockSize_, std::bit_ceil(size)) + extra);
  if (!block.memory) return false;
  if (purpose_ == Purpose::Constants) {
    block.constants = device_.allocateConstantSets(block.memory.buffer);
    if (!block.constants.vertex) {
      device_.memory().free(block.memory);
      return false;
    }
  }
  total_ += block.memory.size;
  current_ = blocks_.size();
  blocks_.push_back(block);
  return true;
}

StreamPiece Stream::allocate(VkDeviceSize size, VkDeviceSize alignment) {
  const auto start = [&] { return (blocks_[current_].head + alignment - 1) / alignment * alignment; };
  if (blocks_.empty() || start() + size > capacity(blocks_[current_]))
    if (!nextBlock(size)) return {};
  Block& block = blocks_[current_];
  const VkDeviceSize offset = start();
  block.head = offset + size;
  block.recording = true;
  return {block.memory.mapped + offset, block.memory.buffer, block.memory.offset + offset, block.constants};
}

bool Stream::extend(const StreamPiece& piece, VkDeviceSize pieceSize, VkDeviceSize size) {
  if (blocks_.empty()) return false;
  Block& block = blocks_[current_];
  if (piece.mapped + pieceSize != block.memory.mapped + block.head) return false;
  if (block.head + size > capacity(block)) return false;
  block.head += size;
  block.recording = true;
  return true;
}

void Stream::submitted(uint64_t serial) {
  for (Block& block : blocks_) {
    if (!block.recording) continue;
    block.serial = serial;
    block.recording = false;
  }
}

}  // namespace anteroom::vulkan
