// How a context joins one that works without the lock.
#include <linux/membarrier.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "layer/gl/context/context.h"

namespace anteroom::gl {
namespace {

// What each thread stored before is seen by this one, and what this one stored before by each.
void orderAllThreads() {
  syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0);
  if (syscall(SYS_membarrier, MEMBARRIER_CMD_PRIVATE_EXPEDITED, 0, 0) == 0) return;
  // Forbidden here, or an old kernel: no store stays unseen for so long.
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace

void ShareGroup::tell(gen::Groups groups) const {
  for (Context* context = first; context; context = context->nextOfGroup) context->told |= groups;
}

void ShareGroup::awaitCommand() const {
  if (contexts.load() != 2) return;
  orderAllThreads();
  for (int i = 0; inCommand.load(std::memory_order_acquire); ++i) {
    if (i < 100)
      std::this_thread::yield();
    else
      std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

}  // namespace anteroom::gl
