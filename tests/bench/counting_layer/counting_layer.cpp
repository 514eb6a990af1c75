// A Vulkan layer that counts what is created: VK_LAYER_ANTEROOM_counting. It serves a test that makes one
// instance and one device, and so keeps one set of next entry points.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <array>
#include <atomic>
#include <cstring>

#define COUNTED_COMMANDS(X)    \
  X(AllocateMemory)            \
  X(AllocateCommandBuffers)    \
  X(AllocateDescriptorSets)    \
  X(CreateBuffer)              \
  X(CreateBufferView)          \
  X(CreateCommandPool)         \
  X(CreateComputePipelines)    \
  X(CreateDescriptorPool)      \
  X(CreateDescriptorSetLayout) \
  X(CreateEvent)               \
  X(CreateFence)               \
  X(CreateFramebuffer)         \
  X(CreateGraphicsPipelines)   \
  X(CreateImage)               \
  X(CreateImageView)           \
  X(CreatePipelineCache)       \
  X(CreatePipelineLayout)      \
  X(CreateQueryPool)           \
  X(CreateRenderPass)          \
  X(CreateRenderPass2)         \
  X(CreateSampler)             \
  X(CreateSemaphore)           \
  X(CreateShaderModule)

namespace {

enum Command {
#define X(name) k##name,
  COUNTED_COMMANDS(X)
#undef X
      kCommands
};

struct CommandInfo {
  const char* name;
  PFN_vkVoidFunction next = nullptr;
  std::atomic<unsigned> count = 0;
};

std::array<CommandInfo, kCommands> commands = {{
#define X(name) {"vk" #name},
    COUNTED_COMMANDS(X)
#undef X
}};

PFN_vkGetInstanceProcAddr nextInstanceProcAddr;
PFN_vkGetDeviceProcAddr nextDeviceProcAddr;

template <typename Function>
struct Counting;

template <typename... Arguments>
struct Counting<VkResult(VKAPI_PTR*)(Arguments...)> {
  template <Command kCommand>
  static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
    ++commands[kCommand].count;
    return reinterpret_cast<VkResult(VKAPI_PTR*)(Arguments...)>(commands[kCommand].next)(arguments...);
  }
};

PFN_vkVoidFunction countingCommand(const char* name) {
#define X(command)                           \
  if (std::strcmp(name, "vk" #command) == 0) \
    return reinterpret_cast<PFN_vkVoidFunction>(&Counting<PFN_vk##command>::call<k##command>);
  COUNTED_COMMANDS(X)
#undef X
  return nullptr;
}

// The loader hands a chain of links; each layer takes one off.
template <typename Info>
Info* chainLink(const void* next, VkStructureType type) {
  auto* info = static_cast<Info*>(const_cast<void*>(next));
  while (info && (info->sType != type || info->function != VK_LAYER_LINK_INFO))
    info = static_cast<Info*>(const_cast<void*>(info->pNext));
  return info;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* instance) {
  auto* link =
      chainLink<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  nextInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(nextInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
  return create(info, allocator, instance);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  auto* link = chainLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(
      link->u.pLayerInfo->pfnNextGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
  nextDeviceProcAddr = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const VkResult result = create(physical, info, allocator, device);
  if (result == VK_SUCCESS)
    for (CommandInfo& command : commands) command.next = nextDeviceProcAddr(*device, command.name);
  return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(&deviceProcAddr);
  if (const PFN_vkVoidFunction counting = countingCommand(name)) return counting;
  return nextDeviceProcAddr(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name) {
  if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(&instanceProcAddr);
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(&deviceProcAddr);
  if (std::strcmp(name, "vkCreateInstance") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(&createInstance);
  if (std::strcmp(name, "vkCreateDevice") == 0) return reinterpret_cast<PFN_vkVoidFunction>(&createDevice);
  if (const PFN_vkVoidFunction counting = countingCommand(name)) return counting;
  return nextInstanceProcAddr ? nextInstanceProcAddr(instance, name) : nullptr;
}

}  // namespace

extern "C" {

VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  interface->loaderLayerInterfaceVersion = 2;
  interface->pfnGetInstanceProcAddr = instanceProcAddr;
  interface->pfnGetDeviceProcAddr = deviceProcAddr;
  interface->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}

// The index-th counted command: its name and how often it was called. Null when there are no more.
VK_LAYER_EXPORT const char* countedCommand(unsigned index, unsigned* count) {
  if (index >= commands.size()) return nullptr;
  *count = commands[index].count;
  return commands[index].name;
}
}
