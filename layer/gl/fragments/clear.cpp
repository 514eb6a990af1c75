// Section 4.2.3: clearing; and 5.1: flush and finish.
#include <optional>

#include "layer/gl/context/context.h"
#include "layer/gl/context/params.h"
#include "layer/gl/debug/tool_names.h"

using namespace anteroom::gl;

GL_API void GL_APIENTRY glClear(GLbitfield mask) {
  Context* c = current();
  if (!c) return;
  if (mask & ~(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)) {
    return c->setError(
        GL_INVALID_VALUE,
        wrongBits("mask", mask, "Use COLOR_BUFFER_BIT, DEPTH_BUFFER_BIT and STENCIL_BUFFER_BIT"));
  }
  ShareLock lock(*c->group);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  if (!mask) return;
  std::optional<CommandGroup> group;
  if (c->groupsCommands) [[unlikely]]
    group.emplace(*c, "glClear", mask);
  if (!c->renderer->clear(c->state, c->changed, mask)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glClearColor(GLclampf r, GLclampf g, GLclampf b, GLclampf a) {
  if (Context* c = current()) c->state.clear.color = clamp01(glm::vec4(r, g, b, a));
}
GL_API void GL_APIENTRY glClearColorx(GLclampx r, GLclampx g, GLclampx b, GLclampx a) {
  glClearColor(fromFixed(r), fromFixed(g), fromFixed(b), fromFixed(a));
}

GL_API void GL_APIENTRY glClearDepthf(GLclampf depth) {
  if (Context* c = current()) c->state.clear.depth = clamp01(depth);
}
GL_API void GL_APIENTRY glClearDepthx(GLclampx depth) {
  glClearDepthf(fromFixed(depth));
}

// Masked to the bits of the stencil buffer when it is used.
GL_API void GL_APIENTRY glClearStencil(GLint stencil) {
  if (Context* c = current()) c->state.clear.stencil = stencil;
}

GL_API void GL_APIENTRY glFlush(void) {
  if (Context* c = current()) RendererLock(*c)->flush();
}

GL_API void GL_APIENTRY glFinish(void) {
  if (Context* c = current()) RendererLock(*c)->finish();
}
