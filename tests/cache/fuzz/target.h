#pragma once

#include <cstddef>
#include <cstdint>

// What the rest of an input is.
enum FuzzKind : char {
  kFuzzDatabase = 'd',
  kFuzzBlob = 'b',
  kFuzzWords = 'w',
  kFuzzVertexKey = 'v',
  kFuzzFragmentKey = 'f',
  kFuzzSpirv = 's',
  kFuzzState = 'p',
};

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
