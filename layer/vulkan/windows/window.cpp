#include "layer/vulkan/windows/window.h"

#include <algorithm>

#include "layer/vulkan/device/device.h"

#include <xcb/xcb.h>
// After the types that they use.
#include <vulkan/vulkan_wayland.h>
#include <vulkan/vulkan_xcb.h>

namespace anteroom::vulkan {
namespace {

// A swapchain may turn out too old again while it is renewed, by a window that is resized all the time.
constexpr int kTries = 4;

template <typename Function>
Function instanceFunction(VkInstance instance, const char* name) {
  return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

// How texels of this format lie in client memory is known; the first of the list is preferred.
struct WindowFormat {
  VkFormat format;
  bool srgb, swapped;
};
constexpr WindowFormat kWindowFormats[] = {
    {VK_FORMAT_R8G8B8A8_UNORM, false, false},
    {VK_FORMAT_B8G8R8A8_UNORM, false, true},
    {VK_FORMAT_R8G8B8A8_SRGB, true, false},
    {VK_FORMAT_B8G8R8A8_SRGB, true, true},
};

Conversion conversionOf(bool swapped, bool hasAlpha) {
  if (hasAlpha) return swapped ? Conversion::SwapBytes : Conversion::None;
  return swapped ? Conversion::SwapAddAlpha : Conversion::AddAlpha;
}

bool isOutOfMemory(VkResult result) {
  return result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
}

VkCompositeAlphaFlagBitsKHR compositeAlpha(VkCompositeAlphaFlagsKHR supported, bool translucent) {
  const auto wanted =
      translucent ? VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR : VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  return supported & wanted ? wanted : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
}

bool same(VkExtent2D a, VkExtent2D b) {
  return a.width == b.width && a.height == b.height;
}

}  // namespace

std::unique_ptr<VulkanWindow> VulkanWindow::create(VulkanDevice& device, const render::WindowDesc& desc) {
  std::unique_ptr<VulkanWindow> window(new VulkanWindow(device, desc));
  if (!window->createSurface() || !window->choose()) return nullptr;
  return window;
}

VulkanWindow::~VulkanWindow() {
  swapchain_.reset();
  if (surface_) device_.instance().surface.destroy(device_.instance().handle, surface_, nullptr);
}

bool VulkanWindow::createSurface() {
  const render::NativeWindow& native = desc_.native;
  if (native.system == render::WindowSystem::Xcb) {
    VkXcbSurfaceCreateInfoKHR info{VK_STRUCTURE_TYPE_XCB_SURFACE_CREATE_INFO_KHR};
    info.connection = static_cast<xcb_connection_t*>(native.connection);
    info.window = native.id;
    const auto create =
        instanceFunction<PFN_vkCreateXcbSurfaceKHR>(device_.instance().handle, "vkCreateXcbSurfaceKHR");
    return create && create(device_.instance().handle, &info, nullptr, &surface_) == VK_SUCCESS;
  }
  VkWaylandSurfaceCreateInfoKHR info{VK_STRUCTURE_TYPE_WAYLAND_SURFACE_CREATE_INFO_KHR};
  info.display = static_cast<wl_display*>(native.connection);
  info.surface = static_cast<wl_surface*>(native.surface);
  const auto create =
      instanceFunction<PFN_vkCreateWaylandSurfaceKHR>(device_.instance().handle, "vkCreateWaylandSurfaceKHR");
  return create && create(device_.instance().handle, &info, nullptr, &surface_) == VK_SUCCESS;
}

// The format, and what else does not depend on the size.
bool VulkanWindow::choose() {
  const VkPhysicalDevice physical = device_.physical();
  const SurfaceFunctions& fn = device_.instance().surface;
  VkBool32 supported = VK_FALSE;
  VkSurfaceCapabilitiesKHR can;
  if (fn.support(physical, device_.queueFamily(), surface_, &supported) != VK_SUCCESS || !supported ||
      capabilities(can) != VK_SUCCESS)
    return false;
  if ((can.supportedUsageFlags & kSwapchainUsage) != kSwapchainUsage) return false;

  uint32_t count = 0;
  fn.presentModes(physical, surface_, &count, nullptr);
  modes_.resize(count);
  fn.presentModes(physical, surface_, &count, modes_.data());

  fn.formats(physical, surface_, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  fn.formats(physical, surface_, &count, formats.data());
  format_ = device_.format(desc_.format);
  for (const WindowFormat& candidate : kWindowFormats) {
    if (candidate.srgb != render::isSrgb(desc_.format)) continue;
    for (const VkSurfaceFormatKHR& offered : formats) {
      if (offered.format != candidate.format || offered.colorSpace != VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
        continue;
      surfaceFormat_ = offered;
      format_.format = candidate.format;
      format_.conversion = conversionOf(candidate.swapped, render::info(desc_.format).alpha != 0);
      return true;
    }
  }
  return false;
}

VkResult VulkanWindow::capabilities(VkSurfaceCapabilitiesKHR& out) const {
  return device_.instance().surface.capabilities(device_.physical(), surface_, &out);
}

bool VulkanWindow::hasMode(VkPresentModeKHR mode) const {
  return std::find(modes_.begin(), modes_.end(), mode) != modes_.end();
}

VkPresentModeKHR VulkanWindow::mode() const {
  if (wish_.interval == 0)
    for (VkPresentModeKHR fast : {VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_MAILBOX_KHR})
      if (hasMode(fast)) return fast;
  return VK_PRESENT_MODE_FIFO_KHR;  // which every device has
}

VkExtent2D VulkanWindow::nativeExtent(const VkSurfaceCapabilitiesKHR& can) const {
  if (can.currentExtent.width != UINT32_MAX) return can.currentExtent;
  const VkExtent2D wanted = wantedExtent();
  return {std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width),
          std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

// 0 by 0: the window system knows.
VkExtent2D VulkanWindow::wantedExtent() const {
  return {static_cast<uint32_t>(std::max(wish_.width, 0)), static_cast<uint32_t>(std::max(wish_.height, 0))};
}

VkResult VulkanWindow::renewSwapchain() {
  suspect_ = false;
  VkSurfaceCapabilitiesKHR can;
  if (const VkResult result = capabilities(can); result != VK_SUCCESS) return result;
  SwapchainDesc desc;
  desc.surface = surface_;
  desc.format = surfaceFormat_;
  desc.extent = nativeExtent(can);
  desc.mode = mode();
  desc.alpha = compositeAlpha(can.supportedCompositeAlpha, desc_.translucent);
  // One on the screen, one that is drawn, and one that the program draws to meanwhile.
  desc.images = std::max(can.minImageCount + 1, 3u);
  if (can.maxImageCount != 0) desc.images = std::min(desc.images, can.maxImageCount);
  desc.presentsBeside = device_.isCpu() && desc.images > can.minImageCount;
  if (desc.extent.width == 0 || desc.extent.height == 0) {
    swapchain_.reset();
    return VK_SUCCESS;
  }
  std::unique_ptr<Swapchain> next;
  const VkResult result = Swapchain::create(device_, desc, swapchain_.get(), next);
  swapchain_ = std::move(next);
  return result;
}

// Brings the swapchain up to date and acquires an image of it.
VkResult VulkanWindow::acquireImage() {
  if (swapchain_ && (suspect_ || swapchain_->acquired())) {
    VkSurfaceCapabilitiesKHR can;
    if (const VkResult result = capabilities(can); result != VK_SUCCESS) return result;
    suspect_ = false;
    if (!same(nativeExtent(can), swapchain_->desc().extent)) swapchain_.reset();
  }
  const VkExtent2D wanted = wantedExtent();
  const bool sized = swapchain_ && (wanted.width == 0 || same(wanted, swapchain_->desc().extent));
  if (!sized || mode() != swapchain_->desc().mode)
    if (const VkResult result = renewSwapchain(); result != VK_SUCCESS) return result;
  return swapchain_ && !swapchain_->acquired() ? swapchain_->acquire() : VK_SUCCESS;
}

VkResult VulkanWindow::acquireFitting() {
  for (int tries = 1;; ++tries) {
    const VkResult result = acquireImage();
    if (result == VK_SUBOPTIMAL_KHR) {
      VkSurfaceCapabilitiesKHR can;
      if (capabilities(can) == VK_SUCCESS && same(nativeExtent(can), swapchain_->desc().extent))
        return VK_SUCCESS;
    } else if (result != VK_ERROR_OUT_OF_DATE_KHR) {
      return result;
    }
    swapchain_.reset();
    // Resized faster than it is drawn: nobody sees this picture, and the next one finds its size.
    if (tries == kTries) return VK_SUCCESS;
  }
}

// The images of the next picture, which are those of the last when it is as large. False: out of memory.
bool VulkanWindow::sizeImages(VkExtent2D extent) {
  render::ImageDesc desc;
  desc.format = desc_.format;
  desc.width = static_cast<int>(extent.width);
  desc.height = static_cast<int>(extent.height);
  desc.renderable = true;
  if (framebuffer_.width == desc.width && framebuffer_.height == desc.height) return true;
  render::Framebuffer next;
  next.window = this;
  next.yDown = true;
  next.samples = desc_.samples;
  next.width = desc.width;
  next.height = desc.height;
  next.color.image = std::make_shared<VulkanImage>(device_, desc, format_);
  desc.samples = desc_.samples;
  if (desc.samples > 1) {
    next.resolve = next.color;
    next.color.image = std::make_shared<VulkanImage>(device_, desc, format_);
  }
  const auto create = [&](render::Format format, render::Attachment& attachment) {
    desc.format = format;
    if (format != render::Format::None) attachment.image = device_.createImage(desc);
    return format == render::Format::None || attachment.image;
  };
  if (!create(desc_.depth, next.depth)) return false;
  if (desc_.stencil == desc_.depth)
    next.stencil = next.depth;
  else if (!create(desc_.stencil, next.stencil))
    return false;
  framebuffer_ = std::move(next);
  width_ = desc.width;
  height_ = desc.height;
  nameImages();
  return true;
}

void VulkanWindow::setLabel(std::string_view text) {
  label_ = text;
  nameImages();
}

void VulkanWindow::nameImages() const {
  if (label_.empty() || !device_.caps().objectNames) return;
  const auto name = [&](const render::Attachment& attachment, const char* use) {
    if (attachment.image) attachment.image->setLabel(label_ + use);
  };
  name(framebuffer_.stencil, " stencil");
  name(framebuffer_.depth, " depth");
  name(framebuffer_.color, " color");
}

void VulkanWindow::lose() {
  lost_ = true;
  returnImage();
  swapchain_.reset();
}

// The image of the picture that was shown is the swapchain's alone.
void VulkanWindow::returnImage() {
  if (framebuffer_.width && drawn().hasStore() && drawn().held()->borrowed) drawn().setStore(nullptr);
}

// False: the native window is gone.
bool VulkanWindow::ask() {
  wish_ = desc_.owner->wish();
  return wish_.there;
}

bool VulkanWindow::makeReady() {
  if (isReady()) return true;
  if (!ask()) lose();
  returnImage();
  if (!lost_) {
    const VkResult result = acquireFitting();
    if (isOutOfMemory(result)) return false;
    if (result != VK_SUCCESS) lose();
  }
  if (!sizeImages(swapchain_ ? swapchain_->desc().extent : extent())) return false;
  const bool keeps = drawn().hasStore() && (wish_.preserved || !swapchain_);
  if (!keeps) drawn().setStore(swapchain_ ? swapchain_->store() : nullptr);
  age_ = keeps ? 1 : swapchain_ ? swapchain_->age() : 0;
  ready_ = drawn().store() != nullptr;
  return isReady();
}

const std::shared_ptr<ImageStore>* VulkanWindow::shown() const {
  return swapchain_ && swapchain_->acquired() ? &swapchain_->store() : nullptr;
}

const std::shared_ptr<render::Image>& VulkanWindow::overlay() {
  const render::ImageDesc& desc = drawn().desc();
  if (!overlay_ || overlay_->desc().width != desc.width || overlay_->desc().height != desc.height)
    overlay_ = std::make_shared<VulkanImage>(device_, desc, format_);
  vulkan(*overlay_).setStore(swapchain_->store());
  return overlay_;
}

// Of a window without pixels: those it had.
VkExtent2D VulkanWindow::extent() const {
  if (framebuffer_.width == 0) return {1, 1};
  return {static_cast<uint32_t>(framebuffer_.width), static_cast<uint32_t>(framebuffer_.height)};
}

render::Presented VulkanWindow::present(uint64_t serial, std::span<const render::Rect> damage) {
  const VkResult result = swapchain_->present(serial, damage);
  if (result == VK_SUBOPTIMAL_KHR) suspect_ = true;
  if (result == VK_ERROR_OUT_OF_DATE_KHR) swapchain_.reset();
  if (result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR)
    return render::Presented::Shown;
  if (isOutOfMemory(result)) return render::Presented::OutOfMemory;
  lose();
  return render::Presented::Lost;
}

std::unique_ptr<render::Window> VulkanDevice::createWindow(const render::WindowDesc& desc) {
  return VulkanWindow::create(*this, desc);
}

}  // namespace anteroom::vulkan
