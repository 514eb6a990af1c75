#include "tests/measure/statistics.h"

#include <algorithm>

namespace measure {

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (values[above] - values[below]) * (at - static_cast<double>(below));
}

double median(std::vector<double> values) {
  return percentile(std::move(values), 0.5);
}

Summary summary(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {values.size(), median(values), *least, *greatest};
}

Summary ratio(const std::vector<double>& rounds, const std::vector<double>& baseline) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(rounds.size(), baseline.size()); ++round)
    if (baseline[round] > 0) ratios.push_back(rounds[round] / baseline[round]);
  return summary(ratios);
}

}  // namespace measure
