// EXT_robustness: resets. ReadnPixelsEXT stands beside ReadPixels.
#include "layer/gl/context.h"

using namespace anteroom::gl;

// Whose fault it was is not known.
GL_API GLenum GL_APIENTRY glGetGraphicsResetStatusEXT(void) {
  const Context* c = current();
  if (!c || !c->options.loseContextOnReset) return GL_NO_ERROR;
  return c->renderer->lost() ? GL_UNKNOWN_CONTEXT_RESET_EXT : GL_NO_ERROR;
}
