// Comparisons and blend factors of section 4.1 in float64.
#pragma once

#include <algorithm>

#include "harness.h"

namespace conformance {

inline constexpr GLenum kComparisons[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                          GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};

inline bool compare(GLenum function, double a, double b) {
  switch (function) {
    case GL_NEVER:
      return false;
    case GL_LESS:
      return a < b;
    case GL_EQUAL:
      return a == b;
    case GL_LEQUAL:
      return a <= b;
    case GL_GREATER:
      return a > b;
    case GL_NOTEQUAL:
      return a != b;
    case GL_GEQUAL:
      return a >= b;
    default:
      return true;
  }
}

inline constexpr GLenum kSourceFactors[] = {GL_ZERO,
                                            GL_ONE,
                                            GL_DST_COLOR,
                                            GL_ONE_MINUS_DST_COLOR,
                                            GL_SRC_ALPHA,
                                            GL_ONE_MINUS_SRC_ALPHA,
                                            GL_DST_ALPHA,
                                            GL_ONE_MINUS_DST_ALPHA,
                                            GL_SRC_ALPHA_SATURATE};
inline constexpr GLenum kDestinationFactors[] = {GL_ZERO,      GL_ONE,
                                                 GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
                                                 GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
                                                 GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};

// Table 4.1 for the source colour s over the destination d.
inline Vec4 blendFactor(GLenum factor, const Vec4& s, const Vec4& d) {
  const double f = std::min(s[3], 1 - d[3]);
  switch (factor) {
    case GL_ZERO:
      return {0, 0, 0, 0};
    case GL_ONE:
      return {1, 1, 1, 1};
    case GL_SRC_COLOR:
      return s;
    case GL_ONE_MINUS_SRC_COLOR:
      return {1 - s[0], 1 - s[1], 1 - s[2], 1 - s[3]};
    case GL_DST_COLOR:
      return d;
    case GL_ONE_MINUS_DST_COLOR:
      return {1 - d[0], 1 - d[1], 1 - d[2], 1 - d[3]};
    case GL_SRC_ALPHA:
      return {s[3], s[3], s[3], s[3]};
    case GL_ONE_MINUS_SRC_ALPHA:
      return {1 - s[3], 1 - s[3], 1 - s[3], 1 - s[3]};
    case GL_DST_ALPHA:
      return {d[3], d[3], d[3], d[3]};
    case GL_ONE_MINUS_DST_ALPHA:
      return {1 - d[3], 1 - d[3], 1 - d[3], 1 - d[3]};
    default:
      return {f, f, f, 1};
  }
}

}  // namespace conformance
