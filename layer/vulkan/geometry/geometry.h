// Vertices in place: what a draw hands to the recorder.
#pragma once

#include <volk.h>

#include <array>
#include <memory>

#include "layer/vulkan/pipelines/vertex_layout.h"

namespace anteroom::vulkan {

struct BufferStore;

// Where the arrays of a VertexLayout lie.
struct VertexArrays {
  VertexLayout layout;
  std::array<VkBuffer, kMostArrays> buffers{};
  std::array<VkDeviceSize, kMostArrays> offsets{};
  // That a recording must hold; null: the array lies in a stream.
  std::array<const std::shared_ptr<BufferStore>*, kMostArrays> stores{};
};

// Vertices, or indices where there is an index buffer.
struct DrawRange {
  uint32_t count = 0;  // 0: there is nothing to draw
  uint32_t first = 0;
  int32_t vertexOffset = 0;  // added to each index
  VkBuffer indexBuffer = VK_NULL_HANDLE;
  VkDeviceSize indexOffset = 0;
  VkIndexType indexType = VK_INDEX_TYPE_UINT16;
};

struct Geometry {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const VertexArrays* arrays = nullptr;
  DrawRange range;
  const std::shared_ptr<BufferStore>* indexStore = nullptr;  // that a recording must hold; null: none
};

}  // namespace anteroom::vulkan
