// Attribute lists: pairs of name and value up to EGL_NONE, of EGLint or, in newer commands, EGLAttrib.
#pragma once

#include <EGL/egl.h>

#include "layer/egl/errors.h"

namespace anteroom::egl {

template <typename Integer, typename Visitor>
void forEachAttribute(const Integer* list, Visitor visit) {
  if (list == nullptr) return;
  for (; list[0] != EGL_NONE; list += 2) visit(static_cast<EGLint>(list[0]), static_cast<EGLAttrib>(list[1]));
}

template <typename Integer>
bool isEmpty(const Integer* list) {
  return list == nullptr || list[0] == EGL_NONE;
}

inline bool toBoolean(EGLAttrib value) {
  require(value == EGL_TRUE || value == EGL_FALSE, EGL_BAD_ATTRIBUTE);
  return value == EGL_TRUE;
}

}  // namespace anteroom::egl
