#include "springs.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numeric>

namespace water {
namespace {

std::size_t countOf(const SpringConstants& constants) {
  return static_cast<std::size_t>(constants.side) * static_cast<std::size_t>(constants.side);
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Of the springs along one axis.
double eigenvalue(int mode, int side) {
  return 2 - 2 * std::cos(glm::pi<double>() * mode / side);
}

// x(t) of x'' = -w x - c x'.
double oscillator(double w, double c, double x, double v, double t) {
  const double lean = v + c * x / 2;
  const double under = w - c * c / 4;
  const double root = std::sqrt(std::abs(under));
  const double decay = std::exp(-c * t / 2);
  if (root * t < 1e-9) return decay * (x + lean * t);
  if (under > 0) return decay * (x * std::cos(root * t) + lean * std::sin(root * t) / root);
  // As two exponentials, for either hyperbolic function alone may be beyond any number.
  const double slow = std::exp((root - c / 2) * t) / 2;
  const double fast = std::exp((-root - c / 2) * t) / 2;
  return x * (slow + fast) + lean * (slow - fast) / root;
}

}  // namespace

std::string_view nameOf(Integrator integrator) {
  switch (integrator) {
    case Integrator::ExplicitEuler:
      return "explicit";
    case Integrator::SemiImplicitEuler:
      return "semi-implicit";
    case Integrator::ImplicitEuler:
      break;
  }
  return "implicit";
}

Springs::Springs(const SpringConstants& constants)
    : constants_(constants),
      forces_(countOf(constants)),
      residual_(countOf(constants)),
      direction_(countOf(constants)),
      product_(countOf(constants)) {}

// Sum of the differences to the up to four neighbours.
void Springs::laplacian(const std::vector<double>& heights, std::vector<double>& out) const {
  const auto side = static_cast<std::size_t>(constants_.side);
  for (std::size_t row = 0; row < side; ++row) {
    const double* here = heights.data() + row * side;
    const double* below = row > 0 ? here - side : here;
    const double* above = row + 1 < side ? here + side : here;
    double* to = out.data() + row * side;
    for (std::size_t i = 0; i < side; ++i) {
      const double left = here[i > 0 ? i - 1 : i];
      const double right = here[i + 1 < side ? i + 1 : i];
      to[i] = 4 * here[i] - left - right - below[i] - above[i];
    }
  }
}

void Springs::addForces(double seconds, std::vector<double>& velocities) const {
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    velocities[i] -= seconds * (constants_.stiffness * forces_[i] + constants_.damping * velocities[i]);
  }
}

void Springs::step(Integrator integrator, double seconds, SpringState& state) {
  const auto move = [&] {
    for (std::size_t i = 0; i < state.heights.size(); ++i) state.heights[i] += seconds * state.velocities[i];
  };
  switch (integrator) {
    case Integrator::ExplicitEuler:
      laplacian(state.heights, forces_);
      move();
      addForces(seconds, state.velocities);
      break;
    case Integrator::SemiImplicitEuler:
      laplacian(state.heights, forces_);
      addForces(seconds, state.velocities);
      move();
      break;
    case Integrator::ImplicitEuler:
      solveImplicit(seconds, state);
      move();
      break;
  }
}

// (1 + c s + k s^2 L) v' = v - k s L h, where s is the step; v is the first guess.
void Springs::solveImplicit(double seconds, SpringState& state) {
  constexpr double kTolerance = 1e-10;  // of the right-hand side
  const double diagonal = 1 + constants_.damping * seconds;
  const double spring = constants_.stiffness * seconds;
  std::vector<double>& v = state.velocities;
  const auto multiply = [&](const std::vector<double>& from, std::vector<double>& to) {
    laplacian(from, to);
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = diagonal * from[i] + spring * seconds * to[i];
  };
  laplacian(state.heights, forces_);
  multiply(v, product_);
  double scale = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double wanted = v[i] - spring * forces_[i];
    scale += wanted * wanted;
    residual_[i] = wanted - product_[i];
  }
  direction_ = residual_;
  double squared = dot(residual_, residual_);
  for (std::size_t i = 0; i < v.size() && squared > kTolerance * kTolerance * scale; ++i) {
    multiply(direction_, product_);
    const double along = squared / dot(direction_, product_);
    for (std::size_t k = 0; k < v.size(); ++k) {
      v[k] += along * direction_[k];
      residual_[k] -= along * product_[k];
    }
    const double next = dot(residual_, residual_);
    for (std::size_t k = 0; k < v.size(); ++k) direction_[k] = residual_[k] + next / squared * direction_[k];
    squared = next;
  }
}

// For each mode x'' = -w x - c x' a step multiplies (x, x') by a matrix; this is where the larger of its
// eigenvalues' sizes becomes 1, for the mode with the largest w.
double Springs::stableStep(Integrator integrator) const {
  const double w = 2 * constants_.stiffness * eigenvalue(constants_.side - 1, constants_.side);
  const double c = constants_.damping;
  switch (integrator) {
    case Integrator::ExplicitEuler:
      return c / w;
    case Integrator::SemiImplicitEuler:
      return (std::sqrt(c * c + 4 * w) - c) / w;
    case Integrator::ImplicitEuler:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

ExactSprings::ExactSprings(const SpringConstants& constants, const SpringState& start)
    : constants_(constants) {
  const int side = constants.side;
  for (int mode = 0; mode < side; ++mode) {
    const double length = std::sqrt((mode == 0 ? 1.0 : 2.0) / side);
    for (int i = 0; i < side; ++i)
      basis_.push_back(length * std::cos(glm::pi<double>() * mode * (i + 0.5) / side));
  }
  heights_ = transformed(start.heights, true);
  velocities_ = transformed(start.velocities, true);
}

std::vector<double> ExactSprings::transformed(const std::vector<double>& values, bool toModes) const {
  const auto side = static_cast<std::size_t>(constants_.side);
  const auto weight = [&](std::size_t to, std::size_t from) {
    return toModes ? basis_[to * side + from] : basis_[from * side + to];
  };
  std::vector<double> half(values.size());
  std::vector<double> whole(values.size());
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t to = 0; to < side; ++to) {
      for (std::size_t from = 0; from < side; ++from)
        half[row * side + to] += weight(to, from) * values[row * side + from];
    }
  }
  for (std::size_t to = 0; to < side; ++to) {
    for (std::size_t from = 0; from < side; ++from) {
      for (std::size_t i = 0; i < side; ++i) whole[to * side + i] += weight(to, from) * half[from * side + i];
    }
  }
  return whole;
}

std::vector<double> ExactSprings::heightsAt(double seconds) const {
  std::vector<double> modes(heights_.size());
  for (int row = 0; row < constants_.side; ++row) {
    for (int column = 0; column < constants_.side; ++column) {
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(constants_.side) +
                     static_cast<std::size_t>(column);
      const double w =
          constants_.stiffness * (eigenvalue(row, constants_.side) + eigenvalue(column, constants_.side));
      modes[i] = oscillator(w, constants_.damping, heights_[i], velocities_[i], seconds);
    }
  }
  return transformed(modes, false);
}

}  // namespace water
