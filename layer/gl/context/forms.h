// The forms of a command: the same for floats and fixed-point numbers, some for integers; for one value, and
// for the values that a pointer points to.
#pragma once

#include "layer/gl/context/params.h"

// The words between parentheses of `arguments` are those before the values, and are the same in all forms.
#define ANTEROOM_INSIDE(...) __VA_ARGS__

// Two commands that set a parameter. `statement` knows the values as `params`.
#define ANTEROOM_SETTERS_OF(one, several, Type, read, arguments, statement)        \
  GL_API void GL_APIENTRY one(ANTEROOM_INSIDE arguments, Type param) {             \
    const anteroom::gl::Params params = anteroom::gl::Params::read(&param, false); \
    statement;                                                                     \
  }                                                                                \
  GL_API void GL_APIENTRY several(ANTEROOM_INSIDE arguments, const Type* values) { \
    const anteroom::gl::Params params = anteroom::gl::Params::read(values, true);  \
    statement;                                                                     \
  }

// A command that asks for a parameter. `statement` knows where the answer goes as `results`.
#define ANTEROOM_GETTER_OF(command, Type, form, arguments, statement)               \
  GL_API void GL_APIENTRY command(ANTEROOM_INSIDE arguments, Type* params) {        \
    const anteroom::gl::Results results(params, anteroom::gl::Results::Form::form); \
    statement;                                                                      \
  }

// ANTEROOM_SETTERS(glLight, , (GLenum light, GLenum pname), setLight(light, pname, params)) makes glLightf,
// glLightfv, glLightx and glLightxv. `suffix`: that of the extension, such as OES.
#define ANTEROOM_SETTERS(command, suffix, arguments, statement)                                       \
  ANTEROOM_SETTERS_OF(command##f##suffix, command##fv##suffix, GLfloat, floats, arguments, statement) \
  ANTEROOM_SETTERS_OF(command##x##suffix, command##xv##suffix, GLfixed, fixeds, arguments, statement)
#define ANTEROOM_INTEGER_SETTERS(command, suffix, arguments, statement) \
  ANTEROOM_SETTERS_OF(command##i##suffix, command##iv##suffix, GLint, integers, arguments, statement)

// The same for commands that ask: glGetLightfv and glGetLightxv, and with integers ...iv.
#define ANTEROOM_GETTERS(command, suffix, arguments, statement)                 \
  ANTEROOM_GETTER_OF(command##fv##suffix, GLfloat, Float, arguments, statement) \
  ANTEROOM_GETTER_OF(command##xv##suffix, GLfixed, Fixed, arguments, statement)
#define ANTEROOM_INTEGER_GETTER(command, suffix, arguments, statement) \
  ANTEROOM_GETTER_OF(command##iv##suffix, GLint, Integer, arguments, statement)
