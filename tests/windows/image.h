// Pictures of windows: 8 bits a channel, lower left origin as glReadPixels gives them, alpha left out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace windows {

using Rgb = std::array<std::uint8_t, 3>;

struct Image {
  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
  Rgb& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Rgb& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  // The part that begins at (x, y), inside the image.
  Image part(int x, int y, int w, int h) const;

  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

// The greatest difference of a channel, and where it is; sizes must be equal.
struct Difference {
  int most = 0, x = 0, y = 0;
  std::size_t pixels = 0;  // how many differ by more than the tolerance
};
Difference difference(const Image& a, const Image& b, int tolerance);

}  // namespace windows
