#include "layer/vulkan/debug/labels.h"

#include <string>

namespace anteroom::vulkan {

void Labels::load(VkDevice device, const Wanted& wanted) {
  if (!wanted.available) return;
  device_ = device;
  all_ = wanted.all;
  const auto get = [&](auto& to, const char* name) {
    to = reinterpret_cast<std::decay_t<decltype(to)>>(vkGetDeviceProcAddr(device, name));
  };
  get(name_, "vkSetDebugUtilsObjectNameEXT");
  if (!wanted.inCommands) return;
  get(begin_, "vkCmdBeginDebugUtilsLabelEXT");
  get(end_, "vkCmdEndDebugUtilsLabelEXT");
  get(insert_, "vkCmdInsertDebugUtilsLabelEXT");
  if (!begin_ || !end_ || !insert_) begin_ = nullptr;
}

void Labels::setName(VkObjectType type, uint64_t handle, std::string_view text) const {
  const std::string terminated(text);
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
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
