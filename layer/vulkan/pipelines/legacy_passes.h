// VkRenderPass objects, for devices without dynamic rendering.
#pragma once

#include <volk.h>

#include <mutex>
#include <vector>

namespace anteroom::vulkan {

class VulkanDevice;

// What a pipeline must know of the pass that it is used in.
struct PassFormats {
  VkFormat color = VK_FORMAT_UNDEFINED;
  VkFormat depth = VK_FORMAT_UNDEFINED;
  uint32_t samples = 1;
  bool operator==(const PassFormats&) const = default;
};

// Thread-safe.
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

}  // namespace anteroom::vulkan
