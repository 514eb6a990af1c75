// Forks while it draws, as its argument says, and looks at what parent and child have then. Exit status 0:
// all was right; else the number of the first thing that was not, plus 100 in a child. A child that hangs is
// killed by an alarm.
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include "fixture.h"

namespace threads {
namespace {

constexpr unsigned kSeconds = 300;  // for children that hang

struct Wrong {
  int number;
};
void require(bool right, int number) {
  if (!right) throw Wrong{number};
}

// States that need a shader each.
void chooseState(unsigned number) {
  const auto set = [&](GLenum what, unsigned bit) { (number >> bit & 1 ? glEnable : glDisable)(what); };
  set(GL_FOG, 0);
  set(GL_ALPHA_TEST, 1);
  set(GL_LIGHTING, 2);
  set(GL_NORMALIZE, 3);
  set(GL_TEXTURE_2D, 4);
  glFogf(GL_FOG_MODE, number >> 5 & 1 ? GL_EXP : GL_LINEAR);
}

void drawRight(unsigned number) {
  chooseState(0);
  require(pictureIn(colorOf(number)) == colorOf(number), 1);
  const GLuint texture = makeTexture(colorOf(number + 1));
  require(pictureOf(texture) == colorOf(number + 1), 2);
  glDeleteTextures(1, &texture);
  require(glGetError() == GL_NO_ERROR, 3);
}

// Runs `body` in a child, which then ends by exit(): its exit handlers and static destructors run.
int inChild(void (*body)(), bool atOnce = false) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    int status = 0;
    try {
      body();
    } catch (const Wrong& wrong) {
      status = 100 + wrong.number;
    }
    if (atOnce) _exit(status);
    std::exit(status);
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) return 90;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 200 + WTERMSIG(status);
}

void doNothing() {}

// With what the parent had.
void useParents() {
  const EGLDisplay on = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  require(eglGetCurrentContext() == EGL_NO_CONTEXT, 10);
  require(eglGetCurrentDisplay() == EGL_NO_DISPLAY, 11);
  clear(colorOf(1));
  drawQuad();
  require(pixel() == Color{0, 0, 0, 0}, 12);  // nothing was read
  glFinish();
  require(glGetError() == GL_NO_ERROR, 13);
  require(glGetString(GL_RENDERER) == nullptr, 14);
  const auto refused = [](EGLBoolean result) { return !result && eglGetError() == EGL_NOT_INITIALIZED; };
  EGLSurface invented = reinterpret_cast<EGLSurface>(&invented);
  require(refused(eglSwapBuffers(on, invented)), 15);
  require(refused(eglMakeCurrent(on, invented, invented, invented)), 16);
  require(eglCreateContext(on, nullptr, EGL_NO_CONTEXT, nullptr) == EGL_NO_CONTEXT, 17);
  require(eglWaitClient() == EGL_TRUE, 18);
  require(eglMakeCurrent(on, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) == EGL_TRUE, 19);
  require(eglTerminate(on) == EGL_TRUE && eglReleaseThread() == EGL_TRUE, 20);
}

void initializeAnew() {
  const EGLDisplay on = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  require(eglInitialize(on, nullptr, nullptr) == EGL_TRUE, 30);
  {
    const Place place(EGL_NO_CONTEXT, on);
    require(place.enter(), 31);
    for (unsigned i = 0; i < 3; ++i) drawRight(i + 20);
  }
  require(eglTerminate(on) == EGL_TRUE, 32);
}

void initializeAnewAndKeep() {
  const EGLDisplay on = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  require(eglInitialize(on, nullptr, nullptr) == EGL_TRUE, 40);
  static const Place place(EGL_NO_CONTEXT, on);
  require(place.enter(), 41);
  drawRight(9);
}

void forkAgain() {
  initializeAnewAndKeep();
  require(inChild(useParents) == 0, 50);
  drawRight(10);
  require(inChild(initializeAnew) == 0, 51);
  drawRight(11);
}

// Other threads draw, and ask for shaders, all the while.
int whileOthersDraw() {
  std::atomic<bool> done = false;
  std::atomic<int> wrong = 0;
  std::vector<std::thread> others;
  const Place root;
  for (unsigned number = 0; number < 3; ++number)
    others.emplace_back([&, number] {
      const Place place(number ? root.context() : EGL_NO_CONTEXT);
      try {
        require(place.enter(), 60);
        for (unsigned i = 0; !done; ++i) {
          drawRight(i);
          chooseState(i * 3 + number);
          pictureIn(colorOf(i));
        }
      } catch (const Wrong& what) {
        wrong = what.number;
      }
    });
  int result = 0;
  for (int i = 0; i < 12 && result == 0; ++i) result = inChild(i % 3 ? doNothing : initializeAnew);
  done = true;
  for (std::thread& other : others) other.join();
  return result ? result : wrong.load();
}

int run(std::string_view how) {
  const Place place;
  require(place.enter(), 70);
  drawRight(1);
  int result = 64;
  if (how == "exits") result = inChild(doNothing);
  if (how == "exits-at-once") result = inChild(doNothing, true);
  if (how == "uses-parents") result = inChild(useParents);
  if (how == "initializes") result = inChild(initializeAnew);
  if (how == "keeps") result = inChild(initializeAnewAndKeep);
  if (how == "forks-again") result = inChild(forkAgain);
  if (how == "busy") result = whileOthersDraw();
  if (how == "in-thread") std::thread([&] { result = inChild(initializeAnew); }).join();
  // The parent is unharmed.
  for (unsigned i = 0; i < 5; ++i) drawRight(i);
  require(eglGetCurrentContext() == place.context(), 71);
  return result;
}

}  // namespace

int effort() {
  return 1;
}

}  // namespace threads

int main(int argc, char** argv) {
  alarm(4 * threads::kSeconds);
  try {
    return argc == 2 ? threads::run(argv[1]) : 64;
  } catch (const threads::Wrong& wrong) {
    return wrong.number;
  }
}
