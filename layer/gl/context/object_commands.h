// What the Gen, Delete and Is commands of all kinds of objects do alike. A kind is named by its table: that
// of the share group, &ShareGroup::textures, or of the context, &Context::vertexArrayObjects.
#pragma once

#include "layer/gl/context/context.h"

namespace anteroom::gl {

template <class T>
ObjectTable<T>& objectsOf(Context& c, ObjectTable<T> ShareGroup::*kind) {
  return (*c.group).*kind;
}
template <class T>
ObjectTable<T>& objectsOf(Context& c, ObjectTable<T> Context::*kind) {
  return c.*kind;
}

// Gen*.
template <class Kind>
void generateNames(Kind kind, GLsizei n, GLuint* names, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("n", n, "Give a count from 0 on"), command);
  if (!names) return;
  ShareLock lock(*c->group);
  if (!objectsOf(*c, kind).reserve(n, names)) c->setError(GL_OUT_OF_MEMORY, {}, command);
}

// Delete*. `unbind(context, object)` undoes the bindings of an object that has just lost its name. Name 0 is
// left alone.
template <class Kind, class Unbind>
void deleteObjects(Kind kind, GLsizei n, const GLuint* names, Unbind unbind,
                   const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("n", n, "Give a count from 0 on"), command);
  if (!names) return;
  ShareLock lock(*c->group);
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    if (const auto object = objectsOf(*c, kind).remove(names[i])) unbind(*c, object);
  }
}

// Is*. Names that are only reserved are not objects yet.
template <class Kind>
GLboolean isObject(Kind kind, GLuint name) {
  Context* c = current();
  if (!c || name == 0) return GL_FALSE;
  ShareLock lock(*c->group);
  return objectsOf(*c, kind).find(name) ? GL_TRUE : GL_FALSE;
}

}  // namespace anteroom::gl
