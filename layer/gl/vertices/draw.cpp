// DrawArrays and DrawElements (section 2.8), and EXT_multi_draw_arrays.
#include "layer/gl/vertices/draw.h"

#include <limits>
#include <optional>

#include "layer/gl/context/context.h"
#include "layer/gl/debug/tool_names.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/vertices/buffer.h"
#include "layer/gl/vertices/vertex_arrays.h"

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

// Whether there are vertices, and, for a matrix palette, what they choose from it.
bool hasArrays(const gen::State& state) {
  const auto& attributes = state.attributes;
  if (!attributes[gen::kPosition].array) return false;
  return !state.palette || (attributes[gen::kMatrixIndex].array && attributes[gen::kWeight].array);
}

// Under the ShareLock; everything has been validated.
void draw(Context& c, const render::DrawCall& call, const char* command = __builtin_FUNCTION()) {
  if (readsMappedBuffer(c, call.indexType != 0))
    return c.setError(GL_INVALID_OPERATION,
                      wrongState("A buffer that the draw reads is mapped", "Call glUnmapBufferOES before"),
                      command);
  prepareDraw(c);
  if (!hasArrays(c.state.fixed)) return;
  c.set(c.state.fixed.primitive, classOf(call.mode), gen::kGroupPrimitive);
  submitDraw(c, c.state, 0, call, command);
}

size_t indexSize(GLenum type) {
  if (type == GL_UNSIGNED_BYTE) return 1;
  return type == GL_UNSIGNED_SHORT ? 2 : 4;
}

}  // namespace

namespace anteroom::gl {

void prepareDraw(Context& c) {
  if (!(c.changed & gen::kGroupTextures)) return;
  const bool updated = updateTextureUnits(c);
  // Texels of an attached texture may have moved.
  c.framebufferComplete();
  if (!updated) c.told |= gen::kGroupTextures;  // the next draw tries again
}

void submitDraw(Context& c, const render::State& state, gen::Groups differs, const render::DrawCall& call,
                const char* command) {
  std::optional<CommandGroup> group;
  if (c.groupsCommands) [[unlikely]]
    group.emplace(c, command, call);
  if (!c.renderer->draw(state, c.changed | differs, call)) return c.setError(GL_OUT_OF_MEMORY, {}, command);
  c.changed = differs;
}

namespace {

// False: the error is set.
bool isMode(Context& c, GLenum mode, const char* command = __builtin_FUNCTION()) {
  if (mode <= GL_TRIANGLE_FAN) return true;
  c.setError(GL_INVALID_ENUM,
             wrongEnum("mode", mode,
                       "Use POINTS, LINES, LINE_LOOP, LINE_STRIP, TRIANGLES, TRIANGLE_STRIP or TRIANGLE_FAN"),
             command);
  return false;
}
bool isIndexType(Context& c, GLenum type, const char* command = __builtin_FUNCTION()) {
  if (type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT) return true;
  c.setError(GL_INVALID_ENUM, wrongEnum("type", type, "Use UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT"),
             command);
  return false;
}

}  // namespace
}  // namespace anteroom::gl

GL_API void GL_APIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
  Context* c = current();
  if (!c) return;
  if (!isMode(*c, mode)) return;
  if (first < 0)
    return c->setError(GL_INVALID_VALUE, wrongNumber("first", first, "Give a first element from 0 on"));
  if (count < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("count", count, "Give a count from 0 on"));
  ShareLock lock(*c->group);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  if (count < fewestVertices(mode)) return;
  if (count > std::numeric_limits<GLint>::max() - first) return c->setError(GL_OUT_OF_MEMORY);

  render::DrawCall call;
  call.mode = mode;
  call.first = first;
  call.count = count;
  draw(*c, call);
}

GL_API void GL_APIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  Context* c = current();
  if (!c) return;
  if (!isMode(*c, mode) || !isIndexType(*c, type)) return;
  if (count < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("count", count, "Give a count from 0 on"));
  ShareLock lock(*c->group);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  if (count < fewestVertices(mode)) return;

  render::DrawCall call;
  call.mode = mode;
  call.count = count;
  call.indexType = type;
  call.indices = indices;
  if (const BufferObject* elements = c->vertexArrays.elementBuffer.get()) {
    // Indices that the buffer does not hold are undefined: nothing is drawn.
    const size_t offset = reinterpret_cast<uintptr_t>(indices);
    const size_t size = elements->store ? elements->store->size() : 0;
    const size_t wanted = static_cast<size_t>(count) * indexSize(type);
    if (offset > size || wanted > size - offset) return;
    call.indexBuffer = elements->store.get();
  } else if (!indices) {
    return;
  }
  draw(*c, call);
}

// EXT_multi_draw_arrays: counts that are not positive are passed over.
GL_API void GL_APIENTRY glMultiDrawArraysEXT(GLenum mode, const GLint* first, const GLsizei* count,
                                             GLsizei primcount) {
  Context* c = current();
  if (!c) return;
  if (primcount < 0)
    return c->setError(GL_INVALID_VALUE, wrongNumber("primcount", primcount, "Give a count from 0 on"));
  if (!isMode(*c, mode) || !first || !count) return;
  for (GLsizei i = 0; i < primcount; ++i) {
    if (count[i] > 0) glDrawArrays(mode, first[i], count[i]);
  }
}

GL_API void GL_APIENTRY glMultiDrawElementsEXT(GLenum mode, const GLsizei* count, GLenum type,
                                               const void* const* indices, GLsizei primcount) {
  Context* c = current();
  if (!c) return;
  if (primcount < 0)
    return c->setError(GL_INVALID_VALUE, wrongNumber("primcount", primcount, "Give a count from 0 on"));
  if (!isMode(*c, mode) || !isIndexType(*c, type) || !count || !indices) return;
  for (GLsizei i = 0; i < primcount; ++i) {
    if (count[i] > 0) glDrawElements(mode, count[i], type, indices[i]);
  }
}
