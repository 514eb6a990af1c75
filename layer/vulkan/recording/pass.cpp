#include "layer/vulkan/recording/pass.h"

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/recording/command_stream.h"

namespace anteroom::vulkan {

bool PassEncoder::require(const Target& target, bool withDepth) {
  // A pass has an attachment: where there is depth alone, it is there without a test, too.
  withDepth = (withDepth || !target.color) && target.depth;
  if (active_ && target_.same(target) && (hasDepth() || !withDepth)) return true;
  // A pass that is opened anew on its own target keeps its depth.
  const bool keepDepth = active_ && target_.same(target) && hasDepth();
  end();
  // Depth that is about to be cleared will be used.
  const bool clearsUsed = target.depth && target.depth->hasStore() && target.depth->pending.aspects;
  return begin(target, withDepth || keepDepth || clearsUsed);
}

// False: out of memory.
bool PassEncoder::attach(const Target& target, bool withDepth, Attached& out) const {
  const auto take = [](VulkanImage* image, int level, int layer, ImageStore*& store, VkImageView& view) {
    if (!image) return true;
    store = image->store();
    if (store) view = store->attachmentView(level, layer);
    return view != VK_NULL_HANDLE;
  };
  return take(target.color, target.colorLevel, target.colorLayer, out.color, out.colorView) &&
         take(withDepth ? target.depth : nullptr, target.depthLevel, target.depthLayer, out.depth,
              out.depthView) &&
         take(target.resolve, target.resolveLevel, target.resolveLayer, out.resolve, out.resolveView);
}

// From now on the level holds the mean of the samples.
void PassEncoder::noteResolved() {
  commands_.write(target_.resolve->held());
  target_.color->resolvedInto = {attached_.resolve->id, attached_.resolve->version, target_.resolveLevel,
                                 target_.resolveLayer};
}

void PassEncoder::resolveAfterPass() {
  commands_.barrier();
  VkImageResolve region{};
  region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<uint32_t>(target_.colorLevel),
                           static_cast<uint32_t>(target_.colorLayer), 1};
  region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<uint32_t>(target_.resolveLevel),
                           static_cast<uint32_t>(target_.resolveLayer), 1};
  region.extent = {static_cast<uint32_t>(target_.width), static_cast<uint32_t>(target_.height), 1};
  device_.fn().vkCmdResolveImage(commands_.commands(), attached_.color->image, VK_IMAGE_LAYOUT_GENERAL,
                                 attached_.resolve->image, VK_IMAGE_LAYOUT_GENERAL, 1, &region);
  commands_.read(target_.color->held());
  noteResolved();
}

// Clears that were put off become load operations.
void PassEncoder::takeClears(const Target& target, const Attached& attached, Start& start) const {
  if (attached.color) {
    PendingClear& pending = target.color->pending;
    if (pending.aspects && pending.level == target.colorLevel && pending.layer == target.colorLayer) {
      start.loads.color = VK_ATTACHMENT_LOAD_OP_CLEAR;
      start.colorValue.color = pending.color;
      pending.aspects = 0;
    }
  }
  if (!attached.depth) return;
  PendingClear& pending = target.depth->pending;
  start.depthValue.depthStencil = pending.depthStencil;
  if (pending.level != target.depthLevel || pending.layer != target.depthLayer) return;
  if (pending.aspects & VK_IMAGE_ASPECT_DEPTH_BIT) start.loads.depth = VK_ATTACHMENT_LOAD_OP_CLEAR;
  if (pending.aspects & VK_IMAGE_ASPECT_STENCIL_BIT) start.loads.stencil = VK_ATTACHMENT_LOAD_OP_CLEAR;
  pending.aspects = 0;
}

bool PassEncoder::begin(const Target& target, bool withDepth) {
  const VkCommandBuffer commands = commands_.commands();
  Attached attached;
  if (!commands || !attach(target, withDepth, attached)) return false;
  const auto busy = [&](const ImageStore* store) { return store && commands_.mustWaitToWrite(*store); };
  if (busy(attached.color) || busy(attached.depth) || busy(attached.resolve)) commands_.barrier();

  Start start;
  takeClears(target, attached, start);
  if (attached.color) {
    commands_.write(target.color->held());
    target.color->averageStale = true;
  }
  if (attached.depth) commands_.write(target.depth->held());
  target_ = target;
  attached_ = attached;
  if (attached.resolve) noteResolved();
  if (target.resolveLayer != 0 && device_.quirks().resolvesFirstLayer) attached_.resolveView = VK_NULL_HANDLE;
  formats_ = {attached.color ? attached.color->format : VK_FORMAT_UNDEFINED,
              attached.depth ? attached.depth->format : VK_FORMAT_UNDEFINED,
              static_cast<uint32_t>(target.samples)};
  if (device_.features().dynamicRendering)
    beginDynamic(commands, start);
  else if (!beginLegacy(commands, start))
    return false;
  active_ = true;
  ++passes_;
  return true;
}

void PassEncoder::beginDynamic(VkCommandBuffer commands, const Start& start) {
  const auto attachment = [](VkImageView view, VkAttachmentLoadOp load, const VkClearValue& value) {
    VkRenderingAttachmentInfoKHR info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO_KHR};
    info.imageView = view;
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = load;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = value;
    return info;
  };
  auto color = attachment(attached_.colorView, start.loads.color, start.colorValue);
  if (attached_.resolveView) {
    color.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    color.resolveImageView = attached_.resolveView;
    color.resolveImageLayout = VK_IMAGE_LAYOUT_GENERAL;
  }
  const auto depth = attachment(attached_.depthView, start.loads.depth, start.depthValue);
  const auto stencil = attachment(attached_.depthView, start.loads.stencil, start.depthValue);
  const VkImageAspectFlags aspects = attached_.depth ? attached_.depth->aspects : 0;
  VkRenderingInfoKHR info{VK_STRUCTURE_TYPE_RENDERING_INFO_KHR};
  info.renderArea.extent = {static_cast<uint32_t>(target_.width), static_cast<uint32_t>(target_.height)};
  info.layerCount = 1;
  info.colorAttachmentCount = attached_.color ? 1 : 0;
  info.pColorAttachments = &color;
  if (aspects & VK_IMAGE_ASPECT_DEPTH_BIT) info.pDepthAttachment = &depth;
  if (aspects & VK_IMAGE_ASPECT_STENCIL_BIT) info.pStencilAttachment = &stencil;
  device_.fn().vkCmdBeginRenderingKHR(commands, &info);
}

// Kept by the color image, or by that of depth where there is no color.
VkFramebuffer PassEncoder::legacyFramebuffer(VkRenderPass pass, VkExtent2D extent) {
  ImageStore& owner = attached_.color ? *attached_.color : *attached_.depth;
  const uint64_t others[2] = {attached_.depth ? attached_.depth->id : 0,
                              attached_.resolve ? attached_.resolve->id : 0};
  for (const auto& held : owner.legacyFramebuffers)
    if (held.renderPass == pass && held.color == attached_.colorView && held.depth == attached_.depthView &&
        held.resolve == attached_.resolveView && held.depthStore == others[0] &&
        held.resolveStore == others[1])
      return held.framebuffer;
  VkImageView views[3];
  VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
  for (VkImageView view : {attached_.colorView, attached_.depthView, attached_.resolveView})
    if (view) views[info.attachmentCount++] = view;
  info.renderPass = pass;
  info.pAttachments = views;
  info.width = extent.width;
  info.height = extent.height;
  info.layers = 1;
  VkFramebuffer made = VK_NULL_HANDLE;
  if (device_.fn().vkCreateFramebuffer(device_.handle(), &info, nullptr, &made) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  device_.countObject();
  owner.legacyFramebuffers.push_back(
      {pass, attached_.colorView, attached_.depthView, attached_.resolveView, others[0], others[1], made});
  return made;
}

bool PassEncoder::beginLegacy(VkCommandBuffer commands, const Start& start) {
  const VkExtent2D extent{static_cast<uint32_t>(target_.width), static_cast<uint32_t>(target_.height)};
  VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  info.renderPass =
      device_.legacyPasses().get(formats_, start.loads, attached_.resolveView != VK_NULL_HANDLE);
  if (!info.renderPass) return false;
  info.framebuffer = legacyFramebuffer(info.renderPass, extent);
  if (!info.framebuffer) return false;
  info.renderArea.extent = extent;
  VkClearValue values[2];
  if (attached_.color) values[info.clearValueCount++] = start.colorValue;
  if (attached_.depth) values[info.clearValueCount++] = start.depthValue;
  info.pClearValues = values;
  device_.fn().vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  return true;
}

void PassEncoder::end() {
  if (!active_) return;
  active_ = false;
  if (device_.features().dynamicRendering)
    device_.fn().vkCmdEndRenderingKHR(commands_.commands());
  else
    device_.fn().vkCmdEndRenderPass(commands_.commands());
  if (attached_.resolve && !attached_.resolveView) resolveAfterPass();
  attached_ = {};
  target_ = {};
}

}  // namespace anteroom::vulkan
