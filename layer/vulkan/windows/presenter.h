// The thread that shows pictures of CPU devices. There vkQueuePresentKHR waits until the picture is drawn,
// and copies it: meanwhile the program's thread records the next one.
#pragma once

#include <volk.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace anteroom::vulkan {

class Swapchain;
class VulkanDevice;

// Thread-safe. Pictures are shown in the order in which they were submitted.
class Presenter {
 public:
  explicit Presenter(VulkanDevice& device) : device_(device) {}
  // No picture is waiting.
  ~Presenter();

  // Shows `image` when submission `serial` is complete. The swapchain outlives it: wait() before it is
  // destroyed.
  void add(Swapchain& swapchain, uint32_t image, uint64_t serial, const std::vector<VkRectLayerKHR>& damage);
  // Waits until all pictures of the swapchain have been shown; null: of all swapchains.
  void wait(const Swapchain* swapchain);

 private:
  struct Picture {
    Swapchain* swapchain;
    uint32_t image;
    uint64_t serial;
    std::vector<VkRectLayerKHR> damage;
  };
  void run();

  VulkanDevice& device_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Picture> pictures_;  // the first is being shown
  bool stop_ = false;
  std::thread thread_;  // started with the first picture
};

}  // namespace anteroom::vulkan
