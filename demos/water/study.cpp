#include "study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>

namespace water {
namespace {

constexpr std::array kIntegrators = {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                     Integrator::ImplicitEuler};
constexpr int kSamplesASecond = 15;  // every step divides the time between two
constexpr double kFlownApart = 10;   // times the height at the start

// A smooth hill off the middle.
SpringState hill(int side) {
  SpringState state;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / side - 0.4;
      const double y = (row + 0.5) / side - 0.55;
      state.heights.push_back(std::exp(-(x * x + y * y) / 0.02));
    }
  }
  state.velocities.assign(state.heights.size(), 0.0);
  return state;
}

double squareSum(const std::vector<double>& v) {
  double sum = 0;
  for (double x : v) sum += x * x;
  return sum;
}

// Of a processor, which other programs do not add to.
double threadMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

bool flownApart(const SpringState& state) {
  return std::any_of(state.heights.begin(), state.heights.end(),
                     [](double h) { return !(std::abs(h) < kFlownApart); });
}

}  // namespace

StudyEntry studyOne(const SpringConstants& constants, Integrator integrator, double step) {
  Springs springs(constants);
  SpringState state = hill(constants.side);
  const ExactSprings exact(constants, state);
  StudyEntry entry{integrator, constants.stiffness, step, 0, 0, springs.stableStep(integrator), true};
  const int steps = static_cast<int>(std::lround(1 / (step * kSamplesASecond)));
  const int samples = static_cast<int>(kStudySeconds * kSamplesASecond);
  double wrong = 0;
  double whole = 0;
  for (int sample = 1; sample <= samples; ++sample) {
    const double begin = threadMilliseconds();
    for (int i = 0; i < steps; ++i) springs.step(integrator, step, state);
    entry.runTime += threadMilliseconds() - begin;
    if (flownApart(state)) entry.stable = false;
    std::vector<double> truth = exact.heightsAt(static_cast<double>(sample) / kSamplesASecond);
    whole += squareSum(truth);
    for (std::size_t i = 0; i < truth.size(); ++i) truth[i] -= state.heights[i];
    wrong += squareSum(truth);
  }
  const double error = std::sqrt(wrong / whole);
  entry.error = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
  return entry;
}

std::vector<StudyEntry> studyIntegrators(int side, double damping) {
  std::vector<StudyEntry> study;
  for (double stiffness = 10; stiffness < 2e6; stiffness *= 10) {
    for (int rate : {240, 120, 60, 30, 15}) {
      for (Integrator integrator : kIntegrators) {
        study.push_back(studyOne({side, stiffness, damping}, integrator, 1.0 / rate));
      }
    }
  }
  return study;
}

std::string studyTable(const std::vector<StudyEntry>& study) {
  std::string text = fmt::format(
      "A sheet of springs for {:g} s: RMS error over the exact heights, ms of a processor, and the longest "
      "step that\n"
      "keeps every mode from growing. ~: the step is longer; !: the sheet flew apart.\n\n{:>9} {:>6}",
      kStudySeconds, "stiffness", "step");
  for (Integrator integrator : kIntegrators) text += fmt::format(" | {:^29}", nameOf(integrator));
  for (std::size_t i = 0; i < study.size(); ++i) {
    const StudyEntry& e = study[i];
    if (i % kIntegrators.size() == 0)
      text += fmt::format("\n{:>9g} {:>6}", e.stiffness, fmt::format("1/{:.0f}", 1 / e.step));
    text += fmt::format(" | {:>9.3g}{} {:>8.2f} {:>9}", e.error,
                        !e.stable               ? '!'
                        : e.step > e.stableStep ? '~'
                                                : ' ',
                        e.runTime,
                        std::isfinite(e.stableStep) ? fmt::format("1/{:.0f}", 1 / e.stableStep) : "any");
  }
  return text + "\n";
}

room::Plot plotOf(const std::vector<StudyEntry>& study) {
  // What flew apart is shown as a cross here.
  constexpr double kWorst = 100;
  constexpr std::array<glm::vec3, 3> kColors = {
      {{0.80F, 0.22F, 0.18F}, {0.15F, 0.45F, 0.75F}, {0.20F, 0.58F, 0.30F}}};
  room::Plot plot;
  plot.title = "Springs: error against run time";
  plot.yLabel = "Error over the exact heights (crosses flew apart)";
  plot.xLabel = fmt::format("ms for {:g} s", kStudySeconds);
  for (std::size_t i = 0; i < kIntegrators.size(); ++i) {
    plot.legend.push_back({kColors[i], std::string(nameOf(kIntegrators[i]))});
    // A line a stiffness, along its steps.
    for (double stiffness = 10; stiffness < 2e6; stiffness *= 10) {
      room::PlotSeries series{kColors[i], {}};
      for (const StudyEntry& e : study) {
        if (e.integrator != kIntegrators[i] || e.stiffness != stiffness) continue;
        series.points.push_back(
            {e.runTime, std::min(e.error, kWorst), e.stable ? room::Marker::Disc : room::Marker::Cross});
      }
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

}  // namespace water
