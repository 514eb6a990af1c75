// The Vulkan loader, an instance, and the choice among physical devices.
#pragma once

#include <volk.h>

#include <string>

#include "layer/vulkan/vulkan_device.h"

namespace anteroom::vulkan {

// Of VK_KHR_surface, for one instance: volk's own are those of the instance that was made last, which may
// not have the extension.
struct SurfaceFunctions {
  PFN_vkDestroySurfaceKHR destroy = nullptr;
  PFN_vkGetPhysicalDeviceSurfaceSupportKHR support = nullptr;
  PFN_vkGetPhysicalDeviceSurfaceCapabilitiesKHR capabilities = nullptr;
  PFN_vkGetPhysicalDeviceSurfaceFormatsKHR formats = nullptr;
  PFN_vkGetPhysicalDeviceSurfacePresentModesKHR presentModes = nullptr;
};

// Messages of the validation layer about calls of this thread are kept here while this lives. One that would
// abort the process does so when this ends.
class ValidationScope {
 public:
  ValidationScope();
  ~ValidationScope();
  ValidationScope(const ValidationScope&) = delete;
  ValidationScope& operator=(const ValidationScope&) = delete;
  const std::string& messages() const { return messages_; }
  void add(const char* message, bool fatal);

 private:
  ValidationScope* const outer_;
  std::string messages_;
  bool fatal_ = false;
};

struct Instance {
  std::string devices, choice;  // of render::Origin
  VkInstance handle = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  uint32_t queueFamily = 0;  // graphics
  bool debugUtils = false;   // VK_EXT_debug_utils is on
  SurfaceFunctions surface;
  bool surfaces = false;  // of the window system that was asked for
};

// Vulkan 1.1 on the preferred device, else a discrete one, an integrated one, a virtual one, a CPU. False:
// `error` says why and what to do. Hold a DeviceLock.
bool createInstance(const DeviceOptions& options, Instance& instance, std::string& error);
void destroyInstance(Instance& instance);

// Held while a device is made or destroyed: what loads functions is global.
class DeviceLock {
 public:
  DeviceLock();
  ~DeviceLock();
  DeviceLock(const DeviceLock&) = delete;
  DeviceLock& operator=(const DeviceLock&) = delete;
};

}  // namespace anteroom::vulkan
