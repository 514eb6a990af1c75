// Texels from client memory.
#pragma once

#include "layer/render/renderer.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

class Recorder;

// As render::Context::upload.
bool upload(Recorder& recorder, VulkanImage& image, const render::Region& region, const void* data,
            size_t rowPitch, size_t slicePitch);

}  // namespace anteroom::vulkan
