#pragma once

#include <string>
#include <vector>

#include "clock.h"
#include "measurement.h"
#include "process.h"
#include "report.h"

namespace bench {

using process::Environment;

struct Implementation {
  std::string name;
  Environment environment;  // makes a process find it
};

struct Plan {
  std::vector<Implementation> implementations;
  NameFilter filter;
  int rounds = 5;
  int visitMilliseconds = 250;
  Clock clock = Clock::kWall;
};

// Runs the workers of all implementations, interleaved, in fresh processes. Throws std::system_error when
// none can be started; a worker that fails ends its implementation and becomes a fault.
std::vector<ImplementationResult> measure(const Plan& plan);

// Every name that measure() can give, in the order to show them in.
std::vector<std::string> allNames();

}  // namespace bench
