#pragma once

#include <pthread.h>
#include <signal.h>

#include <system_error>
#include <thread>

namespace anteroom::gen {

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

}  // namespace anteroom::gen
