#pragma once

#include <string_view>

namespace anteroom::cache {

// 16 hex digits: a hash of all that decides what SPIR-V a key becomes (gen/, shaders/, glslang), made by
// CMake.
std::string_view generatorVersion();

}  // namespace anteroom::cache
