#include "tests/vulkan_layer/layer.h"

#include <vulkan/vk_layer.h>

#include <cstring>
#include <map>
#include <mutex>
#include <string_view>

namespace layer {

namespace {

// The next commands are looked up while the instance is made: later, the loader would answer with the first
// layer's.
struct Instance {
  VkInstance handle;
  PFN_vkGetInstanceProcAddr get;
  std::map<std::string_view, PFN_vkVoidFunction> next;
};
struct Device {
  VkDevice handle;
  PFN_vkGetDeviceProcAddr get;
};
std::mutex tablesMutex;
std::map<const void*, Instance> instances;
std::map<const void*, Device> devices;

// The loader hands a chain of links; each layer takes one off.
template <class Info>
Info* chainLink(const void* chain, VkStructureType type) {
  auto* info = static_cast<Info*>(const_cast<void*>(chain));
  while (info && (info->sType != type || info->function != VK_LAYER_LINK_INFO))
    info = static_cast<Info*>(const_cast<void*>(info->pNext));
  return info;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* instance) {
  auto* link =
      chainLink<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  const PFN_vkGetInstanceProcAddr get = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(get(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  Instance made{*instance, get, {}};
  for (const Command& own : instanceCommands()) made.next[own.name] = get(*instance, own.name);
  const std::lock_guard lock(tablesMutex);
  instances[tableOf(*instance)] = std::move(made);
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  auto* link = chainLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  const PFN_vkGetDeviceProcAddr get = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  const PFN_vkGetInstanceProcAddr getOfInstance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  VkInstance instance;
  {
    const std::lock_guard lock(tablesMutex);
    instance = instances.at(tableOf(physical)).handle;
  }
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(getOfInstance(instance, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  const std::lock_guard lock(tablesMutex);
  if (result == VK_SUCCESS) devices[tableOf(*device)] = {*device, get};
  return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name);

PFN_vkVoidFunction find(std::span<const Command> commands, const char* name) {
  for (const Command& each : commands)
    if (std::strcmp(each.name, name) == 0) return each.function;
  return nullptr;
}

PFN_vkVoidFunction ofDevice(const char* name) {
  static const Command kOwn[] = {command("vkGetDeviceProcAddr", deviceProcAddr)};
  const PFN_vkVoidFunction own = find(kOwn, name);
  return own ? own : find(deviceCommands(), name);
}

PFN_vkVoidFunction ofInstance(const char* name) {
  static const Command kOwn[] = {command("vkGetInstanceProcAddr", instanceProcAddr),
                                 command("vkCreateInstance", createInstance),
                                 command("vkCreateDevice", createDevice)};
  if (const PFN_vkVoidFunction own = find(kOwn, name)) return own;
  const PFN_vkVoidFunction taken = find(instanceCommands(), name);
  return taken ? taken : ofDevice(name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
  if (const PFN_vkVoidFunction own = ofDevice(name)) return own;
  return nextOfDevice(tableOf(device), name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name) {
  if (const PFN_vkVoidFunction own = ofInstance(name)) return own;
  if (!instance) return nullptr;
  const std::lock_guard lock(tablesMutex);
  return instances.at(tableOf(instance)).get(instance, name);
}

}  // namespace

PFN_vkVoidFunction nextOfInstance(const void* table, const char* name) {
  const std::lock_guard lock(tablesMutex);
  return instances.at(table).next.at(name);
}

PFN_vkVoidFunction nextOfDevice(const void* table, const char* name) {
  const std::lock_guard lock(tablesMutex);
  const auto& [device, get] = devices.at(table);
  return get(device, name);
}

}  // namespace layer

LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  interface->loaderLayerInterfaceVersion = 2;
  interface->pfnGetInstanceProcAddr = layer::instanceProcAddr;
  interface->pfnGetDeviceProcAddr = layer::deviceProcAddr;
  interface->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
