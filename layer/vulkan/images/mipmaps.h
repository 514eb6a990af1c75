// Levels 1 and up by a box filter (section 3.7.8): in mapped memory, or by blits.
#pragma once

#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

class Recorder;

// As render::Context::generateMipmaps.
bool generateMipmaps(Recorder& recorder, VulkanImage& image);

}  // namespace anteroom::vulkan
