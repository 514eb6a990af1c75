// Two contexts, a surface of 1024x768 with depth and stencil, and a few pictures in each. Prints what is
// resident. With the argument "window" the surface is a window of X11's.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <xcb/xcb.h>

#include <cstring>

#include "resident.h"

namespace {

void draw(EGLDisplay display, EGLSurface surface, float shade) {
  const GLfloat corners[] = {-1, -1, 1, -1, 0, 1};
  const GLubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  for (int i = 0; i < 4; ++i) {
    (i & 1) != 0 ? glEnable(GL_TEXTURE_2D) : glDisable(GL_TEXTURE_2D);
    (i & 2) != 0 ? glEnable(GL_LIGHTING) : glDisable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glColor4f(shade, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    eglSwapBuffers(display, surface);
  }
  glFinish();
}

constexpr int kWidth = 1024, kHeight = 768;

EGLSurface createWindow(xcb_connection_t* xServer, EGLDisplay display, EGLConfig config) {
  const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(xServer)).data;
  EGLint visual = 0;
  eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
  xcb_window_t window = xcb_generate_id(xServer);
  xcb_create_window(xServer, XCB_COPY_FROM_PARENT, window, screen->root, 0, 0, kWidth, kHeight, 0,
                    XCB_WINDOW_CLASS_INPUT_OUTPUT, static_cast<xcb_visualid_t>(visual), 0, nullptr);
  xcb_map_window(xServer, window);
  xcb_flush(xServer);
  return eglCreatePlatformWindowSurface(display, config, &window, nullptr);
}

EGLSurface createPbuffer(EGLDisplay display, EGLConfig config) {
  const EGLint size[] = {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
  return eglCreatePbufferSurface(display, config, size);
}

bool run(bool inWindow) {
  xcb_connection_t* const xServer = inWindow ? xcb_connect(nullptr, nullptr) : nullptr;
  const EGLDisplay display =
      inWindow ? eglGetPlatformDisplay(EGL_PLATFORM_XCB_EXT, xServer, nullptr)
               : eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const EGLint wanted[] = {EGL_SURFACE_TYPE, inWindow ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
                           EGL_RED_SIZE,     8,
                           EGL_DEPTH_SIZE,   24,
                           EGL_STENCIL_SIZE, 8,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wanted, &config, 1, &count) ||
      count == 0)
    return false;
  const EGLSurface surface =
      inWindow ? createWindow(xServer, display, config) : createPbuffer(display, config);
  for (int i = 0; i < 2; ++i) {
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display, surface, surface, context)) return false;
    draw(display, surface, static_cast<float>(i));
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
      return std::fprintf(stderr, "GL's error is %#x\n", error), false;
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  if (!run(count > 1 && std::strcmp(arguments[1], "window") == 0)) {
    std::fprintf(stderr, "it cannot draw: EGL's error is %#x\n", static_cast<unsigned>(eglGetError()));
    return 1;
  }
  printResident();
  return 0;
}
