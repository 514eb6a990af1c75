// The float64 renderer as a device of the seam.
#pragma once

#include "layer/render/renderer.h"

// What a loader looks up by name in the plug-in: a new device, owned by the caller.
extern "C" __attribute__((visibility("default"))) anteroom::render::Device* anteroomCreateReferenceDevice();
