#pragma once

#include <map>
#include <string>
#include <vector>

#include "measurement.h"

namespace bench {

// All rounds of one implementation.
struct ImplementationResult {
  std::string name;                 // "ours", "mesa" ...
  std::string implementation;       // what it says of itself
  std::vector<std::string> faults;  // of whole workers: crashes, timeouts
  // By measurement; one median a round, in the order of rounds.
  std::map<std::string, Measurement> measurements;
};

struct Row {
  std::string name;
  std::string unit;
  std::string implementation;
  double median = 0;  // of the medians of the rounds
  double spread = 0;  // half of (greatest - least) / median
  double least = 0;
  double greatest = 0;
  std::size_t rounds = 0;
  double ratio =
      0;  // to the first implementation that is named `baseline`, median of the rounds' ratios; 0: none
  Verdict verdict;
};

// One row for each name and implementation, names in the order of `order`. A faulty measurement has no
// numbers.
std::vector<Row> makeRows(const std::vector<ImplementationResult>& results,
                          const std::vector<std::string>& order, const std::string& baseline);

std::string asTable(const std::vector<ImplementationResult>& results, const std::vector<Row>& rows);
std::string asCsv(const std::vector<Row>& rows);
std::string asJson(const std::vector<ImplementationResult>& results, const std::vector<Row>& rows);

}  // namespace bench
