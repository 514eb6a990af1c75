// What is wrong with a command, for the message that its error makes (KHR_debug). Costs nothing until then.
#pragma once

#include <GLES/gl.h>

#include <type_traits>

namespace anteroom::gl {

struct Fault {
  enum class Kind : uint8_t { Unknown, State, Number, Enum, Bits };

  Kind kind = Kind::Unknown;
  const char* subject = nullptr;  // an argument's name; or, of State, a sentence
  double value = 0;               // the argument's
  const char* remedy = nullptr;   // what to do: an imperative sentence without its full stop
};

// An argument that must be one of some names.
inline Fault wrongEnum(const char* argument, GLenum value, const char* remedy) {
  return {Fault::Kind::Enum, argument, static_cast<double>(value), remedy};
}

// An argument that is made of bits.
inline Fault wrongBits(const char* argument, GLbitfield value, const char* remedy) {
  return {Fault::Kind::Bits, argument, static_cast<double>(value), remedy};
}

// An argument that is a number.
template <class Number>
requires std::is_arithmetic_v<Number> Fault wrongNumber(const char* argument, Number value,
                                                        const char* remedy) {
  return {Fault::Kind::Number, argument, static_cast<double>(value), remedy};
}

// Arguments that do not fit what is bound, attached or enabled.
inline Fault wrongState(const char* sentence, const char* remedy) {
  return {Fault::Kind::State, sentence, 0, remedy};
}

}  // namespace anteroom::gl
