// GL's fixed-function raster and fragment state in Vulkan's terms.
#pragma once

#include <volk.h>

#include "layer/render/state.h"
#include "layer/vulkan/device/features.h"
#include "layer/vulkan/pipelines/draw_state.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

// All of `out` but the topology. False: nothing can be drawn, since the viewport or the scissor is empty, or
// both faces are culled (triangles only).
bool translate(const render::State& state, const Target& target, const Features& features,
               const VkPhysicalDeviceLimits& limits, DrawState& out);

}  // namespace anteroom::vulkan
