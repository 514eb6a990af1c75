// Renders scenes on several implementations, and judges.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "difference.h"
#include "process.h"
#include "scene.h"

namespace comparison {

using process::Environment;

struct Implementation {
  std::string name;
  Environment environment;
};

// What one implementation made of a scene.
struct Result {
  Picture picture;
  double milliseconds = 0;  // of drawing and reading back once everything is compiled
  std::string fault;        // a crash, or why there is no picture
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
  std::vector<Implementation> implementations;  // besides the reference
  Environment reference;
  std::vector<std::string> filters;  // parts of names; empty: all
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

// Throws std::runtime_error when the driver cannot be measured.
Comparison compareAll(const Plan& plan);

// Frames of the demos: their errors away from edges, by RMS. The rooms program must be built.
std::vector<Row> compareDemos(const Plan& plan);

bool wanted(const Plan& plan, const std::string& name);
Environment withoutCaches(Environment environment);
// The reference, the others, then their errors, as far as the plan asks for pictures.
void writePictures(const Plan& plan, const Row& row, const Picture& reference);

// Of the extremes: whether ours is further from the reference than Mesa by more than the rounding of the
// framebuffer.
bool mesaIsExacter(const Row& row);

// Sum of what the reader wants to know first.
std::string asTable(const Comparison& comparison, const Plan& plan);
std::string asCsv(const std::vector<Row>& rows, const Plan& plan);
std::string asJson(const std::vector<Row>& rows, const Plan& plan);

}  // namespace comparison
