#include "noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace room {
namespace {

int wrap(int x, int period) {
  const int r = x % period;
  return r < 0 ? r + period : r;
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

std::uint32_t hashBits(int x, int y, std::uint32_t seed) {
  std::uint32_t h = seed * 0x9E3779B9U + static_cast<std::uint32_t>(x) * 0x85EBCA6BU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU + static_cast<std::uint32_t>(y) * 0xC2B2AE35U;
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return h ^ (h >> 15);
}

double slope(int x, int y, double dx, double dy, std::uint32_t seed) {
  // Eight directions are enough, and cheaper than a sine and a cosine a corner.
  constexpr double kHalf = 0.7071067811865476;
  constexpr std::array<std::array<double, 2>, 8> kDirections = {{{1, 0},
                                                                {kHalf, kHalf},
                                                                {0, 1},
                                                                {-kHalf, kHalf},
                                                                {-1, 0},
                                                                {-kHalf, -kHalf},
                                                                {0, -1},
                                                                {kHalf, -kHalf}}};
  const auto& d = kDirections[hashBits(x, y, seed) & 7U];
  return d[0] * dx + d[1] * dy;
}

}  // namespace

double hash(int x, int y, std::uint32_t seed) { return hashBits(x, y, seed) * (1.0 / 4294967296.0); }

double noise(double x, double y, int periodX, int periodY, std::uint32_t seed) {
  const double floorX = std::floor(x);
  const double floorY = std::floor(y);
  const double dx = x - floorX;
  const double dy = y - floorY;
  const int x0 = wrap(static_cast<int>(floorX), periodX);
  const int y0 = wrap(static_cast<int>(floorY), periodY);
  const int x1 = x0 + 1 == periodX ? 0 : x0 + 1;
  const int y1 = y0 + 1 == periodY ? 0 : y0 + 1;
  const double a = slope(x0, y0, dx, dy, seed);
  const double b = slope(x1, y0, dx - 1, dy, seed);
  const double c = slope(x0, y1, dx, dy - 1, seed);
  const double d = slope(x1, y1, dx - 1, dy - 1, seed);
  const double fx = fade(dx);
  return std::lerp(std::lerp(a, b, fx), std::lerp(c, d, fx), fade(dy)) * 1.414;
}

double fractalNoise(double u, double v, int cellsX, int cellsY, int octaves, std::uint32_t seed) {
  double sum = 0;
  double amplitude = 0.5;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * noise(u * cellsX, v * cellsY, cellsX, cellsY, seed + static_cast<std::uint32_t>(i));
    amplitude *= 0.5;
    cellsX *= 2;
    cellsY *= 2;
  }
  return sum;
}

CellDistance cellNoise(double u, double v, int cellsX, int cellsY, std::uint32_t seed) {
  const double x = u * cellsX;
  const double y = v * cellsY;
  const int cellX = static_cast<int>(std::floor(x));
  const int cellY = static_cast<int>(std::floor(y));
  CellDistance result{1e9, 1e9, 0};
  for (int j = cellY - 1; j <= cellY + 1; ++j) {
    for (int i = cellX - 1; i <= cellX + 1; ++i) {
      const int wx = wrap(i, cellsX);
      const int wy = wrap(j, cellsY);
      const double distance = std::hypot(i + hash(wx, wy, seed) - x, j + hash(wx, wy, seed + 1) - y);
      if (distance < result.nearest) {
        result = {distance, result.nearest, hash(wx, wy, seed + 2)};
      } else {
        result.second = std::min(result.second, distance);
      }
    }
  }
  return result;
}

double smoothStep(double edge0, double edge1, double x) {
  const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace room
