#pragma once

#include <pthread.h>
#include <signal.h>

#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace anteroom::cache {

// A thread that takes no signals: they are for the program's own threads. Not joinable: there is none to be
// had.
template <class Body>
std::thread quietThread(Body body) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread;
  try {
    thread = std::thread(body);
  } catch (const std::system_error&) {
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

// In a forked process, where the thread is not: its handle is dropped. To detach or to join it would look for
// it in memory that is another's by now.
inline void forget(std::thread& thread) {
  static auto& forgotten = *new std::vector<std::thread>;
  if (thread.joinable()) forgotten.push_back(std::move(thread));
}

}  // namespace anteroom::cache
