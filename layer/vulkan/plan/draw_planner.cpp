#include "layer/vulkan/plan/draw_planner.h"

#include <bit>
#include <cstring>
#include <utility>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/plan/translate.h"
#include "layer/vulkan/resources/sampler.h"

namespace anteroom::vulkan {
namespace {

using gen::Groups;

// What translate() reads.
constexpr Groups kDrawStateGroups = gen::kGroupRaster | gen::kGroupFragmentOps | gen::kGroupViewport |
                                    gen::kGroupFramebuffer | gen::kGroupPrimitive;

}  // namespace

DrawPlanner::ArrayForms DrawPlanner::formsOf(const gen::State& state) {
  ArrayForms forms;
  for (int a = 0; a < gen::kAttributeCount; ++a)
    forms[a] = {state.attributes[a].array, state.attributes[a].size, state.attributes[a].type};
  return forms;
}

void DrawPlanner::updateTarget(const render::State& state, Groups changed) {
  if (!(changed & gen::kGroupFramebuffer)) return;
  Target target = targetOf(state.framebuffer);
  if (!target.same(plan_.target)) plan_.target = std::move(target);
}

bool DrawPlanner::update(const render::State& state, Groups changed, Carried carried) {
  if (!complete_) changed = gen::kAllGroups;
  NewKeys made{!complete_, !complete_};
  complete_ = false;
  updateTarget(state, changed);
  if (keysChanged(state, changed) && !updateKeys(state, carried, made)) return false;
  if (changed & kDrawStateGroups)
    plan_.nothing = !translate(state, plan_.target, device_.features(), device_.limits(), plan_.state) ||
                    (!plan_.target.color && !plan_.target.depth);
  updateConstants(state, changed, made);
  if (changed & gen::kGroupTextures || made.fragment) updateTextures(state);
  complete_ = true;
  return true;
}

// Whether something changed that the keys depend on. Arrays that lie elsewhere but look the same change no
// key.
bool DrawPlanner::keysChanged(const render::State& state, Groups changed) const {
  if (changed & gen::keyGroups() & ~gen::kGroupArrays) return true;
  return changed & gen::kGroupArrays && !sameArrays(state.fixed);
}

bool DrawPlanner::updateKeys(const render::State& state, Carried carried, NewKeys& made) {
  const gen::Profile& profile = device_.caps().profile;
  forms_ = formsOf(state.fixed);
  const gen::FragmentKey fragment = gen::canonicaliseFragment(state.fixed, profile);
  const auto color = carried == Carried::Color ? gen::CurrentColor::OfVertices : gen::CurrentColor::OfState;
  gen::VertexKey vertex = gen::canonicaliseVertex(state.fixed, fragment, profile, color);
  vertex.ownValues = carried == Carried::Values;
  made.fragment |= !(fragment == plan_.fragmentKey);
  made.vertex |= !(vertex == plan_.vertexKey);
  if (!made.fragment && !made.vertex) return true;
  if (made.fragment) {
    plan_.fragmentKey = fragment;
    plan_.fragmentShader = device_.shaders().get(fragment);
    plan_.units = gen::unitsSampled(fragment);
  }
  if (made.vertex) {
    plan_.vertexKey = vertex;
    plan_.vertexShader = device_.shaders().get(vertex);
  }
  const gen::Blocks& blocks = plan_.blocks = gen::blocks(plan_.vertexKey, plan_.fragmentKey);
  return plan_.vertexShader && plan_.fragmentShader && blocks.pushSize <= kPushRange &&
         blocks.vertexSize <= kConstantRange && blocks.fragmentSize <= kConstantRange &&
         blocks.paletteSize <= kConstantRange;
}

void DrawPlanner::updateConstants(const render::State& state, Groups changed, const NewKeys& made) {
  const gen::Blocks& blocks = plan_.blocks;
  if (made.vertex || changed & blocks.pushGroups) {
    alignas(16) std::array<std::byte, kPushRange> packed;
    gen::packPush(plan_.vertexKey, state.fixed, packed.data());
    if (made.vertex || std::memcmp(packed.data(), plan_.push.data.data(), blocks.pushSize) != 0) {
      std::memcpy(plan_.push.data.data(), packed.data(), blocks.pushSize);
      ++plan_.push.version;
    }
  }
  const auto update = [](auto& block, uint32_t size, bool stale, auto pack) {
    block.size = size;
    if (!stale || size == 0) return;
    pack(block.data.data());
    ++block.version;
  };
  plan_.push.size = blocks.pushSize;
  update(plan_.vertex, blocks.vertexSize, made.vertex || changed & blocks.vertexGroups,
         [&](std::byte* out) { gen::packVertex(plan_.vertexKey, state.fixed, out); });
  update(plan_.fragment, blocks.fragmentSize, made.fragment || changed & blocks.fragmentGroups,
         [&](std::byte* out) { gen::packFragment(plan_.fragmentKey, state.fixed, out); });
  update(plan_.palette, blocks.paletteSize, made.vertex || changed & blocks.paletteGroups,
         [&](std::byte* out) { gen::packPalette(plan_.vertexKey, state.fixed, out); });
}

void DrawPlanner::packCarried(const render::State& state) {
  gen::packPush(plan_.vertexKey, state.fixed, plan_.push.data.data());
}

void DrawPlanner::updateTextures(const render::State& state) {
  for (uint32_t units = plan_.units; units; units &= units - 1) {
    const int unit = std::countr_zero(units);
    const render::TextureBinding& binding = state.textures[unit];
    plan_.sampled[unit] = {static_cast<VulkanImage*>(binding.image), binding.onlyLevel, binding.onlyLayer};
    if (!binding.image) continue;
    const int levels = binding.onlyLevel < 0 ? binding.image->desc().levels : 1;
    plan_.textures[unit].sampler =
        device_.samplers().get(binding.sampler, levels, state.fixed.units[unit].env.lodBias);
  }
}

}  // namespace anteroom::vulkan
