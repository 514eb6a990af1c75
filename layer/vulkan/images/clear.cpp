// glClear (section 4.2.3): remembered until a pass begins where it can be, else done inside the pass.
#include <algorithm>

#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/resources/sampler.h"

namespace anteroom::vulkan {
namespace {

VkClearColorValue clearColor(const glm::vec4& color, const VulkanImage& image) {
  VkClearColorValue value;
  for (int i = 0; i < 4; ++i) value.float32[i] = color[i] > 0 ? std::min(color[i], 1.0f) : 0.0f;
  if (render::info(image.desc().format).alpha == 0) value.float32[3] = 1;
  return value;
}

constexpr VkImageAspectFlags kColor = VK_IMAGE_ASPECT_COLOR_BIT;
constexpr VkImageAspectFlags kDepth = VK_IMAGE_ASPECT_DEPTH_BIT;
constexpr VkImageAspectFlags kStencil = VK_IMAGE_ASPECT_STENCIL_BIT;

}  // namespace

bool VulkanContext::clear(const render::State& state, gen::Groups changed, GLbitfield mask) {
  flushBatch();
  takeTarget(state, changed);
  const render::Rect all{0, 0, target_.width, target_.height};
  const render::Rect rect = clipped(state.scissorTest ? state.scissor : all, target_);
  if (rect.width <= 0 || rect.height <= 0) return true;
  const bool covers = rect.width == all.width && rect.height == all.height;

  const uint8_t colors = writeMask(state.ops.colorMask, target_);
  const uint32_t stencilBits = state.ops.stencilWriteMask & 0xff;
  VkImageAspectFlags plain = 0, masked = 0;
  if (mask & GL_COLOR_BUFFER_BIT && colors)
    (colors == writeMask({true, true, true, true}, target_) ? plain : masked) |= kColor;
  if (mask & GL_DEPTH_BUFFER_BIT && target_.hasDepth && state.ops.depthMask) plain |= kDepth;
  if (mask & GL_STENCIL_BUFFER_BIT && target_.hasStencil && stencilBits)
    (stencilBits == 0xff ? plain : masked) |= kStencil;

  const bool inPass = pass_.activeOn(target_);
  const PendingClear values{
      0,
      target_.colorLevel,
      target_.colorLayer,
      target_.color ? clearColor(state.clear.color, *target_.color) : VkClearColorValue{},
      {std::clamp(state.clear.depth, 0.0f, 1.0f), static_cast<uint32_t>(state.clear.stencil) & 0xff}};
  VkImageAspectFlags now = plain;
  if (covers) {
    if (plain & kColor && !inPass) {
      if (!remember(*target_.color, target_.colorLevel, target_.colorLayer, kColor, values)) return false;
      now &= ~kColor;
    }
    const VkImageAspectFlags depth = plain & (kDepth | kStencil);
    if (depth && !(inPass && pass_.hasDepth())) {
      if (!remember(*target_.depth, target_.depthLevel, target_.depthLayer, depth, values)) return false;
      now &= ~depth;
    }
    // What is read is the other image: the clear cannot wait until somebody asks for this one.
    if (plain & kColor && !inPass && target_.resolve && !openPass(target_, false)) return false;
  }
  if (now && !clearInPass(now, rect, values)) return false;
  return !masked || clearMasked(state, masked, rect);
}

// The clear of a whole attachment is done when the next pass on it begins, if there is one.
bool VulkanContext::remember(VulkanImage& image, int level, int layer, VkImageAspectFlags aspects,
                             const PendingClear& values) {
  PendingClear& pending = image.pending;
  if (pending.aspects && (pending.level != level || pending.layer != layer) && !materialise(image))
    return false;
  // A stencil buffer may live in an image with depth, and the other way round.
  pending.aspects |= aspects;
  pending.level = level;
  pending.layer = layer;
  if (aspects & kColor) pending.color = values.color;
  if (aspects & kDepth) pending.depthStencil.depth = values.depthStencil.depth;
  if (aspects & kStencil) pending.depthStencil.stencil = values.depthStencil.stencil;
  image.alphaStale = false;
  return true;
}

bool VulkanContext::clearInPass(VkImageAspectFlags aspects, const render::Rect& rect,
                                const PendingClear& values) {
  if (!openPass(target_, aspects & (kDepth | kStencil))) return false;
  VkClearAttachment attachments[2];
  uint32_t count = 0;
  if (aspects & kColor) {
    attachments[count].aspectMask = kColor;
    attachments[count].colorAttachment = 0;
    attachments[count++].clearValue.color = values.color;
  }
  if (aspects & (kDepth | kStencil)) {
    attachments[count].aspectMask = aspects & (kDepth | kStencil);
    attachments[count++].clearValue.depthStencil = values.depthStencil;
  }
  const VkClearRect area{flipped(rect, target_), 0, 1};
  device_.fn().vkCmdClearAttachments(commands_.commands(), count, attachments, 1, &area);
  return true;
}

// Some components of the color, some bits of the stencil: a flat quad under the masks.
bool VulkanContext::clearMasked(const render::State& state, VkImageAspectFlags aspects,
                                const render::Rect& rect) {
  DrawState quad = plainQuad(target_);
  quad.scissor = flipped(rect, target_);
  if (aspects & kColor) quad.fixed.writeMask = writeMask(state.ops.colorMask, target_);
  if (aspects & kStencil) {
    quad.fixed.stencilTest = 1;
    quad.fixed.stencilPass = VK_STENCIL_OP_REPLACE;
    quad.stencilWriteMask = state.ops.stencilWriteMask & 0xff;
    quad.stencilReference = static_cast<uint32_t>(state.clear.stencil) & 0xff;
  }
  const VkClearColorValue color =
      target_.color ? clearColor(state.clear.color, *target_.color) : VkClearColorValue{};
  return drawQuad(target_, quad, color, aspects & kStencil);
}

// All of the target, under no test; it writes nothing yet.
DrawState VulkanContext::plainQuad(const Target& target) {
  DrawState quad;
  quad.viewport = {0, 0, static_cast<float>(target.width), static_cast<float>(target.height), 0, 1};
  quad.scissor.extent = {static_cast<uint32_t>(target.width), static_cast<uint32_t>(target.height)};
  quad.fixed.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  quad.fixed.depthCompare = quad.fixed.stencilCompare = VK_COMPARE_OP_ALWAYS;
  quad.fixed.srcRgb = quad.fixed.srcAlpha = VK_BLEND_FACTOR_ONE;
  quad.fixed.logicOp = VK_LOGIC_OP_COPY;
  quad.fixed.frontFace = VK_FRONT_FACE_CLOCKWISE;
  quad.fixed.sampleMask = static_cast<uint8_t>((1u << target.samples) - 1);
  return quad;
}

// Everything that a quad needs but its constants and textures.
bool VulkanContext::bindQuad(const Target& target, const DrawState& quad, const OwnShader& fragmentShader,
                             bool withDepth, Counted counted) {
  const auto& fn = device_.fn();
  const Features& features = device_.features();
  const Shader* const vertex = device_.shaders().get(kQuadVertex, counted);
  const Shader* const fragment = device_.shaders().get(fragmentShader, counted);
  if (!vertex || !fragment || !openPass(target, withDepth)) return false;

  PipelineKey key;
  key.vertexShader = vertex->id;
  key.fragmentShader = fragment->id;
  key.colorFormat = pass_.formats().color;
  key.depthFormat = pass_.formats().depth;
  key.samples = pass_.formats().samples;
  key.state = baked(quad.fixed, features);
  const VkPipeline pipeline = device_.pipelines().get(key, *vertex, *fragment, counted);
  const VkCommandBuffer commands = commands_.commands();
  if (!pipeline || !commands) return false;
  startBound();
  fn.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  bound_.pipeline = pipeline;
  if (features.dynamicVertexInput) fn.vkCmdSetVertexInputEXT(commands, 0, nullptr, 0, nullptr);
  bound_.layout = {};
  emit(device_, commands, key.samples, quad, sent_, !bound_.stateSent);
  bound_.stateSent = true;
  return true;
}

// A quad over the target: in one color, or with the texels of `copied`.
bool VulkanContext::drawQuad(const Target& target, const DrawState& quad, const VkClearColorValue& color,
                             bool withDepth, VkImageView copied) {
  const OwnShader& fragment = copied ? kCopyFragment : kFlatFragment;
  if (!bindQuad(target, quad, fragment, withDepth, Counted::Yes)) return false;
  const VkCommandBuffer commands = commands_.commands();
  device_.fn().vkCmdPushConstants(commands, device_.pipelineLayout(), VK_SHADER_STAGE_VERTEX_BIT, 0,
                                  sizeof color.float32, color.float32);
  bound_.pushed = 0;
  if (copied) {
    const VkSampler sampler = device_.samplers().get({GL_NEAREST, GL_NEAREST}, 1, 0);
    if (!sampler || !bindTextures(commands, 1, &copied, &sampler)) return false;
  }
  device_.fn().vkCmdDraw(commands, 3, 1, 0, 0);
  return true;
}

// Does a remembered clear of an image that is about to be read.
bool VulkanContext::materialise(VulkanImage& image) {
  const PendingClear& pending = image.pending;
  Target target;
  target.width = image.levelWidth(pending.level);
  target.height = image.levelHeight(pending.level);
  target.samples = image.desc().samples;
  const bool color = pending.aspects & kColor;
  (color ? target.color : target.depth) = &image;
  (color ? target.colorLevel : target.depthLevel) = pending.level;
  (color ? target.colorLayer : target.depthLayer) = pending.layer;
  pass_.end();
  if (!pass_.require(target, !color)) return false;
  pass_.end();
  return true;
}

// Copies can leave any alpha in the store of a format that has none: before it is drawn to, it must read
// as 1.
bool VulkanContext::opaqueAlpha(VulkanImage& image, int level, int layer) {
  Target target;
  target.color = &image;
  target.colorLevel = level;
  target.colorLayer = layer;
  target.width = image.levelWidth(level);
  target.height = image.levelHeight(level);
  target.samples = image.desc().samples;
  DrawState quad = plainQuad(target);
  quad.fixed.writeMask = VK_COLOR_COMPONENT_A_BIT;
  image.alphaStale = false;
  return drawQuad(target, quad, {{0, 0, 0, 1}}, false);
}

}  // namespace anteroom::vulkan
