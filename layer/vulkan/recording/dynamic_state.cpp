// What a draw sends as dynamic state: only what changed.
#include <cstring>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/draw_state.h"

namespace anteroom::vulkan {
namespace {

class Emitter {
 public:
  Emitter(const VulkanDevice& device, VkCommandBuffer commands, const DrawState& wanted,
          const DrawState& sent, bool all)
      : device_(device), fn_(device.fn()), commands_(commands), wanted_(wanted), sent_(sent), all_(all) {}

  void core();
  void first();
  void second();
  void third(uint32_t samples);

 private:
  template <class... Member>
  bool changed(Member... member) const {
    return all_ || ((wanted_.*member != sent_.*member) || ...);
  }
  template <class... Member>
  bool differs(Member... member) const {
    return all_ || ((wanted_.fixed.*member != sent_.fixed.*member) || ...);
  }

  const VulkanDevice& device_;
  const VolkDeviceTable& fn_;
  const VkCommandBuffer commands_;
  const DrawState& wanted_;
  const DrawState& sent_;
  const bool all_;
};

void Emitter::core() {
  if (all_ || std::memcmp(&wanted_.viewport, &sent_.viewport, sizeof(VkViewport)) != 0)
    fn_.vkCmdSetViewport(commands_, 0, 1, &wanted_.viewport);
  if (all_ || std::memcmp(&wanted_.scissor, &sent_.scissor, sizeof(VkRect2D)) != 0)
    fn_.vkCmdSetScissor(commands_, 0, 1, &wanted_.scissor);
  if (changed(&DrawState::lineWidth)) fn_.vkCmdSetLineWidth(commands_, wanted_.lineWidth);
  if (changed(&DrawState::biasFactor, &DrawState::biasUnits, &DrawState::biasClamp))
    fn_.vkCmdSetDepthBias(commands_, wanted_.biasUnits, wanted_.biasClamp, wanted_.biasFactor);
  constexpr VkStencilFaceFlags both = VK_STENCIL_FACE_FRONT_AND_BACK;
  if (changed(&DrawState::stencilCompareMask))
    fn_.vkCmdSetStencilCompareMask(commands_, both, wanted_.stencilCompareMask);
  if (changed(&DrawState::stencilWriteMask))
    fn_.vkCmdSetStencilWriteMask(commands_, both, wanted_.stencilWriteMask);
  if (changed(&DrawState::stencilReference))
    fn_.vkCmdSetStencilReference(commands_, both, wanted_.stencilReference);
}

void Emitter::first() {
  const BakedState& w = wanted_.fixed;
  if (differs(&BakedState::topology))
    fn_.vkCmdSetPrimitiveTopologyEXT(commands_, static_cast<VkPrimitiveTopology>(w.topology));
  if (differs(&BakedState::cullMode)) fn_.vkCmdSetCullModeEXT(commands_, w.cullMode);
  if (differs(&BakedState::frontFace))
    fn_.vkCmdSetFrontFaceEXT(commands_, static_cast<VkFrontFace>(w.frontFace));
  if (differs(&BakedState::depthTest)) fn_.vkCmdSetDepthTestEnableEXT(commands_, w.depthTest);
  if (differs(&BakedState::depthWrite)) fn_.vkCmdSetDepthWriteEnableEXT(commands_, w.depthWrite);
  if (differs(&BakedState::depthCompare))
    fn_.vkCmdSetDepthCompareOpEXT(commands_, static_cast<VkCompareOp>(w.depthCompare));
  if (differs(&BakedState::stencilTest)) fn_.vkCmdSetStencilTestEnableEXT(commands_, w.stencilTest);
  if (differs(&BakedState::stencilCompare, &BakedState::stencilFail, &BakedState::stencilPass,
              &BakedState::stencilDepthFail))
    fn_.vkCmdSetStencilOpEXT(commands_, VK_STENCIL_FACE_FRONT_AND_BACK,
                             static_cast<VkStencilOp>(w.stencilFail), static_cast<VkStencilOp>(w.stencilPass),
                             static_cast<VkStencilOp>(w.stencilDepthFail),
                             static_cast<VkCompareOp>(w.stencilCompare));
}

void Emitter::second() {
  const BakedState& w = wanted_.fixed;
  if (differs(&BakedState::depthBias)) fn_.vkCmdSetDepthBiasEnableEXT(commands_, w.depthBias);
  if (differs(&BakedState::logicOp)) fn_.vkCmdSetLogicOpEXT(commands_, static_cast<VkLogicOp>(w.logicOp));
}

void Emitter::third(uint32_t samples) {
  const BakedState& w = wanted_.fixed;
  const bool logic =
      device_.quirks().logicOpNeedsBlend && differs(&BakedState::logicOp, &BakedState::logicOpEnable);
  if (differs(&BakedState::logicOpEnable)) fn_.vkCmdSetLogicOpEnableEXT(commands_, w.logicOpEnable);
  const VkBool32 blend = w.blend;
  if (differs(&BakedState::blend)) fn_.vkCmdSetColorBlendEnableEXT(commands_, 0, 1, &blend);
  if (logic || differs(&BakedState::srcRgb, &BakedState::dstRgb, &BakedState::opRgb, &BakedState::srcAlpha,
                       &BakedState::dstAlpha, &BakedState::opAlpha)) {
    const VkColorBlendEquationEXT equation{
        static_cast<VkBlendFactor>(w.srcRgb),   static_cast<VkBlendFactor>(w.dstRgb),
        static_cast<VkBlendOp>(w.opRgb),        static_cast<VkBlendFactor>(w.srcAlpha),
        static_cast<VkBlendFactor>(w.dstAlpha), static_cast<VkBlendOp>(w.opAlpha)};
    fn_.vkCmdSetColorBlendEquationEXT(commands_, 0, 1, &equation);
  }
  const VkColorComponentFlags mask = w.writeMask;
  if (differs(&BakedState::writeMask)) fn_.vkCmdSetColorWriteMaskEXT(commands_, 0, 1, &mask);
  if (differs(&BakedState::alphaToCoverage))
    fn_.vkCmdSetAlphaToCoverageEnableEXT(commands_, w.alphaToCoverage);
  if (device_.features().alphaToOne && differs(&BakedState::alphaToOne))
    fn_.vkCmdSetAlphaToOneEnableEXT(commands_, w.alphaToOne);
  if (differs(&BakedState::lineMode))
    fn_.vkCmdSetLineRasterizationModeEXT(commands_, static_cast<VkLineRasterizationModeEXT>(w.lineMode));
  const VkSampleMask sampleMask = w.sampleMask;
  if (differs(&BakedState::sampleMask))
    fn_.vkCmdSetSampleMaskEXT(commands_, static_cast<VkSampleCountFlagBits>(samples), &sampleMask);
}

}  // namespace

void emit(const VulkanDevice& device, VkCommandBuffer commands, uint32_t samples, const DrawState& wanted,
          DrawState& sent, bool all) {
  const Features& features = device.features();
  Emitter emitter(device, commands, wanted, sent, all);
  emitter.core();
  if (features.dynamicState1) emitter.first();
  if (features.dynamicState2) emitter.second();
  if (features.dynamicState3) emitter.third(samples);
  sent = wanted;
}

}  // namespace anteroom::vulkan
