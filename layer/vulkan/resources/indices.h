// Indices in memory, of any alignment.
#pragma once

#include <GLES/gl.h>

#include <cstddef>
#include <cstdint>

namespace anteroom::vulkan {

struct IndexRange {
  uint32_t least, most;
};

// Bytes of an index of `type`.
constexpr uint32_t indexSize(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

// The least and the greatest of `count` > 0 indices.
IndexRange scanIndices(GLenum type, const std::byte* indices, uint32_t count);

// Index `i`.
uint32_t readIndex(GLenum type, const std::byte* indices, uint32_t i);

}  // namespace anteroom::vulkan
