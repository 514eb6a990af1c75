// Displays whose connection is closed, at any time.
#include "window_fixture.h"

namespace windows {
namespace {

// Displays of their own, closed in every order that a program can have in mind; each in a process of its own.
class ClosedConnections : public testing::TestWithParam<Platform> {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  struct Program {
    explicit Program(Platform platform)
        : native(NativeDisplay::open(platform)),
          egl(eglGetPlatformDisplay(eglPlatform(platform), native->handle(), nullptr)) {
      eglInitialize(egl, nullptr, nullptr);
      const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_RED_SIZE, 8, EGL_NONE};
      EGLint count = 0;
      eglChooseConfig(egl, attributes, &config, 1, &count);
      EGLint visual = 0;
      eglGetConfigAttrib(egl, config, EGL_NATIVE_VISUAL_ID, &visual);
      window = native->createWindow({.visual = std::uint32_t(visual)});
      surface = eglCreatePlatformWindowSurface(egl, config, window->pointer(), nullptr);
      context = eglCreateContext(egl, config, EGL_NO_CONTEXT, nullptr);
      if (!eglMakeCurrent(egl, surface, surface, context)) std::exit(3);
      for (int frame = 0; frame < 3; ++frame) {
        drawPicture(64, 48, frame);
        if (!eglSwapBuffers(egl, surface)) std::exit(4);
      }
    }
    void release() { eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

    std::unique_ptr<NativeDisplay> native;
    EGLDisplay egl;
    EGLConfig config = nullptr;
    std::unique_ptr<NativeWindow> window;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
  };
};
ON_ALL_PLATFORMS(ClosedConnections);

TEST_P(ClosedConnections, InGoodOrder) {
  EXPECT_EXIT(
      {
        Program program(GetParam());
        program.release();
        eglDestroySurface(program.egl, program.surface);
        eglDestroyContext(program.egl, program.context);
        eglTerminate(program.egl);
        program.window.reset();
        program.native.reset();
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST_P(ClosedConnections, TerminatedWhileCurrent) {
  EXPECT_EXIT(
      {
        Program program(GetParam());
        eglTerminate(program.egl);
        drawPicture(64, 48);
        glFinish();
        program.release();
        eglReleaseThread();
        program.window.reset();
        program.native.reset();
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST_P(ClosedConnections, WindowBeforeTerminate) {
  EXPECT_EXIT(
      {
        Program program(GetParam());
        program.window->destroy();
        program.release();
        eglTerminate(program.egl);
        program.window.reset();
        program.native.reset();
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

// Programs that are done just leave.
TEST_P(ClosedConnections, ExitWithEverythingOpen) {
  EXPECT_EXIT(
      {
        [[maybe_unused]] static Program program(GetParam());
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST_P(ClosedConnections, ExitWithoutTerminate) {
  EXPECT_EXIT(
      {
        Program program(GetParam());
        program.release();
        eglDestroySurface(program.egl, program.surface);
        program.window.reset();
        program.native.reset();
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

// The server ends the connection. Xlib would end the program.
TEST_P(ClosedConnections, CutByTheServer) {
  if (GetParam() != Platform::Xcb) GTEST_SKIP() << "not with this library";
  MESA_DISAGREES("3.10.4", "it waits for the server that is gone");
  EXPECT_EXIT(
      {
        Program program(GetParam());
        NativeDisplay::open(GetParam())->cut(*program.window);
        for (int frame = 0; frame < 5; ++frame) {
          drawPicture(64, 48, frame);
          readPixels(0, 0, 64, 48);
          if (!eglSwapBuffers(program.egl, program.surface) && eglGetError() != EGL_BAD_NATIVE_WINDOW)
            std::exit(5);
        }
        program.release();
        eglDestroySurface(program.egl, program.surface);
        eglTerminate(program.egl);
        std::_Exit(0);
      },
      testing::ExitedWithCode(0), "");
}

// Again on the same connection, and on another that may have the first one's address.
TEST_P(ClosedConnections, OpenedAgain) {
  EXPECT_EXIT(
      {
        for (int times = 0; times < 3; ++times) {
          Program program(GetParam());
          program.release();
          eglTerminate(program.egl);
          if (!eglInitialize(program.egl, nullptr, nullptr)) std::exit(5);
          eglTerminate(program.egl);
          program.window.reset();
          program.native.reset();
        }
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace windows
