// Section 2.9 and its queries.
#include "layer/gl/buffer.h"

#include <algorithm>
#include <limits>

#include "layer/gl/context.h"

namespace anteroom::gl {
namespace {

// The binding that `target` names, or null.
std::shared_ptr<BufferObject>* binding(Context& c, GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER:
      return &c.arrayBuffer;
    case GL_ELEMENT_ARRAY_BUFFER:
      return &c.vertexArrays.elementBuffer;
    default:
      return nullptr;
  }
}

// The object that a command on `target` works on; otherwise null, and the error is set.
BufferObject* boundBuffer(Context& c, GLenum target) {
  const std::shared_ptr<BufferObject>* bound = binding(c, target);
  if (!bound) {
    c.setError(GL_INVALID_ENUM);
    return nullptr;
  }
  if (!*bound) c.setError(GL_INVALID_OPERATION);
  return bound->get();
}

// The object of that name, made when there is none yet. Null: out of memory.
std::shared_ptr<BufferObject> obtain(ShareGroup& group, GLuint name) {
  std::shared_ptr<BufferObject> object = group.buffers.find(name);
  if (object) return object;
  try {
    object = std::make_shared<BufferObject>(name);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return group.buffers.put(name, object) ? object : nullptr;
}

void unbindEverywhere(Context& c, const std::shared_ptr<BufferObject>& object) {
  if (c.arrayBuffer == object) c.arrayBuffer = nullptr;
  if (c.vertexArrays.elementBuffer == object) c.vertexArrays.elementBuffer = nullptr;
  for (uint32_t i = 0; i < c.vertexArrays.arrays.size(); ++i) {
    if (c.vertexArrays.arrays[i].buffer != object) continue;
    c.vertexArrays.arrays[i].buffer = nullptr;
    c.staleArrays |= 1u << i;
    c.mark(gen::kGroupArrays);
  }
}

// A store of the same size is written again; the renderer keeps the old bytes for draws that were issued.
bool respecify(Context& c, BufferObject& buffer, size_t size, const void* data) {
  if (size == buffer.size()) return !data || size == 0 || buffer.store->write(0, data, size);
  std::shared_ptr<render::Buffer> store;
  if (size != 0) {
    store = c.device.createBuffer(size, data);
    if (!store) return false;
  }
  buffer.store = std::move(store);
  c.group->bufferVersion.fetch_add(1, std::memory_order_relaxed);
  return true;
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glGenBuffers(GLsizei n, GLuint* buffers) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE);
  if (!buffers) return;
  ShareLock lock(*c->group);
  if (!c->group->buffers.reserve(n, buffers)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glDeleteBuffers(GLsizei n, const GLuint* buffers) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE);
  if (!buffers) return;
  ShareLock lock(*c->group);
  for (GLsizei i = 0; i < n; ++i) {
    if (buffers[i] == 0) continue;
    if (const std::shared_ptr<BufferObject> object = c->group->buffers.remove(buffers[i])) {
      unbindEverywhere(*c, object);
    }
  }
}

GL_API GLboolean GL_APIENTRY glIsBuffer(GLuint buffer) {
  Context* c = current();
  if (!c || buffer == 0) return GL_FALSE;
  ShareLock lock(*c->group);
  return c->group->buffers.find(buffer) ? GL_TRUE : GL_FALSE;
}

GL_API void GL_APIENTRY glBindBuffer(GLenum target, GLuint buffer) {
  Context* c = current();
  if (!c) return;
  std::shared_ptr<BufferObject>* bound = binding(*c, target);
  if (!bound) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  if (buffer == 0) {
    bound->reset();
    return;
  }
  std::shared_ptr<BufferObject> object = obtain(*c->group, buffer);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  *bound = std::move(object);
}

GL_API void GL_APIENTRY glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (!binding(*c, target)) return c->setError(GL_INVALID_ENUM);
  if (size < 0) return c->setError(GL_INVALID_VALUE);
  if (usage != GL_STATIC_DRAW && usage != GL_DYNAMIC_DRAW) return c->setError(GL_INVALID_ENUM);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  if (!respecify(*c, *buffer, static_cast<size_t>(size), data)) return c->setError(GL_OUT_OF_MEMORY);
  buffer->usage = usage;
}

GL_API void GL_APIENTRY glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  if (offset < 0 || size < 0) return c->setError(GL_INVALID_VALUE);
  const size_t begin = static_cast<size_t>(offset), bytes = static_cast<size_t>(size);
  if (begin > buffer->size() || bytes > buffer->size() - begin) return c->setError(GL_INVALID_VALUE);
  if (bytes == 0 || !data) return;
  if (!buffer->store->write(begin, data, bytes)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glGetBufferParameteriv(GLenum target, GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (!binding(*c, target) || (pname != GL_BUFFER_SIZE && pname != GL_BUFFER_USAGE)) {
    return c->setError(GL_INVALID_ENUM);
  }
  const BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer || !params) return;
  constexpr size_t kLargest = std::numeric_limits<GLint>::max();
  *params = pname == GL_BUFFER_SIZE ? static_cast<GLint>(std::min(buffer->size(), kLargest))
                                    : static_cast<GLint>(buffer->usage);
}
