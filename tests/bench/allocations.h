#pragma once

#include <string>
#include <vector>

namespace bench {

// Counts allocations of this whole process, whose malloc this program replaces, by the library that asks for
// them. What drivers (libvulkan*, libLLVM*, libVkLayer*) ask for is left out.
void beginCountingAllocations();

struct AllocationCount {
  unsigned number = 0;
  std::vector<std::string> callers;  // of the first few: library and symbol or offset
};

AllocationCount endCountingAllocations();

}  // namespace bench
