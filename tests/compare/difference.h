// How far a picture is from the reference, pixel by pixel. Errors are in 1/255.
#pragma once

#include <string>
#include <vector>

#include "tests/measure/picture.h"

namespace comparison {

using measure::Picture;

// The reference's picture, and what it may become when rounding moves geometry by one unit of the sub-pixel
// grid: per pixel and channel the least and the greatest of its pictures with everything moved that rounding
// may move (variants). A pixel whose range is wider than a step is an edge pixel: on which side of an edge
// its sample lies is a matter of rounding. Every other pixel is an interior one.
class Expectation {
 public:
  // The pictures of all variants, the unmoved first; they must be of one size.
  explicit Expectation(std::vector<Picture> pictures);
  const Picture& picture() const { return picture_; }
  bool edge(std::size_t pixel) const;
  // How far outside the range of the channel a value is.
  int outside(std::size_t channel, int value) const;

 private:
  Picture picture_;
  std::vector<std::uint8_t> least_, greatest_;
};

struct Difference {
  bool present = false;  // there is a picture of the right size
  int worst = 0;         // of an interior pixel's channel
  double rms = 0;        // over the channels of the interior pixels
  int x = 0, y = 0;      // where the worst is
  int edgePixels = 0;
  int coverage = 0;      // edge pixels that differ by more than a step
  int worstOutside = 0;  // of an edge pixel: how far it is from all that the edge may make of it
};

Difference difference(const Expectation& expected, const Picture& actual);

// Interior pixels that differ by more than `steps`.
int disagreements(const Expectation& expected, const Picture& a, const Picture& b, int steps);

}  // namespace comparison
