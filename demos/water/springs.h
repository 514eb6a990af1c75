// A sheet of masses that springs tie to their neighbours: heights h with h'' = -k L h - c h', where L sums
// the differences to the neighbours. Its edges are free.
#pragma once

#include <string_view>
#include <vector>

namespace water {

enum class Integrator { ExplicitEuler, SemiImplicitEuler, ImplicitEuler };
std::string_view nameOf(Integrator integrator);

struct SpringConstants {
  int side = 64;           // masses along each edge, two at least
  double stiffness = 180;  // k, of a spring over a mass, 1/s^2
  double damping = 1;      // c, 1/s
};

// Heights and velocities, rows one after another.
struct SpringState {
  std::vector<double> heights;     // metres
  std::vector<double> velocities;  // metres a second
};

class Springs {
 public:
  explicit Springs(const SpringConstants& constants);
  const SpringConstants& constants() const { return constants_; }
  // Moves the state by one step of so many seconds. Explicit Euler takes both rates at the step's start;
  // semi-implicit Euler moves heights by the velocities at its end; implicit Euler takes both rates at the
  // end, and finds them by conjugate gradients.
  void step(Integrator integrator, double seconds, SpringState& state);
  // Steps up to this length do not make the sheet's fastest mode grow; infinite for implicit Euler.
  double stableStep(Integrator integrator) const;

 private:
  void laplacian(const std::vector<double>& heights, std::vector<double>& out) const;
  // Of forces_, the differences' sums.
  void addForces(double seconds, std::vector<double>& velocities) const;
  void solveImplicit(double seconds, SpringState& state);

  SpringConstants constants_;
  std::vector<double> forces_, residual_, direction_, product_;
};

// The exact motion, by the eigenmodes of the sheet: cosines, each an oscillator of its own.
class ExactSprings {
 public:
  ExactSprings(const SpringConstants& constants, const SpringState& start);
  std::vector<double> heightsAt(double seconds) const;

 private:
  // Between places and modes along both axes.
  std::vector<double> transformed(const std::vector<double>& values, bool toModes) const;

  SpringConstants constants_;
  std::vector<double> basis_;  // mode after mode, orthonormal
  std::vector<double> heights_;
  std::vector<double> velocities_;
};

}  // namespace water
