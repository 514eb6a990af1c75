// Section 3.8.1: fences in a context's stream of commands; and EGL_KHR_reusable_sync: what programs signal.
#pragma once

#include <EGL/egl.h>

#include <condition_variable>
#include <cstdint>
#include <memory>

#include "layer/egl/context.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

class Sync {
 public:
  virtual ~Sync() = default;
  virtual EGLenum type() const = 0;
  // Waits up to `timeout` ns, EGL_FOREVER without end, without the lock. True: signaled.
  virtual bool wait(Lock& lock, uint64_t timeout) = 0;
  // The current context goes on when it is signaled.
  virtual void waitInServer(Lock& lock) = 0;
  // Its handle is gone: who waits goes on.
  virtual void abandon() {}

  void* handle = nullptr;
};

class FenceSync final : public Sync {
 public:
  // A fence after all that `context`, which is current, has been given so far.
  explicit FenceSync(const std::shared_ptr<Context>& context);

  EGLenum type() const override { return EGL_SYNC_FENCE; }
  // Fences have been submitted: every wait ends.
  bool wait(Lock& lock, uint64_t timeout) override;
  // A renderer's contexts keep the order by themselves (layer/render/renderer.h).
  void waitInServer(Lock&) override {}

 private:
  std::weak_ptr<Context> context_;  // gone: it finished
  uint64_t fence_;
  bool signaled_ = false;
};

class ReusableSync final : public Sync {
 public:
  EGLenum type() const override;
  bool wait(Lock& lock, uint64_t timeout) override;
  // There is no server but this thread.
  void waitInServer(Lock& lock) override { wait(lock, EGL_FOREVER); }
  void abandon() override { set(true); }
  void set(bool signaled);

 private:
  std::condition_variable_any changed_;
  bool signaled_ = false;
  uint64_t signals_ = 0;  // how often it became signaled: each releases who waits, even when it lasts no time
};

}  // namespace anteroom::egl
