// Consecutive small draws of separate primitives that differ only in their vertices, and in values that their
// vertices carry, become one draw: on every driver the cost of a small draw is the draw, not its vertices.
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

// Vertices of a primitive of a mode that draws separate ones; 0: another mode.
uint32_t verticesOf(GLenum mode) {
  switch (mode) {
    case GL_POINTS:
      return 1;
    case GL_LINES:
      return 2;
    case GL_TRIANGLES:
      return 3;
    default:
      return 0;
  }
}

}  // namespace

// What may change between draws of a batch: where arrays lie, and values that nothing reads but what each
// vertex carries.
gen::Groups VulkanContext::harmless() const {
  gen::Groups read = blocks_.vertexGroups | blocks_.fragmentGroups;
  if (carried_ != Carried::Values) read |= blocks_.pushGroups;
  return gen::kGroupArrays | (kValueGroups & ~read);
}

// Appends the draw to the open batch. False: it is not of its kind.
bool VulkanContext::join(const render::State& state, const render::DrawCall& call) {
  if (stale_ & ~harmless() || call.mode != batch_.mode || call.indexType || call.first < 0) return false;
  const uint32_t each = verticesOf(call.mode);
  const auto count = static_cast<uint32_t>(call.count) / each * each;
  if (count == 0) return true;
  if (count > mostJoined() || batch_.count + count > kMostBatched) return false;
  const bool moved = stale_ & gen::kGroupArrays;
  if (moved && shapesOf(state.fixed) != shapes_) return false;
  if (carried_ == Carried::Values && stale_ & blocks_.pushGroups)
    gen::packPush(vertexKey_, state.fixed, push_.data());
  if (!fetch_.append(state, moved, static_cast<uint32_t>(call.first), count, vertices_, commands_))
    return false;
  batch_.count += count;
  alone_ = 0;
  stale_ = 0;
  return true;
}

uint32_t VulkanContext::mostJoined() const {
  return carried_ == Carried::Values ? kMostCarrying : kMostJoined;
}

// Holds the draw back, when others may join it. Everything that it needs is bound.
bool VulkanContext::openBatch(const render::DrawCall& call, const Geometry& geometry) {
  const uint32_t each = verticesOf(call.mode);
  if (geometry.indexed || each == 0 || geometry.count > mostJoined() || !fetch_.gathersAll()) return false;
  batch_ = {call.mode, geometry.first, geometry.count / each * each};
  return true;
}

void VulkanContext::flushBatch() {
  if (batch_.count == 0) return;
  record(commands_.commands(), {batch_.count, batch_.first});
  batch_.count = 0;
}

// A program that changes matrices or the current color between small draws has them copied to each vertex, so
// that these draws can be one. That takes a shader of its own: it must have happened often, in a row.
void VulkanContext::watch(const render::State& state, const render::DrawCall& call) {
  const bool small =
      verticesOf(call.mode) != 0 && !call.indexType && static_cast<uint32_t>(call.count) <= mostJoined();
  if (!small || (carried_ != Carried::Nothing && ++alone_ > kMostAlone)) return carry(Carried::Nothing);
  const gen::Groups changed = stale_ & kValueGroups;
  const bool colorOnly = changed == gen::kGroupCurrentColor && !state.arrays[gen::kPosition].buffer;
  const bool valuesOnly = changed && !(stale_ & ~(kValueGroups | gen::kGroupArrays)) &&
                          !(changed & (blocks_.vertexGroups | blocks_.fragmentGroups));
  const Carried better = colorOnly ? Carried::Color : carriesValues_ ? Carried::Values : Carried::Nothing;
  valueChanges_ = valuesOnly && better > carried_ ? valueChanges_ + 1 : 0;
  if (valueChanges_ >= valueChangesNeeded_) carry(better);
}

void VulkanContext::carry(Carried carried) {
  valueChanges_ = alone_ = 0;
  if (carried == carried_) return;
  // To and fro costs more than it gains.
  if (carried == Carried::Nothing && valueChangesNeeded_ < (1u << 20)) valueChangesNeeded_ *= 2;
  carried_ = carried;
  stale_ |= gen::kGroupCurrentColor | gen::kGroupPrimitive;
}

}  // namespace anteroom::vulkan
