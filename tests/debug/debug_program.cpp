// What a person who debugs would look at: small programs of GL, chosen by the first argument.
#define EGL_EGLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#include <X11/Xlib.h>
#include <X11/Xutil.h>
// Before those of EGL, which name its types.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

// EGL_ANTEROOM_context_counters: draws, pipelines, compiles, uploaded bytes.
constexpr EGLint kFirstCounter = 0x3FE0, kCounters = 4;

EGLDisplay display;
EGLSurface surface;
EGLContext context;
int width = 64, height = 64;

Display* server;  // null: no windows
Window window;

EGLSurface createSurface(EGLConfig config) {
  if (server == nullptr) {
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    return eglCreatePbufferSurface(display, config, size);
  }
  EGLint visual = 0, count = 0;
  eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
  XVisualInfo wanted{};
  wanted.visualid = static_cast<VisualID>(visual);
  XVisualInfo* const info = XGetVisualInfo(server, VisualIDMask, &wanted, &count);
  if (info == nullptr) return EGL_NO_SURFACE;
  const Window root = DefaultRootWindow(server);
  XSetWindowAttributes attributes{};
  attributes.override_redirect = True;
  attributes.colormap = XCreateColormap(server, root, info->visual, AllocNone);
  window = XCreateWindow(server, root, 10, 10, static_cast<unsigned>(width), static_cast<unsigned>(height), 0,
                         info->depth, InputOutput, info->visual,
                         CWOverrideRedirect | CWColormap | CWBorderPixel, &attributes);
  XFree(info);
  XMapWindow(server, window);
  XSync(server, False);
  return eglCreateWindowSurface(display, config, window, nullptr);
}

void start() {
  display = server ? eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, server, nullptr)
                   : eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  eglInitialize(display, nullptr, nullptr);
  const EGLint wanted[] = {EGL_SURFACE_TYPE, server ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
                           EGL_RED_SIZE,     8,
                           EGL_GREEN_SIZE,   8,
                           EGL_BLUE_SIZE,    8,
                           EGL_ALPHA_SIZE,   8,
                           EGL_DEPTH_SIZE,   24,
                           EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  surface = createSurface(config);
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (count != 1 || !eglMakeCurrent(display, surface, surface, context)) {
    std::puts("no context");
    std::exit(2);
  }
}

void finish() {
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  eglDestroySurface(display, surface);
  eglTerminate(display);
}

// Two triangles, a color each; the picture is the same at any size.
void drawScene(float shift) {
  const GLfloat corners[] = {-0.9f, -0.9f, 0.9f, -0.9f, 0, 0.9f + shift};
  glClearColor(0.35f, 0.45f, 0.55f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glColor4f(0.9f, 0.7f, 0.3f, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glRotatef(180, 0, 0, 1);
  glColor4f(0.2f, 0.5f, 0.3f, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glLoadIdentity();
}

std::vector<GLubyte> pixels() {
  std::vector<GLubyte> all(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
  return all;
}

// Rows from the lowest.
void writePicture(const char* path, const std::vector<GLubyte>& all) {
  std::FILE* file = std::fopen(path, "wb");
  if (!file) std::exit(3);
  std::fprintf(file, "P6\n%d %d\n255\n", width, height);
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x) std::fwrite(&all[static_cast<size_t>(y * width + x) * 4], 1, 3, file);
  std::fclose(file);
}

// pictures FILE WIDTH HEIGHT FRAMES: what a pbuffer shows after so many swaps. The counters go to the output.
void pictures(char** arguments) {
  width = std::atoi(arguments[1]);
  height = std::atoi(arguments[2]);
  start();
  for (int i = 0; i < std::atoi(arguments[3]); ++i) {
    drawScene(static_cast<float>(i % 10) / 100);
    glViewport(0, 0, width, height);
    eglSwapBuffers(display, surface);
  }
  writePicture(arguments[0], pixels());
  for (EGLint i = 0; i < kCounters; ++i) {
    EGLint value = -1;
    eglQueryContext(display, context, kFirstCounter + i, &value);
    std::printf("counter %d %d\n", i, value);
  }
  std::printf("error 0x%x\n", glGetError());
  finish();
}

std::vector<GLubyte> pixelsOfScreen() {
  std::vector<GLubyte> all(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  XImage* const image = XGetImage(server, window, 0, 0, static_cast<unsigned>(width),
                                  static_cast<unsigned>(height), AllPlanes, ZPixmap);
  if (image == nullptr) std::exit(4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      GLubyte* const to = &all[static_cast<size_t>((height - 1 - y) * width + x) * 4];
      for (int i = 0; i < 3; ++i) to[i] = static_cast<GLubyte>(pixel >> (16 - 8 * i));
    }
  XDestroyImage(image);
  return all;
}

// window SCREEN PICTURE WIDTH HEIGHT FRAMES: what a window shows after so many swaps, and what the program
// then has of a picture that is kept.
int showWindow(char** arguments) {
  server = XOpenDisplay(nullptr);
  if (server == nullptr) return 5;
  width = std::atoi(arguments[2]);
  height = std::atoi(arguments[3]);
  start();
  if (!eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED)) return 6;
  for (int i = 0; i < std::atoi(arguments[4]); ++i) {
    drawScene(0);
    eglSwapBuffers(display, surface);
  }
  glFinish();
  XSync(server, False);
  writePicture(arguments[0], pixelsOfScreen());
  writePicture(arguments[1], pixels());
  // A picture that is not kept, and how old it is said to be.
  eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED);
  for (int i = 0; i < 4; ++i) {
    drawScene(0);
    eglSwapBuffers(display, surface);
  }
  EGLint age = -1;
  drawScene(0);
  eglQuerySurface(display, surface, EGL_BUFFER_AGE_EXT, &age);
  std::printf("age %d\nerror 0x%x\n", age, glGetError());
  finish();
  XCloseDisplay(server);
  return 0;
}

// What <GLES/glext.h> does not declare.
template <class Function>
Function command(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Objects with and without labels, draws of every kind, a group of the program's own.
void groups() {
  start();
  const auto label =
      command<void (*)(GLenum type, GLuint object, GLsizei length, const char* text)>("glLabelObjectEXT");
  const auto push = command<void (*)(GLsizei length, const char* text)>("glPushGroupMarkerEXT");
  const auto pop = command<void (*)()>("glPopGroupMarkerEXT");
  GLuint texture, buffers[2], framebuffer, renderbuffer;
  const GLubyte texels[4 * 3] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  label(GL_TEXTURE, texture, 0, "brick");

  const GLfloat corners[] = {-1, -1, 1, -1, 0, 1};
  const GLushort indices[] = {0, 1, 2};
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);

  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  push(0, "scene");
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
  glEnable(GL_TEXTURE_2D);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  pop();
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDrawTexiOES(0, 0, 0, 8, 8);
  glDisable(GL_TEXTURE_2D);

  // Three that would be one draw.
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const GLfloat six[] = {-1, -1, 1, -1, 0, 1, -1, -1, 1, -1, 0, 1};
  glVertexPointer(2, GL_FLOAT, 0, six);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawArrays(GL_TRIANGLES, 3, 3);
  glDrawArrays(GL_TRIANGLES, 0, 6);

  glGenFramebuffersOES(1, &framebuffer);
  glGenRenderbuffersOES(1, &renderbuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, renderbuffer);
  glRenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_RGBA8_OES, 16, 16);
  glFramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES,
                               renderbuffer);
  label(GL_FRAMEBUFFER_OES, framebuffer, 0, "mirror");
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFinish();
  std::printf("error 0x%x\n", glGetError());
  eglSwapBuffers(display, surface);
  finish();
}

// A draw, whose error goes to the output; `lit` with another shader.
void broken() {
  start();
  drawScene(0);
  std::printf("error 0x%x\n", glGetError());
  drawScene(0);
  std::printf("error 0x%x\n", glGetError());
  glFinish();
  finish();
}

void misuse() {
  start();
  glLineWidth(-1);
  eglCreatePbufferSurface(display, nullptr, nullptr);
  std::printf("error 0x%x\n", glGetError());
  finish();
}

// Ends without giving anything back.
void leave() {
  start();
  drawScene(0);
  eglSwapBuffers(display, surface);
  glFinish();
}

}  // namespace

int main(int count, char** arguments) {
  const std::string verb = count > 1 ? arguments[1] : "";
  if (verb == "pictures" && count == 6)
    pictures(arguments + 2);
  else if (verb == "window" && count == 7)
    return showWindow(arguments + 2);
  else if (verb == "groups")
    groups();
  else if (verb == "broken")
    broken();
  else if (verb == "misuse")
    misuse();
  else if (verb == "leave")
    leave();
  else
    return 1;
  return 0;
}
