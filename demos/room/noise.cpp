#include "noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace room {
namespace {

// Lattice points lie at most a few periods outside: cheaper than a division.
int wrap(int x, int period) {
  while (x >= period) x -= period;
  while (x < 0) x += period;
  return x;
}

// std::floor is a call where the baseline instruction set has no rounding.
int floorOf(double x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < truncated ? 1 : 0);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

std::uint32_t hashBits(int x, int y, std::uint32_t seed) {
  std::uint32_t h = seed * 0x9E3779B9U + static_cast<std::uint32_t>(x) * 0x85EBCA6BU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU + static_cast<std::uint32_t>(y) * 0xC2B2AE35U;
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return h ^ (h >> 15);
}

// Eight directions are enough, and cheaper than a sine and a cosine a corner.
constexpr double kHalf = 0.7071067811865476;
constexpr std::array<std::array<double, 2>, 8> kDirections = {
    {{1, 0}, {kHalf, kHalf}, {0, 1}, {-kHalf, kHalf}, {-1, 0}, {-kHalf, -kHalf}, {0, -1}, {kHalf, -kHalf}}};

// The bytes 0..255 shuffled: noise asks for four random directions a sample, and two look-ups give one.
std::array<std::uint8_t, 512> makeShuffle() {
  std::array<std::uint8_t, 512> table{};
  for (unsigned i = 0; i < 256; ++i) table[i] = static_cast<std::uint8_t>(i);
  for (unsigned i = 255; i > 0; --i)
    std::swap(table[i], table[hashBits(static_cast<int>(i), 0, 1) % (i + 1)]);
  std::copy_n(table.begin(), 256, table.begin() + 256);
  return table;
}

const std::array<std::uint8_t, 512> kShuffle = makeShuffle();

}  // namespace

double hash(int x, int y, std::uint32_t seed) {
  return hashBits(x, y, seed) * (1.0 / 4294967296.0);
}

double noise(double x, double y, int periodX, int periodY, std::uint32_t seed) {
  const int column = floorOf(x);
  const int row = floorOf(y);
  const double dx = x - column;
  const double dy = y - row;
  const int x0 = wrap(column, periodX);
  const int y0 = wrap(row, periodY);
  const int x1 = x0 + 1 == periodX ? 0 : x0 + 1;
  const int y1 = y0 + 1 == periodY ? 0 : y0 + 1;
  const unsigned offset = seed * 37U;
  const unsigned left = kShuffle[(static_cast<unsigned>(x0) + offset) & 255U];
  const unsigned right = kShuffle[(static_cast<unsigned>(x1) + offset) & 255U];
  const auto slope = [offset](unsigned shuffled, int latticeRow, double toX, double toY) {
    const unsigned index = shuffled + ((static_cast<unsigned>(latticeRow) + (offset >> 8U)) & 255U);
    const auto& d = kDirections[kShuffle[index] & 7U];
    return d[0] * toX + d[1] * toY;
  };
  const double a = slope(left, y0, dx, dy);
  const double b = slope(right, y0, dx - 1, dy);
  const double c = slope(left, y1, dx, dy - 1);
  const double d = slope(right, y1, dx - 1, dy - 1);
  const double fx = fade(dx);
  const double below = a + (b - a) * fx;
  const double above = c + (d - c) * fx;
  return (below + (above - below) * fade(dy)) * 1.414;
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
      const double dx = i + hash(wx, wy, seed) - x;
      const double dy = j + hash(wx, wy, seed + 1) - y;
      const double distance = std::sqrt(dx * dx + dy * dy);
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

double bell(double x, double middle, double width) {
  return std::exp(-((x - middle) / width) * ((x - middle) / width));
}

double fractionOf(double x) {
  return x - std::floor(x);
}

}  // namespace room
