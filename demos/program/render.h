// Draws demos to picture files.
#pragma once

#include "options.h"

namespace program {

// The stages and frames that the options choose, to the folder that they name.
void render(const room::DemoEntry& entry, const Options& options);

}  // namespace program
