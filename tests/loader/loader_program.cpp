// Ends as its argument says, with a context current. Draws, so that there is something to leave behind.
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <dlfcn.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace {

EGLDisplay display = EGL_NO_DISPLAY;

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
  const auto clear = reinterpret_cast<decltype(&glClear)>(eglGetProcAddress("glClear"));
  const auto getError = reinterpret_cast<decltype(&glGetError)>(eglGetProcAddress("glGetError"));
  if (clear == nullptr || getError == nullptr) return false;
  clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return getError() == GL_NO_ERROR;
}

void cleanUp() {
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) || !eglTerminate(display)) {
    std::_Exit(3);
  }
}

struct AtStaticDestruction {
  bool armed = false;
  ~AtStaticDestruction() {
    if (armed) cleanUp();
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

int run(const char* how) {
  const auto is = [=](const char* name) { return std::strcmp(how, name) == 0; };
  if (is("no-display")) return eglGetDisplay(EGL_DEFAULT_DISPLAY) == EGL_NO_DISPLAY ? 0 : 1;
  if (is("loads-late")) return loadsLate() ? 0 : 1;
  if (is("atexit")) std::atexit(cleanUp);
  atStaticDestruction.armed = is("static-destructor");
  if (is("exit-in-thread")) {
    std::thread([] { std::exit(makeCurrent() ? 0 : 1); }).join();
  } else if (is("other-thread")) {
    std::thread([] {
      if (!makeCurrent()) std::_Exit(1);
      std::exit(0);
    }).detach();
    std::this_thread::sleep_for(std::chrono::seconds(60));
    return 2;
  } else if (is("thread-ends")) {
    bool made = false;
    std::thread([&] { made = makeCurrent(); }).join();
    return made ? 0 : 1;
  }
  return makeCurrent() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return argc == 2 ? run(argv[1]) : 64;
}
