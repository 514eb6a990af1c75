// What the device can do, as a value: it enters the making of keys, which is otherwise a function of state
// alone. Generated code never depends on it but through the key.
#pragma once

#include <cstdint>

namespace anteroom::gen {

struct Profile {
  bool clipDistance = true;       // gl_ClipDistance with at least 8 entries; else fragments are discarded
  bool largePoints = true;        // gl_PointSize other than 1
  bool mirrorClampToEdge = true;  // as an address mode of samplers
};

}  // namespace anteroom::gen
