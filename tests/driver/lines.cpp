// Lines of 26 pixels in all directions, each in a cell of its own.
#include <algorithm>
#include <array>
#include <cmath>

#include "measurements.h"
#include "value_frag.h"

namespace driver {

namespace {

constexpr int kColumns = 6, kCell = 40, kSize = kColumns * kCell;
constexpr double kLength = 25.6;

struct Line {
  double x, y, dx, dy;  // start in pixels, and a unit vector
};

Line line(int i) {
  const double a = 2 * M_PI * i / (kColumns * kColumns) + 0.05, dx = std::cos(a), dy = std::sin(a);
  return {kCell * (i % kColumns + 0.5) + 0.3 - dx * kLength / 2,
          kCell * (i / kColumns + 0.5) - 0.2 - dy * kLength / 2, dx, dy};
}

std::vector<Vertex> lines() {
  std::vector<Vertex> result;
  const auto clip = [](double pixel) { return static_cast<float>(pixel * 2 / kSize - 1); };
  for (int i = 0; i < kColumns * kColumns; ++i) {
    const Line l = line(i);
    result.push_back({{clip(l.x), clip(l.y), 0, 1}, {0, 1, 1, 1}});
    result.push_back({{clip(l.x + l.dx * kLength), clip(l.y + l.dy * kLength), 0, 1}, {1, 1, 1, 1}});
  }
  return result;
}

const Line lineAt(int x, int y) {
  return line(y / kCell * kColumns + x / kCell);
}

// The part of the pixel (x, y) that a line of a width covers, by rows: of each the part that lies between the
// line's sides and between its ends.
double covered(const Line& l, double width, int x, int y) {
  constexpr int kRows = 256;
  double area = 0;
  for (int row = 0; row < kRows; ++row) {
    const double py = y + (row + 0.5) / kRows - l.y;
    double from = x - l.x, to = from + 1;
    const auto limit = [&](double slope, double start, double low,
                           double high) {  // low <= start + slope * px <= high
      if (std::abs(slope) < 1e-12) {
        if (start < low || start > high) to = from;
        return;
      }
      const double a = (low - start) / slope, b = (high - start) / slope;
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    };
    limit(l.dx, l.dy * py, 0, kLength);
    limit(-l.dy, l.dx * py, -width / 2, width / 2);
    area += std::max(0.0, to - from) / kRows;
  }
  return area;
}

}  // namespace

double lineParameter(Device& device) {
  Draw draw{value_frag, lines(), VK_PRIMITIVE_TOPOLOGY_LINE_LIST};
  if (device.bresenhamLines()) draw.lineMode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  const std::vector<float> pixels = device.render(VK_FORMAT_R8G8B8A8_UNORM, kSize, kSize, {draw});
  double worst = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const auto at = static_cast<std::size_t>(4 * (y * kSize + x));
      if (pixels[at + 1] == 0) continue;
      const Line l = lineAt(x, y);
      const double t = ((x + 0.5 - l.x) * l.dx + (y + 0.5 - l.y) * l.dy) / kLength;
      worst = std::max(worst, std::abs(double(pixels[at]) - std::clamp(t, 0.0, 1.0)));
    }
  }
  return worst;
}

double smoothLineCoverage(Device& device) {
  if (!device.smoothLines()) return 0;
  Draw draw{value_frag, lines(), VK_PRIMITIVE_TOPOLOGY_LINE_LIST};
  draw.lineMode = VK_LINE_RASTERIZATION_MODE_RECTANGULAR_SMOOTH_EXT;
  draw.lineWidth = 2.5f;
  draw.blend = {1,
                VK_BLEND_FACTOR_SRC_ALPHA,
                VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                VK_BLEND_OP_ADD,
                VK_BLEND_FACTOR_ONE,
                VK_BLEND_FACTOR_ZERO,
                VK_BLEND_OP_ADD,
                0};
  const std::vector<float> pixels = device.render(VK_FORMAT_R8G8B8A8_UNORM, kSize, kSize, {draw});
  double worst = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double exact = covered(lineAt(x, y), 2.5, x, y);
      worst = std::max(worst,
                       std::abs(double(pixels[static_cast<std::size_t>(4 * (y * kSize + x) + 1)]) - exact));
    }
  }
  return worst;
}

}  // namespace driver
