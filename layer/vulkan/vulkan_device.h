// The renderer that ships: the seam of layer/render on Vulkan.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "layer/render/debug_options.h"
#include "layer/render/renderer.h"

namespace anteroom::cache {
struct PipelineRow;
}

namespace anteroom::vulkan {

struct DeviceOptions {
  std::string preferred;            // part of a device name, or an index; empty: the best there is
  render::DebugOptions debug = {};  // messages of the validation layer are counted, too
  bool minimal = false;             // pretend that the device has only Vulkan 1.1 and no optional extension
  std::optional<render::WindowSystem> windows = std::nullopt;  // whose windows will be drawn to
};

// Null: no usable Vulkan device; `error` then says why and what to do.
std::unique_ptr<render::Device> createDevice(const DeviceOptions& options, std::string& error);

// Makes pipelines of the shader cache, as a program would before it draws, and saves what the driver keeps of
// them. `device` is of createDevice(). How many are for it.
size_t makePipelines(render::Device& device, std::span<const cache::PipelineRow> rows);

// Messages of the validation layer so far in this process.
unsigned validationMessages();

}  // namespace anteroom::vulkan
