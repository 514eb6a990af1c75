// Render passes: begun at the first draw or clear that needs one, ended when something else must happen.
#pragma once

#include <volk.h>

#include "layer/vulkan/pipelines/legacy_passes.h"
#include "layer/vulkan/resources/image.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

class CommandStream;
class VulkanDevice;

// The images of a pass, null where there is none.
struct Attached {
  ImageStore* color = nullptr;
  ImageStore* depth = nullptr;
  ImageStore* resolve = nullptr;
  // resolveView null: `resolve` is written after the pass.
  VkImageView colorView = VK_NULL_HANDLE, depthView = VK_NULL_HANDLE, resolveView = VK_NULL_HANDLE;
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
  void noteResolved();
  void resolveAfterPass();
  void takeClears(const Target& target, const Attached& attached, Start& start) const;
  void beginDynamic(VkCommandBuffer commands, const Start& start);
  bool beginLegacy(VkCommandBuffer commands, const Start& start);
  VkFramebuffer legacyFramebuffer(VkRenderPass pass, VkExtent2D extent);

  VulkanDevice& device_;
  CommandStream& commands_;
  bool active_ = false;
  Target target_;
  Attached attached_;
  PassFormats formats_;
  uint64_t passes_ = 0;
};

}  // namespace anteroom::vulkan
