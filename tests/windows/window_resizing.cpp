// EGL 1.5 section 3.10.1.1: surfaces follow their windows.
#include <random>

#include "window_fixture.h"

namespace windows {
namespace {

class WindowResizing : public WindowTest {
 protected:
  // Frames until the surface has the window's new size, at most a few. Mesa may tell of it a frame too early.
  testing::AssertionResult follows(Target& target, int width, int height, int frame = 0) {
    target.native->resize(width, height);
    for (int tries = egl_conformance::onMesa() ? -1 : 0; tries < 5; ++tries) {
      if (tries >= 0 && query(target, EGL_WIDTH) == width && query(target, EGL_HEIGHT) == height)
        return drawsAndShows(target, frame);
      drawPicture(query(target, EGL_WIDTH), query(target, EGL_HEIGHT), frame);
      if (!swap(target)) return egl_conformance::eglErrorIs(EGL_SUCCESS) << " of eglSwapBuffers";
    }
    return testing::AssertionFailure()
           << "the surface stays " << query(target, EGL_WIDTH) << "x" << query(target, EGL_HEIGHT)
           << ", the window is " << width << "x" << height;
  }
};
ON_ALL_PLATFORMS(WindowResizing);

TEST_P(WindowResizing, GrowsAndShrinks) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  const int sizes[][2] = {{128, 96}, {32, 24}, {32, 200}, {300, 20}, {1, 1},
                          {2, 1},    {1, 3},   {64, 48},  {65, 47}};
  int frame = 0;
  for (const auto& size : sizes)
    EXPECT_TRUE(follows(target, size[0], size[1], ++frame)) << size[0] << "x" << size[1];
}

TEST_P(WindowResizing, FromOnePixel) {
  Target& target = openCurrent({.width = 1, .height = 1});
  EXPECT_EQ(query(target, EGL_WIDTH), 1);
  EXPECT_TRUE(drawsAndShows(target));
  EXPECT_TRUE(follows(target, 77, 55));
}

// Whatever size the surface has at the moment is drawn; at the end all of the window is there.
TEST_P(WindowResizing, AtRandomWhileDrawing) {
  Target& target = openCurrent();
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    target.native->resize(1 + int(random() % 220), 1 + int(random() % 170));
    for (unsigned frames = random() % 3; frames > 0; --frames) {
      const int width = query(target, EGL_WIDTH), height = query(target, EGL_HEIGHT);
      drawPicture(width, height, i);
      // Resized between the query and the drawing, it would be another size.
      if (random() % 8 == 0 && query(target, EGL_WIDTH) == width && query(target, EGL_HEIGHT) == height) {
        ASSERT_TRUE(same(readPixels(0, 0, width, height), picture(width, height, i))) << i;
      }
      ASSERT_TRUE(swap(target)) << i;
    }
  }
  EXPECT_TRUE(follows(target, 101, 77));
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

// In one go, without a frame between them.
TEST_P(WindowResizing, ManyTimesBeforeAFrame) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  for (int i = 0; i < 30; ++i) target.native->resize(10 + i, 90 - i);
  EXPECT_TRUE(follows(target, 90, 60, 1));
}

// 3.10.1.1: viewport and scissor box are the program's.
TEST_P(WindowResizing, ViewportStays) {
  Target& target = openCurrent();
  ASSERT_TRUE(follows(target, 100, 80));
  GLint box[4] = {};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 64, 48}));
  const EGLContext own = eglGetCurrentContext();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  ASSERT_TRUE(makeCurrent(target, own));
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 64, 48}));
}

TEST_P(WindowResizing, WhileNotCurrent) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  const EGLContext own = eglGetCurrentContext();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  target.native->resize(120, 90);
  ASSERT_TRUE(makeCurrent(target, own));
  EXPECT_TRUE(follows(target, 120, 90, 2));
}

TEST_P(WindowResizing, BeforeTheFirstFrame) {
  const EGLConfig config = windowConfig();
  Target& target = open(config);
  target.native->resize(90, 70);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  EXPECT_TRUE(follows(target, 90, 70));
}

// Depth and stencil buffers and samples grow with the color buffer.
TEST_P(WindowResizing, AncillaryBuffers) {
  for (EGLint samples : {0, 4}) {
    const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8, EGL_SAMPLES, samples});
    if (!config) continue;
    Target& target = open(config, {.x = 50 * samples});
    ASSERT_TRUE(makeCurrent(target, context(config)));
    ASSERT_TRUE(drawsAndShows(target));
    ASSERT_TRUE(follows(target, 150, 100));
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glColor4f(0, 1, 0, 1);
    drawRect(80, 60, 60, 30, 0.5f, 150, 100);
    glColor4f(1, 0, 0, 1);
    drawRect(70, 50, 60, 30, -0.5f, 150, 100);
    glDisable(GL_DEPTH_TEST);
    Image expected(150, 100);
    paint(expected, {70, 50, 60, 30, {255, 0, 0}});
    paint(expected, {80, 60, 60, 30, {0, 255, 0}});
    EXPECT_TRUE(same(readPixels(0, 0, 150, 100), expected));
    EXPECT_TRUE(swap(target));
    EXPECT_TRUE(shows(*target.native, expected));
  }
}

TEST_P(WindowResizing, BeyondTheScreen) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  const NativeDisplay::ScreenSize screen = native().screenSize();
  target.native->resize(screen.width + 200, screen.height + 100);
  for (int tries = 0; tries < 5 && query(target, EGL_WIDTH) == 64; ++tries) {
    drawPicture(64, 48);
    ASSERT_TRUE(swap(target));
  }
  EXPECT_EQ(query(target, EGL_WIDTH), screen.width + 200);
  EXPECT_TRUE(follows(target, 64, 48));
}

}  // namespace
}  // namespace windows
