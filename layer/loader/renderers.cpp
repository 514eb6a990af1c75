// The renderers that are built in; the first is the default.
#include "layer/egl/renderer.h"
#include "layer/vulkan/vulkan_device.h"

namespace anteroom {
namespace {

std::unique_ptr<render::Device> createVulkan(const egl::RendererOptions& options, std::string& error) {
  return vulkan::createDevice({options.device, options.validation, options.minimal}, error);
}

[[maybe_unused]] const bool added = egl::addRenderer("vulkan", createVulkan);

}  // namespace
}  // namespace anteroom
