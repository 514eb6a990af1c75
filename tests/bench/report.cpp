#include "report.h"

#include <fmt/format.h>

#include <algorithm>

namespace bench {

namespace {

double pairedRatio(const std::vector<double>& values, const std::vector<double>& baseline) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(values.size(), baseline.size()); ++round)
    if (baseline[round] > 0) ratios.push_back(values[round] / baseline[round]);
  return ratios.empty() ? 0 : median(std::move(ratios));
}

const Measurement* find(const ImplementationResult& result, const std::string& name) {
  const auto found = result.measurements.find(name);
  return found == result.measurements.end() ? nullptr : &found->second;
}

Row makeRow(const ImplementationResult& result, const Measurement& measurement, const Measurement* baseline) {
  Row row;
  row.name = measurement.name;
  row.unit = measurement.unit;
  row.implementation = result.name;
  row.verdict = measurement.verdict;
  if (!row.verdict.fault.empty() || measurement.samples.empty()) return row;
  const auto [least, greatest] = std::minmax_element(measurement.samples.begin(), measurement.samples.end());
  row.rounds = measurement.samples.size();
  row.median = median(measurement.samples);
  row.least = *least;
  row.greatest = *greatest;
  row.spread = row.median > 0 ? (row.greatest - row.least) / 2 / row.median : 0;
  if (baseline && baseline->verdict.fault.empty())
    row.ratio = pairedRatio(measurement.samples, baseline->samples);
  return row;
}

std::string cell(const Row& row) {
  if (!row.verdict.fault.empty()) return "WRONG";
  if (row.rounds == 0) return "-";
  const std::string ratio = row.ratio > 0 ? fmt::format("{:6.2f}x", row.ratio) : "";
  return fmt::format("{:9.3f} ±{:3.0f}%{} {:2d}", row.median, 100 * row.spread, ratio, row.verdict.error);
}

}  // namespace

Verdict worst(const Verdict& first, const Verdict& second) {
  return {first.fault.empty() ? second.fault : first.fault, std::max(first.error, second.error)};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::vector<Row> makeRows(const std::vector<ImplementationResult>& results,
                          const std::vector<std::string>& order, const std::string& baseline) {
  const auto base = std::find_if(results.begin(), results.end(),
                                 [&](const ImplementationResult& result) { return result.name == baseline; });
  std::vector<Row> rows;
  for (const std::string& name : order)
    for (const ImplementationResult& result : results)
      if (const Measurement* measurement = find(result, name))
        rows.push_back(makeRow(result, *measurement, base == results.end() ? nullptr : find(*base, name)));
  return rows;
}

std::string asTable(const std::vector<ImplementationResult>& results, const std::vector<Row>& rows) {
  std::string text;
  for (const ImplementationResult& result : results) {
    text += fmt::format("{}: {}\n", result.name, result.implementation);
    for (const std::string& fault : result.faults) text += fmt::format("  FAULT: {}\n", fault);
  }
  text += fmt::format("\n{:46}", "median, spread, ratio, error in 1/255");
  for (const ImplementationResult& result : results) text += fmt::format("{:>27}", result.name);

  std::string current;
  std::size_t column = 0;
  for (const Row& row : rows) {
    if (row.name != current) {
      current = row.name;
      column = 0;
      text += fmt::format("\n{:46}", row.name + " [" + row.unit + "]");
    }
    for (; column < results.size() && results[column].name != row.implementation; ++column)
      text += fmt::format("{:>27}", "-");
    text += fmt::format("{:>27}", cell(row));
    ++column;
  }
  text += "\n";
  for (const Row& row : rows)
    if (!row.verdict.fault.empty())
      text += fmt::format("WRONG {} of {}: {}\n", row.name, row.implementation, row.verdict.fault);
  return text;
}

std::string asCsv(const std::vector<Row>& rows) {
  std::string text = "name,unit,implementation,median,least,greatest,rounds,ratio,error,fault\n";
  for (const Row& row : rows)
    text += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{},{:.4g},{},\"{}\"\n", row.name, row.unit,
                        row.implementation, row.median, row.least, row.greatest, row.rounds, row.ratio,
                        row.verdict.error, row.verdict.fault);
  return text;
}

std::string asJson(const std::vector<ImplementationResult>& results, const std::vector<Row>& rows) {
  nlohmann::json document;
  for (const ImplementationResult& result : results)
    document["implementations"].push_back(
        {{"name", result.name}, {"says", result.implementation}, {"faults", result.faults}});
  for (const Row& row : rows) {
    nlohmann::json entry = {{"name", row.name}, {"unit", row.unit}, {"implementation", row.implementation}};
    if (row.verdict.fault.empty()) {
      entry.update({{"median", row.median},
                    {"least", row.least},
                    {"greatest", row.greatest},
                    {"rounds", row.rounds},
                    {"error", row.verdict.error}});
      if (row.ratio > 0) entry["ratio"] = row.ratio;
    } else {
      entry["fault"] = row.verdict.fault;
    }
    document["results"].push_back(entry);
  }
  return document.dump(2) + "\n";
}

}  // namespace bench
