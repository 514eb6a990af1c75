// What a draw binds: nothing that the present recording has bound already.
#include <algorithm>
#include <bit>
#include <cstring>

#include "layer/render/renderer.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {

void Recorder::startBound() {
  if (bound_.recording == commands_.recordingId()) return;
  bound_ = {};
  bound_.recording = commands_.recordingId();
}

bool Recorder::bindPipeline(VkCommandBuffer commands, const DrawPlan& plan, const VertexLayout& layout,
                            const BakedState& state) {
  const Features& features = device_.features();
  PipelineKey key;
  key.vertexShader = plan.vertexShader->id;
  key.fragmentShader = plan.fragmentShader->id;
  key.colorFormat = pass_.formats().color;
  key.depthFormat = pass_.formats().depth;
  key.samples = pass_.formats().samples;
  if (!features.dynamicVertexInput) key.layout = layout;
  key.state = baked(state, features);
  if (!pipeline_ || !(key == pipelineKey_)) {
    pipelineKey_ = key;
    const uint64_t before = listener_ ? device_.pipelines().awaited() : 0;
    pipeline_ = device_.pipelines().get(key, *plan.vertexShader, *plan.fragmentShader);
    if (!pipeline_) return false;
    if (listener_ && device_.pipelines().awaited() != before) tellWaited(plan);
  }
  if (pipeline_ == bound_.pipeline) return true;
  device_.fn().vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  bound_.pipeline = pipeline_;
  return true;
}

void Recorder::tellWaited(const DrawPlan& plan) {
  listener_->slow("A draw waits for a pipeline that is compiled for its state: " +
                  describe(plan.fragmentKey) + ". Draw once with every combination of state while loading.");
}

void Recorder::bindVertices(VkCommandBuffer commands, const VertexArrays& arrays) {
  const VertexLayout& layout = arrays.layout;
  if (device_.features().dynamicVertexInput && !(layout == bound_.layout)) {
    VkVertexInputBindingDescription2EXT bindings[kMostArrays];
    VkVertexInputAttributeDescription2EXT attributes[kMostArrays];
    for (uint32_t i = 0; i < layout.count; ++i) {
      const VertexLayout::Array& array = layout.arrays[i];
      bindings[i] = {VK_STRUCTURE_TYPE_VERTEX_INPUT_BINDING_DESCRIPTION_2_EXT,
                     nullptr,
                     i,
                     array.stride,
                     VK_VERTEX_INPUT_RATE_VERTEX,
                     1};
      attributes[i] = {VK_STRUCTURE_TYPE_VERTEX_INPUT_ATTRIBUTE_DESCRIPTION_2_EXT,
                       nullptr,
                       array.location,
                       i,
                       static_cast<VkFormat>(array.format),
                       0};
    }
    device_.fn().vkCmdSetVertexInputEXT(commands, layout.count, bindings, layout.count, attributes);
    bound_.layout = layout;
  }
  // One call for the bindings between the first and the last that changed.
  uint32_t first = layout.count, end = 0;
  for (uint32_t i = 0; i < layout.count; ++i) {
    if (arrays.stores[i]) commands_.hold(*arrays.stores[i]);
    if (i < bound_.arrays && bound_.buffers[i] == arrays.buffers[i] && bound_.offsets[i] == arrays.offsets[i])
      continue;
    first = std::min(first, i);
    end = i + 1;
  }
  if (first >= end) return;
  device_.fn().vkCmdBindVertexBuffers(commands, first, end - first, arrays.buffers.data() + first,
                                      arrays.offsets.data() + first);
  for (uint32_t i = first; i < end; ++i) {
    bound_.buffers[i] = arrays.buffers[i];
    bound_.offsets[i] = arrays.offsets[i];
  }
  bound_.arrays = std::max(bound_.arrays, end);
}

// Brings a block into the stream, when it is new or this recording has not got it yet.
bool Recorder::sendBlock(const Block& block, SentBlock& sent) {
  const bool here = sent.recording == commands_.recordingId() && sent.size == block.size;
  if (here &&
      (sent.version == block.version || !std::memcmp(block.data.data(), sent.piece.mapped, block.size))) {
    sent.version = block.version;
    return true;
  }
  sent.piece = constants_.allocate(block.size, device_.limits().minUniformBufferOffsetAlignment);
  if (!sent.piece) return false;
  std::memcpy(sent.piece.mapped, block.data.data(), block.size);
  sent.size = block.size;
  sent.version = block.version;
  sent.recording = commands_.recordingId();
  return true;
}

void Recorder::bindSet(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set,
                       const StreamPiece& piece, BoundSet& bound) {
  const auto offset = static_cast<uint32_t>(piece.offset);
  if (set == bound.set && offset == bound.offset) return;
  device_.fn().vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(),
                                       index, 1, &set, 1, &offset);
  bound = {set, offset};
}

bool Recorder::bindConstants(VkCommandBuffer commands, const DrawPlan& plan) {
  const auto& push = plan.push;
  const bool pushed = bound_.pushVersion == push.version && bound_.pushed >= push.size;
  if (push.size && !plan.vertexKey.ownValues && !pushed) {
    device_.fn().vkCmdPushConstants(commands, device_.pipelineLayout(), VK_SHADER_STAGE_VERTEX_BIT, 0,
                                    push.size, push.data.data());
    bound_.pushVersion = push.version;
    bound_.pushed = push.size;
  }
  if (plan.vertex.size) {
    if (!sendBlock(plan.vertex, vertexBlock_)) return false;
    bindSet(commands, 0, vertexBlock_.piece.constants.vertex, vertexBlock_.piece, bound_.vertex);
  }
  if (plan.fragment.size) {
    if (!sendBlock(plan.fragment, fragmentBlock_)) return false;
    bindSet(commands, 2, fragmentBlock_.piece.constants.fragment, fragmentBlock_.piece, bound_.fragment);
  }
  if (plan.palette.size) {
    if (!sendBlock(plan.palette, paletteBlock_)) return false;
    bindSet(commands, 3, paletteBlock_.piece.constants.vertex, paletteBlock_.piece, bound_.palette);
  }
  return true;
}

// The textures of `units`, by unit.
bool Recorder::bindTextures(VkCommandBuffer commands, uint32_t units, const Texture* textures) {
  bool changed = (bound_.units & units) != units;
  for (uint32_t left = units; left && !changed; left &= left - 1) {
    const int unit = std::countr_zero(left);
    changed = textures[unit] != bound_.textures[unit];
  }
  if (!changed) return true;
  const bool push = device_.features().pushDescriptors;
  const VkDescriptorSet set = push ? VkDescriptorSet{} : commands_.allocateTextureSet();
  if (!push && !set) return false;
  VkDescriptorImageInfo images[gen::kMaxTextureUnits];
  VkWriteDescriptorSet writes[gen::kMaxTextureUnits];
  uint32_t count = 0;
  for (uint32_t left = units; left; left &= left - 1) {
    const int unit = std::countr_zero(left);
    images[count] = {textures[unit].sampler, textures[unit].view, VK_IMAGE_LAYOUT_GENERAL};
    VkWriteDescriptorSet& write = writes[count];
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = static_cast<uint32_t>(unit);
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &images[count++];
    bound_.textures[unit] = textures[unit];
  }
  const auto& fn = device_.fn();
  if (push) {
    fn.vkCmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), 1,
                                 count, writes);
    bound_.units |= units;
    return true;
  }
  for (uint32_t unit = 0; device_.quirks().readsUnusedBindings && unit < gen::kMaxTextureUnits; ++unit) {
    if (units >> unit & 1) continue;
    writes[count] = writes[0];
    writes[count++].dstBinding = unit;
  }
  fn.vkUpdateDescriptorSets(device_.handle(), count, writes, 0, nullptr);
  fn.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), 1, 1, &set,
                             0, nullptr);
  bound_.units = units;
  return true;
}

}  // namespace anteroom::vulkan
