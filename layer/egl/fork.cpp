#include "layer/egl/fork.h"

#include <pthread.h>

#include <new>

#include "layer/egl/current.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

constinit thread_local bool tookLock = false;

// No other thread is in a command.
void before() {
  if (mutex().isMine()) return;
  mutex().lock();
  tookLock = true;
}

void afterInParent() {
  if (!tookLock) return;
  tookLock = false;
  mutex().unlock();
}

void afterInChild() {
  new (&mutex()) Mutex;
  tookLock = false;
  abandonBinding();
  abandonDisplays();
}

}  // namespace

void registerForkHandlers() {
  static const int registered = pthread_atfork(before, afterInParent, afterInChild);
  static_cast<void>(registered);
}

}  // namespace anteroom::egl
