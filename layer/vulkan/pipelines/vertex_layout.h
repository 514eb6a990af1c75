// The vertex arrays of a pipeline, and what else its vertices bring.
#pragma once

#include <array>
#include <cstdint>

#include "gen/gen.h"

namespace anteroom::vulkan {

// What each vertex brings although GL has no array of it: the current color, or all that would be push
// constants. Draws that differ in nothing else can then be one.
enum class Carried : uint8_t { Nothing, Color, Values };

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

}  // namespace anteroom::vulkan
