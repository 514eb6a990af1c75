// From a call to vertices in place.
#pragma once

#include <cstdint>

#include "layer/render/state.h"
#include "layer/vulkan/geometry/batch.h"
#include "layer/vulkan/geometry/geometry.h"
#include "layer/vulkan/geometry/primitive_lists.h"
#include "layer/vulkan/geometry/vertex_fetch.h"

namespace anteroom::vulkan {

class GeometryBuilder {
 public:
  // Gathered vertices go to `vertices`, indices that are made to `indices`.
  GeometryBuilder(VulkanDevice& device, Stream& vertices, Stream& indices);

  // What vertices carry, and which draws become one.
  Batch& batch() { return batch_; }

  // Takes over the arrays that the vertex shader reads. To be called when they or the key changed. `values`:
  // where `size` bytes of the values that vertices carry lie, at each build() and append().
  void configure(const render::State& state, const gen::VertexKey& key, const std::byte* values,
                 uint32_t size) {
    fetch_.configure(state, key, batch_.carried(), values, size);
  }
  // Vertices, and indices, of a draw. `recording`: the number of the recording that will draw them. False:
  // out of memory.
  bool build(const render::State& state, const render::DrawCall& call, uint64_t recording, Geometry& out);

  // Whether other draws may join this one, which then is `out`.
  bool opensBatch(const render::DrawCall& call, const Geometry& geometry, DrawRange& out);
  // Gathers the vertices of a draw behind those of the open batch, which accepts it; `count`: how many.
  // False: there is no room, or they cannot be reached: build() it.
  bool append(const render::State& state, const render::DrawCall& call, bool arraysMoved, uint64_t recording,
              uint32_t& count);

 private:
  Expansion expansionOf(const render::State& state, GLenum mode) const;
  bool takesList(const render::State& state, const render::DrawCall& call) const;
  uint32_t listOf(const render::State& state, const render::DrawCall& call, uint32_t* list) const;
  bool buildList(const render::State& state, const render::DrawCall& call, uint64_t recording, Geometry& out);
  bool buildArrays(const render::DrawCall& call, Expansion expansion, uint64_t recording, Geometry& out);
  bool buildElements(const render::DrawCall& call, Expansion expansion, uint64_t recording, Geometry& out);
  bool placeIndices(const render::DrawCall& call, const std::byte* indices, Geometry& out);
  bool makeIndices(const render::DrawCall& call, Expansion expansion, const std::byte* indices,
                   uint32_t count, uint32_t base, Geometry& out);

  VulkanDevice& device_;
  Stream& vertices_;
  Stream& indices_;
  Batch batch_;
  VertexFetch fetch_;
};

}  // namespace anteroom::vulkan
