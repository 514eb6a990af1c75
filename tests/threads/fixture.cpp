#include "fixture.h"

#include <latch>
#include <thread>
#include <vector>

namespace threads {
namespace {

template <typename Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
}

Extensions loadAll() {
  Extensions all{};
  load(all.genFramebuffers, "glGenFramebuffersOES");
  load(all.deleteFramebuffers, "glDeleteFramebuffersOES");
  load(all.bindFramebuffer, "glBindFramebufferOES");
  load(all.framebufferTexture2D, "glFramebufferTexture2DOES");
  load(all.framebufferRenderbuffer, "glFramebufferRenderbufferOES");
  load(all.checkFramebufferStatus, "glCheckFramebufferStatusOES");
  load(all.genRenderbuffers, "glGenRenderbuffersOES");
  load(all.deleteRenderbuffers, "glDeleteRenderbuffersOES");
  load(all.bindRenderbuffer, "glBindRenderbufferOES");
  load(all.renderbufferStorage, "glRenderbufferStorageOES");
  load(all.imageTargetTexture2D, "glEGLImageTargetTexture2DOES");
  load(all.createSyncKHR, "eglCreateSyncKHR");
  load(all.signalSyncKHR, "eglSignalSyncKHR");
  return all;
}

}  // namespace

EGLDisplay display() {
  static const EGLDisplay one = [] {
    const EGLDisplay got = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(got, nullptr, nullptr);
    return got;
  }();
  return one;
}

EGLConfig configOf(EGLDisplay on) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(on, wanted, &config, 1, &count);
  return config;
}

const Extensions& gl() {
  static const Extensions all = loadAll();
  return all;
}

std::ostream& operator<<(std::ostream& out, const Color& c) {
  return out << '(' << +c.r << ' ' << +c.g << ' ' << +c.b << ' ' << +c.a << ')';
}

Color colorOf(unsigned number) {
  const auto part = [&](unsigned prime) { return static_cast<GLubyte>(51 * (number / prime % 6)); };
  return {part(1), part(6), static_cast<GLubyte>(255 - 51 * (number % 5)), 255};
}

Place::Place(EGLContext share, EGLDisplay on) : display_(on) {
  const EGLConfig config = configOf(on);
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  surface_ = eglCreatePbufferSurface(on, config, size);
  context_ = eglCreateContext(on, config, share, version);
}

Place::~Place() {
  if (context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_) leave();
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
}

bool Place::enter() const {
  return surface_ != EGL_NO_SURFACE && eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
}

void Place::leave() const {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void clear(Color c) {
  glClearColorx(c.r * 65536 / 255, c.g * 65536 / 255, c.b * 65536 / 255, c.a * 65536 / 255);
  glClear(GL_COLOR_BUFFER_BIT);
}

Color pixel() {
  GLubyte got[4] = {};
  glReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
  return {got[0], got[1], got[2], got[3]};
}

void drawQuad() {
  static const GLbyte corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  static const GLbyte texels[] = {0, 0, 1, 0, 0, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_BYTE, 0, corners);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_BYTE, 0, texels);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void specify(Color color, GLsizei size) {
  const std::vector<Color> texels(static_cast<size_t>(size) * static_cast<size_t>(size), color);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

GLuint makeTexture(Color color, GLsizei size) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  specify(color, size);
  return name;
}

Color pictureOf(GLuint texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glEnable(GL_TEXTURE_2D);
  glColor4ub(255, 255, 255, 255);
  clear({});
  drawQuad();
  glDisable(GL_TEXTURE_2D);
  return pixel();
}

Color pictureIn(Color color) {
  clear({});
  glColor4ub(color.r, color.g, color.b, color.a);
  drawQuad();
  return pixel();
}

void inThreads(int count, const std::function<void(int)>& body) {
  std::latch start(count);
  std::vector<std::thread> all;
  for (int i = 0; i < count; ++i)
    all.emplace_back([&, i] {
      start.arrive_and_wait();
      body(i);
    });
  for (std::thread& thread : all) thread.join();
}

}  // namespace threads
