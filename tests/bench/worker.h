#pragma once

#include <cstdint>
#include <string>

#include "measurement.h"

namespace bench {

// The workers run in processes of their own, against whichever libEGL.so.1 their environment gives them.

// Every steady scene that passes, in interleaved visits of at least `visitMilliseconds`: milliseconds a
// frame.
WorkerReport measureSteady(const NameFilter& filter, double visitMilliseconds);

// From the start of the process (nanoseconds of CLOCK_MONOTONIC) to the first frame, then the first use of
// each state mix. `temperature` ("cold" or "warm") becomes part of the names.
WorkerReport measureFresh(const std::string& temperature, std::int64_t processStart);

// The names that the two can give.
std::vector<std::string> steadyNames();
std::vector<std::string> freshNames(const std::string& temperature);

// Nanoseconds of CLOCK_MONOTONIC.
std::int64_t now();

}  // namespace bench
