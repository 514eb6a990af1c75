#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bench {

using Rgb = std::array<int, 3>;  // 0..255

// What a picture is worth.
struct Verdict {
  std::string fault;  // empty when it is right
  int error = 0;      // the greatest difference of a channel, in steps of 1/255
};

// The frame as it was rendered, read back once, and what is wrong with it.
class Picture {
 public:
  Picture();  // reads the current framebuffer; takes GL errors as faults

  // (x, y) counts from the lower left corner; each channel may differ by `tolerance`.
  void expect(int x, int y, Rgb wanted, int tolerance = 1);
  // The first fault and their number.
  Verdict verdict() const;

 private:
  std::vector<std::uint8_t> texels_;
  std::string firstFault_;
  int faults_ = 0;
  int error_ = 0;
};

// A colour that differs for neighbouring n, exact in 8 bits.
Rgb variedColor(unsigned n);

}  // namespace bench
