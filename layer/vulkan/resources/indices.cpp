#include "layer/vulkan/resources/indices.h"

#include <algorithm>
#include <cstring>

namespace anteroom::vulkan {
namespace {

template <class Index>
IndexRange scan(const std::byte* indices, uint32_t count) {
  Index least = static_cast<Index>(~Index{0}), most = 0;
  for (uint32_t i = 0; i < count; ++i) {
    Index value;
    std::memcpy(&value, indices + size_t{i} * sizeof value, sizeof value);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return {least, most};
}

}  // namespace

IndexRange scanIndices(GLenum type, const std::byte* indices, uint32_t count) {
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return scan<uint8_t>(indices, count);
    case GL_UNSIGNED_SHORT:
      return scan<uint16_t>(indices, count);
    default:
      return scan<uint32_t>(indices, count);
  }
}

uint32_t readIndex(GLenum type, const std::byte* indices, uint32_t i) {
  if (type == GL_UNSIGNED_BYTE) return std::to_integer<uint32_t>(indices[i]);
  if (type == GL_UNSIGNED_SHORT) {
    uint16_t value;
    std::memcpy(&value, indices + size_t{i} * 2, 2);
    return value;
  }
  uint32_t value;
  std::memcpy(&value, indices + size_t{i} * 4, 4);
  return value;
}

}  // namespace anteroom::vulkan
