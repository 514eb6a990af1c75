#include <fmt/format.h>

#include <map>

#include "bench.h"

namespace program {
namespace {

std::string orDash(bool known, const std::string& text) {
  return known ? text : "-";
}

std::string times(double ratio) {
  return orDash(ratio > 0, fmt::format("{:.2f}x", ratio));
}

}  // namespace

std::string benchTable(const std::vector<BenchRow>& rows) {
  std::map<std::string, std::string> says;
  for (const BenchRow& row : rows) {
    if (!row.says.empty()) says[row.implementation] = row.says;
  }
  std::string text;
  for (const auto& [name, words] : says) text += fmt::format("{}: {}\n", name, words);
  text += fmt::format(
      "\nms a frame; error: RMS against the reference renderer in 1/255, edges and all\n{:<16} {:<6} {:>7} "
      "{:>9} {:>9} {:>9} {:>9} {:>8} {:>9} {:>8} {:>7} {:>7}\n",
      "demo", "on", "error", "median", "1st", "99th", "worst", "to mesa", "CPU", "to mesa", "draws",
      "KiB up");
  for (const BenchRow& row : rows) {
    if (!row.fault.empty()) {
      text += fmt::format("{:<16} {:<6} {}\n", row.demo, row.implementation, row.fault);
      continue;
    }
    text += fmt::format(
        "{:<16} {:<6} {:>7} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>8} {:>9.2f} {:>8} {:>7.0f} {:>7.0f}\n",
        row.demo, row.implementation, orDash(row.error >= 0, fmt::format("{:.3f}", row.error)), row.median,
        row.first, row.ninetyNinth, row.worst, times(row.ratio), row.cpu, times(row.cpuRatio), row.draws,
        row.uploads);
  }
  return text;
}

std::string benchCsv(const std::vector<BenchRow>& rows) {
  std::string text =
      "demo,implementation,error_rms_255,median_ms,first_percentile_ms,99th_percentile_ms,worst_ms,cpu_ms,"
      "draws,"
      "uploaded_kib,ratio_to_mesa,cpu_ratio_to_mesa,fault\n";
  for (const BenchRow& row : rows) {
    text += fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.1f},{:.1f},{},{},\"{}\"\n", row.demo,
                        row.implementation, row.error >= 0 ? fmt::format("{:.4f}", row.error) : "",
                        row.median, row.first, row.ninetyNinth, row.worst, row.cpu, row.draws, row.uploads,
                        row.ratio > 0 ? fmt::format("{:.4f}", row.ratio) : "",
                        row.cpuRatio > 0 ? fmt::format("{:.4f}", row.cpuRatio) : "", row.fault);
  }
  return text;
}

std::string benchJson(const std::vector<BenchRow>& rows) {
  nlohmann::json document = nlohmann::json::array();
  for (const BenchRow& row : rows) {
    nlohmann::json entry = {{"demo", row.demo}, {"implementation", row.implementation}};
    if (row.fault.empty()) {
      entry.update({{"says", row.says},
                    {"median_ms", row.median},
                    {"first_percentile_ms", row.first},
                    {"99th_percentile_ms", row.ninetyNinth},
                    {"worst_ms", row.worst},
                    {"cpu_ms", row.cpu},
                    {"draws", row.draws},
                    {"uploaded_kib", row.uploads}});
      if (row.error >= 0) entry["error_rms_255"] = row.error;
      if (row.ratio > 0) entry.update({{"ratio_to_mesa", row.ratio}, {"cpu_ratio_to_mesa", row.cpuRatio}});
    } else {
      entry["fault"] = row.fault;
    }
    document.push_back(std::move(entry));
  }
  return document.dump(2) + "\n";
}

}  // namespace program
