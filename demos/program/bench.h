// Error and run time of the demos on several implementations, each in processes of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "options.h"
#include "tests/measure/options.h"

namespace program {

struct BenchOptions {
  std::string demo = "all";
  std::string size = "640x480";
  std::string errorSize = "160x120";  // of the pictures that are held against the reference renderer's
  int frames = 60;
  int rounds = 1;
  int samples = 0;
  double time = 2;
  bool found = false;  // only the implementation that the program finds
  bool withoutError = false;
  measure::Format format = measure::Format::Text;
  measure::Sources sources;
  measure::Filter filter;  // of the demos that are named
  room::Settings settings;
};

// What one process hands to the one that started it.
struct WorkerReport {
  std::string implementation;        // what it says of itself
  std::vector<double> milliseconds;  // of every frame
  double cpuMilliseconds = 0;        // a frame, of all threads
  double draws = 0;                  // a frame
  double uploadedKibibytes = 0;      // a frame
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WorkerReport, implementation, milliseconds, cpuMilliseconds, draws,
                                   uploadedKibibytes)

// All rounds of one demo on one implementation.
struct Measured {
  std::string demo;
  std::string implementation;        // "ours", "mesa", "zink" or "found"
  std::string says;                  // what it calls itself
  std::string fault;                 // why there are no numbers
  std::vector<double> milliseconds;  // of every frame
  // Of every round: the median of its frames' times, the processor's time a frame, in ms.
  std::vector<double> medians, cpu;
  double draws = 0, uploads = 0;  // a frame; uploads in KiB
  double error = -1;              // RMS against the reference renderer, 1/255; -1: not known
};

// Runs everything that the options ask for, in rounds that go around the implementations. Throws UsageError
// when that is nothing.
std::vector<Measured> bench(const std::vector<room::DemoEntry>& demos, const BenchOptions& options);

// What the processes do: draws the demo's frames and prints a report, or draws one frame into a file.
struct WorkerTask {
  std::string demo;
  std::string size;
  int frames = 1;
  int samples = 0;
  double time = 0;
  std::string picture;  // a file
  room::Settings settings;
};
int work(const std::vector<room::DemoEntry>& demos, const WorkerTask& task);

// Text, CSV or JSON. Ratios are to Mesa's native implementation.
std::string benchReport(const std::vector<Measured>& measured, measure::Format format);

}  // namespace program
