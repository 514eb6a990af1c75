// APPLE_sync (section 5.2 of its text) and NV_fence (5.X).
#include "layer/gl/context/fences.h"

#include <new>

#include "layer/gl/context/object_commands.h"

using namespace anteroom::gl;

namespace anteroom::gl {

void Fence::insert(Context& c) {
  point_ = c.renderer->insertFence();
  passed_.store(false, std::memory_order_relaxed);
}

bool Fence::wait(Context& c, uint64_t timeout) {
  if (passed_.load(std::memory_order_relaxed)) return true;
  if (!c.renderer->waitFence(point_, timeout)) return false;
  passed_.store(true, std::memory_order_relaxed);
  return true;
}

namespace {

Fault noSync() {
  return wrongState("sync is not the name of a sync object",
                    "Make one with glFenceSyncAPPLE, and use it before glDeleteSyncAPPLE");
}

// Null: not a sync object.
std::shared_ptr<SyncObject> findSync(Context& c, GLsync sync) {
  ShareLock lock(*c.group);
  return c.group->syncs.find(syncName(sync));
}

// Null, and the error is set: not the name of an existing fence.
FenceObject* findFence(Context& c, GLuint name, const char* command = __builtin_FUNCTION()) {
  const std::shared_ptr<FenceObject> fence = c.fences.find(name);
  if (!fence) {
    c.setError(GL_INVALID_OPERATION, wrongState("No fence of this name is set", "Call glSetFenceNV before"),
               command);
  }
  return fence.get();  // only this context deletes it
}

}  // namespace
}  // namespace anteroom::gl

GL_API GLsync GL_APIENTRY glFenceSyncAPPLE(GLenum condition, GLbitfield flags) {
  Context* c = current();
  if (!c) return nullptr;
  if (condition != GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE) {
    c->setError(GL_INVALID_ENUM, wrongEnum("condition", condition, "Use SYNC_GPU_COMMANDS_COMPLETE_APPLE"));
    return nullptr;
  }
  if (flags != 0) {
    c->setError(GL_INVALID_VALUE, wrongNumber("flags", flags, "Give 0"));
    return nullptr;
  }
  ShareLock lock(*c->group);
  GLuint name = 0;
  std::shared_ptr<SyncObject> sync;
  try {
    sync = std::make_shared<SyncObject>();
  } catch (const std::bad_alloc&) {
  }
  if (!sync || !c->group->syncs.reserve(1, &name)) {
    c->setError(GL_OUT_OF_MEMORY);
    return nullptr;
  }
  sync->fence.insert(*c);
  c->group->syncs.put(name, std::move(sync));
  return reinterpret_cast<GLsync>(static_cast<uintptr_t>(name));
}

GL_API GLboolean GL_APIENTRY glIsSyncAPPLE(GLsync sync) {
  Context* c = current();
  return c && findSync(*c, sync) ? GL_TRUE : GL_FALSE;
}

// Who waits for it holds it until then.
GL_API void GL_APIENTRY glDeleteSyncAPPLE(GLsync sync) {
  Context* c = current();
  if (!c || !sync) return;
  ShareLock lock(*c->group);
  if (!c->group->syncs.remove(syncName(sync))) c->setError(GL_INVALID_VALUE, noSync());
}

// SYNC_FLUSH_COMMANDS_BIT_APPLE asks for nothing more: to insert a fence flushes.
GL_API GLenum GL_APIENTRY glClientWaitSyncAPPLE(GLsync sync, GLbitfield flags, GLuint64 timeout) {
  Context* c = current();
  if (!c) return GL_WAIT_FAILED_APPLE;
  const std::shared_ptr<SyncObject> found = findSync(*c, sync);
  if (!found || (flags & ~GLbitfield{GL_SYNC_FLUSH_COMMANDS_BIT_APPLE}) != 0) {
    c->setError(GL_INVALID_VALUE,
                found ? wrongNumber("flags", flags, "Give 0 or SYNC_FLUSH_COMMANDS_BIT_APPLE") : noSync());
    return GL_WAIT_FAILED_APPLE;
  }
  if (found->fence.wait(*c, 0)) return GL_ALREADY_SIGNALED_APPLE;
  const bool passed = timeout != 0 && found->fence.wait(*c, timeout);
  return passed ? GL_CONDITION_SATISFIED_APPLE : GL_TIMEOUT_EXPIRED_APPLE;
}

// What this context is given from now on is done after the fence anyway.
GL_API void GL_APIENTRY glWaitSyncAPPLE(GLsync sync, GLbitfield flags, GLuint64 timeout) {
  Context* c = current();
  if (!c) return;
  if (!findSync(*c, sync)) return c->setError(GL_INVALID_VALUE, noSync());
  if (flags != 0 || timeout != GL_TIMEOUT_IGNORED_APPLE)
    c->setError(GL_INVALID_VALUE, wrongState("flags or timeout is not the only value that there is",
                                             "Give 0 and TIMEOUT_IGNORED_APPLE"));
}

GL_API void GL_APIENTRY glGetSyncivAPPLE(GLsync sync, GLenum pname, GLsizei count, GLsizei* length,
                                         GLint* values) {
  Context* c = current();
  if (!c) return;
  const std::shared_ptr<SyncObject> found = findSync(*c, sync);
  if (!found) return c->setError(GL_INVALID_VALUE, noSync());
  if (count < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("bufSize", count, "Give a size from 0 on"));
  GLint value = 0;
  switch (pname) {
    case GL_OBJECT_TYPE_APPLE:
      value = GL_SYNC_FENCE_APPLE;
      break;
    case GL_SYNC_STATUS_APPLE:
      value = found->fence.wait(*c, 0) ? GL_SIGNALED_APPLE : GL_UNSIGNALED_APPLE;
      break;
    case GL_SYNC_CONDITION_APPLE:
      value = GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE;
      break;
    case GL_SYNC_FLAGS_APPLE:
      break;
    default:
      return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, "Use SYNC_STATUS_APPLE"));
  }
  const bool written = values && count > 0;
  if (written) *values = value;
  if (length) *length = written ? 1 : 0;
}

GL_API void GL_APIENTRY glGenFencesNV(GLsizei n, GLuint* fences) {
  generateNames(&Context::fences, n, fences);
}

// 0 is a name like any other for NV_fence.
GL_API void GL_APIENTRY glDeleteFencesNV(GLsizei n, const GLuint* fences) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("n", n, "Give a count from 0 on"));
  for (GLsizei i = 0; fences && i < n; ++i) c->fences.remove(fences[i]);
}

GL_API GLboolean GL_APIENTRY glIsFenceNV(GLuint fence) {
  Context* c = current();
  return c && c->fences.find(fence) ? GL_TRUE : GL_FALSE;
}

GL_API void GL_APIENTRY glSetFenceNV(GLuint fence, GLenum condition) {
  Context* c = current();
  if (!c) return;
  if (condition != GL_ALL_COMPLETED_NV)
    return c->setError(GL_INVALID_ENUM, wrongEnum("condition", condition, "Use ALL_COMPLETED_NV"));
  const std::shared_ptr<FenceObject> object = obtain(c->fences, fence);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  ShareLock lock(*c->group);
  object->fence.insert(*c);
}

GL_API GLboolean GL_APIENTRY glTestFenceNV(GLuint fence) {
  Context* c = current();
  if (!c) return GL_TRUE;
  FenceObject* object = findFence(*c, fence);
  return !object || object->fence.wait(*c, 0) ? GL_TRUE : GL_FALSE;
}

GL_API void GL_APIENTRY glFinishFenceNV(GLuint fence) {
  Context* c = current();
  if (!c) return;
  if (FenceObject* object = findFence(*c, fence)) object->fence.wait(*c, UINT64_MAX);
}

GL_API void GL_APIENTRY glGetFenceivNV(GLuint fence, GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  FenceObject* object = findFence(*c, fence);
  if (!object) return;
  if (pname != GL_FENCE_STATUS_NV && pname != GL_FENCE_CONDITION_NV)
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, "Use FENCE_STATUS_NV"));
  if (!params) return;
  *params = pname == GL_FENCE_CONDITION_NV ? GL_ALL_COMPLETED_NV : object->fence.wait(*c, 0);
}
