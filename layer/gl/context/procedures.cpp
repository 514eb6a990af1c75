// Names of commands to their addresses, for eglGetProcAddress.
#include <algorithm>
#include <iterator>

#include "layer/gl/context/context.h"

namespace anteroom::gl {

namespace {

constexpr std::string_view kNames[] = {
#define ANTEROOM_COMMAND(name) #name,
#include "registry/commands.inc"
#undef ANTEROOM_COMMAND
};
static_assert(std::ranges::is_sorted(kNames));

const Proc kProcs[] = {
#define ANTEROOM_COMMAND(name) reinterpret_cast<Proc>(name),
#include "registry/commands.inc"
#undef ANTEROOM_COMMAND
};

}  // namespace

Proc procAddress(std::string_view name) {
  const auto* found = std::ranges::lower_bound(kNames, name);
  return found != std::end(kNames) && *found == name ? kProcs[found - kNames] : nullptr;
}

}  // namespace anteroom::gl
