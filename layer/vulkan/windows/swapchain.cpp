#include "layer/vulkan/windows/swapchain.h"

#include <algorithm>
#include <string>
#include <utility>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/windows/presenter.h"

namespace anteroom::vulkan {

VkResult Swapchain::create(VulkanDevice& device, const SwapchainDesc& desc, const Swapchain* former,
                           std::unique_ptr<Swapchain>& out) {
  // Its last picture is shown before another has the window.
  if (former) former->waitUntilShown();
  std::unique_ptr<Swapchain> made(new Swapchain(device, desc));
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = desc.surface;
  info.minImageCount = desc.images;
  info.imageFormat = desc.format.format;
  info.imageColorSpace = desc.format.colorSpace;
  info.imageExtent = desc.extent;
  info.imageArrayLayers = 1;
  info.imageUsage = kSwapchainUsage;
  info.preTransform = VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR;
  info.compositeAlpha = desc.alpha;
  info.presentMode = desc.mode;
  info.clipped = VK_FALSE;  // pixels that are covered are read back, too
  info.oldSwapchain = former ? former->handle_ : VK_NULL_HANDLE;
  const auto& fn = device.fn();
  VkResult result = fn.vkCreateSwapchainKHR(device.handle(), &info, nullptr, &made->handle_);
  if (result != VK_SUCCESS) return result;
  device.countObject();
  if ((result = made->createImages()) != VK_SUCCESS) return result;
  out = std::move(made);
  return VK_SUCCESS;
}

VkResult Swapchain::createImages() {
  const auto& fn = device_.fn();
  uint32_t count = 0;
  std::vector<VkImage> handles;
  VkResult result;
  do {
    if ((result = fn.vkGetSwapchainImagesKHR(device_.handle(), handle_, &count, nullptr)) != VK_SUCCESS)
      return result;
    handles.resize(count);
    result = fn.vkGetSwapchainImagesKHR(device_.handle(), handle_, &count, handles.data());
  } while (result == VK_INCOMPLETE);
  if (result != VK_SUCCESS) return result;
  images_.resize(count);
  for (uint32_t i = 0; i < count; ++i) {
    auto store = std::make_shared<ImageStore>(device_);
    store->image = handles[i];
    store->borrowed = true;
    store->format = desc_.format.format;
    store->aspects = VK_IMAGE_ASPECT_COLOR_BIT;
    store->id = newStoreId();
    if (device_.labels().nameAll())
      device_.labels().name(VK_OBJECT_TYPE_IMAGE, store->image, "window, image " + std::to_string(i));
    images_[i].store = std::move(store);
    if ((result = createSemaphore(images_[i].drawn)) != VK_SUCCESS) return result;
    if ((result = createSemaphore(images_[i].ready)) != VK_SUCCESS) return result;
  }
  return createSemaphore(spare_);
}

VkResult Swapchain::createSemaphore(VkSemaphore& out) {
  const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  device_.countObject();
  return device_.fn().vkCreateSemaphore(device_.handle(), &info, nullptr, &out);
}

Swapchain::~Swapchain() {
  const auto& fn = device_.fn();
  waitUntilShown();
  if (acquired() && device_.removeFreshImage(store()->image))
    device_.timeline().consume(images_[acquired_].ready);
  // Nothing tells when a present is done but the queue.
  device_.timeline().idle();
  for (Image& image : images_) {
    if (image.store) image.store->release();
    fn.vkDestroySemaphore(device_.handle(), image.ready, nullptr);
    fn.vkDestroySemaphore(device_.handle(), image.drawn, nullptr);
  }
  fn.vkDestroySemaphore(device_.handle(), spare_, nullptr);
  fn.vkDestroySwapchainKHR(device_.handle(), handle_, nullptr);
}

void Swapchain::waitUntilShown() const {
  if (desc_.presentsBeside) device_.presenter().wait(this);
}

VkResult Swapchain::acquire() {
  const auto& fn = device_.fn();
  uint32_t index = 0;
  const std::lock_guard lock(mutex_);
  const VkResult result =
      fn.vkAcquireNextImageKHR(device_.handle(), handle_, UINT64_MAX, spare_, VK_NULL_HANDLE, &index);
  if (result != VK_SUCCESS && result != VK_SUBOPTIMAL_KHR) return result;
  acquired_ = static_cast<int>(index);
  // Nobody waits any more for the semaphore of the image's last turn: it could not be acquired otherwise.
  std::swap(images_[index].ready, spare_);
  const bool shown = images_[index].picture != 0;
  device_.addFreshImage({images_[index].store, images_[index].store->image, VK_IMAGE_ASPECT_COLOR_BIT,
                         shown ? VK_IMAGE_LAYOUT_PRESENT_SRC_KHR : VK_IMAGE_LAYOUT_UNDEFINED, !shown,
                         images_[index].ready});
  return result;
}

int Swapchain::age() const {
  const uint64_t picture = images_[acquired_].picture;
  return picture == 0 ? 0 : static_cast<int>(pictures_ - picture + 1);
}

VkResult Swapchain::present(uint64_t serial, std::span<const render::Rect> damage) {
  const auto width = static_cast<int>(desc_.extent.width), height = static_cast<int>(desc_.extent.height);
  damage_.clear();
  for (const render::Rect& rect : damage) {
    const auto edge = [](int64_t at, int size) { return static_cast<int>(std::clamp<int64_t>(at, 0, size)); };
    const int left = edge(rect.x, width), right = edge(int64_t{rect.x} + rect.width, width);
    const int low = edge(rect.y, height), high = edge(int64_t{rect.y} + rect.height, height);
    if (left >= right || low >= high) continue;
    damage_.push_back(
        {{left, height - high}, {static_cast<uint32_t>(right - left), static_cast<uint32_t>(high - low)}, 0});
  }
  const auto image = static_cast<uint32_t>(std::exchange(acquired_, -1));
  images_[image].picture = ++pictures_;
  if (desc_.presentsBeside) {
    waitUntilShown();  // one at a time: there are no images for more
    device_.presenter().add(*this, image, serial, damage_);
  } else {
    show(image, damage_);
  }
  const std::lock_guard lock(mutex_);
  return std::exchange(result_, VK_SUCCESS);
}

void Swapchain::show(uint32_t image, const std::vector<VkRectLayerKHR>& damage) {
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &images_[image].drawn;
  info.swapchainCount = 1;
  info.pSwapchains = &handle_;
  info.pImageIndices = &image;
  VkPresentRegionKHR region{};
  VkPresentRegionsKHR regions{VK_STRUCTURE_TYPE_PRESENT_REGIONS_KHR};
  if (device_.features().presentRegions && !damage.empty()) {
    region = {static_cast<uint32_t>(damage.size()), damage.data()};
    regions.swapchainCount = 1;
    regions.pRegions = &region;
    info.pNext = &regions;
  }
  const std::lock_guard lock(mutex_);
  result_ = device_.timeline().present(info);
}

}  // namespace anteroom::vulkan
