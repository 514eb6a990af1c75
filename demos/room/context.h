// An offscreen OpenGL ES 1.x context on whichever EGL implementation is found.
#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace room {

// What the implementation has done so far for the current context, modulo 2^31.
struct ImplementationCounters {
  std::uint32_t draws = 0;
  std::uint32_t pipelines = 0;
  std::uint32_t compiles = 0;
  std::uint32_t uploadedBytes = 0;
};
ImplementationCounters operator-(const ImplementationCounters& a, const ImplementationCounters& b);

// Owns a display connection, a pbuffer and a context, current on the creating thread.
// Throws std::runtime_error with the EGL error when no display or no config will do.
class Context {
 public:
  // samples: the multisamples wished for; the nearest lower count that a config has is taken.
  Context(int width, int height, int samples);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }
  // By EGL_ANTEROOM_context_counters; none where the implementation does not tell.
  std::optional<ImplementationCounters> counters() const;

 private:
  bool open(EGLDisplay display, int samples);
  void checkSize(EGLDisplay display, EGLConfig config);
  void close();

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
  int width_;
  int height_;
  int samples_ = 0;
  EGLint error_ = EGL_SUCCESS;  // why the last display was passed over
};

// Whether the current context lists the extension.
bool hasExtension(std::string_view name);

// The implementation is too old or too small for a demo: nothing is wrong with either.
struct MissingExtension : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws MissingExtension, naming the demo, unless the current context lists the extension.
void requireExtension(std::string_view name, std::string_view demo);

// The same for texture units.
void requireTextureUnits(int units, std::string_view demo);

// Throws std::runtime_error that names every GL error since the last call; `where` tells what was running.
void checkErrors(std::string_view where);

}  // namespace room
