#include "layer/vulkan/context.h"

#include <algorithm>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/windows/presenter.h"

namespace anteroom::vulkan {
namespace {

constexpr uint32_t kMostLocations = gen::kOwnValuesLocation + gen::kMostOwnValues;

}  // namespace

VulkanContext::VulkanContext(VulkanDevice& device)
    : device_(device),
      commands_(device),
      pass_(device, commands_),
      vertices_(device, Stream::Purpose::Vertices, 512 << 10),
      indices_(device, Stream::Purpose::Vertices, 128 << 10),
      constants_(device, Stream::Purpose::Constants, 128 << 10),
      staging_(device, Stream::Purpose::Vertices, 1 << 20),
      readBack_(device, Stream::Purpose::ReadBack, 1 << 20),
      fetch_(device),
      carriesValues_(std::min(device.limits().maxVertexInputAttributes,
                              device.limits().maxVertexInputBindings) >= kMostLocations) {}

VulkanContext::~VulkanContext() {
  while (openGroups_ > 0) popGroup();
  finish();
  ShaderLibrary::flush();
  device_.driverCache().save();
}

bool VulkanContext::submit(VkSemaphore signal) {
  flushBatch();
  pass_.end();
  drawsSinceSubmit_ = 0;
  if (!commands_.recording()) return !commands_.lost();
  const uint64_t serial = commands_.submit(signal);
  for (Stream* stream : {&vertices_, &indices_, &constants_, &staging_, &readBack_})
    stream->submitted(serial);
  if (serial) ++stats_.submits;
  return serial != 0;
}

void VulkanContext::pushGroup(std::string_view text) {
  flushBatch();
  const VkCommandBuffer commands = device_.labels().inCommands() ? commands_.commands() : VK_NULL_HANDLE;
  if (!commands) return;
  device_.labels().begin(commands, text);
  ++openGroups_;
}

void VulkanContext::popGroup() {
  if (openGroups_ == 0) return;
  --openGroups_;
  flushBatch();
  if (const VkCommandBuffer commands = commands_.commands()) device_.labels().end(commands);
}

void VulkanContext::mark(std::string_view text) {
  flushBatch();
  const VkCommandBuffer commands = device_.labels().inCommands() ? commands_.commands() : VK_NULL_HANDLE;
  if (commands) device_.labels().insert(commands, text);
}

void VulkanContext::flush() {
  submit();
}

void VulkanContext::finish() {
  submit();
  device_.timeline().wait(commands_.lastSubmitted(), UINT64_MAX);
  device_.presenter().wait(nullptr);
  commands_.retire();
}

uint64_t VulkanContext::insertFence() {
  submit();
  return commands_.lastSubmitted();
}

bool VulkanContext::waitFence(uint64_t fence, uint64_t timeout) {
  return device_.timeline().wait(fence, timeout);
}

const render::Stats& VulkanContext::stats() const {
  stats_.renderPasses = pass_.passes() - ownPasses_;
  stats_.pipelinesCreated = device_.pipelines().created();
  stats_.shadersCompiled = device_.shaders().compiled();
  stats_.shadersFromCache = device_.shaders().fromCache();
  stats_.vulkanObjectsCreated = device_.objects();
  stats_.memoryAllocations = device_.memoryAllocations();
  stats_.memoryBytes = device_.memoryBytes();
  return stats_;
}

}  // namespace anteroom::vulkan
