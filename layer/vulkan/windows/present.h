// A picture goes to the screen.
#pragma once

#include <span>

#include "layer/vulkan/windows/window.h"

namespace anteroom::vulkan {

class Recorder;

// As render::Context::present.
render::Presented present(Recorder& recorder, VulkanWindow& window, std::span<const render::Rect> damage);

}  // namespace anteroom::vulkan
