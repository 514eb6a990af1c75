#include "layer/vulkan/geometry/primitive_lists.h"

#include "layer/vulkan/resources/indices.h"

namespace anteroom::vulkan {
VkPrimitiveTopology topologyOf(GLenum mode) {
  switch (mode) {
    case GL_POINTS:
      return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case GL_LINES:
      return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case GL_LINE_LOOP:
    case GL_LINE_STRIP:
      return VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
    case GL_TRIANGLE_STRIP:
      return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    case GL_TRIANGLE_FAN:
      return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
    default:
      return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  }
}

GLenum separateMode(GLenum mode) {
  switch (mode) {
    case GL_POINTS:
      return GL_POINTS;
    case GL_LINES:
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
      return GL_LINES;
    default:
      return GL_TRIANGLES;
  }
}

uint32_t verticesOfPrimitive(GLenum separate) {
  return separate == GL_POINTS ? 1 : separate == GL_LINES ? 2 : 3;
}

uint32_t expandedCount(GLenum mode, Expansion expansion, uint32_t count) {
  if (expansion == Expansion::LoopToStrip) return count < 2 ? 0 : count + 1;
  switch (mode) {
    case GL_LINES:
      return count / 2 * 2;
    case GL_LINE_STRIP:
      return count < 2 ? 0 : (count - 1) * 2;
    case GL_LINE_LOOP:
      return count < 2 ? 0 : count * 2;
    case GL_TRIANGLES:
      return count / 3 * 3;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
      return count < 3 ? 0 : (count - 2) * 3;
    default:
      return count;
  }
}

void expandIndices(GLenum mode, Expansion expansion, GLenum type, const std::byte* indices, uint32_t count,
                   uint32_t offset, uint32_t* out) {
  const auto at = [&](uint32_t i) { return (indices ? readIndex(type, indices, i) : i) + offset; };
  const uint32_t total = expandedCount(mode, expansion, count);
  if (total == 0) return;
  if (expansion == Expansion::LoopToStrip) {
    for (uint32_t i = 0; i < count; ++i) *out++ = at(i);
    *out = at(0);
    return;
  }
  const bool rotated = expansion == Expansion::ToListRotated;
  const auto line = [&](uint32_t a, uint32_t b) {
    *out++ = at(rotated ? b : a);
    *out++ = at(rotated ? a : b);
  };
  // Section 2.6.1: c is the provoking vertex. A rotation keeps the winding.
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    if (rotated) *out++ = at(c);
    *out++ = at(a);
    *out++ = at(b);
    if (!rotated) *out++ = at(c);
  };
  switch (mode) {
    case GL_LINES:
      for (uint32_t i = 0; i + 1 < count; i += 2) line(i, i + 1);
      break;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
      for (uint32_t i = 0; i + 1 < count; ++i) line(i, i + 1);
      if (mode == GL_LINE_LOOP) line(count - 1, 0);
      break;
    case GL_TRIANGLES:
      for (uint32_t i = 0; i + 2 < count; i += 3) triangle(i, i + 1, i + 2);
      break;
    case GL_TRIANGLE_STRIP:
      for (uint32_t i = 0; i + 2 < count; ++i) i % 2 ? triangle(i + 1, i, i + 2) : triangle(i, i + 1, i + 2);
      break;
    case GL_TRIANGLE_FAN:
      for (uint32_t i = 1; i + 1 < count; ++i) triangle(0, i, i + 1);
      break;
    default:
      for (uint32_t i = 0; i < count; ++i) *out++ = at(i);
  }
}

}  // namespace anteroom::vulkan
