#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparison.h"
#include "tests/measure/statistics.h"

namespace comparison {

namespace {

const Result* find(const Row& row, const std::string& name) {
  const auto result = row.results.find(name);
  return result == row.results.end() ? nullptr : &result->second;
}

// Columns of a scene come before this one, those of an implementation behind it.
constexpr std::size_t kImplementation = 6;

const char* verdictOf(const Row& row) {
  if (!row.skipped.empty()) return "skipped";
  if (row.failures.empty()) return "good";
  return row.deviates.empty() ? "FAIL" : "deviates";
}

measure::Cell medianOf(const Result* result) {
  if (!result || result->milliseconds.empty()) return {};
  return measure::median(result->milliseconds);
}

std::vector<measure::Cell> rowOf(const Row& row, const std::string& name) {
  const Result* ours = find(row, "ours");
  const Result* result = find(row, name);
  std::vector<measure::Cell> cells = {row.name,
                                      row.section,
                                      verdictOf(row),
                                      double(ours ? ours->difference.edgePixels : 0),
                                      double(row.bound),
                                      medianOf(find(row, "reference")),
                                      name};
  if (result && result->difference.present) {
    const Difference& d = result->difference;
    const measure::Summary times = measure::summary(result->milliseconds);
    cells.insert(cells.end(), {double(d.worst), d.rms, double(d.coverage), double(d.worstOutside),
                               times.median, 100 * times.spread()});
  } else {
    cells.resize(cells.size() + 6);
  }
  cells.push_back(result ? result->fault : "");
  cells.push_back(name == "ours" ? fmt::format("{}", fmt::join(row.failures, "; ")) : "");
  cells.push_back(name == "mesa" ? measure::Cell(double(row.disagreements)) : measure::Cell());
  cells.push_back(name == "mesa" ? row.mesaDiffers : "");
  return cells;
}

std::string notes(const Row& row) {
  if (!row.skipped.empty()) return fmt::format("  skipped {}: {}\n", row.name, row.skipped);
  std::string text;
  for (const std::string& failure : row.failures)
    text += fmt::format("  {} {}: {}\n", row.deviates.empty() ? "FAIL" : "deviates", row.name, failure);
  if (!row.deviates.empty()) text += fmt::format("  deviates {}: {}\n", row.name, row.deviates);
  if (row.disagreements > 0 && row.mesaDiffers.empty())
    text +=
        fmt::format("  UNEXPLAINED {}: Mesa differs in {} interior pixels\n", row.name, row.disagreements);
  if (row.disagreements > 0 && !row.mesaDiffers.empty())
    text += fmt::format("  mesa differs {}: {} pixels: {}\n", row.name, row.disagreements, row.mesaDiffers);
  if (row.disagreements == 0 && !row.mesaDiffers.empty() && find(row, "mesa"))
    text +=
        fmt::format("  mesa agrees {}, though the table says it differs: {}\n", row.name, row.mesaDiffers);
  if (mesaIsExacter(row)) text += fmt::format("  FAIL {}: less exact than Mesa\n", row.name);
  for (const auto& [name, result] : row.results)
    if (!result.fault.empty()) text += fmt::format("  {} on {}: {}\n", row.name, name, result.fault);
  return text;
}

}  // namespace

bool mesaIsExacter(const Row& row) {
  const Result* ours = find(row, "ours");
  const Result* mesa = find(row, "mesa");
  return row.extreme && ours && mesa && mesa->difference.present &&
         ours->difference.worst > std::max(mesa->difference.worst, 1);
}

measure::Table tableOf(const std::vector<Row>& rows, const Plan& plan) {
  measure::Table table({{"scene"},
                        {.name = "section", .detail = true},
                        {"verdict"},
                        {"edges", "pixels"},
                        {"bound", "1/255"},
                        {"reference", "ms", 2},
                        {"implementation"},
                        {"worst", "1/255"},
                        {"rms", "1/255", 4},
                        {"coverage", "pixels"},
                        {.name = "outside edges", .unit = "1/255", .detail = true},
                        {"time", "ms", 2},
                        {"spread", "%"},
                        {.name = "fault", .detail = true},
                        {.name = "failures", .detail = true},
                        {.name = "disagreements", .unit = "pixels", .detail = true},
                        {.name = "mesa differs", .detail = true}});
  for (const Row& row : rows)
    for (const measure::Implementation& implementation : plan.implementations)
      table.add(rowOf(row, implementation.name));
  return table;
}

std::string asText(const Comparison& comparison, const Plan& plan) {
  const std::vector<Row>& rows = comparison.rows;
  std::string text = "the driver's own errors:\n";
  for (const auto& [name, error] : comparison.driverErrors)
    text += fmt::format("  {:38} {:.6f}\n", name, error);
  text += tableOf(rows, plan).sideBySide(kImplementation);
  for (const measure::Implementation& implementation : plan.implementations) {
    double milliseconds = 0;
    int worst = 0, exact = 0;
    for (const Row& row : rows) {
      const Result* result = find(row, implementation.name);
      if (!result || !result->difference.present) continue;
      milliseconds += measure::median(result->milliseconds);
      worst = std::max(worst, result->difference.worst);
      exact += result->difference.worst <= 1;
    }
    text += fmt::format("{}: {} of {} scenes within 1/255, worst {}/255, {:.1f} ms in all\n",
                        implementation.name, exact, rows.size(), worst, milliseconds);
  }
  for (const Row& row : rows) text += notes(row);
  return text;
}

}  // namespace comparison
