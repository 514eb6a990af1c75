// glReadPixels (section 4.3.1): straight from mapped memory where the color image is there, else by a copy.
#pragma once

#include "layer/render/state.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

class Recorder;

// As render::Context::readPixels. Waits for the device.
bool readPixels(Recorder& recorder, const render::Framebuffer& framebuffer, const render::Rect& rect,
                render::Format format, void* out, size_t rowPitch);

}  // namespace anteroom::vulkan
