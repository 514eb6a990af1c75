// APPLE_sync and NV_fence: points in the stream of commands.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "extension_commands.h"

namespace conformance {
namespace {

class Fences : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (onMesa()) GTEST_SKIP() << "Mesa has neither extension in ES 1.1";
    NEEDS_EXTENSION("GL_APPLE_sync");
    NEEDS_EXTENSION("GL_NV_fence");
  }
  GLint property(GLsync sync, GLenum name) const {
    GLint value = -1;
    GetSyncivAPPLE(sync, name, 1, nullptr, &value);
    return value;
  }
  GLsync fence() const { return FenceSyncAPPLE(GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE, 0); }

  const PFNGLFENCESYNCAPPLEPROC FenceSyncAPPLE = command<PFNGLFENCESYNCAPPLEPROC>("glFenceSyncAPPLE");
  const PFNGLISSYNCAPPLEPROC IsSyncAPPLE = command<PFNGLISSYNCAPPLEPROC>("glIsSyncAPPLE");
  const PFNGLDELETESYNCAPPLEPROC DeleteSyncAPPLE = command<PFNGLDELETESYNCAPPLEPROC>("glDeleteSyncAPPLE");
  const PFNGLCLIENTWAITSYNCAPPLEPROC ClientWaitSyncAPPLE =
      command<PFNGLCLIENTWAITSYNCAPPLEPROC>("glClientWaitSyncAPPLE");
  const PFNGLWAITSYNCAPPLEPROC WaitSyncAPPLE = command<PFNGLWAITSYNCAPPLEPROC>("glWaitSyncAPPLE");
  const PFNGLGETINTEGER64VAPPLEPROC GetInteger64vAPPLE =
      command<PFNGLGETINTEGER64VAPPLEPROC>("glGetInteger64vAPPLE");
  const PFNGLGETSYNCIVAPPLEPROC GetSyncivAPPLE = command<PFNGLGETSYNCIVAPPLEPROC>("glGetSyncivAPPLE");
  const PFNGLGENFENCESNVPROC GenFencesNV = command<PFNGLGENFENCESNVPROC>("glGenFencesNV");
  const PFNGLDELETEFENCESNVPROC DeleteFencesNV = command<PFNGLDELETEFENCESNVPROC>("glDeleteFencesNV");
  const PFNGLSETFENCENVPROC SetFenceNV = command<PFNGLSETFENCENVPROC>("glSetFenceNV");
  const PFNGLTESTFENCENVPROC TestFenceNV = command<PFNGLTESTFENCENVPROC>("glTestFenceNV");
  const PFNGLFINISHFENCENVPROC FinishFenceNV = command<PFNGLFINISHFENCENVPROC>("glFinishFenceNV");
  const PFNGLISFENCENVPROC IsFenceNV = command<PFNGLISFENCENVPROC>("glIsFenceNV");
  const PFNGLGETFENCEIVNVPROC GetFenceivNV = command<PFNGLGETFENCEIVNVPROC>("glGetFenceivNV");
};

constexpr GLuint64 kForever = std::numeric_limits<GLuint64>::max();

TEST_F(Fences, SyncObjects) {
  glColor4f(0, 1, 0, 1);
  for (int i = 0; i < 50; ++i) drawRect();
  const GLsync sync = fence();
  ASSERT_NE(sync, nullptr);
  EXPECT_TRUE(IsSyncAPPLE(sync));
  EXPECT_EQ(property(sync, GL_OBJECT_TYPE_APPLE), GL_SYNC_FENCE_APPLE);
  EXPECT_EQ(property(sync, GL_SYNC_CONDITION_APPLE), GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE);
  EXPECT_EQ(property(sync, GL_SYNC_FLAGS_APPLE), 0);
  const GLint status = property(sync, GL_SYNC_STATUS_APPLE);
  EXPECT_TRUE(status == GL_SIGNALED_APPLE || status == GL_UNSIGNALED_APPLE);
  WaitSyncAPPLE(sync, 0, GL_TIMEOUT_IGNORED_APPLE);
  const GLenum first = ClientWaitSyncAPPLE(sync, GL_SYNC_FLUSH_COMMANDS_BIT_APPLE, kForever);
  EXPECT_TRUE(first == GL_ALREADY_SIGNALED_APPLE || first == GL_CONDITION_SATISFIED_APPLE);
  EXPECT_EQ(property(sync, GL_SYNC_STATUS_APPLE), GL_SIGNALED_APPLE);
  // Signaled, it stays so; zero tests it.
  EXPECT_EQ(ClientWaitSyncAPPLE(sync, 0, 0), GLenum{GL_ALREADY_SIGNALED_APPLE});
  EXPECT_EQ(ClientWaitSyncAPPLE(sync, 0, kForever - 1), GLenum{GL_ALREADY_SIGNALED_APPLE});
  DeleteSyncAPPLE(sync);
  EXPECT_FALSE(IsSyncAPPLE(sync));
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
}

// Each finite wait has one of the two answers, and the fence passes without another flush.
TEST_F(Fences, FiniteWaits) {
  drawRect();
  const GLsync sync = fence();
  GLenum answer = GL_TIMEOUT_EXPIRED_APPLE;
  for (int i = 0; i < 200000 && answer == GL_TIMEOUT_EXPIRED_APPLE; ++i) {
    answer = ClientWaitSyncAPPLE(sync, 0, 1000000);
  }
  EXPECT_TRUE(answer == GL_ALREADY_SIGNALED_APPLE || answer == GL_CONDITION_SATISFIED_APPLE);
  DeleteSyncAPPLE(sync);
}

TEST_F(Fences, SyncQueries) {
  const GLsync sync = fence();
  GLint values[2] = {7, 7};
  GLsizei length = 7;
  GetSyncivAPPLE(sync, GL_OBJECT_TYPE_APPLE, 2, &length, values);
  EXPECT_EQ(length, 1);
  EXPECT_EQ(values[0], GL_SYNC_FENCE_APPLE);
  EXPECT_EQ(values[1], 7);
  values[0] = 7;
  GetSyncivAPPLE(sync, GL_OBJECT_TYPE_APPLE, 0, &length, values);
  EXPECT_EQ(length, 0);
  EXPECT_EQ(values[0], 7);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  GetSyncivAPPLE(sync, GL_TEXTURE_2D, 1, &length, values);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  GetSyncivAPPLE(sync, GL_OBJECT_TYPE_APPLE, -1, &length, values);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  GetSyncivAPPLE(nullptr, GL_OBJECT_TYPE_APPLE, 1, &length, values);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(length, 0);
  EXPECT_EQ(values[0], 7);
  DeleteSyncAPPLE(sync);
}

// Any simple query, in 64 bits.
TEST_F(Fences, Integer64) {
  GLint64 value = -1;
  GetInteger64vAPPLE(GL_MAX_SERVER_WAIT_TIMEOUT_APPLE, &value);
  EXPECT_GE(value, 0);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  GLint64 viewport[4] = {};
  GetInteger64vAPPLE(GL_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], width());
  GetInteger64vAPPLE(GL_DEPTH_TEST, &value);
  EXPECT_EQ(value, 0);
  GetInteger64vAPPLE(GL_MATRIX_MODE, &value);
  EXPECT_EQ(value, GL_MODELVIEW);
  glClearDepthf(1);
  GetInteger64vAPPLE(GL_DEPTH_CLEAR_VALUE, &value);
  EXPECT_EQ(value, 0x7fffffff);
  glLineWidth(2.6f);
  GetInteger64vAPPLE(GL_LINE_WIDTH, &value);
  EXPECT_EQ(value, 3);
  GetInteger64vAPPLE(0x1234, &value);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  GLint small = 0;
  glGetIntegerv(GL_MAX_SERVER_WAIT_TIMEOUT_APPLE, &small);
  EXPECT_GE(small, 0);
}

TEST_F(Fences, SyncErrors) {
  EXPECT_EQ(FenceSyncAPPLE(GL_SYNC_FENCE_APPLE, 0), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(FenceSyncAPPLE(GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE, 1), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  const GLsync sync = fence();
  EXPECT_EQ(ClientWaitSyncAPPLE(sync, 2, 0), GLenum{GL_WAIT_FAILED_APPLE});
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  WaitSyncAPPLE(sync, 1, GL_TIMEOUT_IGNORED_APPLE);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  WaitSyncAPPLE(sync, 0, 0);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  DeleteSyncAPPLE(nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  DeleteSyncAPPLE(sync);
  int local = 0;
  for (const GLsync none : {sync, GLsync{nullptr}, reinterpret_cast<GLsync>(~std::uintptr_t{0}),
                            reinterpret_cast<GLsync>(&local)}) {
    EXPECT_FALSE(IsSyncAPPLE(none));
    EXPECT_EQ(ClientWaitSyncAPPLE(none, 0, 0), GLenum{GL_WAIT_FAILED_APPLE});
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    WaitSyncAPPLE(none, 0, GL_TIMEOUT_IGNORED_APPLE);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    if (none) DeleteSyncAPPLE(none);
    if (none) {
      EXPECT_GL_ERROR(GL_INVALID_VALUE);
    }
  }
}

// Sync objects belong to the share group; what a context is told after WaitSync sees what was before.
TEST_F(Fences, BetweenContexts) {
  const GLuint texture = solidTexture(GL_RGBA, {255, 0, 0, 255});
  glFinish();
  const EGLContext here = eglGetCurrentContext();
  std::atomic<GLsync> handed{nullptr};
  std::atomic<int> wrong{0};
  std::thread other([&] {
    {
      const Session session(SurfaceRequest{}, here);
      wrong += !session.makeCurrent();
      const std::uint8_t green[] = {0, 255, 0, 255};
      glBindTexture(GL_TEXTURE_2D, texture);
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green);
      handed = fence();
      wrong += glGetError() != GL_NO_ERROR;
    }
    eglReleaseThread();
  });
  while (!handed && !wrong) std::this_thread::yield();
  WaitSyncAPPLE(handed, 0, GL_TIMEOUT_IGNORED_APPLE);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glBindTexture(GL_TEXTURE_2D, texture);
  glEnable(GL_TEXTURE_2D);
  glColor4f(1, 1, 1, 1);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
  other.join();
  EXPECT_EQ(wrong, 0);
  // Its context is gone.
  EXPECT_NE(ClientWaitSyncAPPLE(handed, 0, kForever), GLenum{GL_WAIT_FAILED_APPLE});
  DeleteSyncAPPLE(handed);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(Fences, NvFences) {
  GLuint names[2] = {};
  GenFencesNV(2, names);
  EXPECT_NE(names[0], names[1]);
  EXPECT_FALSE(IsFenceNV(names[0]));  // until it is set
  drawRect();
  SetFenceNV(names[0], GL_ALL_COMPLETED_NV);
  EXPECT_TRUE(IsFenceNV(names[0]));
  GLint value = 0;
  GetFenceivNV(names[0], GL_FENCE_CONDITION_NV, &value);
  EXPECT_EQ(value, GL_ALL_COMPLETED_NV);
  FinishFenceNV(names[0]);
  EXPECT_TRUE(TestFenceNV(names[0]));
  GetFenceivNV(names[0], GL_FENCE_STATUS_NV, &value);
  EXPECT_EQ(value, GL_TRUE);
  // Set anew, by a name that nobody reserved too; tests alone bring it to an end.
  for (const GLuint name : {names[0], GLuint{77777}}) {
    drawRect();
    SetFenceNV(name, GL_ALL_COMPLETED_NV);
    bool passed = false;
    for (int i = 0; i < 200000 && !passed; ++i) {
      passed = TestFenceNV(name);
      if (!passed) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(passed) << name;
  }
  const GLuint all[] = {names[0], names[1], 77777, 5555};
  DeleteFencesNV(4, all);
  EXPECT_FALSE(IsFenceNV(names[0]));
  EXPECT_FALSE(IsFenceNV(77777));
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(Fences, NvFenceErrors) {
  GLuint name = 0;
  GenFencesNV(-1, &name);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  DeleteFencesNV(-1, &name);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  GenFencesNV(1, &name);
  SetFenceNV(name, GL_FENCE_STATUS_NV);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_FALSE(IsFenceNV(name));
  EXPECT_TRUE(TestFenceNV(name));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  FinishFenceNV(name);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  GLint value = 7;
  GetFenceivNV(name, GL_FENCE_STATUS_NV, &value);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  SetFenceNV(name, GL_ALL_COMPLETED_NV);
  GetFenceivNV(name, GL_ALL_COMPLETED_NV, &value);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(value, 7);
  DeleteFencesNV(1, &name);
}

TEST_F(Fences, Labels) {
  NEEDS_EXTENSION("GL_EXT_debug_label");
  using Label = void (*)(GLenum, GLuint, GLsizei, const char*);
  using GetLabel = void (*)(GLenum, GLuint, GLsizei, GLsizei*, char*);
  COMMAND(Label, LabelObjectEXT);
  COMMAND(GetLabel, GetObjectLabelEXT);
  const GLsync sync = fence();
  const auto name = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(sync));
  LabelObjectEXT(GL_SYNC_OBJECT_APPLE, name, 0, "end of the frame");
  char text[32] = {};
  GLsizei length = 0;
  GetObjectLabelEXT(GL_SYNC_OBJECT_APPLE, name, sizeof text, &length, text);
  EXPECT_STREQ(text, "end of the frame");
  EXPECT_EQ(length, 16);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  DeleteSyncAPPLE(sync);
  GetObjectLabelEXT(GL_SYNC_OBJECT_APPLE, name, sizeof text, &length, text);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

}  // namespace
}  // namespace conformance
