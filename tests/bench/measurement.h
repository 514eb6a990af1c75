#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pixels.h"

namespace bench {

// What one process measured under one name.
struct Measurement {
  std::string name;
  std::string unit;             // "ms" or "MiB"
  std::vector<double> samples;  // empty when faulty
  Verdict verdict;              // on what was drawn meanwhile
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Verdict, fault, error)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, name, unit, samples, verdict)

// What a worker process hands to the one that started it.
struct WorkerReport {
  std::string implementation;
  std::vector<Measurement> measurements;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WorkerReport, implementation, measurements)

// The first fault and the greatest error of both.
inline Verdict worst(const Verdict& first, const Verdict& second) {
  return {first.fault.empty() ? second.fault : first.fault, std::max(first.error, second.error)};
}

}  // namespace bench
