#include "layer/gl/debug/enum_names.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace anteroom::gl {
namespace {

constexpr uint16_t kValues[] = {
#define ANTEROOM_ENUM(name, value) value,
#include "registry/enums.inc"
#undef ANTEROOM_ENUM
};
static_assert(std::ranges::is_sorted(kValues));

// One after the other: 3,800 pointers would have to be relocated in every process.
constexpr char kNames[] =
#define ANTEROOM_ENUM(name, value) #name "\0"
#include "registry/enums.inc"
#undef ANTEROOM_ENUM
    ;

}  // namespace

std::string_view enumName(GLenum value) {
  const auto* found = std::ranges::lower_bound(kValues, value);
  if (found == std::end(kValues) || *found != value) return {};
  const char* name = kNames;
  for (auto before = found - kValues; before > 0; --before) name += std::strlen(name) + 1;
  return name;
}

}  // namespace anteroom::gl
