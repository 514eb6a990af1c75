// Waves as sums of sines and cosines.
#pragma once

#include "sheet.h"

namespace water {

// What the wind does to the pool at a time, seconds.
void waveHeights(double time, Heights& out);

}  // namespace water
