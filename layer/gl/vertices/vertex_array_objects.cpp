// OES_vertex_array_object.
#include "layer/gl/context/object_commands.h"
#include "layer/gl/vertices/vertex_arrays.h"

namespace anteroom::gl {
namespace {

// The bound object's arrays lie in the context; those of the others lie in the objects. Under the ShareLock.
void bindVertexArray(Context& c, std::shared_ptr<VertexArrayObject> object) {
  if (object == c.boundVertexArray) return;
  std::swap(c.vertexArrays, c.boundVertexArray->arrays);
  c.boundVertexArray = std::move(object);
  std::swap(c.vertexArrays, c.boundVertexArray->arrays);
  syncArrays(c);
}

void unbind(Context& c, const std::shared_ptr<VertexArrayObject>& object) {
  if (object == c.boundVertexArray) bindVertexArray(c, c.defaultVertexArray);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glBindVertexArrayOES(GLuint array) {
  Context* c = current();
  if (!c) return;
  const ShareLock lock(*c->group);
  if (array == 0) return bindVertexArray(*c, c->defaultVertexArray);
  if (!c->vertexArrayObjects.used(array))
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("array", array, "Take names from glGenVertexArraysOES"));
  std::shared_ptr<VertexArrayObject> object = obtain(c->vertexArrayObjects, array);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  bindVertexArray(*c, std::move(object));
}

GL_API void GL_APIENTRY glDeleteVertexArraysOES(GLsizei n, const GLuint* arrays) {
  deleteObjects(&Context::vertexArrayObjects, n, arrays, unbind);
}

GL_API void GL_APIENTRY glGenVertexArraysOES(GLsizei n, GLuint* arrays) {
  generateNames(&Context::vertexArrayObjects, n, arrays);
}

GL_API GLboolean GL_APIENTRY glIsVertexArrayOES(GLuint array) {
  return isObject(&Context::vertexArrayObjects, array);
}
