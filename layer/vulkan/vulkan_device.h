// The renderer that ships: the seam of layer/render on Vulkan.
#pragma once

#include <memory>
#include <string>

#include "layer/render/renderer.h"

namespace anteroom::vulkan {

struct DeviceOptions {
  std::string preferred;    // part of a device name, or an index; empty: the best there is
  bool validation = false;  // the Khronos layer; every message is logged, and counted
  bool minimal = false;     // pretend that the device has only Vulkan 1.1 and no optional extension
};

// Null: no usable Vulkan device; `error` then says why and what to do.
std::unique_ptr<render::Device> createDevice(const DeviceOptions& options, std::string& error);

// Messages of the validation layer so far in this process.
unsigned validationMessages();

}  // namespace anteroom::vulkan
