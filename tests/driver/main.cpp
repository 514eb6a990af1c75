// anteroom-driver [NAME ...]: a line a measurement, its name and the greatest error.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "measurements.h"

namespace {

struct Measurement {
  std::string_view name;
  double (*measure)(driver::Device&);
};

constexpr Measurement kMeasurements[] = {
    {"filter-weights", driver::filterWeights},
    {"level-of-detail", driver::levelOfDetail},
    {"level-of-detail-in-perspective", driver::levelOfDetailInPerspective},
    {"anisotropy", driver::anisotropy},
    {"power", driver::power},
    {"exponential", driver::exponential},
    {"blending", driver::blending},
    {"line-parameter", driver::lineParameter},
    {"smooth-line-coverage", driver::smoothLineCoverage},
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Measures how exact the Vulkan driver is: a line a measurement, its name and the greatest error.");
  app.set_version_flag("--version", "anteroom-driver " ANTEROOM_VERSION);
  std::vector<std::string> wanted, names;
  for (const Measurement& measurement : kMeasurements) names.emplace_back(measurement.name);
  app.add_option("NAME", wanted, "only these")->check(CLI::IsMember(names));
  try {
    app.parse(argc, argv);
    driver::Device device;
    for (const auto& [name, measure] : kMeasurements) {
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end())
        fmt::print("{} {:.6f}\n", name, measure(device));
    }
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-driver: {}\n", error.what());
    return 1;
  }
}
