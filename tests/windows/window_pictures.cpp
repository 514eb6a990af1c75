// EGL 1.5 section 3.10: what is posted is what was drawn, the right way up, in all configs.
#include <set>

#include "window_fixture.h"

namespace windows {
namespace {

class WindowPictures : public WindowTest {
 protected:
  // A picture that needs everything the config has: three rectangles behind each other, one inside of a
  // stencil.
  void drawLayers(EGLConfig config, int width, int height) const;
  Image layers(EGLConfig config, int width, int height) const;
};
ON_ALL_PLATFORMS(WindowPictures);

void WindowPictures::drawLayers(EGLConfig config, int width, int height) const {
  drawPicture(width, height);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  if (attribute(config, EGL_DEPTH_SIZE) > 0) glEnable(GL_DEPTH_TEST);
  glColor4f(0, 0, 0, 1);
  drawRect(10, 10, 20, 20, 0.5f, width, height);
  glColor4f(1, 0, 1, 1);
  drawRect(20, 4, 20, 20, -0.5f, width, height);
  glDisable(GL_DEPTH_TEST);
  if (attribute(config, EGL_STENCIL_SIZE) > 0) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawRect(44, 30, 8, 10, 0, width, height);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_EQUAL, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  }
  glColor4f(0, 0, 0, 1);
  drawRect(40, 28, 8, 10, 0, width, height);
  glDisable(GL_STENCIL_TEST);
}

Image WindowPictures::layers(EGLConfig config, int width, int height) const {
  Image image = picture(width, height);
  // z = 0.5 is in front of -0.5: glOrthof looks along -z.
  const bool depth = attribute(config, EGL_DEPTH_SIZE) > 0, stencil = attribute(config, EGL_STENCIL_SIZE) > 0;
  const Block front{10, 10, 20, 20, {0, 0, 0}}, back{20, 4, 20, 20, {255, 0, 255}};
  paint(image, depth ? back : front);
  paint(image, depth ? front : back);
  paint(image, stencil ? Block{44, 30, 4, 8, {0, 0, 0}} : Block{40, 28, 8, 10, {0, 0, 0}});
  return image;
}

// Every format, and depth, stencil and samples beside it.
TEST_P(WindowPictures, EveryConfig) {
  std::set<std::vector<EGLint>> seen;
  for (EGLConfig config : windowConfigs()) {
    std::vector<EGLint> key;
    for (EGLint name : {EGL_RED_SIZE, EGL_ALPHA_SIZE}) key.push_back(attribute(config, name));
    for (EGLint name : {EGL_DEPTH_SIZE, EGL_STENCIL_SIZE, EGL_SAMPLES})
      key.push_back(attribute(config, name) > 0);
    if (!seen.insert(key).second) continue;
    SCOPED_TRACE(testing::Message() << "red " << key[0] << " alpha " << key[1] << " depth " << key[2]
                                    << " stencil " << key[3] << " samples " << key[4]);
    Target& target = open(config);
    const EGLContext own = context(config);
    ASSERT_TRUE(makeCurrent(target, own));
    EXPECT_TRUE(eglSwapInterval(display_, 0));
    drawLayers(config, 64, 48);
    const Image expected = layers(config, 64, 48);
    ASSERT_TRUE(same(readPixels(0, 0, 64, 48), expected));
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(shows(*target.native, expected));
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    close(target);
  }
  EXPECT_FALSE(seen.empty());
}

// Smooth colors and slanted edges reach the screen as glReadPixels has them, resolved where there are
// samples.
TEST_P(WindowPictures, SmoothColors) {
  for (EGLint samples : {0, 4}) {
    const EGLConfig config = windowConfig({EGL_SAMPLES, samples});
    if (!config) continue;
    // On edges Mesa does not read what it shows, the resolved color (OpenGL ES 4.3.1).
    if (samples > 0 && egl_conformance::onMesa()) continue;
    Target& target = open(config, {.width = 61, .height = 47, .x = 70 * samples});
    ASSERT_TRUE(makeCurrent(target, context(config)));
    glClearColor(0.1f, 0.2f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const GLfloat vertices[] = {-0.9f, -0.8f, 0.95f, -0.3f, 0.1f, 0.9f};
    const GLfloat colors[] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices);
    glColorPointer(4, GL_FLOAT, 0, colors);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const Image drawn = readPixels(0, 0, 61, 47);
    EXPECT_TRUE(swap(target));
    EXPECT_TRUE(shows(*target.native, drawn)) << samples;
  }
}

// A config without alpha is opaque whatever is drawn.
TEST_P(WindowPictures, NoAlphaIsOpaque) {
  Target& target = openCurrent();
  glClearColor(1, 0.5f, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  const Image drawn = readPixels(0, 0, 64, 48);
  EXPECT_EQ(drawn.at(3, 3)[0], 255);
  GLubyte pixel[4] = {};
  glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[3], 255);
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, drawn));
}

// Alpha is kept for glReadPixels and blending. X shows colors whatever their alpha; Wayland shows what is
// behind them, whose colors are premultiplied, unless EGL_EXT_present_opaque asks it not to.
TEST_P(WindowPictures, Alpha) {
  Target& behind = openCurrent();
  ASSERT_TRUE(drawsAndShows(behind));
  std::set<std::pair<int, bool>> seen;
  for (EGLConfig config : windowConfigs({EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 8})) {
    if (attribute(config, EGL_RED_SIZE) != 8) continue;
    for (bool opaque : {false, true}) {
      if (opaque && !has("EGL_EXT_present_opaque")) continue;
      if (!seen.insert({native().visualDepth(fitting(config).visual), opaque}).second) continue;
      SCOPED_TRACE(testing::Message()
                   << "config " << attribute(config, EGL_CONFIG_ID) << " opaque " << opaque);
      std::vector<EGLAttrib> attributes;
      if (opaque) attributes = {EGL_PRESENT_OPAQUE_EXT, EGL_TRUE};
      Target& target = open(config, {}, attributes);
      const EGLContext own = context(config);
      ASSERT_TRUE(makeCurrent(target, own));
      if (has("EGL_EXT_present_opaque")) {
        EXPECT_EQ(query(target, EGL_PRESENT_OPAQUE_EXT), opaque);
      }
      glClearColor(0.25f, 0.5f, 0, 0.5f);
      glClear(GL_COLOR_BUFFER_BIT);
      GLubyte pixel[4] = {};
      glReadPixels(5, 6, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
      EXPECT_NEAR(pixel[3], 128, 1);
      Image expected(64, 48);
      for (Rgb& color : expected.pixels) color = {64, 128, 0};
      const bool translucent = onWayland() && !opaque;
      if (translucent) {
        const Image below = picture(64, 48);
        for (std::size_t i = 0; i < expected.pixels.size(); ++i)
          for (std::size_t j = 0; j < 3; ++j)
            expected.pixels[i][j] = std::uint8_t(expected.pixels[i][j] + below.pixels[i][j] / 2);
      }
      EXPECT_TRUE(swap(target));
      EXPECT_TRUE(shows(*target.native, expected, 2));
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      close(target);
    }
  }
}

TEST_P(WindowPictures, SrgbColors) {
  if (!has("EGL_KHR_gl_colorspace")) GTEST_SKIP() << "no EGL_KHR_gl_colorspace";
  const EGLConfig config = windowConfig();
  Target& target = open(config, {}, {EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB});
  ASSERT_TRUE(makeCurrent(target, context(config)));
  EXPECT_EQ(query(target, EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_SRGB);
  glClearColor(0.25f, 0.5f, 0.75f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const Image drawn = readPixels(0, 0, 64, 48);
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, drawn));
}

// 3.10.1: the window changes with eglSwapBuffers, not before.
TEST_P(WindowPictures, NothingShowsBeforeTheSwap) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target, 0));
  drawPicture(64, 48, 1);
  glFlush();
  glFinish();
  EXPECT_TRUE(same(target.native->onScreen(), picture(64, 48, 0)));
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, picture(64, 48, 1)));
}

TEST_P(WindowPictures, ManyFrames) {
  Target& target = openCurrent();
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  for (int frame = 0; frame < 12; ++frame) ASSERT_TRUE(drawsAndShows(target, frame)) << frame;
}

// What is drawn stays while another surface is current, until the swap.
TEST_P(WindowPictures, KeptWhileNotCurrent) {
  const EGLConfig config = windowConfig();
  Target& target = openCurrent();
  const EGLContext own = eglGetCurrentContext();
  drawPicture(64, 48);
  Target& other = open(config, {.x = 100});
  ASSERT_TRUE(makeCurrent(other, own));
  EXPECT_TRUE(drawsAndShows(other, 1));
  ASSERT_TRUE(makeCurrent(target, own));
  EXPECT_TRUE(same(readPixels(0, 0, 64, 48), picture(64, 48)));
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, picture(64, 48)));
}

// A second context goes on where the first one was.
TEST_P(WindowPictures, TwoContexts) {
  Target& target = openCurrent();
  const Block first{0, 0, 64, 20, {255, 0, 0}}, second{10, 20, 54, 28, {0, 255, 0}},
      third{0, 20, 10, 28, {0, 0, 255}};
  const EGLContext one = eglGetCurrentContext(), two = context(windowConfig());
  draw(first);
  ASSERT_TRUE(makeCurrent(target, two));
  draw(second);
  ASSERT_TRUE(makeCurrent(target, one));
  draw(third);
  Image expected(64, 48);
  for (const Block& each : {first, second, third}) paint(expected, each);
  EXPECT_TRUE(swap(target));
  EXPECT_TRUE(shows(*target.native, expected));
}

// 4.5: eglSwapBuffers with a framebuffer object bound posts the window, not the object.
TEST_P(WindowPictures, SwapWithAFramebufferObject) {
  Target& target = openCurrent();
  if (!glHas("GL_OES_framebuffer_object")) GTEST_SKIP() << "no framebuffer objects";
  const auto gen = reinterpret_cast<PFNGLGENFRAMEBUFFERSOESPROC>(eglGetProcAddress("glGenFramebuffersOES"));
  const auto bind = reinterpret_cast<PFNGLBINDFRAMEBUFFEROESPROC>(eglGetProcAddress("glBindFramebufferOES"));
  const auto attach =
      reinterpret_cast<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>(eglGetProcAddress("glFramebufferTexture2DOES"));
  GLuint texture = 0, object = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gen(1, &object);
  for (int frame = 0; frame < 3; ++frame) {
    drawPicture(64, 48, frame);
    bind(GL_FRAMEBUFFER_OES, object);
    attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture, 0);
    drawPicture(32, 32, frame + 2);
    EXPECT_TRUE(swap(target));
    EXPECT_TRUE(same(readPixels(0, 0, 32, 32), picture(32, 32, frame + 2)));
    EXPECT_TRUE(shows(*target.native, picture(64, 48, frame)));
    bind(GL_FRAMEBUFFER_OES, 0);
  }
}

// A window bigger than the screen has its whole size.
TEST_P(WindowPictures, BiggerThanTheScreen) {
  const NativeDisplay::ScreenSize screen = native().screenSize();
  Target& target = openCurrent({.width = screen.width + 100, .height = screen.height + 50});
  EXPECT_EQ(query(target, EGL_WIDTH), screen.width + 100);
  drawPicture(screen.width + 100, screen.height + 50);
  EXPECT_TRUE(same(readPixels(0, 0, screen.width + 100, screen.height + 50),
                   picture(screen.width + 100, screen.height + 50)));
  EXPECT_TRUE(swap(target));
}

}  // namespace
}  // namespace windows
