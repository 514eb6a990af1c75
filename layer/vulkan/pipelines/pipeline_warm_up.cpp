#include "layer/vulkan/pipelines/pipeline_warm_up.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

#include "gen/interface.h"
#include "layer/cache/quiet_thread.h"
#include "layer/cache/shader_cache.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/pipeline_words.h"
#include "layer/vulkan/pipelines/shader_library.h"

namespace anteroom::vulkan {
namespace {

template <class Key>
const Key& as(const Shader& shader) {
  return *reinterpret_cast<const Key*>(shader.key.data());
}

// Own shaders go with own shaders, and read no arrays.
bool fitTogether(const Shader& vertex, const Shader& fragment, const VertexLayout& layout,
                 bool dynamicInput) {
  const bool own = vertex.kind == cache::KeyKind::VertexText;
  if (own != (fragment.kind == cache::KeyKind::FragmentText)) return false;
  if (own) return true;
  const auto& vertexKey = as<gen::VertexKey>(vertex);
  const auto& fragmentKey = as<gen::FragmentKey>(fragment);
  return gen::feeds(vertexKey, fragmentKey) && (dynamicInput || feeds(layout, vertexKey, fragmentKey));
}

bool attaches(const VulkanDevice& device, uint32_t format, VkFormatFeatureFlags feature) {
  if (format == VK_FORMAT_UNDEFINED) return true;
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device.physical(), static_cast<VkFormat>(format), &properties);
  return (properties.linearTilingFeatures | properties.optimalTilingFeatures) & feature;
}

bool possible(const PipelineKey& key, const VulkanDevice& device) {
  const Features& f = device.features();
  const VkPhysicalDeviceLimits& limits = device.limits();
  const VkSampleCountFlags counts = (key.colorFormat ? limits.framebufferColorSampleCounts : ~0u) &
                                    (key.depthFormat ? limits.framebufferDepthSampleCounts : ~0u);
  if (!key.colorFormat && !key.depthFormat) return false;
  if ((key.samples & (key.samples - 1)) != 0 || !(key.samples & counts)) return false;
  if (!attaches(device, key.colorFormat, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) ||
      !attaches(device, key.depthFormat, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
    return false;
  const BakedState& s = key.state;
  if ((s.logicOpEnable && !f.logicOp) || (s.alphaToOne && !f.alphaToOne)) return false;
  if (s.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN && !f.triangleFans) return false;
  if (s.lineMode == VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT || (s.lineMode && !f.bresenhamLines) ||
      (s.lineMode == VK_LINE_RASTERIZATION_MODE_RECTANGULAR_SMOOTH_EXT && !f.smoothLines))
    return false;
  for (uint32_t i = 0; i < key.layout.count; ++i) {
    const VertexLayout::Array& array = key.layout.arrays[i];
    if (array.location >= limits.maxVertexInputAttributes ||
        array.stride > limits.maxVertexInputBindingStride ||
        !device.vertexFormat(static_cast<VkFormat>(array.format)))
      return false;
  }
  return key.layout.count <= limits.maxVertexInputBindings;
}

// As this device bakes it. False: another device's, that took more as dynamic state, or had what this one has
// not.
bool fitDevice(const VulkanDevice& device, const DynamicStates& dynamic, PipelineKey& key) {
  const Features& f = device.features();
  if ((dynamic.state1 && !f.dynamicState1) || (dynamic.state2 && !f.dynamicState2) ||
      (dynamic.state3 && !f.dynamicState3) || (dynamic.vertexInput && !f.dynamicVertexInput))
    return false;
  if (f.dynamicVertexInput) key.layout = {};
  key.state = baked(key.state, f);
  return possible(key, device);
}

}  // namespace

bool makeAhead(VulkanDevice& device, const cache::PipelineRow& row) {
  PipelineKey key;
  DynamicStates dynamic;
  if (!parse(row.state, key, dynamic) || !fitDevice(device, dynamic, key)) return false;
  const Shader* const vertex = device.shaders().get(gen::Stage::Vertex, row.vertex);
  const Shader* const fragment = device.shaders().get(gen::Stage::Fragment, row.fragment);
  if (!vertex || !fragment ||
      !fitTogether(*vertex, *fragment, key.layout, device.features().dynamicVertexInput))
    return false;
  key.vertexShader = vertex->id;
  key.fragmentShader = fragment->id;
  return device.pipelines().makeAhead(key, *vertex, *fragment);
}

size_t makePipelines(render::Device& device, std::span<const cache::PipelineRow> rows) {
  auto& vulkan = static_cast<VulkanDevice&>(device);
  vulkan.driverCache().load();
  size_t made = 0;
  for (const cache::PipelineRow& row : rows) made += makeAhead(vulkan, row);
  vulkan.driverCache().save();
  return made;
}

PipelineWarmUp::~PipelineWarmUp() {
  stop();
}

void PipelineWarmUp::start() {
  if (!cache::ShaderCache::process().wanted()) return;
  const std::lock_guard lock(mutex_);
  if (started_) return;
  started_ = true;
  process_ = getpid();
  device_.driverCache().load();
  thread_ = cache::quietThread([this] { run(); });
}

void PipelineWarmUp::run() {
  try {
    for (const cache::PipelineRow& row : cache::ShaderCache::process().usualPipelines()) {
      if (stopping_) return;
      makeAhead(device_, row);
    }
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "anteroom: pipelines are not made ahead: %s\n", problem.what());
  }
}

void PipelineWarmUp::stop() {
  const std::lock_guard lock(mutex_);
  if (!started_) return;
  stopping_ = true;
  if (getpid() != process_) {
    cache::forget(thread_);
    return;
  }
  if (!thread_.joinable()) return;
  thread_.join();
  device_.driverCache().save();
}

}  // namespace anteroom::vulkan
