// Runs a demo in a window.
#pragma once

#include "options.h"

namespace program {

// In real time and led by keys until it is closed; or, where the options choose frames, just those, which are
// written to files, too. Throws UsageError, which names what is missing, where there can be no window.
void show(const room::DemoEntry& entry, const Options& options);

}  // namespace program
