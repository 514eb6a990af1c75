// Tileable noise: every function repeats after `periodX` x `periodY` lattice cells, so textures wrap.
#pragma once

#include <cstdint>

namespace room {

// A number in [0,1) that depends on nothing but its arguments.
double hash(int x, int y, std::uint32_t seed);

// Gradient noise in about [-1,1].
double noise(double x, double y, int periodX, int periodY, std::uint32_t seed);

// Octaves of noise over u, v in [0,1), each with half the amplitude and double the frequency; about [-1,1].
double fractalNoise(double u, double v, int cellsX, int cellsY, int octaves, std::uint32_t seed);

struct CellDistance {
  double nearest;   // to the nearest of the scattered points, in cells
  double second;    // to the next
  double identity;  // in [0,1), one number a cell
};
CellDistance cellNoise(double u, double v, int cellsX, int cellsY, std::uint32_t seed);

double smoothStep(double edge0, double edge1, double x);

// 1 at the middle, falling off on both sides: exp(-((x - middle) / width)^2).
double bell(double x, double middle, double width);

// What x has over the next lower whole number, in [0,1).
double fractionOf(double x);

}  // namespace room
