#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench.h"
#include "tests/measure/statistics.h"

namespace program {
namespace {

std::vector<measure::Cell> rowOf(const Measured& measured, const Measured* mesa) {
  std::vector<measure::Cell> row = {measured.demo, measured.implementation};
  if (!measured.fault.empty()) {
    row.resize(14);
    row.insert(row.end(), {measured.says, measured.fault});
    return row;
  }
  const auto known = [](bool there, double number) {
    return there ? measure::Cell(number) : measure::Cell();
  };
  measure::Summary ratio, cpuRatio;
  if (mesa && mesa->fault.empty()) {
    ratio = measure::ratio(measured.medians, mesa->medians);
    cpuRatio = measure::ratio(measured.cpu, mesa->cpu);
  }
  const bool compared = ratio.count > 0;
  row.insert(
      row.end(),
      {known(measured.error >= 0, measured.error), measure::median(measured.milliseconds),
       100 * measure::summary(measured.medians).spread(), measure::percentile(measured.milliseconds, 0.01),
       measure::percentile(measured.milliseconds, 0.99), measure::percentile(measured.milliseconds, 1),
       known(compared, ratio.median), known(compared, 100 * ratio.spread()), measure::median(measured.cpu),
       known(compared, cpuRatio.median), measured.draws, measured.uploads, measured.says, ""});
  return row;
}

measure::Table tableOf(const std::vector<Measured>& measured) {
  measure::Table table({{"demo"},
                        {"implementation"},
                        {"error rms", "1/255", 3},
                        {"median", "ms", 2},
                        {"spread", "%"},
                        {"1st percentile", "ms", 2},
                        {"99th percentile", "ms", 2},
                        {"worst", "ms", 2},
                        {"ratio to mesa", "", 2},
                        {"spread of ratio", "%"},
                        {"cpu", "ms", 2},
                        {"cpu ratio to mesa", "", 2},
                        {"draws"},
                        {"uploaded", "KiB"},
                        {.name = "says", .detail = true},
                        {.name = "fault", .detail = true}});
  for (const Measured& each : measured) {
    const auto mesa = std::find_if(measured.begin(), measured.end(), [&](const Measured& other) {
      return other.demo == each.demo && other.implementation == "mesa";
    });
    table.add(rowOf(each, mesa == measured.end() ? nullptr : &*mesa));
  }
  return table;
}

}  // namespace

std::string benchReport(const std::vector<Measured>& measured, measure::Format format) {
  const measure::Table table = tableOf(measured);
  if (format == measure::Format::Json) return table.json().dump(2) + "\n";
  if (format == measure::Format::Csv) return table.csv();
  std::map<std::string, std::string> says;
  std::string text, faults;
  for (const Measured& each : measured) {
    if (!each.says.empty()) says[each.implementation] = each.says;
    if (!each.fault.empty())
      faults += fmt::format("{} on {}: {}\n", each.demo, each.implementation, each.fault);
  }
  for (const auto& [name, words] : says) text += fmt::format("{}: {}\n", name, words);
  return text + "\na frame; error: against the reference renderer, edges and all\n" + table.text() + faults;
}

}  // namespace program
