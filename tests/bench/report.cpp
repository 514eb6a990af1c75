#include "report.h"

#include <fmt/format.h>

#include <algorithm>

#include "tests/measure/statistics.h"

namespace bench {

namespace {

// Numbers of the rows stand side by side, behind this column.
constexpr std::size_t kImplementation = 2;

const Measurement* find(const ImplementationResult& result, const std::string& name) {
  const auto found = result.measurements.find(name);
  return found == result.measurements.end() ? nullptr : &found->second;
}

std::vector<measure::Cell> rowOf(const std::string& implementation, const Measurement& measurement,
                                 const Measurement* baseline) {
  const measure::Cell none;
  const std::string& fault = measurement.verdict.fault;
  std::vector<measure::Cell> row = {measurement.name, measurement.unit, implementation};
  if (!fault.empty() || measurement.samples.empty()) {
    row.insert(row.end(), {fault.empty() ? none : "WRONG", none, none, none, none, none, none, none, fault});
    return row;
  }
  const measure::Summary times = measure::summary(measurement.samples);
  measure::Summary ratio;
  if (baseline && baseline->verdict.fault.empty())
    ratio = measure::ratio(measurement.samples, baseline->samples);
  const bool compared = ratio.count > 0;
  row.insert(row.end(), {times.median, 100 * times.spread(), times.least, times.greatest,
                         static_cast<double>(times.count), compared ? measure::Cell(ratio.median) : none,
                         compared ? measure::Cell(100 * ratio.spread()) : none,
                         static_cast<double>(measurement.verdict.error), none});
  return row;
}

}  // namespace

bool good(const std::vector<ImplementationResult>& results) {
  return std::all_of(results.begin(), results.end(), [](const ImplementationResult& result) {
    return result.faults.empty() &&
           std::all_of(result.measurements.begin(), result.measurements.end(),
                       [](const auto& named) { return named.second.verdict.fault.empty(); });
  });
}

measure::Table tableOf(const std::vector<ImplementationResult>& results,
                       const std::vector<std::string>& order, const std::string& baseline) {
  const auto base = std::find_if(results.begin(), results.end(),
                                 [&](const ImplementationResult& result) { return result.name == baseline; });
  measure::Table table({{"name"},
                        {"unit"},
                        {"implementation"},
                        {"median", "", 3},
                        {"spread", "%"},
                        {.name = "least", .digits = 3, .detail = true},
                        {.name = "greatest", .digits = 3, .detail = true},
                        {.name = "rounds", .detail = true},
                        {"ratio", "", 2},
                        {"spread of ratio", "%"},
                        {"error", "1/255"},
                        {.name = "fault", .detail = true}});
  for (const std::string& name : order)
    for (const ImplementationResult& result : results)
      if (const Measurement* measurement = find(result, name))
        table.add(rowOf(result.name, *measurement, base == results.end() ? nullptr : find(*base, name)));
  return table;
}

std::string asText(const std::vector<ImplementationResult>& results, const measure::Table& table) {
  std::string text;
  for (const ImplementationResult& result : results) {
    text += fmt::format("{}: {}\n", result.name, result.implementation);
    for (const std::string& fault : result.faults) text += fmt::format("  FAULT: {}\n", fault);
  }
  text += "\n" + table.sideBySide(kImplementation);
  for (const ImplementationResult& result : results)
    for (const auto& [name, measurement] : result.measurements)
      if (!measurement.verdict.fault.empty())
        text += fmt::format("WRONG {} of {}: {}\n", name, result.name, measurement.verdict.fault);
  return text;
}

std::string asJson(const std::vector<ImplementationResult>& results, const measure::Table& table) {
  nlohmann::json document = {{"results", table.json()}};
  for (const ImplementationResult& result : results)
    document["implementations"].push_back(
        {{"name", result.name}, {"says", result.implementation}, {"faults", result.faults}});
  return document.dump(2) + "\n";
}

}  // namespace bench
