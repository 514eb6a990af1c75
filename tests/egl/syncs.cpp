// EGL 1.5 section 3.8: fence syncs, and EGL_KHR_reusable_sync.
#include <atomic>
#include <chrono>
#include <thread>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Syncs : public EglTest {
 protected:
  void makeCurrent() {
    const EGLConfig config = choose();
    const EGLSurface surface = createPbuffer(config);
    ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  }
};

// Table 3.7, 3.8.1.3
TEST_F(Syncs, Fence) {
  makeCurrent();
  glClear(GL_COLOR_BUFFER_BIT);
  const EGLSync sync = eglCreateSync(display_, EGL_SYNC_FENCE, nullptr);
  ASSERT_NE(sync, EGL_NO_SYNC);
  EGLAttrib value = 0;
  EXPECT_TRUE(eglGetSyncAttrib(display_, sync, EGL_SYNC_TYPE, &value));
  EXPECT_EQ(value, EGL_SYNC_FENCE);
  EXPECT_TRUE(eglGetSyncAttrib(display_, sync, EGL_SYNC_CONDITION, &value));
  EXPECT_EQ(value, EGL_SYNC_PRIOR_COMMANDS_COMPLETE);
  EXPECT_TRUE(eglWaitSync(display_, sync, 0));
  EXPECT_EQ(eglClientWaitSync(display_, sync, EGL_SYNC_FLUSH_COMMANDS_BIT, EGL_FOREVER),
            EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(eglGetSyncAttrib(display_, sync, EGL_SYNC_STATUS, &value));
  EXPECT_EQ(value, EGL_SIGNALED);
  EXPECT_EQ(eglClientWaitSync(display_, sync, 0, 0), EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(eglDestroySync(display_, sync));
  EXPECT_FALSE(eglDestroySync(display_, sync));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// A finite wait without a flush returns one of the two answers and does not hang.
TEST_F(Syncs, FiniteWait) {
  makeCurrent();
  glClear(GL_COLOR_BUFFER_BIT);
  const EGLSync sync = eglCreateSync(display_, EGL_SYNC_FENCE, nullptr);
  const EGLint answer = eglClientWaitSync(display_, sync, 0, 1000000);
  EXPECT_TRUE(answer == EGL_CONDITION_SATISFIED || answer == EGL_TIMEOUT_EXPIRED);
  glFinish();
  EXPECT_EQ(eglClientWaitSync(display_, sync, EGL_SYNC_FLUSH_COMMANDS_BIT, EGL_FOREVER),
            EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(eglDestroySync(display_, sync));
}

TEST_F(Syncs, Errors) {
  EXPECT_EQ(eglCreateSync(display_, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC) << "no context";
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  makeCurrent();
  EXPECT_EQ(eglCreateSync(display_, 0x1234, nullptr), EGL_NO_SYNC);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  const EGLAttrib unknown[] = {EGL_SYNC_STATUS, EGL_SIGNALED, EGL_NONE};
  EXPECT_EQ(eglCreateSync(display_, EGL_SYNC_FENCE, unknown), EGL_NO_SYNC);
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglDestroySync(display_, EGL_NO_SYNC));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_EQ(eglClientWaitSync(display_, EGL_NO_SYNC, 0, 0), EGL_FALSE);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglWaitSync(display_, EGL_NO_SYNC, 0));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  const EGLSync sync = eglCreateSync(display_, EGL_SYNC_FENCE, nullptr);
  EGLAttrib value = 77;
  EXPECT_FALSE(eglGetSyncAttrib(display_, sync, EGL_WIDTH, &value));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(value, 77);
  EXPECT_FALSE(eglWaitSync(display_, sync, 5));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_TRUE(eglDestroySync(display_, sync));
}

// EGL_KHR_reusable_sync
class ReusableSyncs : public EglTest {
 protected:
  EGLSyncKHR create() const { return createSync(display_, EGL_SYNC_REUSABLE_KHR, nullptr); }
  EGLint get(EGLSyncKHR sync, EGLint name) const {
    EGLint value = -1;
    EXPECT_TRUE(getAttribute(display_, sync, name, &value));
    return value;
  }
  template <class Command>
  static Command command(const char* name) {
    return reinterpret_cast<Command>(eglGetProcAddress(name));
  }
  const PFNEGLCREATESYNCKHRPROC createSync = command<PFNEGLCREATESYNCKHRPROC>("eglCreateSyncKHR");
  const PFNEGLDESTROYSYNCKHRPROC destroySync = command<PFNEGLDESTROYSYNCKHRPROC>("eglDestroySyncKHR");
  const PFNEGLCLIENTWAITSYNCKHRPROC clientWait = command<PFNEGLCLIENTWAITSYNCKHRPROC>("eglClientWaitSyncKHR");
  const PFNEGLSIGNALSYNCKHRPROC signal = command<PFNEGLSIGNALSYNCKHRPROC>("eglSignalSyncKHR");
  const PFNEGLGETSYNCATTRIBKHRPROC getAttribute = command<PFNEGLGETSYNCATTRIBKHRPROC>("eglGetSyncAttribKHR");
};

TEST_F(ReusableSyncs, SignalAndUnsignal) {
  EXPECT_TRUE(names(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_reusable_sync"));
  const EGLSyncKHR sync = create();  // needs no context
  ASSERT_NE(sync, EGL_NO_SYNC_KHR);
  EXPECT_EQ(get(sync, EGL_SYNC_TYPE_KHR), EGL_SYNC_REUSABLE_KHR);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(get(sync, EGL_SYNC_STATUS_KHR), EGL_UNSIGNALED_KHR);
    EXPECT_EQ(clientWait(display_, sync, 0, 0), EGL_TIMEOUT_EXPIRED_KHR);
    EXPECT_EQ(clientWait(display_, sync, EGL_SYNC_FLUSH_COMMANDS_BIT_KHR, 1000000), EGL_TIMEOUT_EXPIRED_KHR);
    EXPECT_TRUE(signal(display_, sync, EGL_SIGNALED_KHR));
    EXPECT_EQ(get(sync, EGL_SYNC_STATUS_KHR), EGL_SIGNALED_KHR);
    EXPECT_EQ(clientWait(display_, sync, 0, EGL_FOREVER_KHR), EGL_CONDITION_SATISFIED_KHR);
    EXPECT_EQ(clientWait(display_, sync, 0, EGL_FOREVER_KHR - 1), EGL_CONDITION_SATISFIED_KHR);
    EXPECT_TRUE(signal(display_, sync, EGL_UNSIGNALED_KHR));
  }
  EXPECT_TRUE(destroySync(display_, sync));
}

// Every transition releases who waits, even when it is taken back at once; and so does the end of the sync.
TEST_F(ReusableSyncs, ReleaseThreads) {
  for (const bool destroy : {false, true}) {
    const EGLSyncKHR sync = create();
    std::atomic<int> waiting = 0, released = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i) {
      threads.emplace_back([&] {
        ++waiting;
        released += clientWait(display_, sync, 0, EGL_FOREVER_KHR) == EGL_CONDITION_SATISFIED_KHR;
        eglReleaseThread();
      });
    }
    while (waiting < 3) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(released, 0);
    if (destroy) {
      EXPECT_TRUE(destroySync(display_, sync));
    } else {
      EXPECT_TRUE(signal(display_, sync, EGL_SIGNALED_KHR));
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(released, 3);
    if (!destroy) {
      EXPECT_TRUE(destroySync(display_, sync));
    }
  }
}

TEST_F(ReusableSyncs, ServerWaits) {
  MESA_DISAGREES("EGL_KHR_wait_sync", "the server does not wait for reusable syncs");
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  const EGLSyncKHR sync = create();
  std::atomic<bool> signaled = false;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    signaled = true;
    EXPECT_TRUE(signal(display_, sync, EGL_SIGNALED_KHR));
    eglReleaseThread();
  });
  EXPECT_TRUE(eglWaitSync(display_, sync, 0));
  glFinish();
  EXPECT_TRUE(signaled);
  other.join();
  EXPECT_TRUE(destroySync(display_, sync));
}

TEST_F(ReusableSyncs, Errors) {
  const EGLint unknown[] = {EGL_SYNC_STATUS_KHR, EGL_SIGNALED_KHR, EGL_NONE};
  EXPECT_EQ(createSync(display_, EGL_SYNC_REUSABLE_KHR, unknown), EGL_NO_SYNC_KHR);
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(createSync(display_, 0x1234, nullptr), EGL_NO_SYNC_KHR);
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(createSync(EGL_NO_DISPLAY, EGL_SYNC_REUSABLE_KHR, nullptr), EGL_NO_SYNC_KHR);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_FALSE(signal(display_, EGL_NO_SYNC_KHR, EGL_SIGNALED_KHR));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  const EGLSyncKHR sync = create();
  EXPECT_FALSE(signal(display_, sync, EGL_SYNC_FENCE_KHR));
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  EXPECT_EQ(get(sync, EGL_SYNC_STATUS_KHR), EGL_UNSIGNALED_KHR);
  EGLint value = 77;
  EXPECT_FALSE(getAttribute(display_, sync, EGL_SYNC_CONDITION_KHR, &value));
  EXPECT_EGL_ERROR(onMesa() ? EGL_BAD_ATTRIBUTE : EGL_BAD_MATCH);
  EXPECT_FALSE(getAttribute(display_, sync, EGL_WIDTH, &value));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(value, 77);
  EXPECT_TRUE(destroySync(display_, sync));
  EXPECT_EQ(clientWait(display_, sync, 0, 0), EGL_FALSE);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  // A fence is signaled by the commands before it alone.
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  const EGLSyncKHR fence = createSync(display_, EGL_SYNC_FENCE_KHR, nullptr);
  EXPECT_FALSE(signal(display_, fence, EGL_SIGNALED_KHR));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_TRUE(destroySync(display_, fence));
}

}  // namespace
}  // namespace egl_conformance
