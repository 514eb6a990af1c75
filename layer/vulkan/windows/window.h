// A native window that contexts draw to: straight to the images of its swapchain, or, where the next picture
// starts with the one before, to an image of its own that is copied.
#pragma once

#include <volk.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "layer/render/window.h"
#include "layer/vulkan/device/formats.h"
#include "layer/vulkan/resources/image.h"
#include "layer/vulkan/windows/swapchain.h"

namespace anteroom::vulkan {

class VulkanWindow final : public render::Window {
 public:
  // Null: out of memory, or nothing that the device can draw to.
  static std::unique_ptr<VulkanWindow> create(VulkanDevice& device, const render::WindowDesc& desc);
  ~VulkanWindow() override;

  bool makeReady() override;
  void setLabel(std::string_view text) override;
  int age() const override { return age_; }
  void setHud(const render::Hud* hud) override { hud_ = hud; }

  // For VulkanContext::present. Whether the picture is to be kept is asked again before it is shown, and
  // whether the native window is gone: it is lost then, when all that was drawn has been submitted.
  bool isGone() { return !ask(); }
  void lose();
  // The picture is in drawn(), and goes to shown(): it lies there, unless pictures are kept. Null: nothing
  // can be seen of the window.
  VulkanImage& drawn() const { return vulkan(*framebuffer_.readable().image); }
  const std::shared_ptr<ImageStore>* shown() const;
  bool preserved() const { return wish_.preserved; }
  const render::Hud* hud() const { return hud_; }
  // An image of shown(), to be drawn over.
  const std::shared_ptr<render::Image>& overlay();
  VkExtent2D extent() const;
  VkSemaphore semaphore() const { return swapchain_->drawn(); }
  // shown() has been drawn by submission `serial`, or will be.
  render::Presented present(uint64_t serial, std::span<const render::Rect> damage);
  bool lost() const { return lost_; }

 private:
  VulkanWindow(VulkanDevice& device, const render::WindowDesc& desc) : device_(device), desc_(desc) {}
  bool ask();
  bool createSurface();
  bool choose();
  VkResult capabilities(VkSurfaceCapabilitiesKHR& out) const;
  VkPresentModeKHR mode() const;
  bool hasMode(VkPresentModeKHR mode) const;
  VkExtent2D wantedExtent() const;
  VkExtent2D nativeExtent(const VkSurfaceCapabilitiesKHR& capabilities) const;
  VkResult acquireFitting();
  VkResult acquireImage();
  VkResult renewSwapchain();
  bool sizeImages(VkExtent2D extent);
  void nameImages() const;
  void returnImage();

  VulkanDevice& device_;
  const render::WindowDesc desc_;
  StoreFormat format_;  // of colors
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR surfaceFormat_{};
  std::vector<VkPresentModeKHR> modes_;
  std::unique_ptr<Swapchain> swapchain_;    // null: lost, or without pixels
  std::shared_ptr<render::Image> overlay_;  // made for the first HUD
  const render::Hud* hud_ = nullptr;
  std::string label_;
  render::PictureWish wish_;
  bool suspect_ = false;  // the swapchain may no longer fit
  bool lost_ = false;
  int age_ = 0;
};

}  // namespace anteroom::vulkan
