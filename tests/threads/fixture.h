// What the cases of many threads stand on: contexts with a surface, pictures of one color.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <ostream>

namespace threads {

// How often the usual work is done: --effort N of the test program, 1 without.
int effort();

// The surfaceless display, initialised.
EGLDisplay display();
// Colors of 8 bits; its context is of the handle's display.
EGLConfig configOf(EGLDisplay display);

// Extension commands by their names without suffixes.
struct Extensions {
  PFNGLGENFRAMEBUFFERSOESPROC genFramebuffers;
  PFNGLDELETEFRAMEBUFFERSOESPROC deleteFramebuffers;
  PFNGLBINDFRAMEBUFFEROESPROC bindFramebuffer;
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC framebufferTexture2D;
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC framebufferRenderbuffer;
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC checkFramebufferStatus;
  PFNGLGENRENDERBUFFERSOESPROC genRenderbuffers;
  PFNGLDELETERENDERBUFFERSOESPROC deleteRenderbuffers;
  PFNGLBINDRENDERBUFFEROESPROC bindRenderbuffer;
  PFNGLRENDERBUFFERSTORAGEOESPROC renderbufferStorage;
  PFNGLEGLIMAGETARGETTEXTURE2DOESPROC imageTargetTexture2D;
  PFNEGLCREATESYNCKHRPROC createSyncKHR;
  PFNEGLSIGNALSYNCKHRPROC signalSyncKHR;
};
const Extensions& gl();

struct Color {
  GLubyte r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Color& color);
// One of many, well apart.
Color colorOf(unsigned number);

// A context and a pbuffer of kSize x kSize. Leaves and destroys them at its end.
inline constexpr GLsizei kSize = 16;
class Place {
 public:
  explicit Place(EGLContext share = EGL_NO_CONTEXT, EGLDisplay on = display());
  ~Place();
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  bool enter() const;
  void leave() const;
  EGLContext context() const { return context_; }
  EGLSurface surface() const { return surface_; }

 private:
  EGLDisplay display_;
  EGLSurface surface_;
  EGLContext context_;
};

void clear(Color color);
// In the middle of what is read from.
Color pixel();
// All of the viewport, in the current color and what is bound.
void drawQuad();
// A texture of one color, bound; sizes are powers of two.
GLuint makeTexture(Color color, GLsizei size = 4);
void specify(Color color, GLsizei size);
// What a quad with this texture, or in this color, looks like on black.
Color pictureOf(GLuint texture);
Color pictureIn(Color color);

// Runs body(0) to body(count - 1) in threads of their own, all at once.
void inThreads(int count, const std::function<void(int)>& body);

}  // namespace threads
