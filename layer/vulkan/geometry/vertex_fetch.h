// Vertex arrays: buffer objects are bound in place where the device can read them so; all else is gathered,
// once, into a stream, interleaved and only the range that is used.
#pragma once

#include <array>
#include <cstdint>

#include "layer/render/renderer.h"
#include "layer/vulkan/geometry/geometry.h"
#include "layer/vulkan/resources/buffer.h"
#include "layer/vulkan/resources/stream.h"

namespace anteroom::vulkan {

class VulkanDevice;

class VertexFetch {
 public:
  explicit VertexFetch(VulkanDevice& device) : device_(device) {}

  // Takes over the arrays that the vertex shader reads. To be called when they or the key changed.
  // Color: when it is no array of GL's. Values: `values` is where `size` bytes of them lie at each fetch;
  // then buffers are gathered, too.
  void configure(const render::State& state, const gen::VertexKey& key, Carried carried,
                 const std::byte* values, uint32_t size);

  bool gathers() const { return gathered_ != 0; }
  bool gathersAll() const { return count_ > 0 && gathered_ == (1u << count_) - 1; }
  // Whether vertices below `end` lie inside all buffers.
  bool inside(uint64_t end) const;

  // Makes vertices [first, first + count) available; they are inside(). `recording`: the number of the
  // recording that will draw them. False: out of memory.
  bool fetchRange(uint32_t first, uint32_t count, Stream& stream, uint64_t recording);
  // Gathers vertices behind those of the last fetchRange, with the same arrays at other places: one more draw
  // can then be one with the last. `moved`: the arrays may lie elsewhere. Not null: the vertices that `list`
  // names. False: configure and fetch anew.
  bool append(const render::State& state, bool moved, const uint32_t* list, uint32_t first, uint32_t count,
              Stream& stream, uint64_t recording);
  // Gathers the `count` vertices that indices name (null: those from `first` on), in their order. What lies
  // outside a buffer is zero.
  bool fetchList(GLenum indexType, const std::byte* indices, uint32_t first, uint32_t count, Stream& stream,
                 uint64_t recording);

  // Of the last fetch.
  const VertexArrays& arrays() const { return arrays_; }
  // What is added to a vertex's number in GL (fetchRange) or in the list (fetchList) to find it.
  int32_t vertexOffset() const { return vertexOffset_; }

 private:
  struct Source {
    uint32_t location;
    VkFormat format;
    uint32_t bytes;      // of an element in memory
    uint32_t component;  // bytes of a component
    uint32_t stride;
    VulkanBuffer* buffer;      // null: client memory
    const std::byte* pointer;  // client memory
    size_t offset;             // in the buffer
    uint64_t limit;            // elements that lie inside the buffer
    bool carried;              // no array of GL's
  };
  // Gathered vertices, one after another as long as nothing comes between them.
  struct Arena {
    StreamPiece piece;
    VkDeviceSize used = 0;
    uint32_t stride = 0;
    uint64_t recording = 0;
  };

  Source source(const render::State& state, const gen::VertexKey& key, gen::Attribute attribute) const;
  void place(const render::VertexArray& where, Source& source) const;
  void add(const Source& source, bool gather);
  VkFormat supported(VkFormat three, VkFormat four) const;
  std::byte* reserve(uint32_t stride, uint32_t count, bool fresh, Stream& stream, uint64_t recording,
                     uint32_t& base);
  uint32_t placeGathered(uint32_t mask);
  void gather(uint32_t first, uint32_t count, uint32_t stride, std::byte* to);
  void gatherList(GLenum indexType, const std::byte* indices, uint32_t first, uint32_t count, uint32_t stride,
                  std::byte* to);
  void bindArena(uint32_t mask, uint32_t stride);

  VulkanDevice& device_;
  std::array<Source, kMostArrays> sources_{};
  uint32_t count_ = 0;
  uint32_t gathered_ = 0;                      // bit i: source i is always gathered
  std::array<uint32_t, kMostArrays> place_{};  // in a gathered vertex
  Arena arena_;
  VertexArrays arrays_;
  int32_t vertexOffset_ = 0;
  mutable std::array<int8_t, 256> formatSupport_{};  // by VkFormat: 0 unknown, 1 yes, -1 no
};

}  // namespace anteroom::vulkan
