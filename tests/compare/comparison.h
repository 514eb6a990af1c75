// Renders scenes on several implementations, and judges.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "difference.h"
#include "scene.h"
#include "tests/measure/options.h"

namespace comparison {

// What one implementation made of a scene.
struct Result {
  Picture picture;
  // Of drawing and reading back once everything is compiled, a round each.
  std::vector<double> milliseconds;
  std::string fault;  // a crash, or why there is no picture
  Difference difference;
};

struct Row {
  std::string name, section, mesaDiffers, deviates;
  bool extreme = false;
  int bound = 1;                          // what an interior pixel of ours may be off
  std::string boundReason;                // empty: the project's own bound
  std::map<std::string, Result> results;  // by implementation
  std::string skipped;                    // both ours and the reference lack a command
  int disagreements = 0;                  // interior pixels where Mesa is further from us than the bound
  std::vector<std::string> failures;      // what of ours is out of bounds
};

struct Plan {
  std::vector<measure::Implementation> implementations;  // besides the reference
  process::Environment reference;
  measure::Filter filter;
  int rounds = 1;
  int repeats = 3;
  bool demos = false;  // frames of the demos as well
  std::string out;     // directory for pictures; empty: none
};

// What anteroom-driver measured, by name.
using DriverErrors = std::map<std::string, double>;

struct Comparison {
  DriverErrors driverErrors;
  std::vector<Row> rows;
};

// Throws std::runtime_error when the driver cannot be measured, std::invalid_argument when the filter lets
// nothing pass.
Comparison compareAll(const Plan& plan);

// Frames of the demos: their errors away from edges, by RMS. The rooms program must be built.
std::vector<Row> compareDemos(const Plan& plan);
std::vector<std::string> demoNames();

// The reference, the others, then their errors, as far as the plan asks for pictures.
void writePictures(const Plan& plan, const Row& row, const Picture& reference);

// Of the extremes: whether ours is further from the reference than Mesa by more than the rounding of the
// framebuffer.
bool mesaIsExacter(const Row& row);

// A row for each scene and implementation.
measure::Table tableOf(const std::vector<Row>& rows, const Plan& plan);
// The table below the driver's errors, above sums and what is to be said of single scenes.
std::string asText(const Comparison& comparison, const Plan& plan);

}  // namespace comparison
