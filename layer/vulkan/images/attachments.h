// What attachments must hold before a pass on them begins.
#pragma once

#include "layer/vulkan/pipelines/own_shaders.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

class Recorder;

// Samples that belong to a level of a texture (EXT_multisampled_render_to_texture): every pass on them
// resolves into it at its end, and they are kept, so that a pass may be interrupted anywhere. When something
// else has written to the texture they start again with what it holds, here. Nothing is done while a pass on
// `target` is open. False: out of memory.
bool loadSamples(Recorder& recorder, const Target& target, Counted counted = Counted::Yes);

// The same, and the alpha of a format that has none is 1, where copies left any other.
bool prepareAttachments(Recorder& recorder, const Target& target);

}  // namespace anteroom::vulkan
