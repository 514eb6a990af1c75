// What every conformance case stands on: a surfaceless display, a pbuffer, an ES 1.1 context, pixels and
// expectations. Sees only the EGL and GLES headers, so that a case runs on any implementation.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace conformance {

using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;

constexpr double kOneStep = 1.0 / 255.0;

// The buffers a case draws into; bits and samples are what eglChooseConfig is asked for, the colour sizes
// exactly.
struct SurfaceRequest {
  int width = 64, height = 64;
  int red = 8, green = 8, blue = 8, alpha = 8;
  int depth = 24, stencil = 8, samples = 0;
};

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  // The pixel in [0, 1], lower left origin.
  Vec4 at(int x, int y) const;
};

// The process' initialised surfaceless display.
EGLDisplay display();
// Mesa is the second opinion; cases in which it departs from the text are skipped there (MESA_DISAGREES).
bool onMesa();

std::string toString(const Vec4& color);
std::string errorName(GLenum error);
// Clamped to [0, 1].
Vec4 clamp01(Vec4 color);

// How far the Vulkan driver itself is off where it may be less exact than a step, as
// build/bin/anteroom-driver measures it (tests/driver has the names); 0 on the float64 renderer.
double driverError(const std::string& measurement);

testing::AssertionResult near(const Vec4& actual, const Vec4& expected, double tolerance = kOneStep);
testing::AssertionResult glErrorIs(GLenum expected);

// A display, a config, a pbuffer and a current ES 1.1 context of its own.
class Session {
 public:
  explicit Session(const SurfaceRequest& request, EGLContext share = EGL_NO_CONTEXT);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  bool valid() const { return context_ != EGL_NO_CONTEXT && surface_ != EGL_NO_SURFACE; }
  bool makeCurrent() const;
  EGLContext context() const { return context_; }

 private:
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

class GlTest : public testing::Test {
 protected:
  explicit GlTest(const SurfaceRequest& request = {}) : request_(request) {}
  void SetUp() override;
  void TearDown() override;

  int width() const { return request_.width; }
  int height() const { return request_.height; }
  Image readAll() const;
  Vec4 readPixel(int x, int y) const;

 private:
  SurfaceRequest request_;
  std::unique_ptr<Session> session_;
};

Image readImage(int x, int y, int width, int height);

// Whether GL_EXTENSIONS of the current context names it.
bool hasExtension(std::string_view name);

// Quads in normalised device coordinates under the current matrices, as a triangle strip from client memory.
struct Rect {
  double x0 = -1, y0 = -1, x1 = 1, y1 = 1, z = 0;
};
void drawRect(const Rect& rect = {});
// The same with texture coordinates of unit `unit` running over [s0, s1] x [t0, t1].
void drawTexturedRect(const Rect& rect, double s0, double t0, double s1, double t1, int unit = 0);

// A texture of one colour, bound to TEXTURE_2D of the active unit, NEAREST; the caller's name, deleted with
// the context.
GLuint solidTexture(GLenum format, const std::array<std::uint8_t, 4>& texel);
void useNearest(GLenum target = GL_TEXTURE_2D);

// One framebuffer divided into small cells, so that a table of hundreds of rows is read back only a few
// times.
class Cells {
 public:
  explicit Cells(int width = 64, int height = 64, int cell = 4);
  ~Cells();
  // Points the viewport at the next cell; draw() fills it, and its centre must become `expected`.
  template <class Draw>
  void add(std::string name, const Vec4& expected, Draw&& draw, double tolerance = kOneStep) {
    begin();
    draw();
    rows_.push_back({std::move(name), expected, tolerance});
    if (rows_.size() == capacity()) check();
  }
  void check();
  // What the last row must become, where only drawing it tells.
  void expectLast(const Vec4& expected, double tolerance) {
    rows_.back().expected = expected;
    rows_.back().tolerance = tolerance;
  }

 private:
  struct Row {
    std::string name;
    Vec4 expected;
    double tolerance;
  };
  std::size_t capacity() const;
  void begin();

  int width_, height_, cell_;
  std::vector<Row> rows_;
};

}  // namespace conformance

#define EXPECT_GL_ERROR(code) EXPECT_TRUE(::conformance::glErrorIs(code))
#define ASSERT_GL_ERROR(code) ASSERT_TRUE(::conformance::glErrorIs(code))
#define EXPECT_PIXEL(x, y, ...) EXPECT_TRUE(::conformance::near(readPixel(x, y), __VA_ARGS__))

// Skips the case on Mesa: `section` of the specification decides against it, `why` says how it departs.
#define MESA_DISAGREES(section, why) \
  if (::conformance::onMesa()) GTEST_SKIP() << "Mesa departs from section " << section << ": " << why
