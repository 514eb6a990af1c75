// Commands of extensions by eglGetProcAddress, so that a case runs on any implementation; and what a case
// needs.
#pragma once

#include "harness.h"

namespace conformance {

// command(name): the address, as the type that glext.h gives it.
template <class Command>
Command command(const char* name) {
  return reinterpret_cast<Command>(eglGetProcAddress(name));
}

// The same into a pointer that has the type.
template <class Command>
void load(Command& to, const char* name) {
  to = command<Command>(name);
  ASSERT_NE(to, nullptr) << name;
}

}  // namespace conformance

// A local function pointer `name` for the command of that name; `type` is its PFN type of glext.h.
#define COMMAND(type, name)                                   \
  const auto name = ::conformance::command<type>("gl" #name); \
  ASSERT_NE(name, nullptr)

// The layer has every extension that is tested; another implementation may lack some.
#define NEEDS_EXTENSION(name)                                                         \
  if (!::conformance::hasExtension(name)) {                                           \
    if (::conformance::onMesa()) GTEST_SKIP() << name << " is not supported by Mesa"; \
    FAIL() << name << " is not advertised";                                           \
  }                                                                                   \
  static_assert(true, "")
