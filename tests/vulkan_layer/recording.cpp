// A Vulkan layer that writes down what a tool would see: VK_LAYER_ANTEROOM_recording. Names, labels, passes
// and draws go to $RECORDING_LAYER_LOG, a line each. Labels of command buffers end here, since Mesa's CPU
// driver crashes in them; ANTEROOM_QUIRKS=-command-labels has them sent at all. It refuses to make what
// $RECORDING_LAYER_REFUSES names: shaders or pipelines.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include "tests/vulkan_layer/layer.h"

namespace {

using layer::next;

void write(const std::string& line) {
  static std::mutex mutex;
  static std::FILE* const log = [] {
    const char* path = std::getenv("RECORDING_LAYER_LOG");
    return path ? std::fopen(path, "w") : nullptr;
  }();
  const std::lock_guard lock(mutex);
  if (log == nullptr) return;
  std::fprintf(log, "%s\n", line.c_str());
  std::fflush(log);
}

bool refuses(const char* what) {
  const char* refused = std::getenv("RECORDING_LAYER_REFUSES");
  return refused != nullptr && std::strcmp(refused, what) == 0;
}

VKAPI_ATTR VkResult VKAPI_CALL setName(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info) {
  write("name " + std::to_string(info->objectType) + " " + info->pObjectName);
  return next<PFN_vkSetDebugUtilsObjectNameEXT>(device, "vkSetDebugUtilsObjectNameEXT")(device, info);
}
VKAPI_ATTR void VKAPI_CALL beginLabel(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
  write(std::string("begin ") + label->pLabelName);
}
VKAPI_ATTR void VKAPI_CALL endLabel(VkCommandBuffer) {
  write("end");
}
VKAPI_ATTR void VKAPI_CALL insertLabel(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
  write(std::string("insert ") + label->pLabelName);
}
VKAPI_ATTR void VKAPI_CALL draw(VkCommandBuffer commands, uint32_t vertices, uint32_t copies, uint32_t first,
                                uint32_t firstInstance) {
  write("draw " + std::to_string(vertices));
  next<PFN_vkCmdDraw>(commands, "vkCmdDraw")(commands, vertices, copies, first, firstInstance);
}
VKAPI_ATTR void VKAPI_CALL drawIndexed(VkCommandBuffer commands, uint32_t indices, uint32_t copies,
                                       uint32_t first, int32_t offset, uint32_t firstInstance) {
  write("draw indexed " + std::to_string(indices));
  next<PFN_vkCmdDrawIndexed>(commands, "vkCmdDrawIndexed")(commands, indices, copies, first, offset,
                                                           firstInstance);
}
VKAPI_ATTR VkResult VKAPI_CALL createShader(VkDevice device, const VkShaderModuleCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkShaderModule* out) {
  if (refuses("shaders")) return VK_ERROR_INITIALIZATION_FAILED;
  return next<PFN_vkCreateShaderModule>(device, "vkCreateShaderModule")(device, info, allocator, out);
}
VKAPI_ATTR VkResult VKAPI_CALL createPipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                               const VkGraphicsPipelineCreateInfo* infos,
                                               const VkAllocationCallbacks* allocator, VkPipeline* out) {
  if (refuses("pipelines")) return VK_ERROR_INITIALIZATION_FAILED;
  const auto create = next<PFN_vkCreateGraphicsPipelines>(device, "vkCreateGraphicsPipelines");
  return create(device, cache, count, infos, allocator, out);
}

}  // namespace

std::span<const layer::Command> layer::instanceCommands() {
  return {};
}

std::span<const layer::Command> layer::deviceCommands() {
  static const Command kCommands[] = {command("vkSetDebugUtilsObjectNameEXT", setName),
                                      command("vkCmdBeginDebugUtilsLabelEXT", beginLabel),
                                      command("vkCmdEndDebugUtilsLabelEXT", endLabel),
                                      command("vkCmdInsertDebugUtilsLabelEXT", insertLabel),
                                      command("vkCmdDraw", draw),
                                      command("vkCmdDrawIndexed", drawIndexed),
                                      command("vkCreateShaderModule", createShader),
                                      command("vkCreateGraphicsPipelines", createPipelines)};
  return kCommands;
}
