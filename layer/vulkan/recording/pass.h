// Render passes: begun at the first draw or clear that needs one, ended when something else must happen.
#pragma once

#include <volk.h>

#include <mutex>
#include <vector>

#include "layer/render/renderer.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

class CommandStream;
class VulkanDevice;

// A framebuffer as the device takes it. Depth and stencil are one image.
struct Target {
  // Held: a pass may outlive the framebuffer object.
  std::shared_ptr<render::Image> colorImage, depthImage, resolveImage;
  VulkanImage* color = nullptr;
  VulkanImage* depth = nullptr;
  VulkanImage* resolve = nullptr;  // gets the mean of color's samples at the end of a pass
  int colorLevel = 0, colorLayer = 0;
  int depthLevel = 0, depthLayer = 0;
  int resolveLevel = 0, resolveLayer = 0;
  bool hasDepth = false, hasStencil = false;  // what the framebuffer has of the image
  int width = 0, height = 0, samples = 1;
  bool yDown = false;
  bool same(const Target& other) const {
    return color == other.color && depth == other.depth && resolve == other.resolve &&
           colorLevel == other.colorLevel && colorLayer == other.colorLayer &&
           depthLevel == other.depthLevel && depthLayer == other.depthLayer &&
           resolveLevel == other.resolveLevel && resolveLayer == other.resolveLayer &&
           hasDepth == other.hasDepth && hasStencil == other.hasStencil && width == other.width &&
           height == other.height && samples == other.samples && yDown == other.yDown;
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

// The images of a pass, null where there is none.
struct Attached {
  ImageStore* color = nullptr;
  ImageStore* depth = nullptr;
  ImageStore* resolve = nullptr;
  // resolveView null: `resolve` is written after the pass.
  VkImageView colorView = VK_NULL_HANDLE, depthView = VK_NULL_HANDLE, resolveView = VK_NULL_HANDLE;
};

// VkRenderPass objects for devices without dynamic rendering. Thread-safe.
class LegacyPasses {
 public:
  struct Loads {
    VkAttachmentLoadOp color = VK_ATTACHMENT_LOAD_OP_LOAD;
    VkAttachmentLoadOp depth = VK_ATTACHMENT_LOAD_OP_LOAD;
    VkAttachmentLoadOp stencil = VK_ATTACHMENT_LOAD_OP_LOAD;
    bool operator==(const Loads&) const = default;
  };

  explicit LegacyPasses(VulkanDevice& device) : device_(device) {}
  ~LegacyPasses();
  // Null: out of memory. Passes that differ only in what they load and in whether they resolve are
  // compatible.
  VkRenderPass get(const PassFormats& formats, const Loads& loads, bool resolves);
  VkFramebuffer framebuffer(VkRenderPass pass, const Attached& attached, VkExtent2D extent);

 private:
  struct Entry {
    PassFormats formats;
    Loads loads;
    bool resolves;
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
  bool attaches(const ImageStore& store) const {
    return active_ && (&store == attached_.color || &store == attached_.depth || &store == attached_.resolve);
  }
  bool hasDepth() const { return attached_.depth != nullptr; }
  const PassFormats& formats() const { return formats_; }
  uint64_t passes() const { return passes_; }

 private:
  struct Start {
    LegacyPasses::Loads loads;
    VkClearValue colorValue{}, depthValue{};
  };
  bool begin(const Target& target, bool withDepth);
  bool attach(const Target& target, bool withDepth, Attached& out) const;
  void follow();
  void resolveAfterPass();
  void takeClears(const Target& target, const Attached& attached, Start& start) const;
  void beginDynamic(VkCommandBuffer commands, const Start& start);
  bool beginLegacy(VkCommandBuffer commands, const Start& start);

  VulkanDevice& device_;
  CommandStream& commands_;
  bool active_ = false;
  Target target_;
  Attached attached_;
  PassFormats formats_;
  uint64_t passes_ = 0;
};

}  // namespace anteroom::vulkan
