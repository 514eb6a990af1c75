#include "layer/vulkan/pipelines/legacy_passes.h"

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {

LegacyPasses::~LegacyPasses() {
  for (const Entry& entry : entries_) device_.fn().vkDestroyRenderPass(device_.handle(), entry.pass, nullptr);
}

VkRenderPass LegacyPasses::get(const PassFormats& formats, const Loads& loads, bool resolves) {
  const std::lock_guard lock(mutex_);
  for (const Entry& entry : entries_)
    if (entry.formats == formats && entry.loads == loads && entry.resolves == resolves) return entry.pass;
  VkAttachmentDescription attachments[3]{};
  VkAttachmentReference references[3]{};
  VkSubpassDescription subpass{};
  uint32_t count = 0;
  const auto attach = [&](VkFormat format, uint32_t samples, VkAttachmentLoadOp load,
                          VkAttachmentLoadOp stencilLoad) {
    VkAttachmentDescription& to = attachments[count];
    to.format = format;
    to.samples = static_cast<VkSampleCountFlagBits>(samples);
    to.loadOp = load;
    to.storeOp = to.stencilStoreOp = VK_ATTACHMENT_STORE_OP_STORE;
    to.stencilLoadOp = stencilLoad;
    to.initialLayout = to.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
    references[count] = {count, VK_IMAGE_LAYOUT_GENERAL};
    return &references[count++];
  };
  constexpr auto any = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  if (formats.color) {
    subpass.pColorAttachments = attach(formats.color, formats.samples, loads.color, any);
    subpass.colorAttachmentCount = 1;
  }
  if (formats.depth)
    subpass.pDepthStencilAttachment = attach(formats.depth, formats.samples, loads.depth, loads.stencil);
  if (resolves) subpass.pResolveAttachments = attach(formats.color, 1, any, any);
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = count;
  info.pAttachments = attachments;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  VkRenderPass pass = VK_NULL_HANDLE;
  if (device_.fn().vkCreateRenderPass(device_.handle(), &info, nullptr, &pass) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  device_.countObject();
  entries_.push_back({formats, loads, resolves, pass});
  return pass;
}

}  // namespace anteroom::vulkan
