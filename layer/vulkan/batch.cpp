// Consecutive draws of separate primitives from client memory that differ only in their vertices become one
// draw: on every driver the cost of a small draw is the draw, not its vertices.
#include <bit>

#include "layer/vulkan/context.h"

namespace anteroom::vulkan {
namespace {

// Larger draws gain nothing from company.
constexpr uint32_t kMostJoined = 256;
constexpr uint32_t kMostBatched = 1 << 16;

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

// Appends the draw to the open batch. False: it is not of its kind.
bool VulkanContext::join(const render::State& state, const render::DrawCall& call) {
  const gen::Groups harmless =
      gen::kGroupArrays | (colorPromoted_ ? gen::Groups{gen::kGroupCurrentColor} : 0);
  if (stale_ & ~harmless || call.mode != batch_.mode || call.indexType || call.first < 0) return false;
  const uint32_t each = verticesOf(call.mode);
  const auto count = static_cast<uint32_t>(call.count) / each * each;
  if (count == 0) return true;
  if (count > kMostJoined || batch_.count + count > kMostBatched) return false;
  if (stale_ & gen::kGroupArrays && shapesOf(state.fixed) != shapes_) return false;
  if (!fetch_.append(state, static_cast<uint32_t>(call.first), count, vertices_, commands_)) return false;
  batch_.count += count;
  stale_ = 0;
  return true;
}

// Holds the draw back, when others may join it. Everything that it needs is bound.
bool VulkanContext::openBatch(const render::DrawCall& call, const Geometry& geometry) {
  const uint32_t each = verticesOf(call.mode);
  if (geometry.indexed || each == 0 || geometry.count > kMostJoined || !fetch_.gathersAll()) return false;
  batch_ = {call.mode, geometry.first, geometry.count / each * each};
  return true;
}

void VulkanContext::flushBatch() {
  if (batch_.count == 0) return;
  record(commands_.commands(), {batch_.count, batch_.first});
  batch_.count = 0;
}

// A program that changes the current color between small draws from client memory has it copied to each
// vertex, so that these draws can be one. That takes a shader of its own: it must have happened often, in a
// row.
void VulkanContext::watchColor(const render::State& state, const render::DrawCall& call) {
  const bool fits = verticesOf(call.mode) != 0 && !call.indexType &&
                    static_cast<uint32_t>(call.count) <= kMostJoined &&
                    !state.fixed.attributes[gen::kColor].array && !state.arrays[gen::kPosition].buffer;
  if (!fits) return promoteColor(false);
  if (colorPromoted_) return;
  const bool colorOnly = stale_ & gen::kGroupCurrentColor &&
                         !(stale_ & ~gen::Groups{gen::kGroupCurrentColor | gen::kGroupArrays});
  colorChanges_ = colorOnly ? colorChanges_ + 1 : 0;
  if (colorChanges_ >= colorChangesNeeded_) promoteColor(true);
}

void VulkanContext::promoteColor(bool promoted) {
  colorChanges_ = 0;
  if (promoted == colorPromoted_) return;
  // To and fro costs more than it gains.
  if (!promoted && colorChangesNeeded_ < (1u << 20)) colorChangesNeeded_ *= 2;
  colorPromoted_ = promoted;
  stale_ |= gen::kGroupCurrentColor | gen::kGroupPrimitive;
}

}  // namespace anteroom::vulkan
