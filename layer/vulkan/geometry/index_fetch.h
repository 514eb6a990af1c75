// Indices: their range, and the lists that stand for primitives that the device has not.
#pragma once

#include <GLES/gl.h>

#include <cstddef>
#include <cstdint>

#include "layer/vulkan/resources/buffer.h"

namespace anteroom::vulkan {

// Bytes of an index of `type`.
constexpr uint32_t indexSize(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

IndexRange scanIndices(GLenum type, const std::byte* indices, uint32_t count);

// Index `i` of an array of any alignment.
uint32_t readIndex(GLenum type, const std::byte* indices, uint32_t i);

// How a primitive of GL is drawn: as it is, or as a list of separate primitives whose indices are made here.
enum class Expansion : uint8_t {
  None,
  LoopToStrip,   // a line loop: the first vertex once more
  ToList,        // strips, fans and loops to lists
  ToListRotated  // and each primitive's last vertex to the front: the device takes flat colors from the first
};

// The number of indices that expandIndices writes for `count` vertices.
uint32_t expandedCount(GLenum mode, Expansion expansion, uint32_t count);
// `indices` null: 0, 1, 2 ... The sum of an index and `offset` is written.
void expandIndices(GLenum mode, Expansion expansion, GLenum type, const std::byte* indices, uint32_t count,
                   uint32_t offset, uint32_t* out);

}  // namespace anteroom::vulkan
