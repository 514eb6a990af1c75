// What the cases of windows stand on: a connection and an initialised EGLDisplay a platform, windows with
// their surfaces and contexts, which end with the case, and what the screen shows of them.
#pragma once

#include <list>
#include <memory>
#include <vector>

#include "image.h"
#include "native.h"
#include "tests/egl/egl_fixture.h"

namespace windows {

using egl_conformance::names;

EGLenum eglPlatform(Platform platform);

struct Block {
  int x, y, width, height;
  Rgb color;
};
// Four quarters and a mark, all different, so that every turn and mirroring of the picture shows; another
// `frame` has other colors, which every format of 4 bits and more holds exactly.
std::vector<Block> quarters(int width, int height, int frame = 0);
void paint(Image& image, const Block& block);
Image picture(int width, int height, int frame = 0);
// The same by glClear. Neither scissor nor clear color are kept.
void draw(const Block& block);
void drawPicture(int width, int height, int frame = 0);
// A rectangle of window coordinates in the current color, through the vertex pipeline.
void drawRect(float x, float y, float width, float height, float z, int surfaceWidth, int surfaceHeight);

Image readPixels(int x, int y, int width, int height);
bool glHas(std::string_view extension);
testing::AssertionResult same(const Image& actual, const Image& expected, int tolerance = 0);
// Waits until the screen shows it: presenting may take its time.
testing::AssertionResult shows(NativeWindow& window, const Image& expected, int tolerance = 0);

// A window and its surface.
struct Target {
  std::unique_ptr<NativeWindow> native;
  EGLSurface surface = EGL_NO_SURFACE;
};

class WindowTest : public egl_conformance::EglTest, public testing::WithParamInterface<Platform> {
 protected:
  void SetUp() override;
  // The server must not have complained, either.
  void TearDown() override;

  NativeDisplay& native() const { return *native_; }
  bool onWayland() const { return GetParam() == Platform::Wayland; }
  bool has(std::string_view extension) const;
  // Configs for windows and ES 1; those with at least what `more` asks for.
  std::vector<EGLConfig> windowConfigs(std::vector<EGLint> more = {}) const;
  // The first one with 8 bits a color and no alpha.
  EGLConfig windowConfig(std::vector<EGLint> more = {}) const;
  // One for pbuffers that is compatible with a window's, or null.
  EGLConfig pbufferConfig(EGLConfig like) const;
  WindowRequest fitting(EGLConfig config, WindowRequest request = {}) const;

  // These end with the case.
  Target& open(EGLConfig config, const WindowRequest& request = {}, std::vector<EGLAttrib> attributes = {});
  EGLContext context(EGLConfig config, EGLContext share = EGL_NO_CONTEXT);
  // A window and a context of its own, current.
  Target& openCurrent(const WindowRequest& request = {}, std::vector<EGLint> config = {});
  bool makeCurrent(const Target& target, EGLContext context) const {
    return eglMakeCurrent(display_, target.surface, target.surface, context);
  }
  // The surface first, then the window.
  void close(Target& target);

  bool swap(const Target& target) const { return eglSwapBuffers(display_, target.surface); }
  EGLint query(const Target& target, EGLint name) const;
  // The current surface's picture, drawn, swapped and seen.
  testing::AssertionResult drawsAndShows(Target& target, int frame = 0);

 private:
  NativeDisplay* native_ = nullptr;
  std::list<Target> targets_;
  std::vector<EGLContext> contexts_;
};

// INSTANTIATE_TEST_SUITE_P for the platforms whose servers there are.
std::string platformName(const testing::TestParamInfo<Platform>& info);
#define ON_ALL_PLATFORMS(suite)                         \
  GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(suite); \
  INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(platforms()), platformName)

}  // namespace windows
