// EGL 1.5 section 3.8: fence syncs.
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

}  // namespace
}  // namespace egl_conformance
