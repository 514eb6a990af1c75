#pragma once

#include <map>
#include <string>
#include <vector>

#include "measurement.h"
#include "tests/measure/table.h"

namespace bench {

// All rounds of one implementation.
struct ImplementationResult {
  std::string name;                 // "ours", "mesa" ...
  std::string implementation;       // what it says of itself
  std::vector<std::string> faults;  // of whole workers: crashes, timeouts
  // By measurement; one median a round, in the order of rounds.
  std::map<std::string, Measurement> measurements;
};

// Nothing crashed and every picture is right.
bool good(const std::vector<ImplementationResult>& results);

// A row for each name and implementation, names in the order of `order`. A faulty measurement has no numbers.
// Ratios are to the implementation that is named `baseline`.
measure::Table tableOf(const std::vector<ImplementationResult>& results,
                       const std::vector<std::string>& order, const std::string& baseline);

std::string asText(const std::vector<ImplementationResult>& results, const measure::Table& table);
std::string asJson(const std::vector<ImplementationResult>& results, const measure::Table& table);

}  // namespace bench
