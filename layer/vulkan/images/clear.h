// glClear (section 4.2.3).
#pragma once

#include "layer/render/state.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

class Recorder;

// Clears what `mask` says of `target`, under the state's scissor and write masks: remembered until a pass
// begins where it can be, else done inside the pass. False: out of memory.
bool clear(Recorder& recorder, const Target& target, const render::State& state, GLbitfield mask);

}  // namespace anteroom::vulkan
