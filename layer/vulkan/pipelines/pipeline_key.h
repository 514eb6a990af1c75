// What tells pipelines apart: little more than their shaders where the device takes the rest as dynamic
// state.
#pragma once

#include <array>
#include <cstring>
#include <type_traits>

#include "gen/gen.h"
#include "layer/vulkan/pipelines/draw_state.h"

namespace anteroom::vulkan {

// GL's arrays, and what else each vertex may bring.
inline constexpr uint32_t kMostArrays = gen::kAttributeCount + gen::kMostOwnValues;

// The arrays that a draw reads: one binding an array, at offset 0.
struct VertexLayout {
  struct Array {
    uint32_t location = 0, format = 0, stride = 0;
    bool operator==(const Array&) const = default;
  };
  uint32_t count = 0;
  std::array<Array, kMostArrays> arrays{};
  bool operator==(const VertexLayout&) const = default;
};

struct PipelineKey {
  uint32_t vertexShader = 0, fragmentShader = 0;
  uint32_t colorFormat = 0, depthFormat = 0, samples = 1;
  VertexLayout layout;  // empty where vertex input is dynamic state
  BakedState state;
  uint8_t unused[2]{};
  bool operator==(const PipelineKey& other) const { return !std::memcmp(this, &other, sizeof other); }
};
static_assert(std::has_unique_object_representations_v<PipelineKey>);

}  // namespace anteroom::vulkan
