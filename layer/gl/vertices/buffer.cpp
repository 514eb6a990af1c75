// Section 2.9 and its queries.
#include "layer/gl/vertices/buffer.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "layer/gl/context/object_commands.h"
#include "layer/gl/queries/query.h"
#include "layer/gl/vertices/vertex_arrays.h"

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

Fault wrongTarget(GLenum target) {
  return wrongEnum("target", target, "Use ARRAY_BUFFER or ELEMENT_ARRAY_BUFFER");
}

// The object that a command on `target` works on; otherwise null, and the error is set.
BufferObject* boundBuffer(Context& c, GLenum target, const char* command = __builtin_FUNCTION()) {
  const std::shared_ptr<BufferObject>* bound = binding(c, target);
  if (!bound) {
    c.setError(GL_INVALID_ENUM, wrongTarget(target), command);
    return nullptr;
  }
  if (!*bound)
    c.setError(GL_INVALID_OPERATION,
               wrongState("No buffer is bound to the target", "Call glBindBuffer before"), command);
  return bound->get();
}

Fault stillMapped() {
  return wrongState("The buffer is mapped", "Call glUnmapBufferOES before");
}

void unbindEverywhere(Context& c, const std::shared_ptr<BufferObject>& object) {
  if (c.arrayBuffer == object) c.arrayBuffer = nullptr;
  if (c.vertexArrays.elementBuffer == object) c.vertexArrays.elementBuffer = nullptr;
  for (uint32_t i = 0; i < c.vertexArrays.arrays.size(); ++i) {
    if (c.vertexArrays.arrays[i].buffer != object) continue;
    c.vertexArrays.arrays[i].buffer = nullptr;
    syncArray(c, i);
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
  c.group->tell(gen::kGroupArrays);
  return true;
}

void dropMapping(Context& c, BufferObject& buffer) {
  if (!buffer.mapped) return;
  buffer.mapped.reset();
  --c.group->mappedBuffers;
}

void forget(Context& c, const std::shared_ptr<BufferObject>& object) {
  dropMapping(c, *object);
  unbindEverywhere(c, object);
}

// Null: out of memory. `keep`: what the program does not write stays.
void* map(Context& c, BufferObject& buffer, size_t offset, size_t length, GLbitfield access, bool keep) {
  buffer.mapped.reset(new (std::nothrow) std::byte[std::max<size_t>(length, 1)]);
  if (!buffer.mapped) {
    c.setError(GL_OUT_OF_MEMORY);
    return nullptr;
  }
  if (keep && length != 0) std::memcpy(buffer.mapped.get(), buffer.store->contents() + offset, length);
  buffer.mapOffset = offset;
  buffer.mapLength = length;
  buffer.mapAccess = access;
  ++c.group->mappedBuffers;
  return buffer.mapped.get();
}

bool isMapped(const std::shared_ptr<BufferObject>& buffer) {
  return buffer && buffer->mapped;
}

using enum Results::Kind;

// Table 6.6, OES_mapbuffer.
constexpr auto kBufferQueries = tableOf<Query<BufferObject>>({
    {GL_BUFFER_SIZE, Integer, [](BufferObject& b) { return b.size(); }},
    {GL_BUFFER_USAGE, Enum, [](BufferObject& b) { return b.usage; }},
    {GL_BUFFER_ACCESS_OES, Enum, [](BufferObject&) { return GL_WRITE_ONLY_OES; }},
    {GL_BUFFER_MAPPED_OES, Boolean, [](BufferObject& b) { return b.mapped != nullptr; }},
});

}  // namespace

bool readsMappedBuffer(const Context& c, bool indices) {
  if (c.group->mappedBuffers == 0) return false;
  if (indices && isMapped(c.vertexArrays.elementBuffer)) return true;
  for (const ClientArray& array : c.vertexArrays.arrays) {
    if (array.enabled && isMapped(array.buffer)) return true;
  }
  return false;
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glGenBuffers(GLsizei n, GLuint* buffers) {
  generateNames(&ShareGroup::buffers, n, buffers);
}

GL_API void GL_APIENTRY glDeleteBuffers(GLsizei n, const GLuint* buffers) {
  deleteObjects(&ShareGroup::buffers, n, buffers, forget);
}

GL_API GLboolean GL_APIENTRY glIsBuffer(GLuint buffer) {
  return isObject(&ShareGroup::buffers, buffer);
}

GL_API void GL_APIENTRY glBindBuffer(GLenum target, GLuint buffer) {
  Context* c = current();
  if (!c) return;
  std::shared_ptr<BufferObject>* bound = binding(*c, target);
  if (!bound) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  ShareLock lock(*c->group);
  if (buffer == 0) {
    bound->reset();
    return;
  }
  std::shared_ptr<BufferObject> object = obtain(c->group->buffers, buffer);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  *bound = std::move(object);
}

GL_API void GL_APIENTRY glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (!binding(*c, target)) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  if (size < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("size", size, "Give a size from 0 on"));
  if (usage != GL_STATIC_DRAW && usage != GL_DYNAMIC_DRAW)
    return c->setError(GL_INVALID_ENUM, wrongEnum("usage", usage, "Use STATIC_DRAW or DYNAMIC_DRAW"));
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  dropMapping(*c, *buffer);
  if (!respecify(*c, *buffer, static_cast<size_t>(size), data)) return c->setError(GL_OUT_OF_MEMORY);
  buffer->usage = usage;
}

GL_API void GL_APIENTRY glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  if (buffer->mapped) return c->setError(GL_INVALID_OPERATION, stillMapped());
  if (offset < 0 || size < 0)
    return c->setError(GL_INVALID_VALUE, wrongNumber(offset < 0 ? "offset" : "size",
                                                     offset < 0 ? offset : size, "Give numbers from 0 on"));
  const size_t begin = static_cast<size_t>(offset), bytes = static_cast<size_t>(size);
  if (begin > buffer->size() || bytes > buffer->size() - begin)
    return c->setError(GL_INVALID_VALUE, wrongNumber("offset + size", begin + bytes,
                                                     "Stay inside the buffer: ask for BUFFER_SIZE"));
  if (bytes == 0 || !data) return;
  if (!buffer->store->write(begin, data, bytes)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API void GL_APIENTRY glGetBufferParameteriv(GLenum target, GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (!binding(*c, target)) return c->setError(GL_INVALID_ENUM, wrongTarget(target));
  if (!kBufferQueries.find(pname))
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum("pname", pname, "Use BUFFER_SIZE, BUFFER_USAGE, BUFFER_ACCESS_OES or BUFFER_MAPPED_OES"));
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  Results results(params, Results::Form::Integer);
  answer(kBufferQueries, *buffer, pname, results);
}

// OES_mapbuffer

GL_API void* GL_APIENTRY glMapBufferOES(GLenum target, GLenum access) {
  Context* c = current();
  if (!c) return nullptr;
  ShareLock lock(*c->group);
  if (access != GL_WRITE_ONLY_OES) {
    c->setError(GL_INVALID_ENUM, wrongEnum("access", access, "Use WRITE_ONLY_OES"));
    return nullptr;
  }
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return nullptr;
  if (buffer->mapped) {
    c->setError(GL_INVALID_OPERATION, stillMapped());
    return nullptr;
  }
  // A program that looks at the pointer alone would write beyond a store that it could not get.
  if (buffer->size() == 0) {
    c->setError(GL_OUT_OF_MEMORY,
                wrongState("The buffer has no store, or an empty one", "Give it one with glBufferData"));
    return nullptr;
  }
  return map(*c, *buffer, 0, buffer->size(), GL_MAP_WRITE_BIT_EXT, true);
}

GL_API GLboolean GL_APIENTRY glUnmapBufferOES(GLenum target) {
  Context* c = current();
  if (!c) return GL_FALSE;
  ShareLock lock(*c->group);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return GL_FALSE;
  if (!buffer->mapped) {
    c->setError(GL_INVALID_OPERATION, wrongState("The buffer is not mapped", "Call glMapBufferOES before"));
    return GL_FALSE;
  }
  const bool writes =
      (buffer->mapAccess & (GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) == GL_MAP_WRITE_BIT_EXT;
  if (writes && buffer->mapLength != 0 &&
      !buffer->store->write(buffer->mapOffset, buffer->mapped.get(), buffer->mapLength)) {
    c->setError(GL_OUT_OF_MEMORY);
  }
  dropMapping(*c, *buffer);
  return GL_TRUE;
}

GL_API void GL_APIENTRY glGetBufferPointervOES(GLenum target, GLenum pname, void** params) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (pname != GL_BUFFER_MAP_POINTER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, "Use BUFFER_MAP_POINTER_OES"));
  const BufferObject* buffer = boundBuffer(*c, target);
  if (buffer && params) *params = buffer->mapped.get();
}

// EXT_map_buffer_range

GL_API void* GL_APIENTRY glMapBufferRangeEXT(GLenum target, GLintptr offset, GLsizeiptr length,
                                             GLbitfield access) {
  Context* c = current();
  if (!c) return nullptr;
  ShareLock lock(*c->group);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return nullptr;
  constexpr GLbitfield kInvalidate = GL_MAP_INVALIDATE_RANGE_BIT_EXT | GL_MAP_INVALIDATE_BUFFER_BIT_EXT;
  constexpr GLbitfield kAll = GL_MAP_READ_BIT_EXT | GL_MAP_WRITE_BIT_EXT | kInvalidate |
                              GL_MAP_FLUSH_EXPLICIT_BIT_EXT | GL_MAP_UNSYNCHRONIZED_BIT_EXT;
  const size_t begin = static_cast<size_t>(offset), bytes = static_cast<size_t>(length);
  if (offset < 0 || length < 0 || begin > buffer->size() || bytes > buffer->size() - begin ||
      (access & ~kAll)) {
    c->setError(GL_INVALID_VALUE,
                wrongState("The range does not lie in the buffer, or access has unknown bits",
                           "Stay inside the buffer, and use MAP_..._BIT_EXT"));
    return nullptr;
  }
  const bool reads = access & GL_MAP_READ_BIT_EXT, writes = access & GL_MAP_WRITE_BIT_EXT;
  if (bytes == 0 || buffer->mapped || (!reads && !writes) ||
      (reads && (access & (kInvalidate | GL_MAP_UNSYNCHRONIZED_BIT_EXT))) ||
      (!writes && (access & GL_MAP_FLUSH_EXPLICIT_BIT_EXT))) {
    c->setError(
        GL_INVALID_OPERATION,
        wrongState("The buffer is mapped, the range is empty, or the bits of access do not go together",
                   "Unmap it, and ask for MAP_READ_BIT_EXT or MAP_WRITE_BIT_EXT; only writes can be "
                   "invalidated or flushed"));
    return nullptr;
  }
  return map(*c, *buffer, begin, bytes, access, !(access & kInvalidate));
}

GL_API void GL_APIENTRY glFlushMappedBufferRangeEXT(GLenum target, GLintptr offset, GLsizeiptr length) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  BufferObject* buffer = boundBuffer(*c, target);
  if (!buffer) return;
  if (!buffer->mapped || !(buffer->mapAccess & GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) {
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("The buffer is not mapped with MAP_FLUSH_EXPLICIT_BIT_EXT",
                                  "Map it so with glMapBufferRangeEXT"));
  }
  const size_t begin = static_cast<size_t>(offset), bytes = static_cast<size_t>(length);
  if (offset < 0 || length < 0 || begin > buffer->mapLength || bytes > buffer->mapLength - begin) {
    return c->setError(
        GL_INVALID_VALUE,
        wrongNumber("offset + length", static_cast<double>(offset) + static_cast<double>(length),
                    "Stay inside the mapped range: offset counts from its start"));
  }
  if (bytes == 0) return;
  if (!buffer->store->write(buffer->mapOffset + begin, buffer->mapped.get() + begin, bytes)) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}
