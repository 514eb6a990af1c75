// What the chapters of errors share: a command that must be rejected, with the error that the text names, and
// no state changed by it.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "harness.h"

namespace conformance {

constexpr GLenum kNoEnum = 0x9999;
inline constexpr GLfloat kFloats[16] = {1, 1, 1, 1};
inline constexpr GLfixed kFixed[16] = {65536, 65536, 65536, 65536};

struct Rejected {
  const char* section;
  const char* text;
  std::function<void()> call;
  // More than one where texts contradict each other or name no code (see the row's section).
  std::vector<GLenum> errors;
  const char* mesaDeparts = nullptr;

  // The row is left out on Mesa, which departs from its section in this way.
  Rejected notMesa(const char* how) && {
    mesaDeparts = how;
    return std::move(*this);
  }
};

// A command that must be rejected: its section, the command, the error or errors that are right.
#define REJECT(section, call, ...)   \
  Rejected {                         \
    section, #call, [&] { call; }, { \
      __VA_ARGS__                    \
    }                                \
  }

class RejectionTest : public GlTest {
 protected:
  void reject(const std::vector<Rejected>& rows);
};

// The value of an integer state.
GLint integer(GLenum name);

}  // namespace conformance
