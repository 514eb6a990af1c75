#include "waves.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace water {
namespace {

struct Wave {
  double heading;    // radians from x towards z
  double length;     // metres
  double amplitude;  // metres
};
constexpr std::array<Wave, 6> kWaves = {{{0.3, 1.90, 0.0100},
                                         {1.4, 1.30, 0.0075},
                                         {-0.5, 0.92, 0.0054},
                                         {2.3, 0.71, 0.0036},
                                         {0.9, 0.52, 0.0022},
                                         {-1.3, 0.43, 0.0013}}};

}  // namespace

void waveHeights(double time, Heights& out) {
  constexpr double kGravity = 9.81;
  out.assign(latticeIndex(0, kLattice), 0.0);
  int number = 0;
  for (const Wave& wave : kWaves) {
    const double k = glm::two_pi<double>() / wave.length;
    const glm::dvec2 direction = k * glm::dvec2(std::cos(wave.heading), std::sin(wave.heading));
    // Long waves are faster in deep water; a third of nature's speed is calm enough for a court.
    const double phase = std::sqrt(kGravity * k) * time * 0.35 + 1.7 * number;
    const bool sine = ++number % 2 != 0;
    for (int row = 0; row < kLattice; ++row) {
      for (int column = 0; column < kLattice; ++column) {
        const double at = glm::dot(direction, latticePoint(column, row)) - phase;
        out[latticeIndex(column, row)] += wave.amplitude * (sine ? std::sin(at) : std::cos(at));
      }
    }
  }
}

}  // namespace water
