// The parameters of a command that has float, fixed-point and integer forms, read as numbers or as enums.
#pragma once

#include <type_traits>

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// A float that names an enum; one that cannot gives no valid enum.
inline GLenum toEnum(float value) {
  return value >= 0 && value < 4294967296.0f ? static_cast<GLenum>(value) : ~GLenum{0};
}

// The unit that TEXTUREi names, from 0 on. -1: none, and the error is set.
inline int unitOf(Context& c, const char* argument, GLenum texture,
                  const char* command = __builtin_FUNCTION()) {
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit < gen::kMaxTextureUnits) return static_cast<int>(unit);
  c.setError(GL_INVALID_ENUM,
             wrongEnum(argument, texture, "Use TEXTURE0 and the next, up to the value of MAX_TEXTURE_UNITS"),
             command);
  return -1;
}

// NaN gives 0.
inline float clamp01(float value) {
  return value > 0 ? (value < 1 ? value : 1) : 0;
}
inline glm::vec4 clamp01(const glm::vec4& v) {
  return {clamp01(v.x), clamp01(v.y), clamp01(v.z), clamp01(v.w)};
}

class Params {
 public:
  enum class Form : uint8_t { Float, Fixed, Integer };

  static Params floats(const GLfloat* values, bool vector) { return {values, Form::Float, vector}; }
  static Params fixeds(const GLfixed* values, bool vector) { return {values, Form::Fixed, vector}; }
  static Params integers(const GLint* values, bool vector) { return {values, Form::Integer, vector}; }

  // Whether the command may set something that has several values.
  bool vector() const { return vector_; }
  // There is nothing to read: the command does nothing, once its enumerants are known to be right (section 2.5).
  bool null() const { return values_ == nullptr; }

  float number(int i = 0) const {
    if (form_ == Form::Float) return static_cast<const GLfloat*>(values_)[i];
    return form_ == Form::Fixed ? fromFixed(integer(i)) : static_cast<float>(integer(i));
  }
  // The nearest integer.
  GLint rounded(int i) const {
    if (form_ == Form::Float) return roundToInt(static_cast<const GLfloat*>(values_)[i]);
    return form_ == Form::Fixed ? roundToInt(fixedToDouble(integer(i))) : integer(i);
  }
  // A color component: integers as Table 2.7 has it for signed ones.
  float component(int i) const {
    if (form_ != Form::Integer) return number(i);
    return static_cast<float>((2.0 * integer(i) + 1.0) / 4294967295.0);
  }
  // Enums in fixed-point commands are not scaled (section 2.3).
  GLenum enumerant() const {
    return form_ == Form::Float ? toEnum(number()) : static_cast<GLenum>(integer(0));
  }
  bool boolean() const { return form_ == Form::Float ? number() != 0 : integer(0) != 0; }

  glm::vec3 vec3() const { return {number(0), number(1), number(2)}; }
  glm::vec4 vec4() const { return {number(0), number(1), number(2), number(3)}; }
  glm::vec4 color() const { return {component(0), component(1), component(2), component(3)}; }

 private:
  Params(const void* values, Form form, bool vector) : values_(values), form_(form), vector_(vector) {}
  GLint integer(int i) const { return static_cast<const GLint*>(values_)[i]; }

  const void* values_;
  Form form_;
  bool vector_;
};

// Where a query puts what it found, in the type that the program asked for. Conversions of section 6.1.2. NULL
// takes nothing.
class Results {
 public:
  enum class Form : uint8_t { Boolean, Integer, Integer64, Fixed, Float };
  enum class Kind : uint8_t {
    Boolean,
    Integer,
    Enum,
    Number,
    Normalised,  // colors, normals, depths: [-1, 1] becomes the whole range of int
  };

  Results(void* out, Form form) : out_(out), form_(form) {}

  // A value; or those of a vector, of a matrix column by column, or of a list.
  template <class T>
  void put(Kind kind, const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      putOne(kind, static_cast<double>(value));
    } else if constexpr (requires { value.begin(); }) {
      for (const auto& element : value) put(kind, element);
    } else {
      for (int i = 0; i < T::length(); ++i) put(kind, value[i]);
    }
  }

 private:
  void putOne(Kind kind, double value);

  void* out_;
  Form form_;
  int count_ = 0;
};

}  // namespace anteroom::gl
