#include "pond.h"

#include <algorithm>
#include <cmath>

#include "room/noise.h"
#include "set/measures.h"

namespace water {
namespace {

constexpr int kStepsASecond = 120;
// After so many seconds nothing is left of a drop that could be seen: exp(-kDamping / 2 * kMemory).
constexpr int kMemory = 16;
constexpr double kDamping = 1.0;
constexpr double kPeriod = 4096;   // seconds after which the drops repeat
constexpr double kHighest = 0.12;  // metres that are drawn of a sheet that flies apart

}  // namespace

Pond::Pond(Integrator integrator, double stiffness)
    : integrator_(integrator), springs_({kLattice, stiffness, kDamping}) {}

void Pond::start(long long second) {
  state_.heights.assign(latticeIndex(0, kLattice), 0.0);
  state_.velocities = state_.heights;
  first_ = second;
  steps_ = 0;
}

// Pushes a hollow down, and a rim about it up, as much.
void Pond::drop(long long which) {
  const int number = static_cast<int>(which);
  const glm::dvec2 place =
      (glm::dvec2(room::hash(number, 0, 960), room::hash(number, 1, 960)) * 1.6 - 0.8) * kPoolHalf;
  const double speed = 0.9 + 0.9 * room::hash(number, 2, 960);
  constexpr double kRadius = 0.15;  // metres
  for (int row = 0; row < kLattice; ++row) {
    for (int column = 0; column < kLattice; ++column) {
      const double r = glm::distance(latticePoint(column, row), place) / kRadius;
      state_.velocities[latticeIndex(column, row)] -= speed * (1 - r * r) * std::exp(-r * r);
    }
  }
}

void Pond::heightsAt(double time, Heights& out) {
  const double wrapped = time - std::floor(time / kPeriod) * kPeriod;
  const auto second = static_cast<long long>(wrapped);
  const auto wanted = static_cast<long long>((wrapped - static_cast<double>(second)) * kStepsASecond) +
                      kMemory * kStepsASecond;
  if (steps_ < 0 || first_ != second - kMemory || steps_ > wanted) start(second - kMemory);
  for (; steps_ < wanted; ++steps_) {
    if (steps_ % (kStepsASecond / 2) == 0) drop(2 * first_ + steps_ / (kStepsASecond / 2));
    springs_.step(integrator_, 1.0 / kStepsASecond, state_);
  }
  out.resize(state_.heights.size());
  std::transform(state_.heights.begin(), state_.heights.end(), out.begin(), [](double height) {
    return std::isfinite(height) ? std::clamp(height, -kHighest, kHighest) : 0.0;
  });
}

}  // namespace water
