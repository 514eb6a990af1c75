#include "layer/vulkan/pass.h"

#include "layer/vulkan/command_stream.h"
#include "layer/vulkan/device.h"

namespace anteroom::vulkan {

Target targetOf(const render::Framebuffer& framebuffer) {
  Target target;
  const render::Attachment& color = framebuffer.color;
  const bool hasDepth = framebuffer.depth.image != nullptr;
  const render::Attachment& depth = hasDepth ? framebuffer.depth : framebuffer.stencil;
  target.colorImage = color.image;
  target.depthImage = depth.image;
  target.color = static_cast<VulkanImage*>(color.image.get());
  target.depth = static_cast<VulkanImage*>(depth.image.get());
  target.colorLevel = color.level;
  target.colorLayer = color.layer;
  target.depthLevel = depth.level;
  target.depthLayer = depth.layer;
  target.hasDepth = hasDepth;
  target.hasStencil = framebuffer.stencil.image != nullptr && framebuffer.stencil.image == depth.image;
  target.width = framebuffer.width;
  target.height = framebuffer.height;
  target.samples = framebuffer.samples;
  target.yDown = framebuffer.yDown;
  return target;
}

LegacyPasses::~LegacyPasses() {
  for (const Entry& entry : entries_) device_.fn().vkDestroyRenderPass(device_.handle(), entry.pass, nullptr);
}

VkRenderPass LegacyPasses::get(const PassFormats& formats, VkAttachmentLoadOp color, VkAttachmentLoadOp depth,
                               VkAttachmentLoadOp stencil) {
  const std::lock_guard lock(mutex_);
  for (const Entry& entry : entries_)
    if (entry.formats == formats && entry.loads[0] == color && entry.loads[1] == depth &&
        entry.loads[2] == stencil)
      return entry.pass;
  VkAttachmentDescription attachments[2]{};
  VkAttachmentReference references[2]{};
  VkSubpassDescription subpass{};
  uint32_t count = 0;
  const auto attach = [&](VkFormat format, VkAttachmentLoadOp load, VkAttachmentLoadOp stencilLoad) {
    VkAttachmentDescription& to = attachments[count];
    to.format = format;
    to.samples = static_cast<VkSampleCountFlagBits>(formats.samples);
    to.loadOp = load;
    to.storeOp = to.stencilStoreOp = VK_ATTACHMENT_STORE_OP_STORE;
    to.stencilLoadOp = stencilLoad;
    to.initialLayout = to.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
    references[count] = {count, VK_IMAGE_LAYOUT_GENERAL};
    return &references[count++];
  };
  if (formats.color) {
    subpass.pColorAttachments = attach(formats.color, color, VK_ATTACHMENT_LOAD_OP_DONT_CARE);
    subpass.colorAttachmentCount = 1;
  }
  if (formats.depth) subpass.pDepthStencilAttachment = attach(formats.depth, depth, stencil);
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = count;
  info.pAttachments = attachments;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  VkRenderPass pass = VK_NULL_HANDLE;
  if (device_.fn().vkCreateRenderPass(device_.handle(), &info, nullptr, &pass) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  device_.countObject();
  entries_.push_back({formats, {color, depth, stencil}, pass});
  return pass;
}

VkFramebuffer LegacyPasses::framebuffer(VkRenderPass pass, ImageStore& owner, VkImageView color,
                                        VkImageView depth, VkExtent2D extent) {
  for (const auto& held : owner.legacyFramebuffers)
    if (held.renderPass == pass && held.color == color && held.depth == depth) return held.framebuffer;
  VkImageView views[2];
  VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
  if (color) views[info.attachmentCount++] = color;
  if (depth) views[info.attachmentCount++] = depth;
  info.renderPass = pass;
  info.pAttachments = views;
  info.width = extent.width;
  info.height = extent.height;
  info.layers = 1;
  VkFramebuffer made = VK_NULL_HANDLE;
  if (device_.fn().vkCreateFramebuffer(device_.handle(), &info, nullptr, &made) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  device_.countObject();
  owner.legacyFramebuffers.push_back({pass, color, depth, made});
  return made;
}

bool PassEncoder::require(const Target& target, bool withDepth) {
  withDepth = withDepth && target.depth;
  if (active_ && target_.same(target) && (depth_ || !withDepth)) return true;
  // A pass that is opened anew on its own target keeps its depth.
  const bool keepDepth = active_ && target_.same(target) && depth_;
  end();
  // Depth that is about to be cleared is surely used.
  const bool clearsUsed = target.depth && target.depth->hasStore() && target.depth->pending.aspects;
  return begin(target, withDepth || keepDepth || clearsUsed);
}

bool PassEncoder::begin(const Target& target, bool withDepth) {
  const VkCommandBuffer commands = commands_.commands();
  ImageStore* color = target.color ? target.color->store() : nullptr;
  ImageStore* depth = withDepth ? target.depth->store() : nullptr;
  if (!commands || (target.color && !color) || (withDepth && !depth)) return false;
  if ((color && commands_.mustWaitToWrite(*color)) || (depth && commands_.mustWaitToWrite(*depth)))
    commands_.barrier();

  Loads loads;
  if (color) {
    PendingClear& pending = target.color->pending;
    if (pending.aspects && pending.level == target.colorLevel && pending.layer == target.colorLayer) {
      loads.color = VK_ATTACHMENT_LOAD_OP_CLEAR;
      loads.colorValue.color = pending.color;
      pending.aspects = 0;
    }
    commands_.write(target.color->held());
    target.color->resolveStale = true;
  }
  if (depth) {
    PendingClear& pending = target.depth->pending;
    const bool here = pending.level == target.depthLevel && pending.layer == target.depthLayer;
    loads.depthValue.depthStencil = pending.depthStencil;
    if (here && pending.aspects & VK_IMAGE_ASPECT_DEPTH_BIT) loads.depth = VK_ATTACHMENT_LOAD_OP_CLEAR;
    if (here && pending.aspects & VK_IMAGE_ASPECT_STENCIL_BIT) loads.stencil = VK_ATTACHMENT_LOAD_OP_CLEAR;
    if (here) pending.aspects = 0;
    commands_.write(target.depth->held());
  }
  const VkImageView colorView =
      color ? color->attachmentView(target.colorLevel, target.colorLayer) : VK_NULL_HANDLE;
  const VkImageView depthView =
      depth ? depth->attachmentView(target.depthLevel, target.depthLayer) : VK_NULL_HANDLE;
  if ((color && !colorView) || (depth && !depthView)) return false;

  target_ = target;
  color_ = color;
  depth_ = depth;
  formats_ = {color ? color->format : VK_FORMAT_UNDEFINED, depth ? depth->format : VK_FORMAT_UNDEFINED,
              static_cast<uint32_t>(target.samples)};
  if (device_.features().dynamicRendering)
    beginDynamic(commands, loads, colorView, depthView);
  else if (!beginLegacy(commands, loads, colorView, depthView))
    return false;
  active_ = true;
  ++passes_;
  return true;
}

void PassEncoder::beginDynamic(VkCommandBuffer commands, const Loads& loads, VkImageView color,
                               VkImageView depth) {
  const auto attachment = [](VkImageView view, VkAttachmentLoadOp load, const VkClearValue& value) {
    VkRenderingAttachmentInfoKHR info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO_KHR};
    info.imageView = view;
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = load;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = value;
    return info;
  };
  const auto colorInfo = attachment(color, loads.color, loads.colorValue);
  const auto depthInfo = attachment(depth, loads.depth, loads.depthValue);
  const auto stencilInfo = attachment(depth, loads.stencil, loads.depthValue);
  VkRenderingInfoKHR info{VK_STRUCTURE_TYPE_RENDERING_INFO_KHR};
  info.renderArea.extent = {static_cast<uint32_t>(target_.width), static_cast<uint32_t>(target_.height)};
  info.layerCount = 1;
  info.colorAttachmentCount = color ? 1 : 0;
  info.pColorAttachments = &colorInfo;
  if (depth && depth_->aspects & VK_IMAGE_ASPECT_DEPTH_BIT) info.pDepthAttachment = &depthInfo;
  if (depth && depth_->aspects & VK_IMAGE_ASPECT_STENCIL_BIT) info.pStencilAttachment = &stencilInfo;
  device_.fn().vkCmdBeginRenderingKHR(commands, &info);
}

bool PassEncoder::beginLegacy(VkCommandBuffer commands, const Loads& loads, VkImageView color,
                              VkImageView depth) {
  LegacyPasses& passes = device_.legacyPasses();
  const VkExtent2D extent{static_cast<uint32_t>(target_.width), static_cast<uint32_t>(target_.height)};
  VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  info.renderPass = passes.get(formats_, loads.color, loads.depth, loads.stencil);
  if (!info.renderPass) return false;
  info.framebuffer = passes.framebuffer(info.renderPass, color_ ? *color_ : *depth_, color, depth, extent);
  if (!info.framebuffer) return false;
  info.renderArea.extent = extent;
  VkClearValue values[2];
  if (color) values[info.clearValueCount++] = loads.colorValue;
  if (depth) values[info.clearValueCount++] = loads.depthValue;
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
  color_ = depth_ = nullptr;
  target_ = {};
}

}  // namespace anteroom::vulkan
