#include "image.h"

#include <algorithm>
#include <cstdlib>

namespace windows {

Image Image::part(int x, int y, int w, int h) const {
  Image result(w, h);
  for (int row = 0; row < h; ++row) std::copy_n(&at(x, y + row), w, &result.at(0, row));
  return result;
}

Difference difference(const Image& a, const Image& b, int tolerance) {
  Difference result;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      int here = 0;
      for (std::size_t i = 0; i < 3; ++i) here = std::max(here, std::abs(a.at(x, y)[i] - b.at(x, y)[i]));
      result.pixels += here > tolerance;
      if (here > result.most) {
        result.most = here;
        result.x = x;
        result.y = y;
      }
    }
  }
  return result;
}

}  // namespace windows
