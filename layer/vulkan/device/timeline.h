// The queue's timeline: submissions are numbered from 1 and complete in order.
#pragma once

#include <volk.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace anteroom::vulkan {

class VulkanDevice;
struct FreshImage;
struct ImageStore;

// Thread-safe. A timeline semaphore, or a fence a submission where there are none.
class Timeline {
 public:
  explicit Timeline(VulkanDevice& device) : device_(device) {}
  ~Timeline();
  bool initialise();

  // Submits `main`. The first layouts of new images are recorded into `fresh` before, which is left out when
  // there are none; `held` then gets these images, to be held until the submission is complete. `signal`: a
  // semaphore that is signaled, too, unless null. Returns the number; 0: the device is lost or out of memory.
  uint64_t submit(VkCommandBuffer fresh, VkCommandBuffer main, VkSemaphore signal,
                  std::vector<std::shared_ptr<ImageStore>>& held);
  VkResult present(const VkPresentInfoKHR& info);
  // Makes a semaphore unsignaled that nobody else will wait for.
  void consume(VkSemaphore semaphore);
  // Waits until the queue does nothing, presents included.
  void idle();

  // The number of the last submission that is complete.
  uint64_t completed();
  // timeout in ns. True: submission `serial` is complete.
  bool wait(uint64_t serial, uint64_t timeout);
  // The process ends: all that was submitted is complete, and what is submitted from now on is when submit()
  // returns. Waits at most some seconds.
  void end();
  uint64_t submitted() const { return submitted_.load(std::memory_order_acquire); }

 private:
  struct Fence {
    explicit Fence(VulkanDevice& owner) : device(owner) {}
    ~Fence();
    VulkanDevice& device;
    VkFence handle = VK_NULL_HANDLE;
  };
  struct Pending {
    uint64_t serial;
    std::shared_ptr<Fence> fence;
  };

  bool recordFreshImages(VkCommandBuffer commands, std::vector<std::shared_ptr<ImageStore>>& held);
  std::shared_ptr<Fence> takeFence();
  void retireFences();

  VulkanDevice& device_;
  VkSemaphore semaphore_ = VK_NULL_HANDLE;
  std::atomic<uint64_t> submitted_{0};
  std::atomic<bool> ending_{false};
  std::atomic<uint64_t> completed_{0};
  std::mutex queueMutex_;
  std::vector<FreshImage> fresh_;
  std::vector<VkImageMemoryBarrier> barriers_;
  std::vector<VkSemaphore> waits_;
  std::vector<VkPipelineStageFlags> waitStages_;
  std::mutex fenceMutex_;
  std::vector<Pending> pending_;  // the oldest first; few
  std::vector<std::shared_ptr<Fence>> idle_;
};

}  // namespace anteroom::vulkan
