#include "layer/vulkan/images/clear.h"

#include <algorithm>

#include "layer/vulkan/images/attachments.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

constexpr VkImageAspectFlags kColor = VK_IMAGE_ASPECT_COLOR_BIT;
constexpr VkImageAspectFlags kDepth = VK_IMAGE_ASPECT_DEPTH_BIT;
constexpr VkImageAspectFlags kStencil = VK_IMAGE_ASPECT_STENCIL_BIT;

VkClearColorValue clearColor(const glm::vec4& color, const VulkanImage& image) {
  VkClearColorValue value;
  for (int i = 0; i < 4; ++i) value.float32[i] = color[i] > 0 ? std::min(color[i], 1.0f) : 0.0f;
  if (render::info(image.desc().format).alpha == 0) value.float32[3] = 1;
  return value;
}

// What a clear clears: all of an aspect, or components and bits under a mask.
struct Aspects {
  VkImageAspectFlags whole = 0, masked = 0;
};
Aspects aspectsOf(const Target& target, const render::State& state, GLbitfield mask) {
  Aspects aspects;
  const uint8_t colors = writeMask(state.ops.colorMask, target);
  const uint32_t stencilBits = state.ops.stencilWriteMask & 0xff;
  if (mask & GL_COLOR_BUFFER_BIT && colors)
    (colors == writeMask({true, true, true, true}, target) ? aspects.whole : aspects.masked) |= kColor;
  if (mask & GL_DEPTH_BUFFER_BIT && target.hasDepth && state.ops.depthMask) aspects.whole |= kDepth;
  if (mask & GL_STENCIL_BUFFER_BIT && target.hasStencil && stencilBits)
    (stencilBits == 0xff ? aspects.whole : aspects.masked) |= kStencil;
  return aspects;
}

// The clear of a whole attachment is done when the next pass on it begins, if there is one.
bool remember(Recorder& recorder, VulkanImage& image, int level, int layer, VkImageAspectFlags aspects,
              const PendingClear& values) {
  PendingClear& pending = image.pending;
  if ((pending.level != level || pending.layer != layer) && !doPendingClear(recorder, image)) return false;
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

bool clearInPass(Recorder& recorder, const Target& target, VkImageAspectFlags aspects,
                 const render::Rect& rect, const PendingClear& values) {
  if (!loadSamples(recorder, target) || !recorder.openPass(target, aspects & (kDepth | kStencil)))
    return false;
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
  recorder.clear({attachments, count}, flipped(rect, target));
  return true;
}

// Some components of the color, some bits of the stencil: a flat quad under the masks.
bool clearMasked(Recorder& recorder, const Target& target, const render::State& state,
                 VkImageAspectFlags aspects, const render::Rect& rect) {
  Quad quad(target);
  quad.state.scissor = flipped(rect, target);
  if (aspects & kColor) quad.state.fixed.writeMask = writeMask(state.ops.colorMask, target);
  if (aspects & kStencil) {
    quad.state.fixed.stencilTest = 1;
    quad.state.fixed.stencilPass = VK_STENCIL_OP_REPLACE;
    quad.state.stencilWriteMask = state.ops.stencilWriteMask & 0xff;
    quad.state.stencilReference = static_cast<uint32_t>(state.clear.stencil) & 0xff;
    quad.withDepth = true;
  }
  if (target.color) {
    const VkClearColorValue color = clearColor(state.clear.color, *target.color);
    std::copy_n(color.float32, 4, quad.color.begin());
  }
  return loadSamples(recorder, target) && recorder.quad(target, quad);
}

}  // namespace

bool clear(Recorder& recorder, const Target& target, const render::State& state, GLbitfield mask) {
  const render::Rect all{0, 0, target.width, target.height};
  const render::Rect rect = clipped(state.scissorTest ? state.scissor : all, target);
  if (rect.width <= 0 || rect.height <= 0) return true;
  const bool covers = rect.width == all.width && rect.height == all.height;
  const Aspects aspects = aspectsOf(target, state, mask);

  const bool inPass = recorder.passIsOn(target);
  const PendingClear values{
      0,
      target.colorLevel,
      target.colorLayer,
      target.color ? clearColor(state.clear.color, *target.color) : VkClearColorValue{},
      {std::clamp(state.clear.depth, 0.0f, 1.0f), static_cast<uint32_t>(state.clear.stencil) & 0xff}};
  VkImageAspectFlags now = aspects.whole;
  if (covers) {
    if (now & kColor && !inPass) {
      if (!remember(recorder, *target.color, target.colorLevel, target.colorLayer, kColor, values))
        return false;
      now &= ~kColor;
    }
    const VkImageAspectFlags depth = now & (kDepth | kStencil);
    if (depth && !(inPass && recorder.passHasDepth())) {
      if (!remember(recorder, *target.depth, target.depthLevel, target.depthLayer, depth, values))
        return false;
      now &= ~depth;
    }
    // What is read is the other image: the clear cannot wait until somebody asks for this one.
    if (aspects.whole & kColor && !inPass && target.resolve)
      if (!loadSamples(recorder, target) || !recorder.openPass(target, false)) return false;
  }
  if (now && !clearInPass(recorder, target, now, rect, values)) return false;
  return !aspects.masked || clearMasked(recorder, target, state, aspects.masked, rect);
}

}  // namespace anteroom::vulkan
