#include "layer/vulkan/recording/recorder.h"

#include <algorithm>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/recording/dynamic_state.h"
#include "layer/vulkan/resources/sampler.h"

namespace anteroom::vulkan {
namespace {

// On a CPU device the queue's thread should not wait for the end of a long frame.
constexpr uint32_t kDrawsASubmission = 1500;

}  // namespace

Recorder::Recorder(VulkanDevice& device)
    : device_(device),
      commands_(device),
      pass_(device, commands_),
      vertices_(device, Stream::Purpose::Vertices, 512 << 10),
      indices_(device, Stream::Purpose::Vertices, 128 << 10),
      constants_(device, Stream::Purpose::Constants, 128 << 10),
      staging_(device, Stream::Purpose::Vertices, 1 << 20),
      readBack_(device, Stream::Purpose::ReadBack, 1 << 20) {}

VkCommandBuffer Recorder::commands() {
  drawHeld();
  return commands_.commands();
}

bool Recorder::submit(VkSemaphore signal) {
  endPass();
  drawsSinceSubmit_ = 0;
  if (!commands_.recording()) return !commands_.lost();
  const uint64_t serial = commands_.submit(signal);
  for (Stream* stream : {&vertices_, &indices_, &constants_, &staging_, &readBack_})
    stream->submitted(serial);
  if (serial) ++submits_;
  return serial != 0;
}

void Recorder::submitLong() {
  if (++drawsSinceSubmit_ > kDrawsASubmission && device_.isCpu()) submit();
}

bool Recorder::waitForSubmitted() {
  return device_.timeline().wait(commands_.lastSubmitted(), UINT64_MAX);
}

bool Recorder::waitFor(const ImageStore& store) {
  if (commands_.mayUse(store) && !submit()) return false;
  return device_.timeline().wait(store.lastUse.load(std::memory_order_relaxed), UINT64_MAX);
}

bool Recorder::openPass(const Target& target, bool withDepth) {
  drawHeld();
  return pass_.require(target, withDepth);
}

void Recorder::endPass() {
  drawHeld();
  pass_.end();
}

bool Recorder::bind(const DrawPlan& plan, const Geometry& geometry) {
  if (!openPass(plan.target, plan.usesDepth())) return false;
  const VkCommandBuffer commands = commands_.commands();
  startBound();
  if (geometry.indexStore) commands_.hold(*geometry.indexStore);
  bindVertices(commands, *geometry.arrays);
  DrawState state = plan.state;
  state.fixed.topology = static_cast<uint8_t>(geometry.topology);
  if (!bindPipeline(commands, plan, geometry.arrays->layout, state.fixed)) return false;
  emit(device_, commands, pass_.formats().samples, state, sent_, !bound_.stateSent);
  bound_.stateSent = true;
  return bindConstants(commands, plan) && bindTextures(commands, plan.units, plan.textures.data());
}

void Recorder::draw(const DrawRange& range) {
  const auto& fn = device_.fn();
  const VkCommandBuffer commands = commands_.commands();
  if (!range.indexBuffer) {
    const bool nine = range.count / 3 == 3 && sent_.fixed.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const uint32_t apart = nine && device_.quirks().losesNineVertices ? 3 : 0;
    if (apart) fn.vkCmdDraw(commands, 6, 1, range.first, 0);
    fn.vkCmdDraw(commands, apart ? apart : range.count, 1, range.first + (apart ? 6 : 0), 0);
    return;
  }
  if (range.indexBuffer != bound_.indexBuffer || range.indexOffset != bound_.indexOffset ||
      range.indexType != bound_.indexType) {
    fn.vkCmdBindIndexBuffer(commands, range.indexBuffer, range.indexOffset, range.indexType);
    bound_.indexBuffer = range.indexBuffer;
    bound_.indexOffset = range.indexOffset;
    bound_.indexType = range.indexType;
  }
  fn.vkCmdDrawIndexed(commands, range.count, 1, range.first, range.vertexOffset, 0);
}

void Recorder::holdBack(const DrawRange& range) {
  held_ = range;
}

void Recorder::drawHeld() {
  if (held_.count == 0) return;
  draw(held_);
  held_.count = 0;
}

void Recorder::clear(std::span<const VkClearAttachment> attachments, const VkRect2D& rect) {
  const VkClearRect area{rect, 0, 1};
  device_.fn().vkCmdClearAttachments(commands(), static_cast<uint32_t>(attachments.size()),
                                     attachments.data(), 1, &area);
}

VkCommandBuffer Recorder::beginTransfer(const std::shared_ptr<ImageStore>* read,
                                        const std::shared_ptr<ImageStore>* written) {
  const VkCommandBuffer commands = this->commands();
  if (!commands) return VK_NULL_HANDLE;
  pass_.end();
  if ((read && commands_.mustWaitToRead(**read)) || (written && commands_.mustWaitToWrite(**written)))
    commands_.barrier();
  if (read) commands_.read(*read);
  if (written) commands_.write(*written);
  return commands;
}

bool Recorder::leaveForPresentation(const std::shared_ptr<ImageStore>& store) {
  endPass();
  const VkCommandBuffer commands = commands_.commands();
  if (!commands) return false;
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
  barrier.newLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = store->image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  device_.fn().vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                    VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0, nullptr, 0, nullptr, 1,
                                    &barrier);
  commands_.write(store);
  return true;
}

bool Recorder::beginSampling(const std::shared_ptr<ImageStore>& store) {
  if (!commands()) return false;
  const bool wait = commands_.mustWaitToRead(*store);
  if (wait || pass_.attaches(*store)) pass_.end();
  if (wait) commands_.barrier();
  commands_.read(store);
  return true;
}

Quad::Quad(const Target& target) {
  state.viewport = {0, 0, static_cast<float>(target.width), static_cast<float>(target.height), 0, 1};
  state.scissor.extent = {static_cast<uint32_t>(target.width), static_cast<uint32_t>(target.height)};
  state.fixed.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  state.fixed.depthCompare = state.fixed.stencilCompare = VK_COMPARE_OP_ALWAYS;
  state.fixed.srcRgb = state.fixed.srcAlpha = VK_BLEND_FACTOR_ONE;
  state.fixed.logicOp = VK_LOGIC_OP_COPY;
  state.fixed.frontFace = VK_FRONT_FACE_CLOCKWISE;
  state.fixed.sampleMask = static_cast<uint8_t>((1u << target.samples) - 1);
}

bool Recorder::quad(const Target& target, const Quad& quad) {
  const VkCommandBuffer commands = bindQuad(target, quad);
  if (!commands) return false;
  const auto& fn = device_.fn();
  fn.vkCmdPushConstants(commands, device_.pipelineLayout(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof quad.color,
                        quad.color.data());
  bound_.pushed = 0;
  if (quad.texels) {
    const Texture texture{quad.texels, device_.samplers().get({GL_NEAREST, GL_NEAREST}, 1, 0)};
    if (!texture.sampler || !bindTextures(commands, 1, &texture)) return false;
  }
  if (!quad.constants.empty()) {
    const StreamPiece piece =
        constants_.allocate(quad.constants.size(), device_.limits().minUniformBufferOffsetAlignment);
    if (!piece) return false;
    std::copy(quad.constants.begin(), quad.constants.end(), piece.mapped);
    bindSet(commands, 2, piece.constants.fragment, piece, bound_.fragment);
  }
  fn.vkCmdDraw(commands, 3, 1, 0, 0);
  return true;
}

// Opens the pass and binds everything that a quad needs but its constants and textures. Null: out of memory.
VkCommandBuffer Recorder::bindQuad(const Target& target, const Quad& quad) {
  const auto& fn = device_.fn();
  const Features& features = device_.features();
  const Shader* const vertex = device_.shaders().get(kQuadVertex, quad.counted);
  const Shader* const fragment = device_.shaders().get(*quad.fragment, quad.counted);
  const uint64_t passes = pass_.passes();
  if (!vertex || !fragment || !openPass(target, quad.withDepth)) return VK_NULL_HANDLE;
  if (quad.counted == Counted::No) uncountedPasses_ += pass_.passes() - passes;

  PipelineKey key;
  key.vertexShader = vertex->id;
  key.fragmentShader = fragment->id;
  key.colorFormat = pass_.formats().color;
  key.depthFormat = pass_.formats().depth;
  key.samples = pass_.formats().samples;
  key.state = baked(quad.state.fixed, features);
  const VkPipeline pipeline = device_.pipelines().get(key, *vertex, *fragment, quad.counted);
  const VkCommandBuffer commands = commands_.commands();
  if (!pipeline || !commands) return VK_NULL_HANDLE;
  startBound();
  fn.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  bound_.pipeline = pipeline;
  if (features.dynamicVertexInput) fn.vkCmdSetVertexInputEXT(commands, 0, nullptr, 0, nullptr);
  bound_.layout = {};
  emit(device_, commands, key.samples, quad.state, sent_, !bound_.stateSent);
  bound_.stateSent = true;
  return commands;
}

}  // namespace anteroom::vulkan
