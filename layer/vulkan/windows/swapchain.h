// A swapchain: the images of a window, of one size.
#pragma once

#include <volk.h>

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "layer/render/state.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

struct SwapchainDesc {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format{};
  VkExtent2D extent{};
  VkPresentModeKHR mode = VK_PRESENT_MODE_FIFO_KHR;
  VkCompositeAlphaFlagBitsKHR alpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  uint32_t images = 2;          // at least
  bool presentsBeside = false;  // one image may wait to be shown while another is drawn to
};

// What recordings do to a swapchain's images.
inline constexpr VkImageUsageFlags kSwapchainUsage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
    VK_IMAGE_USAGE_SAMPLED_BIT;

class Swapchain {
 public:
  // `former` is retired. Not a success: nothing was made.
  static VkResult create(VulkanDevice& device, const SwapchainDesc& desc, const Swapchain* former,
                         std::unique_ptr<Swapchain>& out);
  // Waits for all that uses the images.
  ~Swapchain();

  const SwapchainDesc& desc() const { return desc_; }

  // An image that the window system is done with; waits for one. Success, or what forbids it.
  VkResult acquire();
  bool acquired() const { return acquired_ >= 0; }
  // The image that is acquired.
  const std::shared_ptr<ImageStore>& store() const { return images_[acquired_].store; }
  // Signaled by the last submission that draws to the acquired image, which leaves it in PRESENT_SRC.
  VkSemaphore drawn() const { return images_[acquired_].drawn; }
  // Pictures since the acquired image was shown; 0: never.
  int age() const;

  // Shows the acquired image, which then no longer is, when submission `serial` has drawn it. On a CPU device
  // that happens beside, and what comes of it is told by the next present().
  VkResult present(uint64_t serial, std::span<const render::Rect> damage);
  // For the presenter.
  void show(uint32_t image, const std::vector<VkRectLayerKHR>& damage);

 private:
  struct Image {
    std::shared_ptr<ImageStore> store;
    VkSemaphore ready = VK_NULL_HANDLE;  // the window system was done with it when it was acquired last
    VkSemaphore drawn = VK_NULL_HANDLE;
    uint64_t picture = 0;  // that it showed last; 0: none
  };
  Swapchain(VulkanDevice& device, const SwapchainDesc& desc) : device_(device), desc_(desc) {}
  // Waits until no picture is being shown.
  void waitUntilShown() const;
  VkResult createImages();
  VkResult createSemaphore(VkSemaphore& out);

  VulkanDevice& device_;
  const SwapchainDesc desc_;
  VkSwapchainKHR handle_ = VK_NULL_HANDLE;
  VkSemaphore spare_ = VK_NULL_HANDLE;  // for the next acquire
  std::vector<Image> images_;
  std::vector<VkRectLayerKHR> damage_;
  int acquired_ = -1;
  uint64_t pictures_ = 0;
  std::mutex mutex_;  // guards the handle, and what follows
  VkResult result_ = VK_SUCCESS;
};

}  // namespace anteroom::vulkan
