// Lists of indices that stand for primitives that the device has not.
#pragma once

#include <GLES/gl.h>
#include <volk.h>

#include <cstddef>
#include <cstdint>

namespace anteroom::vulkan {

// How a primitive of GL is drawn: as it is, or as a list of separate primitives whose indices are made here.
enum class Expansion : uint8_t {
  None,
  LoopToStrip,   // a line loop: the first vertex once more
  ToList,        // strips, fans and loops to lists
  ToListRotated  // and each primitive's last vertex to the front: the device takes flat colors from the first
};

VkPrimitiveTopology topologyOf(GLenum mode);
// The mode that draws the primitives of `mode` separately: points, lines or triangles.
GLenum separateMode(GLenum mode);
// Vertices of a primitive of such a mode.
uint32_t verticesOfPrimitive(GLenum separate);

// The number of indices that expandIndices writes for `count` vertices.
uint32_t expandedCount(GLenum mode, Expansion expansion, uint32_t count);
// `indices` null: 0, 1, 2 ... The sum of an index and `offset` is written.
void expandIndices(GLenum mode, Expansion expansion, GLenum type, const std::byte* indices, uint32_t count,
                   uint32_t offset, uint32_t* out);

}  // namespace anteroom::vulkan
