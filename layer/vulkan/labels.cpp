#include "layer/vulkan/labels.h"

#include <string>

namespace anteroom::vulkan {

void Labels::load(VkDevice device, bool available, bool inCommands) {
  if (!available) return;
  device_ = device;
  const auto get = [&](auto& to, const char* name) {
    to = reinterpret_cast<std::decay_t<decltype(to)>>(vkGetDeviceProcAddr(device, name));
  };
  get(name_, "vkSetDebugUtilsObjectNameEXT");
  if (!inCommands) return;
  get(begin_, "vkCmdBeginDebugUtilsLabelEXT");
  get(end_, "vkCmdEndDebugUtilsLabelEXT");
  get(insert_, "vkCmdInsertDebugUtilsLabelEXT");
  if (!begin_ || !end_ || !insert_) begin_ = nullptr;
}

void Labels::name(VkImage image, std::string_view text) const {
  if (!name_) return;
  const std::string terminated(text);
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = VK_OBJECT_TYPE_IMAGE;
  info.objectHandle = reinterpret_cast<uint64_t>(image);
  info.pObjectName = terminated.c_str();
  name_(device_, &info);
}

void Labels::begin(VkCommandBuffer commands, std::string_view text) const {
  const std::string terminated(text);
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = terminated.c_str();
  begin_(commands, &label);
}

void Labels::end(VkCommandBuffer commands) const {
  end_(commands);
}

void Labels::insert(VkCommandBuffer commands, std::string_view text) const {
  const std::string terminated(text);
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = terminated.c_str();
  insert_(commands, &label);
}

}  // namespace anteroom::vulkan
