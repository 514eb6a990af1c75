// EGL 1.5 section 3.10.4 and common sense: windows that are destroyed, at any time.
#include <dirent.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <thread>

#include "window_fixture.h"

namespace windows {
namespace {

std::size_t openFiles() {
  std::size_t count = 0;
  DIR* const folder = opendir("/proc/self/fd");
  while (readdir(folder)) ++count;
  closedir(folder);
  return count;
}

// Memory that is shared with the server, of either kind.
std::size_t sharedMaps() {
  std::ifstream maps("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(maps, line);)
    count += line.find("SYSV") != line.npos || line.find("memfd") != line.npos ||
             line.find("/shm/") != line.npos || line.find("/dev/zero") != line.npos;
  return count;
}

class LostWindows : public WindowTest {
 protected:
  // The window is gone: an error, or a picture that nobody sees.
  void swapLost(const Target& target) {
    if (swap(target)) return;
    const EGLint error = eglGetError();
    EXPECT_EQ(egl_conformance::errorName(error), "BAD_NATIVE_WINDOW");
  }
  void drawLost(const Target& target) {
    for (int frame = 0; frame < 4; ++frame) {
      drawPicture(64, 48, frame);
      glColor4f(1, 1, 1, 1);
      drawRect(3, 3, 9, 9, 0, 64, 48);
      readPixels(0, 0, 64, 48);
      swapLost(target);
    }
    EXPECT_GT(query(target, EGL_WIDTH), 0);
    EXPECT_GT(query(target, EGL_HEIGHT), 0);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
  void openOneAfterAnother(int count, const std::function<void(Target&, int)>& close);
};
ON_ALL_PLATFORMS(LostWindows);

TEST_P(LostWindows, WhileDrawing) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  drawPicture(64, 48, 1);
  target.native->destroy();
  drawLost(target);
}

TEST_P(LostWindows, AfterTheSwap) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  target.native->destroy();
  drawLost(target);
}

TEST_P(LostWindows, BeforeTheFirstFrame) {
  const EGLConfig config = windowConfig();
  Target& target = open(config);
  target.native->destroy();
  if (makeCurrent(target, context(config))) {
    drawLost(target);
  } else {
    EXPECT_EGL_ERROR(EGL_BAD_NATIVE_WINDOW);
  }
}

// A thread that is elsewhere comes back.
TEST_P(LostWindows, WhileNotCurrent) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  const EGLContext own = eglGetCurrentContext();
  Target& other = open(windowConfig(), {.x = 100});
  ASSERT_TRUE(makeCurrent(other, own));
  target.native->destroy();
  EXPECT_TRUE(drawsAndShows(other, 2));
  if (makeCurrent(target, own)) {
    drawLost(target);
  } else {
    EXPECT_EGL_ERROR(EGL_BAD_NATIVE_WINDOW);
  }
  ASSERT_TRUE(makeCurrent(other, own));
  EXPECT_TRUE(drawsAndShows(other, 3));
}

// The surface, current until later, before its window and after it.
TEST_P(LostWindows, SurfaceDestroyedWhileCurrent) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  EXPECT_TRUE(eglDestroySurface(display_, target.surface));
  target.surface = EGL_NO_SURFACE;
  drawPicture(64, 48, 1);
  EXPECT_TRUE(same(readPixels(0, 0, 64, 48), picture(64, 48, 1)));
  target.native->destroy();
  drawPicture(64, 48, 2);
  glFinish();
}

TEST_P(LostWindows, WithPreservedContents) {
  Target& target = openCurrent();
  if (!eglSurfaceAttrib(display_, target.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED)) {
    eglGetError();
    GTEST_SKIP() << "nothing preserves";
  }
  ASSERT_TRUE(drawsAndShows(target));
  target.native->destroy();
  drawLost(target);
}

TEST_P(LostWindows, WhileAnotherThreadDraws) {
  if (onWayland()) GTEST_SKIP() << "a wl_egl_window belongs to one thread";
  MESA_DISAGREES("3.10.4", "an X error reaches the program");
  const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 16});
  for (int times = 0; times < 4; ++times) {
    Target& target = open(config);
    const EGLContext own = context(config);
    std::atomic<int> frames = 0;
    std::thread drawing([&] {
      eglBindAPI(EGL_OPENGL_ES_API);
      EXPECT_TRUE(makeCurrent(target, own));
      eglSwapInterval(display_, 0);
      for (; frames < 60; ++frames) {
        drawPicture(64, 48, frames);
        swapLost(target);
      }
      eglReleaseThread();
    });
    while (frames < 10 + 5 * times) std::this_thread::yield();
    target.native->destroy();
    drawing.join();
  }
}

// Windows that are drawn to and closed one after the other: more of them hold no more files and memory.
void LostWindows::openOneAfterAnother(int count, const std::function<void(Target&, int)>& close) {
  const EGLConfig config = windowConfig();
  const EGLContext own = context(config);
  std::size_t files = 0, maps = 0;
  for (int i = 0; i < count; ++i) {
    Target target;
    target.native = native().createWindow(fitting(config));
    target.surface = eglCreatePlatformWindowSurface(display_, config, target.native->pointer(), nullptr);
    ASSERT_NE(target.surface, EGL_NO_SURFACE) << i;
    ASSERT_TRUE(makeCurrent(target, own));
    eglSwapInterval(display_, 0);
    for (int frame = 0; frame < 3; ++frame) {
      drawPicture(64, 48, i);
      ASSERT_TRUE(swap(target)) << i;
    }
    close(target, i);
    if (i == 9) {
      files = openFiles();
      maps = sharedMaps();
    }
  }
  EXPECT_LE(openFiles(), files);
  EXPECT_LE(sharedMaps(), maps);
}

TEST_P(LostWindows, FollowedByOthers) {
  openOneAfterAnother(50, [&](Target& target, int i) {
    if (i % 10 == 0) {
      EXPECT_TRUE(shows(*target.native, picture(64, 48, i))) << i;
    }
    if (i % 3 == 0) drawPicture(64, 48, i + 1);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_TRUE(eglDestroySurface(display_, target.surface));
    target.native.reset();
    native().complaints();
  });
}

// The window goes first, each time.
TEST_P(LostWindows, FollowedByOthersInTheWrongOrder) {
  openOneAfterAnother(20, [&](Target& target, int i) {
    target.native->destroy();
    if (i % 2) swapLost(target);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_TRUE(eglDestroySurface(display_, target.surface));
  });
}

}  // namespace
}  // namespace windows
