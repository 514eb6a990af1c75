// OES_vertex_array_object.
#include "layer/gl/vertices/vertex_arrays.h"

namespace anteroom::gl {
namespace {

// The bound object's arrays lie in the context; those of the others lie in the objects.
void bindVertexArray(Context& c, std::shared_ptr<VertexArrayObject> object) {
  if (object == c.boundVertexArray) return;
  std::swap(c.vertexArrays, c.boundVertexArray->arrays);
  c.boundVertexArray = std::move(object);
  std::swap(c.vertexArrays, c.boundVertexArray->arrays);
  c.staleArrays = kAllArrays;
  c.mark(gen::kGroupArrays);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glBindVertexArrayOES(GLuint array) {
  Context* c = current();
  if (!c) return;
  if (array == 0) return bindVertexArray(*c, c->defaultVertexArray);
  if (!c->vertexArrayObjects.used(array))
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("array", array, "Take names from glGenVertexArraysOES"));
  std::shared_ptr<VertexArrayObject> object = obtain(c->vertexArrayObjects, array);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  bindVertexArray(*c, std::move(object));
}

GL_API void GL_APIENTRY glDeleteVertexArraysOES(GLsizei n, const GLuint* arrays) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("n", n, "Give a count from 0 on"));
  if (!arrays) return;
  ShareLock lock(*c->group);
  for (GLsizei i = 0; i < n; ++i) {
    if (arrays[i] == 0) continue;
    const std::shared_ptr<VertexArrayObject> object = c->vertexArrayObjects.remove(arrays[i]);
    if (object && object == c->boundVertexArray) bindVertexArray(*c, c->defaultVertexArray);
  }
}

GL_API void GL_APIENTRY glGenVertexArraysOES(GLsizei n, GLuint* arrays) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("n", n, "Give a count from 0 on"));
  if (arrays && !c->vertexArrayObjects.reserve(n, arrays)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API GLboolean GL_APIENTRY glIsVertexArrayOES(GLuint array) {
  Context* c = current();
  return c && array != 0 && c->vertexArrayObjects.find(array) ? GL_TRUE : GL_FALSE;
}
