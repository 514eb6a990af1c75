// A window that takes on one size after the other, by turns with and without waiting for the screen. Every
// size stays for kFrames frames, the last of which are 3, 7, 11 ...
#include <EGL/egl.h>
#include <GLES/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>

#include "scene.h"

namespace {

struct Size {
  int width, height;
};
// The first is the largest: Weston puts the window where it has room for that.
constexpr std::array kSizes = {Size{640, 480}, Size{200, 301}, Size{481, 163}, Size{320, 240},
                               Size{640, 480}};
constexpr int kFrames = 4;

template <class... Arguments>
[[noreturn]] void fail(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::print(stderr, "glfw_window: {}\n", fmt::format(format, std::forward<Arguments>(arguments)...));
  std::exit(1);
}

GLFWwindow* openWindow(Size size) {
  if (glfwInit() != GLFW_TRUE) fail("no window system");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 1);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  GLFWwindow* window = glfwCreateWindow(size.width, size.height, "glfw_window", nullptr, nullptr);
  if (!window) {
    const char* why = nullptr;
    glfwGetError(&why);
    fail("no window: {}", why ? why : "?");
  }
  glfwMakeContextCurrent(window);
  return window;
}

void resize(GLFWwindow* window, Size wanted) {
  glfwSetWindowSize(window, wanted.width, wanted.height);
  const double end = glfwGetTime() + 10;
  for (Size now{}; now.width != wanted.width || now.height != wanted.height;) {
    glfwWaitEventsTimeout(0.01);
    glfwGetFramebufferSize(window, &now.width, &now.height);
    if (glfwGetTime() > end) fail("the window stays at {}x{}", now.width, now.height);
  }
}

void checkSurface(Size size) {
  const EGLDisplay display = eglGetCurrentDisplay();
  const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
  EGLint width = 0, height = 0;
  eglQuerySurface(display, surface, EGL_WIDTH, &width);
  eglQuerySurface(display, surface, EGL_HEIGHT, &height);
  if (width != size.width || height != size.height)
    fail("the surface is {}x{} in a window of {}x{}", width, height, size.width, size.height);
  if (!programs::cornersAreRight(size.width, size.height)) fail("the picture does not fill the window");
  if (const GLenum error = glGetError()) fail("GL error {:#x}", error);
}

}  // namespace

int main() {
  GLFWwindow* window = openWindow(kSizes[0]);
  fmt::print("{}, {}\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
             reinterpret_cast<const char*>(glGetString(GL_VERSION)));
  const unsigned texture = programs::uploadTexture();
  int frame = 0;
  for (std::size_t i = 0; i < kSizes.size(); ++i) {
    const Size size = kSizes[i];
    resize(window, size);
    glfwSwapInterval(i % 2 == 0 ? 1 : 0);
    for (int n = 0; n < kFrames; ++n, ++frame) {
      programs::drawScene(size.width, size.height, 10.f * static_cast<float>(frame), texture);
      if (n == kFrames - 1) checkSurface(size);
      glfwSwapBuffers(window);
      glfwPollEvents();
    }
  }
  glfwTerminate();
}
