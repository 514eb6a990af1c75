// Error and run time of the demos on several implementations, each in processes of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "options.h"

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
  bool csv = false;
  bool json = false;
  std::string mesaLibraries;
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

struct BenchRow {
  std::string demo;
  std::string implementation;  // "ours", "mesa", "zink" or "found"
  std::string says;            // what it calls itself
  std::string fault;           // why there are no numbers
  double median = 0;           // ms a frame
  double first = 0;            // 1st percentile
  double ninetyNinth = 0;
  double worst = 0;
  double cpu = 0;
  double draws = 0;
  double uploads = 0;   // KiB
  double ratio = 0;     // of the medians, to Mesa's native; 0: none
  double cpuRatio = 0;  // the same of processor time, which other programs disturb less
  double error = -1;    // RMS against the reference renderer, 1/255; -1: not known
};

// Runs everything that the options ask for, in rounds that go around the implementations.
std::vector<BenchRow> bench(const std::vector<room::DemoEntry>& demos, const BenchOptions& options);

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

std::string benchTable(const std::vector<BenchRow>& rows);
std::string benchCsv(const std::vector<BenchRow>& rows);
std::string benchJson(const std::vector<BenchRow>& rows);

// Value below which that share of the values lies, between neighbours by their distance; values not empty.
double percentile(std::vector<double> values, double share);

}  // namespace program
