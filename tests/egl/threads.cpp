// EGL 1.5 sections 3.1, 3.7.3, 3.12: a context per thread, errors per thread, contexts that move between
// threads.
#include <atomic>
#include <thread>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Threads : public EglTest {};

// 3.7.3: what is current in one thread cannot be made current in another.
TEST_F(Threads, CurrentElsewhere) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config), other = createPbuffer(config);
  const EGLContext context = createContext(config), second = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  std::thread([&] {
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    EXPECT_FALSE(eglMakeCurrent(display_, other, other, context));
    EXPECT_EGL_ERROR(EGL_BAD_ACCESS);
    EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, second));
    EXPECT_EGL_ERROR(EGL_BAD_ACCESS);
    EXPECT_TRUE(eglMakeCurrent(display_, other, other, second));
    EXPECT_TRUE(eglReleaseThread());
  }).join();
  EXPECT_EQ(eglGetCurrentContext(), context);
}

// A context goes to another thread with its state and back.
TEST_F(Threads, ContextMoves) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  std::thread([&] {
    ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
    GLubyte pixel[4] = {};
    glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[1], 255);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    eglReleaseThread();
  }).join();
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  GLubyte pixel[4] = {};
  glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 255);
}

// 3.1: the error belongs to the thread.
TEST_F(Threads, ErrorsAreSeparate) {
  EXPECT_FALSE(eglTerminate(EGL_NO_DISPLAY));
  std::thread([] {
    EXPECT_EGL_ERROR(EGL_SUCCESS);
    eglReleaseThread();
  }).join();
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
}

// Four threads draw at once, each with its own context; two of them share objects.
TEST_F(Threads, DrawingAtOnce) {
  const EGLConfig config = choose();
  const EGLContext shared = createContext(config);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      const EGLSurface surface = createPbuffer(config);
      const EGLContext context = createContext(config, t < 2 ? shared : EGL_NO_CONTEXT);
      if (!eglMakeCurrent(display_, surface, surface, context)) {
        ++wrong;
        return;
      }
      const GLfloat quad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(2, GL_FLOAT, 0, quad);
      for (int i = 0; i < 40; ++i) {
        GLuint texture = 0, buffer = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        const GLubyte texel[] = {static_cast<GLubyte>(t * 60), static_cast<GLubyte>(i * 5), 0, 255};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        glEnable(GL_TEXTURE_2D);
        glGenBuffers(1, &buffer);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        GLubyte pixel[4] = {};
        glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        wrong += pixel[0] != texel[0] || pixel[1] != texel[1];
        glDeleteTextures(1, &texture);
        glDeleteBuffers(1, &buffer);
      }
      wrong += glGetError() != GL_NO_ERROR;
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display_, context);
      eglDestroySurface(display_, surface);
      eglReleaseThread();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

// 3.12: a thread that ends without releasing anything harms nobody.
TEST_F(Threads, EndsWithAContext) {
  const EGLConfig config = choose();
  for (int i = 0; i < 5; ++i) {
    std::thread([&] {
      const EGLSurface surface = createPbuffer(config);
      EXPECT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
      glClear(GL_COLOR_BUFFER_BIT);
    }).join();
  }
  const EGLSurface surface = createPbuffer(config);
  EXPECT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
}

}  // namespace
}  // namespace egl_conformance
