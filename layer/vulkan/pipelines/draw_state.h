// Fixed-function raster and fragment state in Vulkan's terms, canonical: what cannot matter has one fixed
// value.
#pragma once

#include <volk.h>

#include <cstdint>
#include <type_traits>

#include "layer/vulkan/device/features.h"

namespace anteroom::vulkan {

// State that a pipeline bakes on devices where it is not dynamic. Bytes only: hashed and compared whole.
struct BakedState {
#define BAKED_PART(member, ...) uint8_t member = 0;
#include "layer/vulkan/pipelines/baked_state.inc"
  bool operator==(const BakedState&) const = default;
};
static_assert(std::has_unique_object_representations_v<BakedState>);

struct DrawState {
  BakedState fixed;
  // Dynamic everywhere.
  VkViewport viewport{};
  VkRect2D scissor{};
  float lineWidth = 1, biasFactor = 0, biasUnits = 0, biasClamp = 0;
  uint32_t stencilCompareMask = 0xff, stencilWriteMask = 0xff, stencilReference = 0;
};

// The state without what the device takes as dynamic state.
BakedState baked(const BakedState& state, const Features& features);

}  // namespace anteroom::vulkan
