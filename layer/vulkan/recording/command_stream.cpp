#include "layer/vulkan/recording/command_stream.h"

#include <atomic>
#include <string>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/resources/buffer.h"

namespace anteroom::vulkan {
namespace {

// Recordings and epochs of all contexts are numbered together: a store remembers but one of each.
std::atomic<uint64_t> nextNumber{1};

std::atomic<unsigned> nextStream{1};  // for names

constexpr uint32_t kSetsAPool = 256;

}  // namespace

CommandStream::CommandStream(VulkanDevice& device)
    : device_(device), number_(nextStream.fetch_add(1, std::memory_order_relaxed)) {}

CommandStream::~CommandStream() {
  device_.timeline().wait(lastSubmitted_, UINT64_MAX);
  for (Slot& slot : slots_) {
    release(slot);
    for (VkDescriptorPool pool : slot.descriptorPools)
      device_.fn().vkDestroyDescriptorPool(device_.handle(), pool, nullptr);
    device_.fn().vkDestroyCommandPool(device_.handle(), slot.pool, nullptr);
  }
}

bool CommandStream::initialise() {
  const auto& fn = device_.fn();
  for (Slot& slot : slots_) {
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = device_.queueFamily();
    if (fn.vkCreateCommandPool(device_.handle(), &pool, nullptr, &slot.pool) != VK_SUCCESS) return false;
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = slot.pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 2;
    VkCommandBuffer buffers[2];
    if (fn.vkAllocateCommandBuffers(device_.handle(), &info, buffers) != VK_SUCCESS) return false;
    for (int i = 0; i < 3; ++i) device_.countObject();
    slot.fresh = buffers[0];
    slot.main = buffers[1];
    nameSlot(slot);
  }
  return true;
}

void CommandStream::nameSlot(const Slot& slot) const {
  const Labels& labels = device_.labels();
  if (!labels.nameAll()) return;
  const std::string context =
      "context " + std::to_string(number_) + ", slot " + std::to_string(&slot - slots_.data());
  labels.name(VK_OBJECT_TYPE_COMMAND_BUFFER, slot.main, context);
  labels.name(VK_OBJECT_TYPE_COMMAND_BUFFER, slot.fresh, context + ", first layouts");
}

VkCommandBuffer CommandStream::begin() {
  if (lost_) return VK_NULL_HANDLE;
  Slot& slot = slots_[slot_];
  const auto& fn = device_.fn();
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  if (!device_.timeline().wait(slot.serial, UINT64_MAX) ||
      fn.vkResetCommandPool(device_.handle(), slot.pool, 0) != VK_SUCCESS ||
      fn.vkBeginCommandBuffer(slot.main, &info) != VK_SUCCESS) {
    lost_ = true;
    return VK_NULL_HANDLE;
  }
  release(slot);
  recording_ = true;
  recordingId_ = nextNumber.fetch_add(1, std::memory_order_relaxed);
  barrier();  // after all earlier submissions; at this place it costs nothing
  return slot.main;
}

void CommandStream::hold(const std::shared_ptr<BufferStore>& store) {
  if (store->recording == recordingId_) return;
  store->recording = recordingId_;
  slots_[slot_].buffers.push_back(store);
}

void CommandStream::hold(const std::shared_ptr<ImageStore>& store) {
  if (store->recording == recordingId_) return;
  store->recording = recordingId_;
  store->lastRecording = std::max(store->lastRecording, recordingId_);
  slots_[slot_].images.push_back(store);
}

void CommandStream::barrier() {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  device_.fn().vkCmdPipelineBarrier(slots_[slot_].main, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                    VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1, &barrier, 0, nullptr, 0,
                                    nullptr);
  epoch_ = nextNumber.fetch_add(1, std::memory_order_relaxed);
}

VkDescriptorSet CommandStream::allocateTextureSet() {
  Slot& slot = slots_[slot_];
  const auto& fn = device_.fn();
  if (slot.setsLeft == 0) {
    if (slot.usedPools == slot.descriptorPools.size()) {
      const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                      kSetsAPool * gen::kMaxTextureUnits};
      VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
      info.maxSets = kSetsAPool;
      info.poolSizeCount = 1;
      info.pPoolSizes = &size;
      VkDescriptorPool pool;
      if (fn.vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool) != VK_SUCCESS)
        return VK_NULL_HANDLE;
      device_.countObject();
      slot.descriptorPools.push_back(pool);
    }
    ++slot.usedPools;
    slot.setsLeft = kSetsAPool;
  }
  const VkDescriptorSetLayout layout = device_.textureSetLayout();
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = slot.descriptorPools[slot.usedPools - 1];
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  if (fn.vkAllocateDescriptorSets(device_.handle(), &info, &set) != VK_SUCCESS) return VK_NULL_HANDLE;
  --slot.setsLeft;
  return set;
}

uint64_t CommandStream::submit(VkSemaphore signal) {
  if (lost_) return 0;
  if (!recording_) return lastSubmitted_;
  Slot& slot = slots_[slot_];
  const auto& fn = device_.fn();
  VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  toHost.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT | VK_ACCESS_HOST_WRITE_BIT;
  fn.vkCmdPipelineBarrier(slot.main, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                          &toHost, 0, nullptr, 0, nullptr);
  recording_ = false;
  recordingId_ = nextNumber.fetch_add(1, std::memory_order_relaxed);  // nothing is bound any more
  if (fn.vkEndCommandBuffer(slot.main) == VK_SUCCESS)
    slot.serial = device_.timeline().submit(slot.fresh, slot.main, signal, slot.images);
  else
    slot.serial = 0;
  if (slot.serial == 0) {
    lost_ = true;
    release(slot);
    return 0;
  }
  for (auto& image : slot.images) image->lastUse.store(slot.serial, std::memory_order_relaxed);
  lastSubmitted_ = slot.serial;
  slot_ = (slot_ + 1) % kSlots;
  return lastSubmitted_;
}

void CommandStream::retire() {
  const uint64_t completed = device_.timeline().completed();
  for (int i = 0; i < kSlots; ++i)
    if (!(recording_ && i == slot_) && slots_[i].serial <= completed) release(slots_[i]);
}

void CommandStream::release(Slot& slot) {
  slot.images.clear();
  slot.buffers.clear();
  for (size_t i = 0; i < slot.usedPools; ++i)
    device_.fn().vkResetDescriptorPool(device_.handle(), slot.descriptorPools[i], 0);
  slot.usedPools = 0;
  slot.setsLeft = 0;
}

}  // namespace anteroom::vulkan
