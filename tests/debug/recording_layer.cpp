// A Vulkan layer that writes down what a tool would see: VK_LAYER_ANTEROOM_recording. Names, labels, passes
// and draws go to $RECORDING_LAYER_LOG, a line each. Labels of command buffers end here, since Mesa's CPU
// driver crashes in them; and so that they are sent at all, the device does not look like a CPU from above.
// It refuses to make what $RECORDING_LAYER_REFUSES names: shaders or pipelines. It serves one instance and
// one device.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace {

// What comes next, by dispatch table, which is the first thing in every object: that of an instance or device
// and all of its own. Instance commands are looked up while the instance is made: later, the loader would
// answer with the first layer's.
struct InstanceCommands {
  VkInstance instance;
  PFN_vkGetInstanceProcAddr get;
  PFN_vkGetPhysicalDeviceProperties properties;
  PFN_vkGetPhysicalDeviceProperties2 properties2;
};
std::mutex tablesMutex;
std::map<const void*, InstanceCommands> instances;
std::map<const void*, std::pair<VkDevice, PFN_vkGetDeviceProcAddr>> devices;

template <typename Handle>
const void* tableOf(Handle handle) {
  return *reinterpret_cast<void* const*>(handle);
}

template <typename Handle>
InstanceCommands commandsOf(Handle handle) {
  const std::lock_guard lock(tablesMutex);
  return instances.at(tableOf(handle));
}
template <typename Function, typename Handle>
Function next(Handle handle, const char* name) {
  const std::lock_guard lock(tablesMutex);
  const auto& [device, nextCommand] = devices.at(tableOf(handle));
  return reinterpret_cast<Function>(nextCommand(device, name));
}

void write(const std::string& line) {
  static std::mutex mutex;
  static std::FILE* const log = [] {
    const char* path = std::getenv("RECORDING_LAYER_LOG");
    return path ? std::fopen(path, "w") : nullptr;
  }();
  const std::lock_guard lock(mutex);
  if (log == nullptr) return;
  std::fprintf(log, "%s\n", line.c_str());
  std::fflush(log);
}

bool refuses(const char* what) {
  const char* refused = std::getenv("RECORDING_LAYER_REFUSES");
  return refused != nullptr && std::strcmp(refused, what) == 0;
}

// ---- the instance's commands ----

void hideCpu(VkPhysicalDeviceProperties& properties) {
  if (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU)
    properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* out) {
  commandsOf(physical).properties(physical, out);
  hideCpu(*out);
}
VKAPI_ATTR void VKAPI_CALL getProperties2(VkPhysicalDevice physical, VkPhysicalDeviceProperties2* out) {
  commandsOf(physical).properties2(physical, out);
  hideCpu(out->properties);
}

// ---- the device's commands ----

VKAPI_ATTR VkResult VKAPI_CALL setName(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info) {
  write("name " + std::to_string(info->objectType) + " " + info->pObjectName);
  return next<PFN_vkSetDebugUtilsObjectNameEXT>(device, "vkSetDebugUtilsObjectNameEXT")(device, info);
}
VKAPI_ATTR void VKAPI_CALL beginLabel(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
  write(std::string("begin ") + label->pLabelName);
}
VKAPI_ATTR void VKAPI_CALL endLabel(VkCommandBuffer) {
  write("end");
}
VKAPI_ATTR void VKAPI_CALL insertLabel(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
  write(std::string("insert ") + label->pLabelName);
}
VKAPI_ATTR void VKAPI_CALL draw(VkCommandBuffer commands, uint32_t vertices, uint32_t copies, uint32_t first,
                                uint32_t firstInstance) {
  write("draw " + std::to_string(vertices));
  next<PFN_vkCmdDraw>(commands, "vkCmdDraw")(commands, vertices, copies, first, firstInstance);
}
VKAPI_ATTR void VKAPI_CALL drawIndexed(VkCommandBuffer commands, uint32_t indices, uint32_t copies,
                                       uint32_t first, int32_t offset, uint32_t firstInstance) {
  write("draw indexed " + std::to_string(indices));
  next<PFN_vkCmdDrawIndexed>(commands, "vkCmdDrawIndexed")(commands, indices, copies, first, offset,
                                                           firstInstance);
}
VKAPI_ATTR VkResult VKAPI_CALL createShader(VkDevice device, const VkShaderModuleCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkShaderModule* out) {
  if (refuses("shaders")) return VK_ERROR_INITIALIZATION_FAILED;
  return next<PFN_vkCreateShaderModule>(device, "vkCreateShaderModule")(device, info, allocator, out);
}
VKAPI_ATTR VkResult VKAPI_CALL createPipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                               const VkGraphicsPipelineCreateInfo* infos,
                                               const VkAllocationCallbacks* allocator, VkPipeline* out) {
  if (refuses("pipelines")) return VK_ERROR_INITIALIZATION_FAILED;
  const auto create = next<PFN_vkCreateGraphicsPipelines>(device, "vkCreateGraphicsPipelines");
  return create(device, cache, count, infos, allocator, out);
}

// ---- the loader's ----

// The loader hands a chain of links; each layer takes one off.
template <typename Info>
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
  const PFN_vkGetInstanceProcAddr below = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(below(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  const std::lock_guard lock(tablesMutex);
  if (result != VK_SUCCESS) return result;
  const auto find = [&](const char* name) { return below(*instance, name); };
  instances[tableOf(*instance)] = {
      *instance, below,
      reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(find("vkGetPhysicalDeviceProperties")),
      reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(find("vkGetPhysicalDeviceProperties2"))};
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  auto* link = chainLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  const PFN_vkGetDeviceProcAddr below = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  const PFN_vkGetInstanceProcAddr belowInstance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create =
      reinterpret_cast<PFN_vkCreateDevice>(belowInstance(commandsOf(physical).instance, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  const std::lock_guard lock(tablesMutex);
  if (result == VK_SUCCESS) devices[tableOf(*device)] = {*device, below};
  return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name);

struct Command {
  const char* name;
  PFN_vkVoidFunction function;
};
template <typename Function>
PFN_vkVoidFunction generic(Function function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

PFN_vkVoidFunction deviceCommand(const char* name) {
  static const Command kCommands[] = {{"vkGetDeviceProcAddr", generic(deviceProcAddr)},
                                      {"vkSetDebugUtilsObjectNameEXT", generic(setName)},
                                      {"vkCmdBeginDebugUtilsLabelEXT", generic(beginLabel)},
                                      {"vkCmdEndDebugUtilsLabelEXT", generic(endLabel)},
                                      {"vkCmdInsertDebugUtilsLabelEXT", generic(insertLabel)},
                                      {"vkCmdDraw", generic(draw)},
                                      {"vkCmdDrawIndexed", generic(drawIndexed)},
                                      {"vkCreateShaderModule", generic(createShader)},
                                      {"vkCreateGraphicsPipelines", generic(createPipelines)}};
  for (const Command& command : kCommands)
    if (std::strcmp(command.name, name) == 0) return command.function;
  return nullptr;
}

PFN_vkVoidFunction instanceCommand(const char* name) {
  static const Command kCommands[] = {{"vkGetInstanceProcAddr", generic(instanceProcAddr)},
                                      {"vkCreateInstance", generic(createInstance)},
                                      {"vkCreateDevice", generic(createDevice)},
                                      {"vkGetPhysicalDeviceProperties", generic(getProperties)},
                                      {"vkGetPhysicalDeviceProperties2", generic(getProperties2)}};
  for (const Command& command : kCommands)
    if (std::strcmp(command.name, name) == 0) return command.function;
  return deviceCommand(name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
  if (const PFN_vkVoidFunction own = deviceCommand(name)) return own;
  return next<PFN_vkVoidFunction>(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceProcAddr(VkInstance instance, const char* name) {
  if (const PFN_vkVoidFunction own = instanceCommand(name)) return own;
  return instance ? commandsOf(instance).get(instance, name) : nullptr;
}

}  // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
  interface->loaderLayerInterfaceVersion = 2;
  interface->pfnGetInstanceProcAddr = instanceProcAddr;
  interface->pfnGetDeviceProcAddr = deviceProcAddr;
  interface->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
