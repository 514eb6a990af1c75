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

// Names that contain one of the parts; every name when there are none.
struct NameFilter {
  std::vector<std::string> parts;

  bool matches(const std::string& name) const {
    return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
             return name.find(part) != std::string::npos;
           });
  }
  bool matchesAny(const std::vector<std::string>& names) const {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return matches(name); });
  }
};

// The first fault and the greatest error of both.
Verdict worst(const Verdict& first, const Verdict& second);

// Of a non-empty set.
double median(std::vector<double> values);

}  // namespace bench
