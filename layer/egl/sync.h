// Section 3.8.1: fences in a context's stream of commands.
#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <memory>

#include "layer/egl/context.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

class Sync {
 public:
  // A fence after all that `context`, which is current, has been told so far.
  explicit Sync(const std::shared_ptr<Context>& context);

  // Waits up to `timeout` ns without the lock. True: signaled. Fences have been submitted: this ends.
  bool wait(Lock& lock, uint64_t timeout);

  void* handle = nullptr;

 private:
  std::weak_ptr<Context> context_;  // gone: it finished
  uint64_t fence_;
  bool signaled_ = false;
};

}  // namespace anteroom::egl
