// fork() in a process that draws: see layer/egl/fork.h.
#pragma once

namespace anteroom::vulkan {

// While a thread has one, other threads' forks wait: the compilers' and drivers' own locks are free in every
// child, which can then make a device of its own.
class NoFork {
 public:
  NoFork();
  ~NoFork();
  NoFork(const NoFork&) = delete;
  NoFork& operator=(const NoFork&) = delete;

  // Forks wait from now on; before, none does.
  static void guardForks();
  // Before a device is made in a process that was forked from one with a device.
  static void prepareChild();
};

}  // namespace anteroom::vulkan
