// Rows of the state tables and how they are read, with a value behind the last that must stay as it is.
#pragma once

#include "harness.h"

namespace conformance {

struct IntegerRow {
  const char* name;
  GLenum value;
  std::vector<GLint> initial;
};
struct FloatRow {
  const char* name;
  GLenum value;
  std::vector<GLfloat> initial;
};
struct EnableRow {
  const char* name;
  GLenum value;
  GLboolean initial;
};
#define NAMED(constant) #constant, constant

inline constexpr GLint kUntouchedInt = 0x5aa55aa5;
inline constexpr GLfloat kUntouchedFloat = -12345.5f;

inline std::vector<GLint> integers(GLenum name, std::size_t count) {
  std::vector<GLint> values(count + 1, kUntouchedInt);
  glGetIntegerv(name, values.data());
  EXPECT_EQ(values.back(), kUntouchedInt) << "more values than the table has";
  values.pop_back();
  return values;
}

inline std::vector<GLfloat> floats(GLenum name, std::size_t count) {
  std::vector<GLfloat> values(count + 1, kUntouchedFloat);
  glGetFloatv(name, values.data());
  EXPECT_EQ(values.back(), kUntouchedFloat) << "more values than the table has";
  values.pop_back();
  return values;
}

inline GLint integer(GLenum name) {
  return integers(name, 1)[0];
}

inline GLfixed fixed(GLenum name) {
  GLfixed value = -1;
  glGetFixedv(name, &value);
  return value;
}

inline void expectIntegers(const std::vector<IntegerRow>& rows) {
  for (const IntegerRow& row : rows) {
    EXPECT_EQ(integers(row.value, row.initial.size()), row.initial) << row.name;
    EXPECT_GL_ERROR(GL_NO_ERROR) << row.name;
  }
}

inline void expectFloats(const std::vector<FloatRow>& rows) {
  for (const FloatRow& row : rows) {
    EXPECT_EQ(floats(row.value, row.initial.size()), row.initial) << row.name;
    EXPECT_GL_ERROR(GL_NO_ERROR) << row.name;
  }
}

// A state that IsEnabled gives is given by the four Get commands as well (6.2).
inline void expectEnables(const std::vector<EnableRow>& rows) {
  for (const EnableRow& row : rows) {
    EXPECT_EQ(glIsEnabled(row.value), row.initial) << row.name;
    GLboolean boolean = GL_FALSE;
    GLint whole = -1;
    GLfixed fixed = -1;
    GLfloat real = -1;
    glGetBooleanv(row.value, &boolean);
    glGetIntegerv(row.value, &whole);
    glGetFixedv(row.value, &fixed);
    glGetFloatv(row.value, &real);
    EXPECT_EQ(boolean, row.initial) << row.name;
    EXPECT_EQ(whole, row.initial) << row.name;
    EXPECT_EQ(fixed, row.initial * 65536) << row.name;
    EXPECT_EQ(real, row.initial) << row.name;
    EXPECT_GL_ERROR(GL_NO_ERROR) << row.name;
  }
}

inline const std::vector<GLfloat> kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

}  // namespace conformance
