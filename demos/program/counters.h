// What the program itself hands to GL, counted between it and whichever library answers.
#pragma once

#include <cstdint>

namespace program {

struct Counters {
  std::uint64_t draws = 0;
  std::uint64_t vertices = 0;  // or indices, where there are
  std::uint64_t clears = 0;
  std::uint64_t textureBinds = 0;
  std::uint64_t matrixLoads = 0;
  std::uint64_t uploads = 0;        // calls that define textures or buffers
  std::uint64_t uploadedBytes = 0;  // by those calls; arrays in the program's memory are not counted
};

// Since the process began.
const Counters& counted();
Counters operator-(const Counters& a, const Counters& b);

}  // namespace program
