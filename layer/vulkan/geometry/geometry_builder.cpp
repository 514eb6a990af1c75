#include "layer/vulkan/geometry/geometry_builder.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

constexpr uint32_t kMostLocations = gen::kOwnValuesLocation + gen::kMostOwnValues;

bool carriesValues(const VkPhysicalDeviceLimits& limits) {
  return std::min(limits.maxVertexInputAttributes, limits.maxVertexInputBindings) >= kMostLocations;
}

// The indices of a call that lie inside its buffer: those beyond the end are not drawn.
struct Indices {
  const std::byte* data = nullptr;
  uint32_t count = 0;
};
Indices indicesOf(const render::DrawCall& call) {
  const auto count = static_cast<uint32_t>(call.count);
  if (!call.indexBuffer) return {static_cast<const std::byte*>(call.indices), count};
  const VulkanBuffer& buffer = vulkan(*call.indexBuffer);
  const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
  const size_t have = offset < buffer.size() ? (buffer.size() - offset) / indexSize(call.indexType) : 0;
  if (have == 0) return {};
  return {buffer.contents() + offset, static_cast<uint32_t>(std::min<size_t>(count, have))};
}

IndexRange rangeOf(const render::DrawCall& call, const Indices& indices) {
  if (!call.indexBuffer) return scanIndices(call.indexType, indices.data, indices.count);
  const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
  return vulkan(*call.indexBuffer).indexRange(call.indexType, offset, indices.count);
}

}  // namespace

GeometryBuilder::GeometryBuilder(VulkanDevice& device, Stream& vertices, Stream& indices)
    : device_(device),
      vertices_(vertices),
      indices_(indices),
      batch_(carriesValues(device.limits())),
      fetch_(device) {}

Expansion GeometryBuilder::expansionOf(const render::State& state, GLenum mode) const {
  const Features& features = device_.features();
  if (!features.provokingVertexLast && state.fixed.shadeModel == GL_FLAT && mode != GL_POINTS)
    return Expansion::ToListRotated;
  if (mode == GL_LINE_LOOP) return Expansion::LoopToStrip;
  if (mode == GL_TRIANGLE_FAN && !features.triangleFans) return Expansion::ToList;
  return Expansion::None;
}

// Whether its vertices are named one by one, so that it can be in a batch: all draws that carry values are
// small.
bool GeometryBuilder::takesList(const render::State& state, const render::DrawCall& call) const {
  return batch_.carried() == Carried::Values &&
         (!isPlain(call) || expansionOf(state, call.mode) == Expansion::ToListRotated);
}

// The vertices of a small draw, one separate primitive after another: at most kMostCarrying.
uint32_t GeometryBuilder::listOf(const render::State& state, const render::DrawCall& call,
                                 uint32_t* list) const {
  const Expansion wanted = expansionOf(state, call.mode);
  const Expansion expansion = wanted == Expansion::ToListRotated ? wanted : Expansion::ToList;
  if (!call.indexType) {
    const auto count = static_cast<uint32_t>(call.count);
    expandIndices(call.mode, expansion, 0, nullptr, count, static_cast<uint32_t>(call.first), list);
    return expandedCount(call.mode, expansion, count);
  }
  const Indices indices = indicesOf(call);
  expandIndices(call.mode, expansion, call.indexType, indices.data, indices.count, 0, list);
  return expandedCount(call.mode, expansion, indices.count);
}

bool GeometryBuilder::build(const render::State& state, const render::DrawCall& call, uint64_t recording,
                            Geometry& out) {
  out = {};
  out.arrays = &fetch_.arrays();
  if (call.count <= 0 || call.first < 0) return true;
  if (takesList(state, call)) return buildList(state, call, recording, out);
  const Expansion expansion = expansionOf(state, call.mode);
  const bool list = expansion == Expansion::ToList || expansion == Expansion::ToListRotated;
  out.topology = topologyOf(list ? separateMode(call.mode) : call.mode);
  return call.indexType ? buildElements(call, expansion, recording, out)
                        : buildArrays(call, expansion, recording, out);
}

// A small draw as a list of separate primitives, whatever its mode.
bool GeometryBuilder::buildList(const render::State& state, const render::DrawCall& call, uint64_t recording,
                                Geometry& out) {
  std::array<uint32_t, kMostCarrying> list;
  out.range.count = listOf(state, call, list.data());
  if (out.range.count == 0) return true;
  out.topology = topologyOf(separateMode(call.mode));
  if (!fetch_.fetchList(GL_UNSIGNED_INT, reinterpret_cast<const std::byte*>(list.data()), 0, out.range.count,
                        vertices_, recording))
    return false;
  out.range.first = static_cast<uint32_t>(fetch_.vertexOffset());
  return true;
}

bool GeometryBuilder::buildArrays(const render::DrawCall& call, Expansion expansion, uint64_t recording,
                                  Geometry& out) {
  const auto first = static_cast<uint32_t>(call.first), count = static_cast<uint32_t>(call.count);
  const bool inside = fetch_.inside(uint64_t{first} + count);
  if (inside ? !fetch_.fetchRange(first, count, vertices_, recording)
             : !fetch_.fetchList(0, nullptr, first, count, vertices_, recording))
    return false;
  const uint32_t start = static_cast<uint32_t>(fetch_.vertexOffset()) + (inside ? first : 0);
  if (expansion != Expansion::None) return makeIndices(call, expansion, nullptr, count, start, out);
  out.range.count = count;
  out.range.first = start;
  return true;
}

bool GeometryBuilder::buildElements(const render::DrawCall& call, Expansion expansion, uint64_t recording,
                                    Geometry& out) {
  const Indices indices = indicesOf(call);
  if (indices.count == 0) return true;
  const IndexRange range = rangeOf(call, indices);
  const uint64_t span = uint64_t{range.most} - range.least + 1;
  const bool sparse = fetch_.gathers() && span > 4 * uint64_t{indices.count} + 256;
  if (sparse || !fetch_.inside(uint64_t{range.most} + 1)) {
    if (!fetch_.fetchList(call.indexType, indices.data, 0, indices.count, vertices_, recording)) return false;
    const auto start = static_cast<uint32_t>(fetch_.vertexOffset());
    if (expansion != Expansion::None) return makeIndices(call, expansion, nullptr, indices.count, start, out);
    out.range.count = indices.count;
    out.range.first = start;
    return true;
  }
  if (!fetch_.fetchRange(range.least, static_cast<uint32_t>(span), vertices_, recording)) return false;
  const bool small = call.indexType == GL_UNSIGNED_BYTE && !device_.features().indexUint8;
  if (expansion != Expansion::None || small)
    return makeIndices(call, expansion, indices.data, indices.count,
                       static_cast<uint32_t>(fetch_.vertexOffset()), out);
  out.range.count = indices.count;
  out.range.vertexOffset = fetch_.vertexOffset();
  return placeIndices(call, indices.data, out);
}

// Indices that the device takes as they are: in their buffer, or copied.
bool GeometryBuilder::placeIndices(const render::DrawCall& call, const std::byte* indices, Geometry& out) {
  const uint32_t size = indexSize(call.indexType);
  out.range.indexType = size == 1   ? VK_INDEX_TYPE_UINT8_EXT
                        : size == 2 ? VK_INDEX_TYPE_UINT16
                                    : VK_INDEX_TYPE_UINT32;
  const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
  if (call.indexBuffer && offset % size == 0) {
    const std::shared_ptr<BufferStore>& store = vulkan(*call.indexBuffer).store();
    // The buffer is bound at its start: draws from other parts of it change only the first index.
    out.indexStore = &store;
    out.range.indexBuffer = store->memory.buffer;
    out.range.indexOffset = store->memory.offset;
    out.range.first = static_cast<uint32_t>(offset / size);
    return true;
  }
  const StreamPiece piece = indices_.allocate(VkDeviceSize{out.range.count} * size, 4);
  if (!piece) return false;
  std::memcpy(piece.mapped, indices, size_t{out.range.count} * size);
  out.range.indexBuffer = piece.buffer;
  out.range.indexOffset = piece.offset;
  return true;
}

// Indices of 32 bits, made here. `base` is added to each.
bool GeometryBuilder::makeIndices(const render::DrawCall& call, Expansion expansion, const std::byte* indices,
                                  uint32_t count, uint32_t base, Geometry& out) {
  if (count > (1u << 29)) return false;
  const bool widen = expansion == Expansion::None;
  const GLenum mode = widen ? GLenum{GL_POINTS} : call.mode;  // as they are
  out.range.indexType = VK_INDEX_TYPE_UINT32;
  out.range.count = expandedCount(mode, expansion, count);
  if (out.range.count == 0) return true;
  const StreamPiece piece = indices_.allocate(VkDeviceSize{out.range.count} * 4, 4);
  if (!piece) return false;
  expandIndices(mode, expansion, call.indexType, indices, count, base,
                reinterpret_cast<uint32_t*>(piece.mapped));
  out.range.indexBuffer = piece.buffer;
  out.range.indexOffset = piece.offset;
  return true;
}

bool GeometryBuilder::opensBatch(const render::DrawCall& call, const Geometry& geometry, DrawRange& out) {
  if (geometry.range.indexBuffer || !batch_.isSmall(call) || !fetch_.gathersAll()) return false;
  batch_.opened(call.mode);
  const uint32_t each = verticesOfPrimitive(separateMode(call.mode));
  out = geometry.range;
  out.count = out.count / each * each;
  return true;
}

bool GeometryBuilder::append(const render::State& state, const render::DrawCall& call, bool arraysMoved,
                             uint64_t recording, uint32_t& count) {
  bool fits;
  if (takesList(state, call)) {
    std::array<uint32_t, kMostCarrying> list;
    count = listOf(state, call, list.data());
    fits = fetch_.append(state, arraysMoved, list.data(), 0, count, vertices_, recording);
  } else {
    const uint32_t each = verticesOfPrimitive(call.mode);
    count = static_cast<uint32_t>(call.count) / each * each;
    const auto first = static_cast<uint32_t>(call.first);
    fits = fetch_.append(state, arraysMoved, nullptr, first, count, vertices_, recording);
  }
  if (fits) batch_.joined();
  return fits;
}

}  // namespace anteroom::vulkan
