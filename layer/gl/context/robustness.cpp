// EXT_robustness: resets. ReadnPixelsEXT stands beside ReadPixels.
#include "layer/gl/context/context.h"

using namespace anteroom::gl;

// Whose fault it was is not known.
GL_API GLenum GL_APIENTRY glGetGraphicsResetStatusEXT(void) {
  Context* c = current();
  if (!c || !c->options.loseContextOnReset) return GL_NO_ERROR;
  ShareLock lock(*c->group);
  return c->renderer->lost() ? GL_UNKNOWN_CONTEXT_RESET_EXT : GL_NO_ERROR;
}

// ES 1.1 has no programs: nothing is the name of one.
GL_API void GL_APIENTRY glGetnUniformfvEXT(GLuint, GLint, GLsizei, GLfloat*) {
  if (Context* c = current()) c->setError(GL_INVALID_VALUE);
}
GL_API void GL_APIENTRY glGetnUniformivEXT(GLuint, GLint, GLsizei, GLint*) {
  if (Context* c = current()) c->setError(GL_INVALID_VALUE);
}
