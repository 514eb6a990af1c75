#include "layer/vulkan/recording/dynamic_state.h"

#include <cstring>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

// Commands that send state which other devices bake.
enum class Command {
#define BAKED_COMMAND(command, ...) command,
#include "layer/vulkan/pipelines/baked_state.inc"
};
constexpr uint32_t bit(Command command) {
  return 1u << static_cast<int>(command);
}

// Those whose state differs.
uint32_t differing(const BakedState& wanted, const BakedState& sent) {
  uint32_t commands = 0;
#define BAKED_PART(member, word, values, primitives, place, command) \
  if (wanted.member != sent.member) commands |= bit(Command::command);
#include "layer/vulkan/pipelines/baked_state.inc"
  return commands;
}

VkColorBlendEquationEXT equationOf(const BakedState& s) {
  return {static_cast<VkBlendFactor>(s.srcRgb),   static_cast<VkBlendFactor>(s.dstRgb),
          static_cast<VkBlendOp>(s.opRgb),        static_cast<VkBlendFactor>(s.srcAlpha),
          static_cast<VkBlendFactor>(s.dstAlpha), static_cast<VkBlendOp>(s.opAlpha)};
}

void sendBaked(const VulkanDevice& device, VkCommandBuffer commands, uint32_t samples, const BakedState& w,
               uint32_t wanted) {
  const VolkDeviceTable& fn = device.fn();
  const Features& f = device.features();
#define BAKED_COMMAND(command, feature, state, send) \
  if (wanted & bit(Command::command) && (feature)) { \
    send;                                            \
  }
#include "layer/vulkan/pipelines/baked_state.inc"
}

// What is dynamic on every device.
void sendCore(const VolkDeviceTable& fn, VkCommandBuffer commands, const DrawState& wanted,
              const DrawState& sent, bool all) {
  const auto changed = [&](auto... member) { return all || ((wanted.*member != sent.*member) || ...); };
  if (all || std::memcmp(&wanted.viewport, &sent.viewport, sizeof(VkViewport)) != 0)
    fn.vkCmdSetViewport(commands, 0, 1, &wanted.viewport);
  if (all || std::memcmp(&wanted.scissor, &sent.scissor, sizeof(VkRect2D)) != 0)
    fn.vkCmdSetScissor(commands, 0, 1, &wanted.scissor);
  if (changed(&DrawState::lineWidth)) fn.vkCmdSetLineWidth(commands, wanted.lineWidth);
  if (changed(&DrawState::biasFactor, &DrawState::biasUnits, &DrawState::biasClamp))
    fn.vkCmdSetDepthBias(commands, wanted.biasUnits, wanted.biasClamp, wanted.biasFactor);
  constexpr VkStencilFaceFlags both = VK_STENCIL_FACE_FRONT_AND_BACK;
  if (changed(&DrawState::stencilCompareMask))
    fn.vkCmdSetStencilCompareMask(commands, both, wanted.stencilCompareMask);
  if (changed(&DrawState::stencilWriteMask))
    fn.vkCmdSetStencilWriteMask(commands, both, wanted.stencilWriteMask);
  if (changed(&DrawState::stencilReference))
    fn.vkCmdSetStencilReference(commands, both, wanted.stencilReference);
}

}  // namespace

void emit(const VulkanDevice& device, VkCommandBuffer commands, uint32_t samples, const DrawState& wanted,
          DrawState& sent, bool all) {
  sendCore(device.fn(), commands, wanted, sent, all);
  uint32_t changed = all ? ~0u : differing(wanted.fixed, sent.fixed);
  if (device.quirks().logicOpNeedsBlend && changed & (bit(Command::logicOp) | bit(Command::logicOpEnable)))
    changed |= bit(Command::blendEquation);
  sendBaked(device, commands, samples, wanted.fixed, changed);
  sent = wanted;
}

}  // namespace anteroom::vulkan
