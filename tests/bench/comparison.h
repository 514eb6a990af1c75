#pragma once

#include <string>
#include <vector>

#include "clock.h"
#include "measurement.h"
#include "report.h"
#include "tests/measure/options.h"

namespace bench {

struct Plan {
  std::vector<measure::Implementation> implementations;
  measure::Filter filter;
  int rounds = 5;
  int visitMilliseconds = 250;
  Clock clock = Clock::kWall;
};

// Runs the workers of all implementations, interleaved, in fresh processes. Throws std::system_error when
// none can be started, std::invalid_argument when the filter lets nothing pass; a worker that fails ends its
// implementation and becomes a fault.
std::vector<ImplementationResult> measureAll(const Plan& plan);

// Every name that measureAll() can give, in the order to show them in.
std::vector<std::string> allNames();

}  // namespace bench
