// Points in a context's stream of commands that programs name: APPLE_sync, NV_fence.
#pragma once

#include <atomic>

#include "layer/gl/context/context.h"

namespace anteroom::gl {

class Fence {
 public:
  // After all that `context` has been given so far. Under the ShareLock.
  void insert(Context& context);
  // Waits up to `timeout` ns: true when it has passed. Without the ShareLock.
  bool wait(Context& context, uint64_t timeout);

 private:
  uint64_t point_ = 0;
  std::atomic<bool> passed_{false};
};

// Of a share group; its name is what GLsync points to.
struct SyncObject {
  Fence fence;
  std::string label;
};

// The name that a GLsync is. 0: it is none.
inline GLuint syncName(const void* sync) {
  const auto name = reinterpret_cast<uintptr_t>(sync);
  return name <= ~GLuint{0} ? static_cast<GLuint>(name) : 0;
}

// NV_fence, of a context.
struct FenceObject {
  explicit FenceObject(GLuint) {}
  Fence fence;
};

}  // namespace anteroom::gl
