// A Vulkan layer that counts what is created: VK_LAYER_ANTEROOM_counting.

#include <array>
#include <atomic>

#include "tests/vulkan_layer/layer.h"

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

enum Counted {
#define X(name) k##name,
  COUNTED_COMMANDS(X)
#undef X
      kCounted
};

constexpr std::array<const char*, kCounted> kNames = {
#define X(name) "vk" #name,
    COUNTED_COMMANDS(X)
#undef X
};
std::array<std::atomic<unsigned>, kCounted> counts;

template <class Function>
struct Counting;

template <class... Arguments>
struct Counting<VkResult(VKAPI_PTR*)(VkDevice, Arguments...)> {
  template <Counted kCommand>
  static VKAPI_ATTR VkResult VKAPI_CALL call(VkDevice device, Arguments... arguments) {
    ++counts[kCommand];
    using Function = VkResult(VKAPI_PTR*)(VkDevice, Arguments...);
    return layer::next<Function>(device, kNames[kCommand])(device, arguments...);
  }
};

}  // namespace

std::span<const layer::Command> layer::instanceCommands() {
  return {};
}

std::span<const layer::Command> layer::deviceCommands() {
  static const Command kCommands[] = {
#define X(name) command(kNames[k##name], &Counting<PFN_vk##name>::call<k##name>),
      COUNTED_COMMANDS(X)
#undef X
  };
  return kCommands;
}

// The index-th counted command: its name and how often it was called. Null when there are no more.
LAYER_EXPORT const char* countedCommand(unsigned index, unsigned* count) {
  if (index >= kCounted) return nullptr;
  *count = counts[index];
  return kNames[index];
}
