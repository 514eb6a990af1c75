#include "layer/vulkan/geometry/vertex_fetch.h"

#include <algorithm>
#include <cstring>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/geometry/primitive_lists.h"

namespace anteroom::vulkan {
namespace {

// Formats by type and class, for 1 to 4 components.
struct Formats {
  VkFormat of[4];
};
constexpr Formats kFloat{{VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT,
                          VK_FORMAT_R32G32B32A32_SFLOAT}};
constexpr Formats kFixed{
    {VK_FORMAT_R32_SINT, VK_FORMAT_R32G32_SINT, VK_FORMAT_R32G32B32_SINT, VK_FORMAT_R32G32B32A32_SINT}};
constexpr Formats kByte{
    {VK_FORMAT_R8_SINT, VK_FORMAT_R8G8_SINT, VK_FORMAT_R8G8B8_SINT, VK_FORMAT_R8G8B8A8_SINT}};
constexpr Formats kUbyte{
    {VK_FORMAT_R8_UINT, VK_FORMAT_R8G8_UINT, VK_FORMAT_R8G8B8_UINT, VK_FORMAT_R8G8B8A8_UINT}};
constexpr Formats kUnorm{
    {VK_FORMAT_R8_UNORM, VK_FORMAT_R8G8_UNORM, VK_FORMAT_R8G8B8_UNORM, VK_FORMAT_R8G8B8A8_UNORM}};
constexpr Formats kShort{
    {VK_FORMAT_R16_SINT, VK_FORMAT_R16G16_SINT, VK_FORMAT_R16G16B16_SINT, VK_FORMAT_R16G16B16A16_SINT}};

const Formats& formatsOf(GLenum type, gen::InputClass input) {
  switch (type) {
    case GL_BYTE:
      return kByte;
    case GL_UNSIGNED_BYTE:
      return input == gen::InputClass::Float ? kUnorm : kUbyte;
    case GL_SHORT:
      return kShort;
    case GL_FIXED:
      return kFixed;
    default:
      return kFloat;
  }
}

uint32_t componentBytes(GLenum type) {
  return type == GL_BYTE || type == GL_UNSIGNED_BYTE ? 1 : type == GL_SHORT ? 2 : 4;
}

template <uint32_t Bytes>
void copyElements(const std::byte* from, size_t fromStride, std::byte* to, size_t toStride, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) std::memcpy(to + i * toStride, from + i * fromStride, Bytes);
}

// `count` elements of `bytes` bytes, 1 to 16.
void copyElements(uint32_t bytes, const std::byte* from, size_t fromStride, std::byte* to, size_t toStride,
                  uint32_t count) {
  switch (bytes) {
    case 4:
      return copyElements<4>(from, fromStride, to, toStride, count);
    case 8:
      return copyElements<8>(from, fromStride, to, toStride, count);
    case 12:
      return copyElements<12>(from, fromStride, to, toStride, count);
    case 16:
      return copyElements<16>(from, fromStride, to, toStride, count);
    default:
      for (uint32_t i = 0; i < count; ++i) std::memcpy(to + i * toStride, from + i * fromStride, bytes);
  }
}

}  // namespace

VkFormat VertexFetch::supported(VkFormat three, VkFormat four) const {
  int8_t& known = formatSupport_[three];
  if (known == 0) known = device_.vertexFormat(three) ? 1 : -1;
  return known > 0 ? three : four;
}

VertexFetch::Source VertexFetch::source(const render::State& state, const gen::VertexKey& key,
                                        gen::Attribute attribute) const {
  const gen::AttributeState& array = state.fixed.attributes[attribute];
  const Formats& formats = formatsOf(array.type, gen::inputClass(key, attribute));
  const uint32_t size = std::clamp<uint32_t>(array.size, 1, 4);
  Source s{};
  s.location = attribute;
  s.component = componentBytes(array.type);
  s.bytes = size * s.component;
  // Vulkan promises vertex formats of one, two and four small components only.
  s.format = size == 3 && s.component < 4 ? supported(formats.of[2], formats.of[3]) : formats.of[size - 1];
  place(state.arrays[attribute], s);
  return s;
}

void VertexFetch::place(const render::VertexArray& where, Source& s) const {
  s.stride = where.stride ? where.stride : s.bytes;
  s.buffer = where.buffer ? &vulkan(*where.buffer) : nullptr;
  if (!s.buffer) {
    s.pointer = static_cast<const std::byte*>(where.pointer);
    s.limit = s.pointer ? UINT64_MAX : 0;
    return;
  }
  s.offset = reinterpret_cast<uintptr_t>(where.pointer);
  const size_t total = s.buffer->size();
  s.limit = total >= s.bytes && s.offset <= total - s.bytes ? (total - s.bytes - s.offset) / s.stride + 1 : 0;
}

void VertexFetch::add(const Source& source, bool gather) {
  if (gather) gathered_ |= 1u << count_;
  sources_[count_] = source;
  arrays_.layout.arrays[count_++] = {source.location, static_cast<uint32_t>(source.format), source.stride};
}

void VertexFetch::configure(const render::State& state, const gen::VertexKey& key, Carried carried,
                            const std::byte* values, uint32_t size) {
  const uint32_t read = gen::attributesRead(key);
  const auto addCarried = [&](uint32_t location, const void* from) {
    Source s{};
    s.location = location;
    s.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    s.bytes = 16;
    s.component = 4;
    s.pointer = static_cast<const std::byte*>(from);
    s.limit = UINT64_MAX;
    s.carried = true;
    add(s, true);
  };
  arrays_ = {};
  count_ = gathered_ = 0;
  for (int a = 0; a < gen::kAttributeCount; ++a) {
    if (!(read >> a & 1)) continue;
    const gen::AttributeState& array = state.fixed.attributes[a];
    if (a == gen::kColor && carried == Carried::Color && !array.array) {
      addCarried(gen::kColor, &array.current);
      continue;
    }
    const Source s = source(state, key, static_cast<gen::Attribute>(a));
    const bool unaligned = s.offset % s.component != 0 || s.stride % s.component != 0 ||
                           s.stride > device_.limits().maxVertexInputBindingStride;
    add(s, carried == Carried::Values || !s.buffer || unaligned);
  }
  if (carried == Carried::Values)
    for (uint32_t at = 0; at < size; at += 16) addCarried(gen::kOwnValuesLocation + at / 16, values + at);
  arrays_.layout.count = count_;
}

bool VertexFetch::inside(uint64_t end) const {
  for (uint32_t i = 0; i < count_; ++i)
    if (sources_[i].limit < end) return false;
  return true;
}

uint32_t VertexFetch::placeGathered(uint32_t mask) {
  uint32_t stride = 0;
  for (uint32_t i = 0; i < count_; ++i) {
    if (!(mask >> i & 1)) continue;
    place_[i] = stride;
    // Room for a fourth component that the format may read.
    stride += (sources_[i].bytes + 3) / 4 * 4;
    if (sources_[i].component == 2 && sources_[i].bytes == 6) stride = place_[i] + 8;
  }
  return stride;
}

std::byte* VertexFetch::reserve(uint32_t stride, uint32_t count, bool fresh, Stream& stream,
                                uint64_t recording, uint32_t& base) {
  const VkDeviceSize bytes = VkDeviceSize{stride} * count;
  if (!fresh && arena_.stride == stride && arena_.recording == recording &&
      stream.extend(arena_.piece, arena_.used, bytes)) {
    base = static_cast<uint32_t>(arena_.used / stride);
    std::byte* const to = arena_.piece.mapped + arena_.used;
    arena_.used += bytes;
    return to;
  }
  arena_.piece = stream.allocate(bytes, 16);
  if (!arena_.piece) {
    arena_.stride = 0;
    return nullptr;
  }
  arena_.used = bytes;
  arena_.stride = stride;
  arena_.recording = recording;
  base = 0;
  return arena_.piece.mapped;
}

void VertexFetch::bindArena(uint32_t mask, uint32_t stride) {
  for (uint32_t i = 0; i < count_; ++i) {
    if (!(mask >> i & 1)) continue;
    arrays_.buffers[i] = arena_.piece.buffer;
    arrays_.offsets[i] = arena_.piece.offset + place_[i];
    arrays_.stores[i] = nullptr;
    arrays_.layout.arrays[i].stride = stride;
  }
}

void VertexFetch::gather(uint32_t first, uint32_t count, uint32_t stride, std::byte* to) {
  for (uint32_t i = 0; i < count_; ++i) {
    if (!(gathered_ >> i & 1)) continue;
    const Source& s = sources_[i];
    const std::byte* const from = s.buffer ? s.buffer->contents() + s.offset : s.pointer;
    copyElements(s.bytes, from + size_t{first} * s.stride, s.stride, to + place_[i], stride, count);
  }
}

void VertexFetch::gatherList(GLenum indexType, const std::byte* indices, uint32_t first, uint32_t count,
                             uint32_t stride, std::byte* to) {
  for (uint32_t i = 0; i < count_; ++i) {
    const Source& s = sources_[i];
    const std::byte* const from = s.buffer ? s.buffer->contents() + s.offset : s.pointer;
    for (uint32_t n = 0; n < count; ++n) {
      const uint64_t index = indices ? readIndex(indexType, indices, n) : uint64_t{first} + n;
      std::byte* const element = to + size_t{n} * stride + place_[i];
      if (index < s.limit)
        std::memcpy(element, from + index * s.stride, s.bytes);
      else
        std::memset(element, 0, s.bytes);
    }
  }
}

bool VertexFetch::append(const render::State& state, bool moved, const uint32_t* list, uint32_t first,
                         uint32_t count, Stream& stream, uint64_t recording) {
  if (moved)
    for (uint32_t i = 0; i < count_; ++i)
      if (!sources_[i].carried) place(state.arrays[sources_[i].location], sources_[i]);
  if (!list && !inside(uint64_t{first} + count)) return false;
  const VkDeviceSize bytes = VkDeviceSize{arena_.stride} * count;
  if (arena_.stride == 0 || arena_.recording != recording || !stream.extend(arena_.piece, arena_.used, bytes))
    return false;
  std::byte* const to = arena_.piece.mapped + arena_.used;
  arena_.used += bytes;
  if (list)
    gatherList(GL_UNSIGNED_INT, reinterpret_cast<const std::byte*>(list), 0, count, arena_.stride, to);
  else
    gather(first, count, arena_.stride, to);
  return true;
}

bool VertexFetch::fetchRange(uint32_t first, uint32_t count, Stream& stream, uint64_t recording) {
  const uint32_t all = (1u << count_) - 1;
  const bool mixed = gathered_ != 0 && gathered_ != all;
  vertexOffset_ = 0;
  if (gathered_) {
    const uint32_t stride = placeGathered(gathered_);
    uint32_t base;
    std::byte* const to = reserve(stride, count, mixed, stream, recording, base);
    if (!to) return false;
    gather(first, count, stride, to);
    bindArena(gathered_, stride);
    vertexOffset_ = static_cast<int32_t>(base - first);
  }
  for (uint32_t i = 0; i < count_; ++i) {
    if (gathered_ >> i & 1) continue;
    const Source& s = sources_[i];
    const std::shared_ptr<BufferStore>& store = s.buffer->store();
    const Allocation& memory = store->memory;
    arrays_.stores[i] = &store;
    arrays_.buffers[i] = memory.buffer;
    arrays_.offsets[i] = memory.offset + s.offset + (mixed ? VkDeviceSize{first} * s.stride : 0);
    arrays_.layout.arrays[i].stride = s.stride;
  }
  return true;
}

bool VertexFetch::fetchList(GLenum indexType, const std::byte* indices, uint32_t first, uint32_t count,
                            Stream& stream, uint64_t recording) {
  const uint32_t all = (1u << count_) - 1;
  const uint32_t stride = placeGathered(all);
  uint32_t base;
  std::byte* const to = reserve(stride, count, false, stream, recording, base);
  if (!to) return false;
  gatherList(indexType, indices, first, count, stride, to);
  bindArena(all, stride);
  vertexOffset_ = static_cast<int32_t>(base);
  return true;
}

}  // namespace anteroom::vulkan
