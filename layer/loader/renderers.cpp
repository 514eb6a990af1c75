// The renderers that ANTEROOM_RENDERER can name; the first is the default.
#include <dlfcn.h>

#include "layer/egl/renderer.h"
#include "layer/vulkan/vulkan_device.h"

namespace anteroom {
namespace {

std::unique_ptr<render::Device> createVulkan(const egl::RendererOptions& options, std::string& error) {
  return vulkan::createDevice({options.device, options.debug, options.minimal, options.windows}, error);
}

// The folder of this library, with the slash at its end.
std::string ownFolder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&ownFolder), &info) == 0 || info.dli_fname == nullptr) return {};
  const std::string path = info.dli_fname;
  return path.substr(0, path.rfind('/') + 1);
}

// A plug-in beside this library, for tests. It stays loaded.
std::unique_ptr<render::Device> createReference(const egl::RendererOptions&, std::string& error) {
  const std::string path = ownFolder() + "libanteroom_reference.so";
  void* plugIn = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  void* create = plugIn == nullptr ? nullptr : dlsym(plugIn, "anteroomCreateReferenceDevice");
  if (create == nullptr) {
    error = std::string("the reference renderer is a part of the tests, which were not built: ") + dlerror();
    return nullptr;
  }
  return std::unique_ptr<render::Device>(reinterpret_cast<render::Device* (*)()>(create)());
}

[[maybe_unused]] const bool vulkanAdded = egl::addRenderer("vulkan", createVulkan);
[[maybe_unused]] const bool referenceAdded = egl::addRenderer("reference", createReference);

}  // namespace
}  // namespace anteroom
