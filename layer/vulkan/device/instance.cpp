#include "layer/vulkan/device/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace anteroom::vulkan {
namespace {

std::mutex deviceMutex;
std::atomic<unsigned> messageCount{0};
thread_local ValidationScope* innermostScope = nullptr;

// glslang decorates gl_Position, a member of gl_PerVertex, as SPIR-V allows; some versions of the layer warn
// of it. Colors that a framebuffer of depth alone has no attachment for are dropped, as Vulkan says.
constexpr const char* kFalseAlarms[] = {"Decoration not allowed on struct members: SpvDecorationInvariant",
                                        "writes to output location 0 with no matching attachment"};

constexpr const char* kNoDriver =
    "no Vulkan device: install a Vulkan driver, such as Mesa's lavapipe (mesa-vulkan-drivers)";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* fatal) {
  for (const char* alarm : kFalseAlarms)
    if (std::strstr(data->pMessage, alarm)) return VK_FALSE;
  messageCount.fetch_add(1, std::memory_order_relaxed);
  std::fprintf(stderr, "anteroom: validation: %s\n", data->pMessage);
  if (innermostScope)
    innermostScope->add(data->pMessage, fatal);
  else if (fatal)
    std::abort();
  return VK_FALSE;
}

bool hasLayer(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const auto& layer : layers)
    if (!std::strcmp(layer.layerName, name)) return true;
  return false;
}

// The extensions that there are of those that are wanted. With `validation` the layer brings the debug
// utilities.
std::vector<const char*> chooseExtensions(const DeviceOptions& options, bool validation, Instance& instance) {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> available(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, available.data());
  std::vector<const char*> chosen;
  const auto choose = [&](const char* name) {
    const bool found = std::any_of(available.begin(), available.end(), [&](const auto& extension) {
      return !std::strcmp(extension.extensionName, name);
    });
    if (found) chosen.push_back(name);
    return found;
  };
  if (validation) {
    chosen.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    instance.debugUtils = true;
  } else {
    instance.debugUtils = !options.minimal && choose(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }
  // Others would have the driver's layers look for servers that nobody asked for.
  if (options.windows && choose(VK_KHR_SURFACE_EXTENSION_NAME))
    instance.surfaces = choose(*options.windows == render::WindowSystem::Xcb ? "VK_KHR_xcb_surface"
                                                                             : "VK_KHR_wayland_surface");
  return chosen;
}

int preference(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 1;
    default:
      return 0;
  }
}

bool graphicsFamily(VkPhysicalDevice physical, uint32_t& family) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (family = 0; family < count; ++family)
    if (families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) return true;
  return false;
}

const char* typeName(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "of no known type";
  }
}

struct Candidate {
  VkPhysicalDevice physical;
  VkPhysicalDeviceProperties properties;
  uint32_t queueFamily = 0;
  const char* fault = nullptr;  // why it cannot be taken

  int rank() const { return fault ? -1 : preference(properties.deviceType); }
  std::string text(size_t index, const Candidate& chosen) const {
    const char* const fate = fault                    ? fault
                             : this == &chosen        ? "chosen"
                             : rank() < chosen.rank() ? "of a kind that comes later"
                                                      : "as good, but listed later";
    const uint32_t version = properties.apiVersion;
    return fmt::format("{}: {}, {}, Vulkan {}.{}.{}: {}", index, properties.deviceName,
                       typeName(properties.deviceType), VK_API_VERSION_MAJOR(version),
                       VK_API_VERSION_MINOR(version), VK_API_VERSION_PATCH(version), fate);
  }
};

std::vector<Candidate> findCandidates(VkInstance instance, const std::string& preferred, bool byIndex) {
  uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  std::vector<Candidate> candidates;
  for (VkPhysicalDevice device : devices) {
    Candidate candidate{device, {}};
    vkGetPhysicalDeviceProperties(device, &candidate.properties);
    if (candidate.properties.apiVersion < VK_API_VERSION_1_1)
      candidate.fault = "not Vulkan 1.1";
    else if (!graphicsFamily(device, candidate.queueFamily))
      candidate.fault = "cannot draw";
    else if (byIndex ? preferred != std::to_string(candidates.size())
                     : !std::strstr(candidate.properties.deviceName, preferred.c_str()))
      candidate.fault = "not what ANTEROOM_DEVICE asks for";
    candidates.push_back(candidate);
  }
  return candidates;
}

std::string choiceText(const std::string& preferred, size_t usable) {
  constexpr const char* order = "discrete GPUs come first, then integrated ones, virtual ones, CPUs";
  if (preferred.empty()) return usable > 1 ? order : "no other can be used";
  std::string text = "ANTEROOM_DEVICE=" + preferred;
  if (usable > 1) text.append("; of those that match it ").append(order);
  return text;
}

bool choosePhysicalDevice(const std::string& preferred, Instance& instance, std::string& error) {
  const bool byIndex = !preferred.empty() && preferred.find_first_not_of("0123456789") == std::string::npos;
  const std::vector<Candidate> candidates = findCandidates(instance.handle, preferred, byIndex);
  const auto best = std::max_element(candidates.begin(), candidates.end(),
                                     [](const auto& a, const auto& b) { return a.rank() < b.rank(); });
  if (best == candidates.end()) {
    error = kNoDriver;
    return false;
  }
  size_t usable = 0;
  for (const Candidate& candidate : candidates) {
    const auto index = static_cast<size_t>(&candidate - candidates.data());
    instance.devices.append(index == 0 ? "" : "\n").append(candidate.text(index, *best));
    if (!candidate.fault) ++usable;
  }
  if (usable == 0) {
    error = fmt::format("no Vulkan 1.1 device with graphics{}; there are:\n{}",
                        preferred.empty() ? "" : " matches ANTEROOM_DEVICE=" + preferred, instance.devices);
    return false;
  }
  instance.physical = best->physical;
  instance.queueFamily = best->queueFamily;
  instance.choice = choiceText(preferred, usable);
  return true;
}

void loadSurfaceFunctions(Instance& instance) {
  const auto load = [&](const char* name, auto& function) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
        vkGetInstanceProcAddr(instance.handle, name));
  };
  load("vkDestroySurfaceKHR", instance.surface.destroy);
  load("vkGetPhysicalDeviceSurfaceSupportKHR", instance.surface.support);
  load("vkGetPhysicalDeviceSurfaceCapabilitiesKHR", instance.surface.capabilities);
  load("vkGetPhysicalDeviceSurfaceFormatsKHR", instance.surface.formats);
  load("vkGetPhysicalDeviceSurfacePresentModesKHR", instance.surface.presentModes);
}

void createMessenger(Instance& instance, bool fatal) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = fatal ? &instance : nullptr;  // only whether there is one is looked at
  vkCreateDebugUtilsMessengerEXT(instance.handle, &info, nullptr, &instance.messenger);
}

// The Vulkan loader's functions serve every instance. Other threads call them: they are looked up again only
// for the sake of extensions that no instance had before.
bool loadLoader() {
  static bool loaded = false;
  if (!loaded) loaded = volkInitialize() == VK_SUCCESS;
  return loaded;
}

void loadFunctions(VkInstance instance, const VkInstanceCreateInfo& info) {
  static bool loaded = false;
  static auto& extensions = *new std::set<std::string>;  // never destroyed, like what may initialize last
  for (uint32_t i = 0; i < info.enabledExtensionCount; ++i)
    loaded &= !extensions.insert(info.ppEnabledExtensionNames[i]).second;
  if (!loaded) volkLoadInstanceOnly(instance);
  loaded = true;
}

}  // namespace

DeviceLock::DeviceLock() {
  deviceMutex.lock();
}
DeviceLock::~DeviceLock() {
  deviceMutex.unlock();
}

ValidationScope::ValidationScope() : outer_(innermostScope) {
  innermostScope = this;
}
ValidationScope::~ValidationScope() {
  innermostScope = outer_;
  if (fatal_) std::abort();
}
void ValidationScope::add(const char* message, bool fatal) {
  messages_.append(message).append("\n");
  fatal_ |= fatal;
}

unsigned validationMessages() {
  return messageCount.load(std::memory_order_relaxed);
}

bool createInstance(const DeviceOptions& options, Instance& instance, std::string& error) {
  if (!loadLoader()) {
    error = "no Vulkan loader: install libvulkan1";
    return false;
  }
  if (volkGetInstanceVersion() < VK_API_VERSION_1_1) {
    error = "the Vulkan loader knows only Vulkan 1.0: install a newer libvulkan1";
    return false;
  }
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pEngineName = "Anteroom";
  application.apiVersion = VK_API_VERSION_1_1;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  const char* layer = "VK_LAYER_KHRONOS_validation";
  using enum render::DebugOptions::Validation;
  const bool wanted = options.debug.validation != Off;
  const bool validation = wanted && hasLayer(layer);
  if (wanted && !validation)
    std::fprintf(stderr, "anteroom: no validation layer: install vulkan-validationlayers\n");
  if (validation) {
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &layer;
  }
  const std::vector<const char*> extensions = chooseExtensions(options, validation, instance);
  info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  if (VkResult result = vkCreateInstance(&info, nullptr, &instance.handle); result != VK_SUCCESS) {
    error = result == VK_ERROR_INCOMPATIBLE_DRIVER
                ? kNoDriver
                : "vkCreateInstance failed with " + std::to_string(result) + ": check the Vulkan driver";
    return false;
  }
  loadFunctions(instance.handle, info);
  if (instance.surfaces) loadSurfaceFunctions(instance);
  if (validation) createMessenger(instance, options.debug.validation == Abort);
  if (choosePhysicalDevice(options.preferred, instance, error)) return true;
  destroyInstance(instance);
  return false;
}

void destroyInstance(Instance& instance) {
  if (!instance.handle) return;
  if (instance.messenger) vkDestroyDebugUtilsMessengerEXT(instance.handle, instance.messenger, nullptr);
  vkDestroyInstance(instance.handle, nullptr);
  instance = {};
}

}  // namespace anteroom::vulkan
