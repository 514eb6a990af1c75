// VK_EXT_debug_utils: what the program calls its images, and groups in its stream of commands.
#pragma once

#include <volk.h>

#include <string_view>

namespace anteroom::vulkan {

class Labels {
 public:
  // Without the extension there is neither. Mesa's CPU driver crashes in labels of command buffers
  // (VK_EXT_debug_utils of Mesa 22.3): `inCommands` false leaves them out.
  void load(VkDevice device, bool available, bool inCommands);
  bool inCommands() const { return begin_ != nullptr; }

  void name(VkImage image, std::string_view text) const;
  // Only with inCommands().
  void begin(VkCommandBuffer commands, std::string_view text) const;
  void end(VkCommandBuffer commands) const;
  void insert(VkCommandBuffer commands, std::string_view text) const;

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  PFN_vkSetDebugUtilsObjectNameEXT name_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT end_ = nullptr;
  PFN_vkCmdInsertDebugUtilsLabelEXT insert_ = nullptr;
};

}  // namespace anteroom::vulkan
