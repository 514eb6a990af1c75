// Ends as its argument says, with a context current. Draws, so that there is something to leave behind.
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace {

EGLDisplay display = EGL_NO_DISPLAY;

// Through EGL: the program needs no other library.
template <typename Function>
Function command(Function, const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}
#define COMMAND(name) command(static_cast<decltype(&(name))>(nullptr), #name)

bool makeCurrent() {
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(display, nullptr, nullptr)) return false;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return false;
  const EGLint size[] = {EGL_WIDTH, 32, EGL_HEIGHT, 32, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, surface, surface, context)) return false;
  const auto clear = COMMAND(glClear);
  const auto getError = COMMAND(glGetError);
  if (clear == nullptr || getError == nullptr) return false;
  clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return getError() == GL_NO_ERROR;
}

void cleanUp() {
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) || !eglTerminate(display)) {
    std::_Exit(3);
  }
}

// Draws for which a CPU device compiles large shaders, and nobody waits.
void leaveWork() {
  const GLfloat corners[] = {-1, -1, 1, -1, 0, 1};
  COMMAND(glEnableClientState)(GL_VERTEX_ARRAY);
  COMMAND(glVertexPointer)(2, GL_FLOAT, 0, corners);
  COMMAND(glEnable)(GL_LIGHTING);
  for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
    COMMAND(glEnable)(light);
    COMMAND(glLightf)(light, GL_SPOT_CUTOFF, 30);
    COMMAND(glLightf)(light, GL_LINEAR_ATTENUATION, 1);
    if (light % 3 != 1) continue;
    COMMAND(glDrawArrays)(GL_TRIANGLES, 0, 3);
    COMMAND(glFlush)();
  }
}

// What is current can be drawn to.
void draw() {
  COMMAND(glClearColor)(0, 1, 0, 1);
  COMMAND(glClear)(GL_COLOR_BUFFER_BIT);
  GLubyte pixel[4] = {};
  COMMAND(glReadPixels)(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  if (pixel[0] != 0 || pixel[1] != 255 || COMMAND(glGetError)() != GL_NO_ERROR) std::_Exit(4);
}

void drawAndCleanUp() {
  draw();
  cleanUp();
}

// With nothing current any more, or with what somebody else left.
void callAnything() {
  COMMAND(glClear)(GL_COLOR_BUFFER_BIT);
  COMMAND(glFinish)();
  COMMAND(glGetError)();
  eglGetCurrentContext();
  eglQueryString(display, EGL_VERSION);
  eglWaitClient();
}

void exitAgain() {
  draw();
  std::exit(0);
}

struct AtStaticDestruction {
  void (*does)() = nullptr;
  ~AtStaticDestruction() {
    if (does) does();
  }
} atStaticDestruction;

bool isLoaded(const char* library) {
  return dlopen(library, RTLD_NOLOAD | RTLD_NOW) != nullptr;
}

// What every vendor of glvnd is asked, and what only the one that is used.
bool loadsLate() {
  if (eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) == nullptr || !eglBindAPI(EGL_OPENGL_ES_API))
    return false;
  if (!eglReleaseThread() || eglGetError() != EGL_SUCCESS) return false;
  if (isLoaded("libanteroom.so.0") || !isLoaded("libEGL_anteroom.so.0")) return false;
  return makeCurrent() && isLoaded("libanteroom.so.0");
}

// Its destructor is called when the thread ends, before the thread gives back what is current.
struct AtThreadsEnd {
  ~AtThreadsEnd() { draw(); }
};

// The context that an ended thread had is free.
bool canHave(EGLContext context, EGLSurface surface) {
  return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
}

EGLContext context = EGL_NO_CONTEXT;
EGLSurface surface = EGL_NO_SURFACE;

// The first thread ends by itself, the process with the last one.
int endFirstThread() {
  if (!makeCurrent()) return 1;
  context = eglGetCurrentContext();
  surface = eglGetCurrentSurface(EGL_DRAW);
  static const pthread_t first = pthread_self();
  std::thread([] {
    if (pthread_join(first, nullptr) != 0 || !canHave(context, surface)) std::_Exit(5);
    draw();
    std::exit(0);
  }).detach();
  pthread_exit(nullptr);
}

int inThread(bool (*body)(), bool exits) {
  bool made = false;
  std::thread([&] {
    made = body();
    if (exits) std::exit(made ? 0 : 1);
  }).join();
  return made ? 0 : 1;
}

bool makeAndWatchEnd() {
  static thread_local AtThreadsEnd end;
  static_cast<void>(end);
  return makeCurrent();
}

bool makeAndLeaveWork() {
  if (!makeCurrent()) return false;
  leaveWork();
  return true;
}

int run(const char* how) {
  const auto is = [=](const char* name) { return std::strcmp(how, name) == 0; };
  if (is("no-display")) return eglGetDisplay(EGL_DEFAULT_DISPLAY) == EGL_NO_DISPLAY ? 0 : 1;
  if (is("loads-late")) return loadsLate() ? 0 : 1;
  if (is("atexit")) std::atexit(cleanUp);
  if (is("atexit-draws")) std::atexit(drawAndCleanUp);
  if (is("atexit-draws-in-thread")) std::atexit(draw);
  if (is("atexit-exits")) std::atexit(exitAgain);
  if (is("static-destructor")) atStaticDestruction.does = cleanUp;
  if (is("static-destructor-draws")) atStaticDestruction.does = drawAndCleanUp;
  if (is("static-destructor-calls")) atStaticDestruction.does = callAnything;
  if (is("exit-in-thread") || is("atexit-draws-in-thread")) return inThread(makeCurrent, true);
  if (is("other-thread")) {
    std::thread([] {
      if (!makeCurrent()) std::_Exit(1);
      std::exit(0);
    }).detach();
    std::this_thread::sleep_for(std::chrono::seconds(60));
    return 2;
  }
  if (is("in-the-middle")) return makeCurrent() ? leaveWork(), 0 : 1;
  if (is("in-the-middle-of-a-thread")) return inThread(makeAndLeaveWork, true);
  if (is("thread-ends")) return inThread(makeCurrent, false);
  if (is("thread-local-draws")) return inThread(makeAndWatchEnd, false);
  if (is("first-thread-ends")) return endFirstThread();
  if (is("_exit")) _exit(makeCurrent() ? 0 : 1);
  return makeCurrent() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return argc == 2 ? run(argv[1]) : 64;
}
