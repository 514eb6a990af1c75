#include "difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace comparison {

Expectation::Expectation(std::vector<Picture> pictures) {
  if (pictures.empty()) return;
  least_ = greatest_ = pictures.front().rgba;
  for (const Picture& picture : pictures) {
    for (std::size_t i = 0; i < least_.size() && i < picture.rgba.size(); ++i) {
      least_[i] = std::min(least_[i], picture.rgba[i]);
      greatest_[i] = std::max(greatest_[i], picture.rgba[i]);
    }
  }
  picture_ = std::move(pictures.front());
}

bool Expectation::edge(std::size_t pixel) const {
  for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
    if (greatest_[i] - least_[i] > 1) return true;
  return false;
}

int Expectation::outside(std::size_t channel, int value) const {
  return std::max({0, least_[channel] - value, value - greatest_[channel]});
}

Difference difference(const Expectation& expected, const Picture& actual) {
  Difference result;
  const Picture& reference = expected.picture();
  if (actual.rgba.empty() || actual.rgba.size() != reference.rgba.size() || actual.width != reference.width)
    return result;
  result.present = true;
  double squares = 0;
  std::size_t interior = 0;
  for (std::size_t pixel = 0; pixel < reference.rgba.size() / 4; ++pixel) {
    int worst = 0, outside = 0;
    const bool edge = expected.edge(pixel);
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
      const int error = std::abs(int{actual.rgba[i]} - int{reference.rgba[i]});
      worst = std::max(worst, error);
      outside = std::max(outside, expected.outside(i, actual.rgba[i]));
      if (!edge) squares += error * error;
    }
    if (edge) {
      ++result.edgePixels;
      result.coverage += worst > 1;
      result.worstOutside = std::max(result.worstOutside, outside);
      continue;
    }
    ++interior;
    if (worst > result.worst) {
      result.worst = worst;
      result.x = static_cast<int>(pixel) % reference.width;
      result.y = static_cast<int>(pixel) / reference.width;
    }
  }
  if (interior > 0) result.rms = std::sqrt(squares / (4.0 * static_cast<double>(interior)));
  return result;
}

int disagreements(const Expectation& expected, const Picture& a, const Picture& b, int steps) {
  if (a.rgba.size() != b.rgba.size()) return 0;
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size() / 4; ++pixel) {
    if (expected.edge(pixel)) continue;
    int worst = 0;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
      worst = std::max(worst, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
    count += worst > steps;
  }
  return count;
}

}  // namespace comparison
