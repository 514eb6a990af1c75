#pragma once

#include <string>

#include "clock.h"
#include "measurement.h"
#include "tests/measure/options.h"

namespace bench {

// The workers run in processes of their own, against whichever libEGL.so.1 their environment gives them.

struct WorkerTask {
  measure::Filter filter;
  Clock clock = Clock::kWall;
  int visitMilliseconds = 0;     // of wall-clock time
  Nanoseconds processStart = 0;  // on that clock
};

// Every steady scene that passes the filter, in interleaved visits: time a frame.
WorkerReport measureSteady(const WorkerTask& task);

// From the start of the process to the first frame, then the first use of each state mix. `temperature`
// ("cold" or "warm") becomes part of the names.
WorkerReport measureFresh(const WorkerTask& task, const std::string& temperature);

// The names that the two can give.
std::vector<std::string> steadyNames();
std::vector<std::string> freshNames(const std::string& temperature);

}  // namespace bench
