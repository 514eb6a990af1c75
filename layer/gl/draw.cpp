// DrawArrays and DrawElements (section 2.8).
#include <limits>

#include "layer/gl/buffer.h"
#include "layer/gl/context.h"
#include "layer/gl/texture.h"
#include "layer/gl/vertex_arrays.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;
namespace render = anteroom::render;

namespace {

gen::PrimitiveClass classOf(GLenum mode) {
  if (mode == GL_POINTS) return gen::PrimitiveClass::Points;
  return mode <= GL_LINE_STRIP ? gen::PrimitiveClass::Lines : gen::PrimitiveClass::Triangles;
}

// Vertices without which a mode draws nothing.
GLsizei fewestVertices(GLenum mode) {
  constexpr GLsizei kFewest[] = {1, 2, 2, 2, 3, 3, 3};
  return kFewest[mode];
}

// Brings the state up to date and draws. Under the ShareLock; everything has been validated.
void draw(Context& c, const render::DrawCall& call) {
  syncArrays(c);
  if (!c.state.fixed.attributes[gen::kPosition].array) return;

  const uint32_t textures = c.group->textureVersion.load(std::memory_order_relaxed);
  if (textures != c.seenTextureVersion) {
    c.seenTextureVersion = textures;
    c.mark(gen::kGroupTextures);
  }
  if (c.staleUnits) resolveTextureUnits(c);
  c.set(c.state.fixed.primitive, classOf(call.mode), gen::kGroupPrimitive);
  if (!c.renderer->draw(c.state, call)) c.setError(GL_OUT_OF_MEMORY);
}

}  // namespace

GL_API void GL_APIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
  Context* c = current();
  if (!c) return;
  if (mode > GL_TRIANGLE_FAN) return c->setError(GL_INVALID_ENUM);
  if (first < 0 || count < 0) return c->setError(GL_INVALID_VALUE);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  if (count < fewestVertices(mode)) return;
  if (count > std::numeric_limits<GLint>::max() - first) return c->setError(GL_OUT_OF_MEMORY);

  render::DrawCall call;
  call.mode = mode;
  call.first = first;
  call.count = count;
  ShareLock lock(*c->group);
  draw(*c, call);
}

GL_API void GL_APIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  Context* c = current();
  if (!c) return;
  if (mode > GL_TRIANGLE_FAN) return c->setError(GL_INVALID_ENUM);
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT) return c->setError(GL_INVALID_ENUM);
  if (count < 0) return c->setError(GL_INVALID_VALUE);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  if (count < fewestVertices(mode)) return;

  render::DrawCall call;
  call.mode = mode;
  call.count = count;
  call.indexType = type;
  call.indices = indices;
  ShareLock lock(*c->group);
  if (const BufferObject* elements = c->vertexArrays.elementBuffer.get()) {
    // Indices that the buffer does not hold are undefined: nothing is drawn.
    const size_t offset = reinterpret_cast<uintptr_t>(indices);
    const size_t size = elements->store ? elements->store->size() : 0;
    const size_t wanted = static_cast<size_t>(count) * (type == GL_UNSIGNED_BYTE ? 1 : 2);
    if (offset > size || wanted > size - offset) return;
    call.indexBuffer = elements->store.get();
  } else if (!indices) {
    return;
  }
  draw(*c, call);
}
