// The integrators of the Water demo's springs, against the exact motion of the sheet's eigenmodes.
#include "water/springs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "water/study.h"

namespace {

using water::Integrator;
using water::SpringConstants;
using water::Springs;
using water::SpringState;

constexpr std::array kIntegrators = {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                     Integrator::ImplicitEuler};

// Heights and velocities without any symmetry.
SpringState unevenState(int side) {
  SpringState state;
  for (int i = 0; i < side * side; ++i) {
    state.heights.push_back(std::sin(1.3 * i) + 0.2 * std::cos(0.37 * i * i));
    state.velocities.push_back(std::cos(2.1 * i));
  }
  return state;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (double v : values) result = std::isfinite(v) ? std::max(result, std::abs(v)) : INFINITY;
  return result;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

// The fastest of the eigenmodes, which grows first.
SpringState fastestMode(int side) {
  SpringState state;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double turn = M_PI * (side - 1) / side;
      state.heights.push_back(std::cos(turn * (row + 0.5)) * std::cos(turn * (column + 0.5)));
    }
  }
  state.velocities.assign(state.heights.size(), 0.0);
  return state;
}

double errorAfterASecond(Integrator integrator, int steps) {
  const SpringConstants constants{8, 20, 0.5};
  Springs springs(constants);
  SpringState state = unevenState(constants.side);
  const water::ExactSprings exact(constants, state);
  for (int i = 0; i < steps; ++i) springs.step(integrator, 1.0 / steps, state);
  return largestDifference(state.heights, exact.heightsAt(1));
}

TEST(Springs, ExactMotionStartsWhereItIsPut) {
  const SpringConstants constants{7, 50, 0.3};
  const SpringState start = unevenState(constants.side);
  EXPECT_LT(largestDifference(water::ExactSprings(constants, start).heightsAt(0), start.heights), 1e-12);
}

// h'' + c h' + k L h = 0 by central differences of the exact heights.
TEST(Springs, ExactMotionObeysItsEquation) {
  for (double damping : {0.0, 0.5, 40.0}) {  // none, some, more than the slow modes can swing with
    SCOPED_TRACE(damping);
    const SpringConstants constants{5, 30, damping};
    const water::ExactSprings exact(constants, unevenState(constants.side));
    constexpr double kStep = 1e-4;
    const std::vector<double> before = exact.heightsAt(0.2 - kStep);
    const std::vector<double> now = exact.heightsAt(0.2);
    const std::vector<double> after = exact.heightsAt(0.2 + kStep);
    for (int row = 0; row < constants.side; ++row) {
      for (int column = 0; column < constants.side; ++column) {
        const auto at = [&](int c, int r) {
          return now[static_cast<std::size_t>(std::clamp(r, 0, 4) * 5 + std::clamp(c, 0, 4))];
        };
        const auto i = static_cast<std::size_t>(row * 5 + column);
        const double pull = 4 * at(column, row) - at(column - 1, row) - at(column + 1, row) -
                            at(column, row - 1) - at(column, row + 1);
        const double rate = (after[i] - before[i]) / (2 * kStep);
        const double bend = (after[i] - 2 * now[i] + before[i]) / (kStep * kStep);
        EXPECT_NEAR(bend + damping * rate + constants.stiffness * pull, 0, 2e-3);
      }
    }
  }
}

TEST(Springs, EachIntegratorIsOfFirstOrder) {
  for (Integrator integrator : kIntegrators) {
    SCOPED_TRACE(water::nameOf(integrator));
    const double coarse = errorAfterASecond(integrator, 4000);
    const double fine = errorAfterASecond(integrator, 8000);
    // w h t / 2 of the amplitude, for the fastest mode, w = 8 k.
    EXPECT_LT(fine, 160.0 / 8000 / 2 * 1.3);
    EXPECT_NEAR(coarse / fine, 2.0, 0.1);
  }
}

TEST(Springs, GrowBeyondTheStableStepAndNotBelow) {
  for (double stiffness : {10.0, 1e4, 1e6}) {
    for (Integrator integrator : {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler}) {
      SCOPED_TRACE(testing::Message() << water::nameOf(integrator) << " at " << stiffness);
      const auto heightAfter = [&](double share) {
        Springs springs({6, stiffness, std::sqrt(stiffness) / 2});  // a mode grows or fades soon
        SpringState state = fastestMode(6);
        const double step = share * springs.stableStep(integrator);
        for (int i = 0; i < 20000; ++i) springs.step(integrator, step, state);
        return largest(state.heights);
      };
      EXPECT_LE(heightAfter(0.98), 1.0);
      EXPECT_GT(heightAfter(1.02), 1.0);
    }
  }
}

TEST(Springs, ImplicitEulerNeverGrows) {
  for (double stiffness = 10; stiffness < 2e6; stiffness *= 10) {
    for (double step : {1.0 / 240, 1.0 / 15, 10.0}) {
      SCOPED_TRACE(testing::Message() << stiffness << ", step " << step);
      Springs springs({12, stiffness, 0.0});
      SpringState state = unevenState(12);
      state.velocities.assign(state.velocities.size(), 0.0);
      const double start = largest(state.heights);
      for (int i = 0; i < 30; ++i) springs.step(Integrator::ImplicitEuler, step, state);
      EXPECT_LE(largest(state.heights), 2 * start);  // modes add up differently, none of them grows
      EXPECT_LT(largest(state.velocities), INFINITY);
    }
  }
}

// One implicit step by its definition: the rates at the end.
TEST(Springs, ImplicitStepSolvesItsEquation) {
  for (double stiffness : {10.0, 1e6}) {
    SCOPED_TRACE(stiffness);
    constexpr double kStep = 1.0 / 15;
    const SpringConstants constants{9, stiffness, 0.7};
    Springs springs(constants);
    const SpringState before = unevenState(constants.side);
    SpringState after = before;
    springs.step(Integrator::ImplicitEuler, kStep, after);
    const auto at = [&](int c, int r) {
      return after.heights[static_cast<std::size_t>(std::clamp(r, 0, 8) * 9 + std::clamp(c, 0, 8))];
    };
    for (int row = 0; row < 9; ++row) {
      for (int column = 0; column < 9; ++column) {
        const auto i = static_cast<std::size_t>(row * 9 + column);
        EXPECT_NEAR(after.heights[i], before.heights[i] + kStep * after.velocities[i], 1e-12);
        const double pull = 4 * at(column, row) - at(column - 1, row) - at(column + 1, row) -
                            at(column, row - 1) - at(column, row + 1);
        const double force = stiffness * pull + constants.damping * after.velocities[i];
        EXPECT_NEAR(after.velocities[i], before.velocities[i] - kStep * force,
                    1e-5 * std::max(1.0, std::sqrt(stiffness)));
      }
    }
  }
}

// Springs between masses cannot move the middle of all of them.
TEST(Springs, KeepTheMeanHeight) {
  for (Integrator integrator : kIntegrators) {
    SCOPED_TRACE(water::nameOf(integrator));
    Springs springs({10, 50, 0.0});
    SpringState state = unevenState(10);
    state.velocities.assign(100, 0.0);
    const double before = std::accumulate(state.heights.begin(), state.heights.end(), 0.0);
    for (int i = 0; i < 200; ++i) springs.step(integrator, 1e-3, state);
    EXPECT_NEAR(std::accumulate(state.heights.begin(), state.heights.end(), 0.0), before, 1e-8);
  }
}

TEST(Springs, StudyTellsStableFromUnstable) {
  const water::StudyEntry stiff = water::studyOne({16, 1e6, 0.5}, Integrator::SemiImplicitEuler, 1.0 / 60);
  EXPECT_FALSE(stiff.stable);
  EXPECT_GT(stiff.step, stiff.stableStep);
  const water::StudyEntry soft = water::studyOne({16, 10, 0.5}, Integrator::SemiImplicitEuler, 1.0 / 240);
  EXPECT_TRUE(soft.stable);
  EXPECT_LT(soft.error, 0.01);
  const water::StudyEntry implicit = water::studyOne({16, 1e6, 0.5}, Integrator::ImplicitEuler, 1.0 / 15);
  EXPECT_TRUE(implicit.stable);
  EXPECT_LT(implicit.error, 1.5);
}

}  // namespace
