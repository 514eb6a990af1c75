#include "layer/vulkan/device/no_fork.h"

#include <pthread.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <shared_mutex>
#include <utility>

#include "layer/cache/quiet_thread.h"

namespace anteroom::vulkan {
namespace {

constinit std::shared_mutex gate;
constinit thread_local int depth = 0;
constinit thread_local bool closed = false;
int threadsAtFork = 0;  // guarded by the gate
int lostThreads = 0;    // of the parent; in the child only

int countThreads() {
  int count = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator task("/proc/self/task", error), end; !error && task != end;
       task.increment(error))
    ++count;
  return count;
}

// Mesa waits at exit for its drivers' threads, in a child for the parent's, too. The C library takes them for
// ended ones, and their stacks for its own: it gives them to new threads, or unmaps them, and the wait hangs
// or crashes. Threads that have these stacks, that are not to be waited for, and that do nothing, prevent
// both.
void keepStacks() {
  for (int left = std::exchange(lostThreads, 0); left > 0; --left) {
    std::thread keeper = cache::quietThread([] {
      for (;;) pause();
    });
    if (!keeper.joinable()) return;
    keeper.detach();
  }
}

// A driver that forks itself does so with the gate held.
void before() {
  if (depth != 0) return;
  gate.lock();
  closed = true;
  threadsAtFork = countThreads();
}

void afterInParent() {
  if (closed) gate.unlock();
  closed = false;
}

void afterInChild() {
  new (&gate) std::shared_mutex;
  if (depth != 0) gate.lock_shared();
  if (!std::exchange(closed, false)) return;
  lostThreads = threadsAtFork - 1;
  std::atexit(keepStacks);  // called before what the driver registered
}

}  // namespace

NoFork::NoFork() {
  if (depth++ == 0) gate.lock_shared();
}

NoFork::~NoFork() {
  if (--depth == 0) gate.unlock_shared();
}

void NoFork::guardForks() {
  static const int registered = pthread_atfork(before, afterInParent, afterInChild);
  static_cast<void>(registered);
}

void NoFork::prepareChild() {
  keepStacks();
}

}  // namespace anteroom::vulkan
