#include "layer/vulkan/device/timeline.h"

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/process_end.h"

namespace anteroom::vulkan {
namespace {

// Submissions that are in flight at a time, with a few contexts.
constexpr size_t kUsualFences = 16;

constexpr uint64_t kLongestEnd = 10'000'000'000;  // ns

}  // namespace

Timeline::Fence::~Fence() {
  device.fn().vkDestroyFence(device.handle(), handle, nullptr);
}

Timeline::~Timeline() {
  device_.fn().vkDestroySemaphore(device_.handle(), semaphore_, nullptr);
}

bool Timeline::initialise() {
  if (!device_.features().timelineSemaphore) {
    pending_.reserve(kUsualFences);
    idle_.reserve(kUsualFences);
    return true;
  }
  VkSemaphoreTypeCreateInfoKHR type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO_KHR};
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE_KHR;
  VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type, 0};
  device_.countObject();
  return device_.fn().vkCreateSemaphore(device_.handle(), &info, nullptr, &semaphore_) == VK_SUCCESS;
}

std::shared_ptr<Timeline::Fence> Timeline::takeFence() {
  const std::lock_guard lock(fenceMutex_);
  retireFences();
  for (auto& fence : idle_) {
    if (fence.use_count() != 1) continue;  // another thread still waits for it
    auto taken = std::move(fence);
    std::swap(fence, idle_.back());
    idle_.pop_back();
    device_.fn().vkResetFences(device_.handle(), 1, &taken->handle);
    return taken;
  }
  auto fence = std::make_shared<Fence>(device_);
  VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  if (device_.fn().vkCreateFence(device_.handle(), &info, nullptr, &fence->handle) != VK_SUCCESS)
    return nullptr;
  device_.countObject();
  return fence;
}

void Timeline::retireFences() {
  while (!pending_.empty() &&
         device_.fn().vkGetFenceStatus(device_.handle(), pending_.front().fence->handle) == VK_SUCCESS) {
    completed_.store(pending_.front().serial, std::memory_order_release);
    idle_.push_back(std::move(pending_.front().fence));
    pending_.erase(pending_.begin());
  }
}

bool Timeline::recordFreshImages(VkCommandBuffer commands, std::vector<std::shared_ptr<ImageStore>>& held) {
  fresh_.clear();
  waits_.clear();
  waitStages_.clear();
  device_.takeFreshImages(fresh_);
  // Another thread may be destroying one.
  std::erase_if(fresh_, [&](const FreshImage& image) {
    std::shared_ptr<ImageStore> store = image.store.lock();
    if (!store) return true;
    held.push_back(std::move(store));
    return false;
  });
  if (fresh_.empty()) return false;
  const auto& fn = device_.fn();
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  fn.vkBeginCommandBuffer(commands, &info);
  barriers_.clear();
  for (const FreshImage& image : fresh_) {
    if (image.ready) {
      waits_.push_back(image.ready);
      waitStages_.push_back(VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    }
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = image.layout;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    barrier.subresourceRange = {image.aspects, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
    barriers_.push_back(barrier);
  }
  fn.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
                          0, nullptr, 0, nullptr, static_cast<uint32_t>(barriers_.size()), barriers_.data());
  for (size_t i = 0; i < fresh_.size(); ++i) {
    const VkClearColorValue black{{0, 0, 0, 1}};
    if (fresh_[i].clear)
      fn.vkCmdClearColorImage(commands, fresh_[i].image, VK_IMAGE_LAYOUT_GENERAL, &black, 1,
                              &barriers_[i].subresourceRange);
  }
  fn.vkEndCommandBuffer(commands);
  return true;
}

uint64_t Timeline::submit(VkCommandBuffer fresh, VkCommandBuffer main, VkSemaphore signal,
                          std::vector<std::shared_ptr<ImageStore>>& held) {
  noteWorker();
  const std::lock_guard lock(queueMutex_);
  VkCommandBuffer buffers[2];
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  if (recordFreshImages(fresh, held)) buffers[info.commandBufferCount++] = fresh;
  buffers[info.commandBufferCount++] = main;
  info.pCommandBuffers = buffers;
  info.waitSemaphoreCount = static_cast<uint32_t>(waits_.size());
  info.pWaitSemaphores = waits_.data();
  info.pWaitDstStageMask = waitStages_.data();

  const uint64_t serial = submitted_.load(std::memory_order_relaxed) + 1;
  std::shared_ptr<Fence> fence;
  VkSemaphore signals[2];
  uint64_t signalValues[2]{};
  VkTimelineSemaphoreSubmitInfoKHR values{VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO_KHR};
  info.pSignalSemaphores = signals;
  if (signal) signals[info.signalSemaphoreCount++] = signal;
  if (semaphore_) {
    signalValues[info.signalSemaphoreCount] = serial;
    signals[info.signalSemaphoreCount++] = semaphore_;
    values.signalSemaphoreValueCount = info.signalSemaphoreCount;
    values.pSignalSemaphoreValues = signalValues;
    info.pNext = &values;
  } else if (!(fence = takeFence())) {
    return 0;
  }
  if (device_.fn().vkQueueSubmit(device_.queue(), 1, &info, fence ? fence->handle : VK_NULL_HANDLE) !=
      VK_SUCCESS)
    return 0;
  if (fence) {
    const std::lock_guard fenceLock(fenceMutex_);
    pending_.push_back({serial, std::move(fence)});
  }
  submitted_.store(serial, std::memory_order_release);
  if (ending_.load(std::memory_order_relaxed)) wait(serial, kLongestEnd);
  return serial;
}

VkResult Timeline::present(const VkPresentInfoKHR& info) {
  const std::lock_guard lock(queueMutex_);
  return device_.fn().vkQueuePresentKHR(device_.queue(), &info);
}

void Timeline::end() {
  ending_ = true;
  wait(submitted(), kLongestEnd);
}

void Timeline::consume(VkSemaphore semaphore) {
  const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &semaphore;
  info.pWaitDstStageMask = &stage;
  const std::lock_guard lock(queueMutex_);
  device_.fn().vkQueueSubmit(device_.queue(), 1, &info, VK_NULL_HANDLE);
}

void Timeline::idle() {
  const std::lock_guard lock(queueMutex_);
  device_.fn().vkQueueWaitIdle(device_.queue());
}

uint64_t Timeline::completed() {
  if (semaphore_) {
    uint64_t value = 0;
    device_.fn().vkGetSemaphoreCounterValueKHR(device_.handle(), semaphore_, &value);
    return value;
  }
  const std::lock_guard lock(fenceMutex_);
  retireFences();
  return completed_.load(std::memory_order_acquire);
}

bool Timeline::wait(uint64_t serial, uint64_t timeout) {
  if (serial == 0) return true;
  if (semaphore_) {
    VkSemaphoreWaitInfoKHR info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO_KHR};
    info.semaphoreCount = 1;
    info.pSemaphores = &semaphore_;
    info.pValues = &serial;
    return device_.fn().vkWaitSemaphoresKHR(device_.handle(), &info, timeout) == VK_SUCCESS;
  }
  std::shared_ptr<Fence> fence;
  {
    const std::lock_guard lock(fenceMutex_);
    for (const Pending& pending : pending_)
      if (pending.serial == serial) fence = pending.fence;
    if (!fence) return completed_.load(std::memory_order_acquire) >= serial;
  }
  return device_.fn().vkWaitForFences(device_.handle(), 1, &fence->handle, VK_TRUE, timeout) == VK_SUCCESS;
}

}  // namespace anteroom::vulkan
