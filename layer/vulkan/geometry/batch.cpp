#include "layer/vulkan/geometry/batch.h"

#include "layer/vulkan/geometry/primitive_lists.h"

namespace anteroom::vulkan {
namespace {

// Larger draws gain nothing from being joined.
constexpr uint32_t kMostJoined = 256;
constexpr uint32_t kMostBatched = 1 << 16;
// After so many draws in a row that none could join, carrying values no longer pays.
constexpr uint32_t kMostAlone = 64;

// Groups that hold values only: no key depends on them.
constexpr gen::Groups kValueGroups = gen::kGroupModelview | gen::kGroupProjection | gen::kGroupCurrentColor;

}  // namespace

bool isPlain(const render::DrawCall& call) {
  return !call.indexType && call.mode == separateMode(call.mode);
}

// What may change between draws of a batch: where arrays lie, and values that nothing reads but what each
// vertex carries.
gen::Groups Batch::mayChange(const gen::Blocks& read) const {
  gen::Groups groups = read.vertexGroups | read.fragmentGroups;
  if (carried_ != Carried::Values) groups |= read.pushGroups;
  return gen::kGroupArrays | (kValueGroups & ~groups);
}

bool Batch::isSmall(const render::DrawCall& call, Carried carried) const {
  const auto count = static_cast<uint32_t>(call.count);
  if (carried != Carried::Values) return isPlain(call) && count <= kMostJoined;
  return count <= kMostCarrying && expandedCount(call.mode, Expansion::ToList, count) <= kMostCarrying;
}

bool Batch::accepts(const render::DrawCall& call, gen::Groups changed, const gen::Blocks& read,
                    uint32_t held) const {
  if (changed & ~mayChange(read) || separateMode(call.mode) != mode_) return false;
  if (call.count <= 0 || call.first < 0 || !isSmall(call)) return false;
  return held + kMostJoined <= kMostBatched;
}

void Batch::opened(GLenum mode) {
  mode_ = separateMode(mode);
}

gen::Groups Batch::chooseCarried(const render::State& state, const render::DrawCall& call,
                                 gen::Groups changed, const gen::Blocks& read) {
  const bool small = isSmall(call) || (carried_ == Carried::Nothing && isSmall(call, Carried::Values));
  if (!small || (carried_ != Carried::Nothing && ++alone_ > kMostAlone)) return setCarried(Carried::Nothing);
  const gen::Groups values = changed & kValueGroups;
  const bool colorOnly = values == gen::kGroupCurrentColor && isSmall(call, Carried::Color) &&
                         !state.arrays[gen::kPosition].buffer;
  const bool canCarry = carriesValues_ && isSmall(call, Carried::Values);
  const bool valuesOnly = values && !(changed & ~(kValueGroups | gen::kGroupArrays)) &&
                          !(values & (read.vertexGroups | read.fragmentGroups));
  const Carried better = colorOnly ? Carried::Color : canCarry ? Carried::Values : Carried::Nothing;
  valueChanges_ = valuesOnly && better > carried_ ? valueChanges_ + 1 : 0;
  return valueChanges_ >= valueChangesNeeded_ ? setCarried(better) : 0;
}

gen::Groups Batch::setCarried(Carried carried) {
  valueChanges_ = alone_ = 0;
  if (carried == carried_) return 0;
  // Changing back and forth costs more than it saves.
  if (carried == Carried::Nothing && valueChangesNeeded_ < (1u << 20)) valueChangesNeeded_ *= 2;
  carried_ = carried;
  return gen::kGroupCurrentColor | gen::kGroupPrimitive;
}

}  // namespace anteroom::vulkan
