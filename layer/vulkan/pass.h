// Render passes: begun at the first draw or clear that needs one, ended when something else must happen.
#pragma once

#include <volk.h>

#include <mutex>
#include <vector>

#include "layer/render/renderer.h"
#include "layer/vulkan/image.h"

namespace anteroom::vulkan {

class CommandStream;
class VulkanDevice;

// A framebuffer as the device takes it. Depth and stencil are one image.
struct Target {
  std::shared_ptr<render::Image> colorImage, depthImage;  // held: a pass may outlive the framebuffer object
  VulkanImage* color = nullptr;
  VulkanImage* depth = nullptr;
  int colorLevel = 0, colorLayer = 0;
  int depthLevel = 0, depthLayer = 0;
  bool hasDepth = false, hasStencil = false;  // what the framebuffer has of the image
  int width = 0, height = 0, samples = 1;
  bool yDown = false;
  bool same(const Target& other) const {
    return color == other.color && depth == other.depth && colorLevel == other.colorLevel &&
           colorLayer == other.colorLayer && depthLevel == other.depthLevel &&
           depthLayer == other.depthLayer && hasDepth == other.hasDepth && hasStencil == other.hasStencil &&
           width == other.width && height == other.height && samples == other.samples && yDown == other.yDown;
  }
};
Target targetOf(const render::Framebuffer& framebuffer);

// What a pipeline must know of the pass that it is used in.
struct PassFormats {
  VkFormat color = VK_FORMAT_UNDEFINED;
  VkFormat depth = VK_FORMAT_UNDEFINED;
  uint32_t samples = 1;
  bool operator==(const PassFormats&) const = default;
};

// VkRenderPass objects for devices without dynamic rendering. Thread-safe.
class LegacyPasses {
 public:
  explicit LegacyPasses(VulkanDevice& device) : device_(device) {}
  ~LegacyPasses();
  // Null: out of memory. Passes that differ only in what they load are compatible.
  VkRenderPass get(const PassFormats& formats, VkAttachmentLoadOp color, VkAttachmentLoadOp depth,
                   VkAttachmentLoadOp stencil);
  VkFramebuffer framebuffer(VkRenderPass pass, ImageStore& owner, VkImageView color, VkImageView depth,
                            VkExtent2D extent);

 private:
  struct Entry {
    PassFormats formats;
    VkAttachmentLoadOp loads[3];
    VkRenderPass pass;
  };
  VulkanDevice& device_;
  std::mutex mutex_;
  std::vector<Entry> entries_;
};

class PassEncoder {
 public:
  PassEncoder(VulkanDevice& device, CommandStream& commands) : device_(device), commands_(commands) {}

  // Makes sure that a pass on `target` is open, with its depth and stencil when `withDepth`. Pending clears
  // are done. False: out of memory.
  bool require(const Target& target, bool withDepth);
  void end();
  bool active() const { return active_; }
  bool activeOn(const Target& target) const { return active_ && target_.same(target); }
  bool attaches(const ImageStore& store) const { return active_ && (&store == color_ || &store == depth_); }
  bool hasDepth() const { return depth_ != nullptr; }
  const PassFormats& formats() const { return formats_; }
  uint64_t passes() const { return passes_; }

 private:
  struct Loads {
    VkAttachmentLoadOp color = VK_ATTACHMENT_LOAD_OP_LOAD;
    VkAttachmentLoadOp depth = VK_ATTACHMENT_LOAD_OP_LOAD;
    VkAttachmentLoadOp stencil = VK_ATTACHMENT_LOAD_OP_LOAD;
    VkClearValue colorValue{}, depthValue{};
  };
  bool begin(const Target& target, bool withDepth);
  void beginDynamic(VkCommandBuffer commands, const Loads& loads, VkImageView color, VkImageView depth);
  bool beginLegacy(VkCommandBuffer commands, const Loads& loads, VkImageView color, VkImageView depth);

  VulkanDevice& device_;
  CommandStream& commands_;
  bool active_ = false;
  Target target_;
  ImageStore* color_ = nullptr;  // what is attached
  ImageStore* depth_ = nullptr;
  PassFormats formats_;
  uint64_t passes_ = 0;
};

}  // namespace anteroom::vulkan
