// What Vulkan layers of tests have in common: the way from the Vulkan loader to their commands, and from
// these to what comes next. A layer is made of layer.cpp and a file that gives the two lists of commands.
#pragma once

#include <vulkan/vulkan.h>

#include <span>

// Of Vulkan's own headers only older ones have such a macro.
#define LAYER_EXPORT extern "C" __attribute__((visibility("default")))

namespace layer {

struct Command {
  const char* name;
  PFN_vkVoidFunction function;
};
template <class Function>
Command command(const char* name, Function function) {
  return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

// The commands in whose place the layer puts its own. Each layer defines these.
std::span<const Command> instanceCommands();
std::span<const Command> deviceCommands();

// What comes next, by the dispatch table that is the first thing in every object: of a physical device one of
// instanceCommands(), of a device and all of its own any of the device's.
PFN_vkVoidFunction nextOfInstance(const void* table, const char* name);
PFN_vkVoidFunction nextOfDevice(const void* table, const char* name);

template <class Handle>
const void* tableOf(Handle handle) {
  return *reinterpret_cast<void* const*>(handle);
}
template <class Function>
Function next(VkPhysicalDevice physical, const char* name) {
  return reinterpret_cast<Function>(nextOfInstance(tableOf(physical), name));
}
template <class Function, class Handle>
Function next(Handle handle, const char* name) {
  return reinterpret_cast<Function>(nextOfDevice(tableOf(handle), name));
}

}  // namespace layer
