// Consecutive small draws that differ only in their vertices, and in values that their
// vertices carry, become one draw: on every driver the cost of a small draw is the draw, not its vertices.
#include <algorithm>
#include <array>

#include "layer/vulkan/context.h"

namespace anteroom::vulkan {
namespace {

// Larger draws gain nothing from company.
constexpr uint32_t kMostJoined = 256;
constexpr uint32_t kMostBatched = 1 << 16;
// Nor do these, when each vertex carries all values.
constexpr uint32_t kMostCarrying = 36;
// Draws in a row that none could join: to gather their vertices was in vain.
constexpr uint32_t kMostAlone = 64;

// Groups that hold values only: no key depends on them.
constexpr gen::Groups kValueGroups = gen::kGroupModelview | gen::kGroupProjection | gen::kGroupCurrentColor;

// The mode that draws the primitives of `mode` separately.
GLenum separate(GLenum mode) {
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

// Vertices of a primitive of a mode that draws separate ones.
uint32_t verticesOf(GLenum separate) {
  return separate == GL_POINTS ? 1 : separate == GL_LINES ? 2 : 3;
}

bool isPlain(const render::DrawCall& call) {
  return !call.indexType && call.mode == separate(call.mode);
}

}  // namespace

// What may change between draws of a batch: where arrays lie, and values that nothing reads but what each
// vertex carries.
gen::Groups VulkanContext::harmless() const {
  gen::Groups read = blocks_.vertexGroups | blocks_.fragmentGroups;
  if (carried_ != Carried::Values) read |= blocks_.pushGroups;
  return gen::kGroupArrays | (kValueGroups & ~read);
}

// Whether the draw gains from company, its vertices carrying so much.
bool VulkanContext::isSmall(const render::DrawCall& call, Carried carried) const {
  const auto count = static_cast<uint32_t>(call.count);
  if (carried != Carried::Values) return isPlain(call) && count <= kMostJoined;
  return count <= kMostCarrying && expandedCount(call.mode, Expansion::ToList, count) <= kMostCarrying;
}

// Whether its vertices are named one by one, so that it can be in a batch.
bool VulkanContext::takesList(const render::DrawCall& call) const {
  return carried_ == Carried::Values &&
         (!isPlain(call) || expansionOf(call.mode) == Expansion::ToListRotated);
}

// The vertices of a small draw, one separate primitive after another: at most kMostCarrying.
uint32_t VulkanContext::listOf(const render::DrawCall& call, uint32_t* list) const {
  auto count = static_cast<uint32_t>(call.count);
  const auto* indices = static_cast<const std::byte*>(call.indices);
  if (call.indexType && call.indexBuffer) {
    // Indices beyond the buffer's end are not drawn.
    const VulkanBuffer& buffer = vulkan(*call.indexBuffer);
    const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
    const size_t have = offset < buffer.size() ? (buffer.size() - offset) / indexSize(call.indexType) : 0;
    count = static_cast<uint32_t>(std::min<size_t>(count, have));
    indices = buffer.contents() + offset;
  }
  const Expansion wanted = expansionOf(call.mode);
  const Expansion expansion = wanted == Expansion::ToListRotated ? wanted : Expansion::ToList;
  expandIndices(call.mode, expansion, call.indexType, call.indexType ? indices : nullptr, count,
                call.indexType ? 0 : static_cast<uint32_t>(call.first), list);
  return expandedCount(call.mode, expansion, count);
}

// Gathers the vertices of a draw that may join the batch.
bool VulkanContext::appendTo(const render::State& state, bool moved, const render::DrawCall& call,
                             uint32_t& count) {
  if (takesList(call)) {
    std::array<uint32_t, kMostCarrying> list;
    count = listOf(call, list.data());
    return fetch_.append(state, moved, list.data(), 0, count, vertices_, commands_);
  }
  const uint32_t each = verticesOf(call.mode);
  count = static_cast<uint32_t>(call.count) / each * each;
  return fetch_.append(state, moved, nullptr, static_cast<uint32_t>(call.first), count, vertices_, commands_);
}

// Appends the draw to the open batch. False: it is not of its kind.
bool VulkanContext::join(const render::State& state, gen::Groups changed, const render::DrawCall& call) {
  if (changed & ~harmless() || separate(call.mode) != batch_.mode) return false;
  if (call.count <= 0 || call.first < 0 || !isSmall(call, carried_)) return false;
  if (batch_.count + kMostJoined > kMostBatched) return false;
  const bool moved = changed & gen::kGroupArrays;
  if (moved && shapesOf(state.fixed) != shapes_) return false;
  if (carried_ == Carried::Values && changed & blocks_.pushGroups)
    gen::packPush(vertexKey_, state.fixed, push_.data());
  uint32_t count = 0;
  if (!appendTo(state, moved, call, count)) return false;
  batch_.count += count;
  alone_ = 0;
  return true;
}

// A small draw as a list of separate primitives, whatever its mode.
bool VulkanContext::listGeometry(const render::DrawCall& call, Geometry& out) {
  std::array<uint32_t, kMostCarrying> list;
  out.count = listOf(call, list.data());
  if (out.count == 0) return true;
  wanted_.fixed.topology = static_cast<uint8_t>(topologyOf(separate(call.mode)));
  if (!fetch_.fetchList(GL_UNSIGNED_INT, reinterpret_cast<const std::byte*>(list.data()), 0, out.count,
                        vertices_, commands_))
    return false;
  out.first = static_cast<uint32_t>(fetch_.vertexOffset());
  return true;
}

// Holds the draw back, when others may join it. Everything that it needs is bound.
bool VulkanContext::openBatch(const render::DrawCall& call, const Geometry& geometry) {
  if (geometry.indexed || !isSmall(call, carried_) || !fetch_.gathersAll()) return false;
  const GLenum mode = separate(call.mode);
  batch_ = {mode, geometry.first, geometry.count / verticesOf(mode) * verticesOf(mode)};
  return true;
}

void VulkanContext::flushBatch() {
  if (batch_.count == 0) return;
  record(commands_.commands(), {batch_.count, batch_.first});
  batch_.count = 0;
}

// A program that changes matrices or the current color between small draws has them copied to each vertex, so
// that these draws can be one. That takes a shader of its own: it must have happened often, in a row. What
// the draw must look at again therefore.
gen::Groups VulkanContext::watch(const render::State& state, gen::Groups changed,
                                 const render::DrawCall& call) {
  const bool small =
      isSmall(call, carried_) || (carried_ == Carried::Nothing && isSmall(call, Carried::Values));
  if (!small || (carried_ != Carried::Nothing && ++alone_ > kMostAlone)) return carry(Carried::Nothing);
  const gen::Groups values = changed & kValueGroups;
  const bool colorOnly = values == gen::kGroupCurrentColor && isSmall(call, Carried::Color) &&
                         !state.arrays[gen::kPosition].buffer;
  const bool all = carriesValues_ && isSmall(call, Carried::Values);
  const bool valuesOnly = values && !(changed & ~(kValueGroups | gen::kGroupArrays)) &&
                          !(values & (blocks_.vertexGroups | blocks_.fragmentGroups));
  const Carried better = colorOnly ? Carried::Color : all ? Carried::Values : Carried::Nothing;
  valueChanges_ = valuesOnly && better > carried_ ? valueChanges_ + 1 : 0;
  return valueChanges_ >= valueChangesNeeded_ ? carry(better) : 0;
}

gen::Groups VulkanContext::carry(Carried carried) {
  valueChanges_ = alone_ = 0;
  if (carried == carried_) return 0;
  // To and fro costs more than it gains.
  if (carried == Carried::Nothing && valueChangesNeeded_ < (1u << 20)) valueChangesNeeded_ *= 2;
  carried_ = carried;
  return gen::kGroupCurrentColor | gen::kGroupPrimitive;
}

}  // namespace anteroom::vulkan
