// The HUD: one quad over the picture. Letters and graph are made in its fragment shader, of a block of
// constants that holds the font, too.
#pragma once

#include "layer/render/hud.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

class Recorder;

// No statistics tell of it. False: out of memory.
bool drawHud(Recorder& recorder, const Target& target, const render::Hud& hud);

}  // namespace anteroom::vulkan
