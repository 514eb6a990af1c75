#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparison.h"

namespace comparison {

namespace {

const Result* find(const Row& row, const std::string& name) {
  const auto result = row.results.find(name);
  return result == row.results.end() ? nullptr : &result->second;
}

std::string cells(const Row& row, const std::string& name) {
  const Result* result = find(row, name);
  if (!result || !result->difference.present)
    return fmt::format("{:>5} {:>7} {:>5} {:>9}", "-", "-", "-", "-");
  return fmt::format("{:5} {:7.4f} {:5} {:9.2f}", result->difference.worst, result->difference.rms,
                     result->difference.coverage, result->milliseconds);
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

std::string asTable(const Comparison& comparison, const Plan& plan) {
  const std::vector<Row>& rows = comparison.rows;
  std::string text = "the driver's own errors:\n";
  for (const auto& [name, error] : comparison.driverErrors)
    text += fmt::format("  {:38} {:.6f}\n", name, error);
  text += fmt::format("{:40} {:>5} {:>5} {:>9}", "scene", "edges", "bound", "ref ms");
  for (const Implementation& implementation : plan.implementations) {
    text += fmt::format(" | {:>5} {:>7} {:>5} {:>9}", implementation.name.substr(0, 5), "rms", "cover", "ms");
  }
  text += '\n';
  for (const Row& row : rows) {
    const Result* reference = find(row, "reference");
    const Result* ours = find(row, "ours");
    text += fmt::format("{:40} {:5} {:5} {:9.2f}", row.name, ours ? ours->difference.edgePixels : 0,
                        row.bound, reference ? reference->milliseconds : 0);
    for (const Implementation& implementation : plan.implementations)
      text += " | " + cells(row, implementation.name);
    text += row.failures.empty() ? "\n" : row.deviates.empty() ? "  FAIL\n" : "  deviates\n";
  }
  for (const Implementation& implementation : plan.implementations) {
    double milliseconds = 0;
    int worst = 0, exact = 0;
    for (const Row& row : rows) {
      const Result* result = find(row, implementation.name);
      if (!result || !result->difference.present) continue;
      milliseconds += result->milliseconds;
      worst = std::max(worst, result->difference.worst);
      exact += result->difference.worst <= 1;
    }
    text += fmt::format("{}: {} of {} scenes within 1/255, worst {}/255, {:.1f} ms in all\n",
                        implementation.name, exact, rows.size(), worst, milliseconds);
  }
  for (const Row& row : rows) text += notes(row);
  return text;
}

std::string asCsv(const std::vector<Row>& rows, const Plan& plan) {
  std::string text = "scene,section,edge_pixels,bound,reference_ms";
  for (const Implementation& implementation : plan.implementations) {
    for (const char* column : {"worst", "rms", "coverage", "ms"})
      text += fmt::format(",{}_{}", implementation.name, column);
  }
  text += ",mesa_disagreements,mesa_differs,failures\n";
  for (const Row& row : rows) {
    const Result* reference = find(row, "reference");
    const Result* ours = find(row, "ours");
    text += fmt::format("\"{}\",\"{}\",{},{},{:.4f}", row.name, row.section,
                        ours ? ours->difference.edgePixels : 0, row.bound,
                        reference ? reference->milliseconds : 0);
    for (const Implementation& implementation : plan.implementations) {
      const Result* result = find(row, implementation.name);
      if (result && result->difference.present)
        text += fmt::format(",{},{:.6f},{},{:.4f}", result->difference.worst, result->difference.rms,
                            result->difference.coverage, result->milliseconds);
      else
        text += ",,,,";
    }
    text +=
        fmt::format(",{},\"{}\",\"{}\"\n", row.disagreements, row.mesaDiffers, fmt::join(row.failures, "; "));
  }
  return text;
}

std::string asJson(const std::vector<Row>& rows, const Plan& plan) {
  nlohmann::json all = nlohmann::json::array();
  for (const Row& row : rows) {
    nlohmann::json entry = {{"scene", row.name},
                            {"section", row.section},
                            {"bound", row.bound},
                            {"boundReason", row.boundReason},
                            {"mesaDiffers", row.mesaDiffers},
                            {"mesaDisagreements", row.disagreements},
                            {"failures", row.failures}};
    if (const Result* reference = find(row, "reference"))
      entry["referenceMilliseconds"] = reference->milliseconds;
    for (const Implementation& implementation : plan.implementations) {
      const Result* result = find(row, implementation.name);
      if (!result) continue;
      const Difference& d = result->difference;
      entry["implementations"][implementation.name] = {{"present", d.present},
                                                       {"worst", d.worst},
                                                       {"rms", d.rms},
                                                       {"coverage", d.coverage},
                                                       {"edgePixels", d.edgePixels},
                                                       {"worstOutsideEdges", d.worstOutside},
                                                       {"milliseconds", result->milliseconds},
                                                       {"fault", result->fault}};
    }
    all.push_back(std::move(entry));
  }
  return all.dump(1) + '\n';
}

}  // namespace comparison
