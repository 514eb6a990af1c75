// EGL 1.5 section 3.2, EGL_KHR/EXT_platform_x11, EGL_EXT_platform_xcb, EGL_KHR/EXT_platform_wayland:
// displays, told by platform or guessed. Each case has a process of its own, since what is guessed is in the
// environment.
#include <cstdlib>

#include "window_fixture.h"

namespace windows {
namespace {

// What a process must find is counted; its exit status is 0 when all is found.
class Findings {
 public:
  void want(bool found, const char* what) {
    if (found) return;
    std::fprintf(stderr, "not so: %s\n", what);
    ok_ = false;
  }
  [[noreturn]] void exit() const { std::exit(ok_ ? 0 : 1); }

 private:
  bool ok_ = true;
};
#define WANT(findings, ...) (findings).want(__VA_ARGS__, #__VA_ARGS__)

template <class Body>
void inItsOwnProcess(Body body) {
  EXPECT_EXIT(
      {
        Findings findings;
        body(findings);
        findings.exit();
      },
      testing::ExitedWithCode(0), "");
}

EGLint errorOf(EGLDisplay display) {
  return display == EGL_NO_DISPLAY ? eglGetError() : EGL_SUCCESS;
}

bool hasWindows(EGLDisplay display) {
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT,
                               EGL_NONE};
  EGLint count = 0;
  return eglInitialize(display, nullptr, nullptr) &&
         eglChooseConfig(display, attributes, nullptr, 0, &count) && count > 0;
}

// A picture in a window of the display, through eglCreateWindowSurface.
bool drawsWindows(EGLDisplay display, NativeDisplay& native) {
  if (!eglInitialize(display, nullptr, nullptr)) return false;
  const EGLint attributes[] = {
      EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 0, EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0, visual = 0;
  if (!eglChooseConfig(display, attributes, configs, 64, &count)) return false;
  EGLConfig config = nullptr;
  for (EGLint i = 0, alpha = 0; i < count && !config; ++i)
    if (eglGetConfigAttrib(display, configs[i], EGL_ALPHA_SIZE, &alpha) && alpha == 0) config = configs[i];
  eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
  const auto window = native.createWindow({.visual = std::uint32_t(visual)});
  const EGLSurface surface =
      eglCreateWindowSurface(display, config, EGLNativeWindowType(window->value()), nullptr);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, surface, surface, context)) return false;
  drawPicture(64, 48);
  const bool shown = eglSwapBuffers(display, surface) && shows(*window, picture(64, 48));
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(display, surface);
  eglTerminate(display);
  return shown;
}

const char* wordFor(Platform platform) {
  return platform == Platform::Xlib ? "x11" : platform == Platform::Xcb ? "xcb" : "wayland";
}

class WindowDisplays : public testing::TestWithParam<Platform> {
 protected:
  void SetUp() override {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    unsetenv("EGL_PLATFORM");
    unsetenv("EGL_DISPLAY");
  }
  EGLenum platform() const { return eglPlatform(GetParam()); }
  // The attribute that chooses a screen; 0: screens are not chosen.
  EGLAttrib screenAttribute() const {
    return GetParam() == Platform::Xlib  ? EGL_PLATFORM_X11_SCREEN_KHR
           : GetParam() == Platform::Xcb ? EGL_PLATFORM_XCB_SCREEN_EXT
                                         : 0;
  }
};
ON_ALL_PLATFORMS(WindowDisplays);

TEST_P(WindowDisplays, ClientExtensions) {
  inItsOwnProcess([&](Findings& findings) {
    const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    WANT(findings, names(all, "EGL_EXT_platform_base"));
    if (GetParam() == Platform::Xcb) {
      WANT(findings, names(all, "EGL_EXT_platform_xcb"));
    } else {
      const std::string word = wordFor(GetParam());
      WANT(findings, names(all, "EGL_KHR_platform_" + word));
      WANT(findings, names(all, "EGL_EXT_platform_" + word));
    }
  });
}

// The same arguments, the same display, and one that works.
TEST_P(WindowDisplays, ByPlatform) {
  inItsOwnProcess([&](Findings& findings) {
    const auto native = NativeDisplay::open(GetParam()), other = NativeDisplay::open(GetParam());
    const auto ext =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const EGLAttrib none[] = {EGL_NONE};
    const EGLDisplay display = eglGetPlatformDisplay(platform(), native->handle(), nullptr);
    WANT(findings, display != EGL_NO_DISPLAY);
    WANT(findings, eglGetPlatformDisplay(platform(), native->handle(), nullptr) == display);
    // 3.2: null is the empty list; to Mesa it is another one.
    if (!egl_conformance::onMesa())
      WANT(findings, eglGetPlatformDisplay(platform(), native->handle(), none) == display);
    WANT(findings, ext(platform(), native->handle(), nullptr) == display);
    WANT(findings, eglGetPlatformDisplay(platform(), other->handle(), nullptr) != display);
    WANT(findings, eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr) != display);
    WANT(findings, eglGetError() == EGL_SUCCESS);
    WANT(findings, drawsWindows(display, *native));
    WANT(findings, drawsWindows(ext(platform(), other->handle(), nullptr), *other));
  });
}

TEST_P(WindowDisplays, Screens) {
  if (!screenAttribute()) GTEST_SKIP() << "no screens to choose from";
  inItsOwnProcess([&](Findings& findings) {
    const auto native = NativeDisplay::open(GetParam());
    const EGLAttrib first[] = {screenAttribute(), 0, EGL_NONE};
    const EGLDisplay display = eglGetPlatformDisplay(platform(), native->handle(), first);
    WANT(findings, display != EGL_NO_DISPLAY);
    WANT(findings, eglGetPlatformDisplay(platform(), native->handle(), first) == display);
    WANT(findings, drawsWindows(display, *native));
  });
}

TEST_P(WindowDisplays, ScreensThatAreNone) {
  if (!screenAttribute()) GTEST_SKIP() << "no screens to choose from";
  MESA_DISAGREES("EGL_EXT_platform_x11", "a screen that is none is found at initialization");
  inItsOwnProcess([&](Findings& findings) {
    const auto native = NativeDisplay::open(GetParam());
    for (EGLAttrib screen : {1, 99, -1}) {
      const EGLAttrib attributes[] = {screenAttribute(), screen, EGL_NONE};
      WANT(findings,
           errorOf(eglGetPlatformDisplay(platform(), native->handle(), attributes)) == EGL_BAD_ATTRIBUTE);
    }
  });
}

TEST_P(WindowDisplays, BadAttributes) {
  inItsOwnProcess([&](Findings& findings) {
    const auto native = NativeDisplay::open(GetParam());
    const auto ext =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const EGLAttrib attributes[] = {EGL_WIDTH, 0, EGL_NONE};
    const EGLint integers[] = {EGL_WIDTH, 0, EGL_NONE};
    WANT(findings,
         errorOf(eglGetPlatformDisplay(platform(), native->handle(), attributes)) == EGL_BAD_ATTRIBUTE);
    WANT(findings, errorOf(ext(platform(), native->handle(), integers)) == EGL_BAD_ATTRIBUTE);
    WANT(findings, errorOf(eglGetPlatformDisplay(0x7777, native->handle(), nullptr)) == EGL_BAD_PARAMETER);
  });
}

// EGL connects to the default server itself; the program's own windows are there, too.
TEST_P(WindowDisplays, DefaultDisplay) {
  inItsOwnProcess([&](Findings& findings) {
    const EGLDisplay display = eglGetPlatformDisplay(platform(), EGL_DEFAULT_DISPLAY, nullptr);
    WANT(findings, display != EGL_NO_DISPLAY);
    WANT(findings, eglGetPlatformDisplay(platform(), EGL_DEFAULT_DISPLAY, nullptr) == display);
    WANT(findings, hasWindows(display));
    if (GetParam() != Platform::Wayland) {
      const auto native = NativeDisplay::open(GetParam());
      WANT(findings, drawsWindows(display, *native));
    }
  });
}

TEST_P(WindowDisplays, NoServer) {
  inItsOwnProcess([&](Findings& findings) {
    setenv("DISPLAY", ":4711", 1);
    setenv("WAYLAND_DISPLAY", "none", 1);
    const EGLDisplay display = eglGetPlatformDisplay(platform(), EGL_DEFAULT_DISPLAY, nullptr);
    WANT(findings, eglGetError() == EGL_SUCCESS);
    if (display != EGL_NO_DISPLAY) {
      WANT(findings, !eglInitialize(display, nullptr, nullptr));
      WANT(findings, eglGetError() == EGL_NOT_INITIALIZED);
    }
  });
}

// eglGetDisplay finds out what it was given. An xcb_connection_t cannot be told from a Display.
TEST_P(WindowDisplays, Guessed) {
  if (GetParam() == Platform::Xcb) GTEST_SKIP() << "not to be guessed";
  inItsOwnProcess([&](Findings& findings) {
    const auto native = NativeDisplay::open(GetParam());
    const EGLDisplay display = eglGetDisplay(EGLNativeDisplayType(native->handle()));
    WANT(findings, display != EGL_NO_DISPLAY);
    WANT(findings, eglGetDisplay(EGLNativeDisplayType(native->handle())) == display);
    WANT(findings, eglGetPlatformDisplay(platform(), native->handle(), nullptr) == display);
    WANT(findings, drawsWindows(display, *native));
  });
}

TEST_P(WindowDisplays, GuessedDefault) {
  inItsOwnProcess([&](Findings& findings) {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    WANT(findings, display != EGL_NO_DISPLAY);
    // Mesa looks for X alone.
    if (GetParam() != Platform::Wayland || !egl_conformance::onMesa()) WANT(findings, hasWindows(display));
  });
}

// EGL_PLATFORM has the last word.
TEST_P(WindowDisplays, NamedByTheEnvironment) {
  if (GetParam() == Platform::Xcb)
    MESA_DISAGREES("3.2", "the dispatching library does not know the name xcb");
  inItsOwnProcess([&](Findings& findings) {
    setenv("EGL_PLATFORM", wordFor(GetParam()), 1);
    const auto native = NativeDisplay::open(GetParam());
    const EGLDisplay display = eglGetDisplay(EGLNativeDisplayType(native->handle()));
    WANT(findings, display != EGL_NO_DISPLAY);
    WANT(findings, drawsWindows(display, *native));
    WANT(findings, hasWindows(eglGetDisplay(EGL_DEFAULT_DISPLAY)));
  });
}

// 3.5.1: surfaceless displays have no windows, whatever the environment offers.
TEST_P(WindowDisplays, SurfacelessBesideWindows) {
  inItsOwnProcess([&](Findings& findings) {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    WANT(findings, eglInitialize(display, nullptr, nullptr) == EGL_TRUE);
    WANT(findings, !hasWindows(display));
  });
}

// Two platforms in one process, with one context each.
TEST_P(WindowDisplays, BesideAnother) {
  inItsOwnProcess([&](Findings& findings) {
    const EGLDisplay other = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    WANT(findings, eglInitialize(other, nullptr, nullptr) == EGL_TRUE);
    const auto native = NativeDisplay::open(GetParam());
    WANT(findings, drawsWindows(eglGetPlatformDisplay(platform(), native->handle(), nullptr), *native));
    WANT(findings, eglTerminate(other) == EGL_TRUE);
    WANT(findings, drawsWindows(eglGetPlatformDisplay(platform(), native->handle(), nullptr), *native));
  });
}

}  // namespace
}  // namespace windows
