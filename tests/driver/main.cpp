// anteroom-driver [NAME ...]: a line a measurement, its name and the greatest error.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string_view>

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
  try {
    driver::Device device;
    for (const Measurement& measurement : kMeasurements) {
      bool wanted = argc < 2;
      for (int i = 1; i < argc; ++i) wanted |= measurement.name == argv[i];
      if (wanted) fmt::print("{} {:.6f}\n", measurement.name, measurement.measure(device));
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-driver: {}\n", error.what());
    return 1;
  }
}
