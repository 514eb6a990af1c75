// What tells pipelines apart: little more than their shaders where the device takes the rest as dynamic
// state.
#pragma once

#include <cstring>
#include <type_traits>

#include "layer/vulkan/pipelines/draw_state.h"
#include "layer/vulkan/pipelines/vertex_layout.h"

namespace anteroom::vulkan {

struct PipelineKey {
  uint32_t vertexShader = 0, fragmentShader = 0;
  uint32_t colorFormat = 0, depthFormat = 0, samples = 1;
  VertexLayout layout;  // empty where vertex input is dynamic state
  BakedState state;
  uint8_t unused[4 - sizeof(BakedState) % 4]{};  // to the next word
  bool operator==(const PipelineKey& other) const { return !std::memcmp(this, &other, sizeof other); }
};
static_assert(std::has_unique_object_representations_v<PipelineKey>);

}  // namespace anteroom::vulkan
