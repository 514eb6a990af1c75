// VK_EXT_debug_utils: what the program calls its objects, and groups in its stream of commands.
#pragma once

#include <volk.h>

#include <string_view>

namespace anteroom::vulkan {

class Labels {
 public:
  struct Wanted {
    bool available = false;   // the extension; without it there are neither names nor groups
    bool inCommands = false;  // labels of command buffers, too
    bool all = false;         // names also for what the program gives none, and groups for its draws
  };
  void load(VkDevice device, const Wanted& wanted);
  bool inCommands() const { return begin_ != nullptr; }
  bool nameAll() const { return all_ && name_ != nullptr; }

  template <class Handle>
  void name(VkObjectType type, Handle handle, std::string_view text) const {
    if (name_) setName(type, reinterpret_cast<uint64_t>(handle), text);
  }
  // Only with inCommands().
  void begin(VkCommandBuffer commands, std::string_view text) const;
  void end(VkCommandBuffer commands) const;
  void insert(VkCommandBuffer commands, std::string_view text) const;

 private:
  void setName(VkObjectType type, uint64_t handle, std::string_view text) const;

  VkDevice device_ = VK_NULL_HANDLE;
  bool all_ = false;
  PFN_vkSetDebugUtilsObjectNameEXT name_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT end_ = nullptr;
  PFN_vkCmdInsertDebugUtilsLabelEXT insert_ = nullptr;
};

}  // namespace anteroom::vulkan
