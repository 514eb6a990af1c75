#include "layer/vulkan/pipelines/draw_state.h"

namespace anteroom::vulkan {

BakedState baked(const BakedState& state, const Features& f) {
  constexpr int kPoints = 1, kLines = 2, kTriangles = 4, kEvery = kPoints | kLines | kTriangles;
  const bool lines =
      state.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST || state.topology == VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
  const bool points = state.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  const int drawn = points ? kPoints : lines ? kLines : kTriangles;
  struct {
#define BAKED_COMMAND(command, feature, ...) bool command;
#include "layer/vulkan/pipelines/baked_state.inc"
  } const dynamic = {
#define BAKED_COMMAND(command, feature, ...) feature,
#include "layer/vulkan/pipelines/baked_state.inc"
  };
  BakedState out = state;
#define BAKED_PART(member, word, values, primitives, place, command) \
  if (dynamic.command || !(drawn & (primitives))) out.member = 0;
#include "layer/vulkan/pipelines/baked_state.inc"
  // Where it is dynamic, pipelines still tell the kinds of primitive apart.
  if (dynamic.topology)
    out.topology = points  ? VK_PRIMITIVE_TOPOLOGY_POINT_LIST
                   : lines ? VK_PRIMITIVE_TOPOLOGY_LINE_LIST
                           : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  return out;
}

}  // namespace anteroom::vulkan
