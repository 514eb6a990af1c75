// EGL 1.5 section 3.7.3: several windows, contexts and threads at once.
#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "window_fixture.h"

namespace windows {
namespace {

constexpr int kWidth = 64, kHeight = 48;

class ManyWindows : public WindowTest {};
ON_ALL_PLATFORMS(ManyWindows);

TEST_P(ManyWindows, OneContext) {
  const EGLConfig config = windowConfig();
  const EGLContext own = context(config);
  std::vector<Target*> targets;
  for (int i = 0; i < 3; ++i)
    targets.push_back(&open(config, {.width = 60 + i, .height = 40 + 3 * i, .x = 80 * i}));
  for (int frame = 0; frame < 6; ++frame) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      ASSERT_TRUE(makeCurrent(*targets[i], own));
      eglSwapInterval(display_, 0);
      const int width = 60 + int(i), height = 40 + 3 * int(i);
      drawPicture(width, height, frame + int(i));
      ASSERT_TRUE(same(readPixels(0, 0, width, height), picture(width, height, frame + int(i))));
      ASSERT_TRUE(swap(*targets[i]));
    }
  }
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_TRUE(shows(*targets[i]->native, picture(60 + int(i), 40 + 3 * int(i), 5 + int(i)))) << i;
}

// Nothing is lost when every picture is drawn in halves, with the other windows between them.
TEST_P(ManyWindows, HalvesInTurn) {
  const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 16});
  const EGLContext own = context(config);
  Target &one = open(config), &two = open(config, {.x = 100});
  for (int half = 0; half < 2; ++half) {
    for (Target* target : {&one, &two}) {
      ASSERT_TRUE(makeCurrent(*target, own));
      const std::vector<Block> blocks = quarters(kWidth, kHeight, target == &one ? 0 : 1);
      const std::size_t middle = 2;
      for (std::size_t i = half ? middle : 0; i < (half ? blocks.size() : middle); ++i) draw(blocks[i]);
      ASSERT_TRUE(half == 0 || swap(*target));
    }
  }
  EXPECT_TRUE(shows(*one.native, picture(kWidth, kHeight, 0)));
  EXPECT_TRUE(shows(*two.native, picture(kWidth, kHeight, 1)));
}

TEST_P(ManyWindows, DrawAndReadDiffer) {
  const EGLConfig config = windowConfig();
  const EGLContext own = context(config);
  Target &one = open(config), &two = open(config, {.x = 100});
  ASSERT_TRUE(makeCurrent(one, own));
  drawPicture(kWidth, kHeight, 0);
  ASSERT_TRUE(eglMakeCurrent(display_, two.surface, one.surface, own));
  drawPicture(kWidth, kHeight, 1);
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, 0)));
  EXPECT_TRUE(swap(two));
  EXPECT_TRUE(same(readPixels(5, 7, 31, 23), picture(kWidth, kHeight, 0).part(5, 7, 31, 23)));
  ASSERT_TRUE(eglMakeCurrent(display_, one.surface, two.surface, own));
  EXPECT_TRUE(swap(one));
  EXPECT_TRUE(shows(*one.native, picture(kWidth, kHeight, 0)));
  EXPECT_TRUE(shows(*two.native, picture(kWidth, kHeight, 1)));
}

// A context off the screen makes the texture that one of a window draws, and gets the window's picture back.
TEST_P(ManyWindows, SharedWithAPbuffer) {
  const EGLConfig config = windowConfig(), offScreen = pbufferConfig(config);
  if (!offScreen) GTEST_SKIP() << "no pbuffers that are compatible";
  Target& target = open(config);
  const EGLSurface pbuffer = createPbuffer(offScreen, {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight});
  const EGLContext here = context(config), there = context(offScreen, here);
  GLuint textures[2] = {};
  const auto useTexture = [](GLuint texture) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
  };
  const auto drawTexture = [] {
    // 64 by 64 texels, of which 48 rows are the picture.
    const GLfloat vertices[] = {-1, -1, 1, -1, -1, 1, 1, 1}, coordinates[] = {0, 0, 1, 0, 0, 0.75f, 1, 0.75f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices);
    glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  ASSERT_TRUE(eglMakeCurrent(display_, pbuffer, pbuffer, there));
  drawPicture(kWidth, kHeight, 1);
  glGenTextures(2, textures);
  for (GLuint texture : textures) {
    useTexture(texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  }
  useTexture(textures[0]);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kWidth, kHeight);
  glFinish();
  ASSERT_TRUE(makeCurrent(target, here));
  useTexture(textures[0]);
  drawTexture();
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, 1)));
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, picture(kWidth, kHeight, 1)));
  drawPicture(kWidth, kHeight, 2);
  useTexture(textures[1]);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kWidth, kHeight);
  glFinish();
  ASSERT_TRUE(eglMakeCurrent(display_, pbuffer, pbuffer, there));
  useTexture(textures[1]);
  drawTexture();
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, 2)));
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  EXPECT_TRUE(eglDestroySurface(display_, pbuffer));
}

TEST_P(ManyWindows, AThreadEach) {
  const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 16});
  constexpr int kThreads = 4;
  std::vector<Target*> targets;
  std::vector<EGLContext> contexts;
  for (int i = 0; i < kThreads; ++i) {
    targets.push_back(&open(config, {.x = 80 * i}));
    contexts.push_back(context(config, i % 2 ? contexts.back() : EGL_NO_CONTEXT));
  }
  std::vector<int> wrong(kThreads);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      int& faults = wrong[std::size_t(i)];
      eglBindAPI(EGL_OPENGL_ES_API);
      faults += !makeCurrent(*targets[std::size_t(i)], contexts[std::size_t(i)]);
      eglSwapInterval(display_, i % 2);
      for (int frame = 0; frame < 25; ++frame) {
        drawPicture(kWidth, kHeight, frame + i);
        if (frame % 5 == 0)
          faults += !same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, frame + i));
        faults += !swap(*targets[std::size_t(i)]);
      }
      eglReleaseThread();
    });
  }
  for (std::thread& each : threads) each.join();
  for (int i = 0; i < kThreads; ++i) {
    EXPECT_EQ(wrong[std::size_t(i)], 0) << i;
    EXPECT_TRUE(shows(*targets[std::size_t(i)]->native, picture(kWidth, kHeight, 24 + i))) << i;
  }
}

// One window, drawn by one thread after the other; in between it is resized.
TEST_P(ManyWindows, HandedFromThreadToThread) {
  const EGLConfig config = windowConfig();
  Target& target = open(config);
  const EGLContext own = context(config);
  for (int turn = 0; turn < 6; ++turn) {
    const int width = 40 + 9 * turn, height = 70 - 5 * turn;
    target.native->resize(width, height);
    testing::AssertionResult result = testing::AssertionFailure();
    std::thread([&] {
      eglBindAPI(EGL_OPENGL_ES_API);
      if (!makeCurrent(target, own)) return;
      for (int tries = 0; tries < 4; ++tries) {
        drawPicture(query(target, EGL_WIDTH), query(target, EGL_HEIGHT), turn);
        swap(target);
      }
      result = drawsAndShows(target, turn);
      eglReleaseThread();
    }).join();
    ASSERT_TRUE(result) << turn;
    EXPECT_EQ(query(target, EGL_WIDTH), width);
  }
}

// The server tells a thread that draws of another size at any moment.
TEST_P(ManyWindows, ResizedByAnotherThread) {
  if (onWayland()) GTEST_SKIP() << "a wl_egl_window belongs to one thread";
  const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 16});
  Target& target = open(config);
  const EGLContext own = context(config);
  std::atomic<bool> done = false;
  int faults = 0, frames = 0;
  std::thread drawing([&] {
    eglBindAPI(EGL_OPENGL_ES_API);
    faults += !makeCurrent(target, own);
    eglSwapInterval(display_, 0);
    for (; !done; ++frames) {
      drawPicture(query(target, EGL_WIDTH), query(target, EGL_HEIGHT), frames);
      faults += !swap(target);
    }
    eglReleaseThread();
  });
  std::mt19937 random(9);
  for (int i = 0; i < 150; ++i) {
    target.native->resize(1 + int(random() % 300), 1 + int(random() % 200));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
  }
  target.native->resize(90, 60);
  done = true;
  drawing.join();
  EXPECT_EQ(faults, 0);
  EXPECT_GT(frames, 0);
  ASSERT_TRUE(makeCurrent(target, own));
  for (int tries = 0; tries < 3; ++tries) {
    drawPicture(query(target, EGL_WIDTH), query(target, EGL_HEIGHT));
    ASSERT_TRUE(swap(target));
  }
  EXPECT_EQ(query(target, EGL_WIDTH), 90);
  EXPECT_TRUE(drawsAndShows(target));
}

// 3.7.3: a window that another thread draws to.
TEST_P(ManyWindows, CurrentElsewhere) {
  Target& target = openCurrent();
  const EGLContext other = context(windowConfig());
  EGLint error = EGL_SUCCESS;
  std::thread([&] {
    eglBindAPI(EGL_OPENGL_ES_API);
    if (!makeCurrent(target, other)) error = eglGetError();
    eglReleaseThread();
  }).join();
  EXPECT_EQ(egl_conformance::errorName(error), "BAD_ACCESS");
  EXPECT_TRUE(drawsAndShows(target));
}

}  // namespace
}  // namespace windows
