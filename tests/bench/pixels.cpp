#include "pixels.h"

#include <GLES/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "session.h"

namespace bench {

Picture::Picture() : texels_(std::size_t{4} * kWidth * kHeight) {
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, texels_.data());
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    firstFault_ = fmt::format("GL error 0x{:04x}", error);
    faults_ = 1;
  }
}

void Picture::expect(int x, int y, Rgb wanted, int tolerance) {
  const std::uint8_t* seen = &texels_[std::size_t{4} * (std::size_t(y) * kWidth + std::size_t(x))];
  int error = 0;
  for (std::size_t channel = 0; channel < 3; ++channel)
    error = std::max(error, std::abs(int{seen[channel]} - wanted[channel]));
  error_ = std::max(error_, error);
  if (error <= tolerance) return;
  if (faults_++ == 0)
    firstFault_ = fmt::format("pixel ({}, {}) is ({}, {}, {}), should be ({}, {}, {})", x, y, seen[0],
                              seen[1], seen[2], wanted[0], wanted[1], wanted[2]);
}

Verdict Picture::verdict() const {
  if (faults_ < 2) return {firstFault_, error_};
  return {fmt::format("{} (and {} more)", firstFault_, faults_ - 1), error_};
}

Rgb variedColor(unsigned n) {
  return {int(n * 37 % 200) + 55, int(n * 101 % 200) + 55, int(n * 211 % 200) + 55};
}

}  // namespace bench
