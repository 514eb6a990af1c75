// What many samples of one thing come down to.
#pragma once

#include <cstddef>
#include <vector>

namespace measure {

// The value below which that share (0 to 1) of the values lies, between neighbours by their distance. Of a
// non-empty set.
double percentile(std::vector<double> values, double share);
double median(std::vector<double> values);

struct Summary {
  std::size_t count = 0;
  double median = 0, least = 0, greatest = 0;  // 0 of no values
  // Half of what lies between the least and the greatest, as a share of the median.
  double spread() const { return median > 0 ? (greatest - least) / 2 / median : 0; }
};
Summary summary(const std::vector<double>& values);

// Of the ratios of the rounds, each to the same round of the baseline: what slows a round slows both. Rounds
// that only one has, and those in which the baseline is 0, do not count.
Summary ratio(const std::vector<double>& rounds, const std::vector<double>& baseline);

}  // namespace measure
