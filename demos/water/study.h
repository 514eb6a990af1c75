// How exact and how dear the integrators of the spring sheet are.
#pragma once

#include <string>
#include <vector>

#include "room/plot.h"
#include "springs.h"

namespace water {

struct StudyEntry {
  Integrator integrator;
  double stiffness;  // 1/s^2
  double step;       // seconds
  double error;    // RMS of the heights' error over that of the exact heights; infinite where they flew apart
  double runTime;  // of a processor, milliseconds for kStudySeconds
  double stableStep;  // seconds
  bool stable;        // as it was seen: never higher than ten times the start
};

inline constexpr double kStudySeconds = 2;

// All three integrators at stiffnesses 10 to 10^6 and steps of 1/240 to 1/15 s, against the exact motion of
// the same sheet.
std::vector<StudyEntry> studyIntegrators(int side = 32, double damping = 0.5);
// One of them.
StudyEntry studyOne(const SpringConstants& constants, Integrator integrator, double step);
std::string studyTable(const std::vector<StudyEntry>& study);
room::Plot plotOf(const std::vector<StudyEntry>& study);

}  // namespace water
