#include "harness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>

namespace conformance {

namespace {

struct OpenDisplay {
  EGLDisplay handle = EGL_NO_DISPLAY;
  bool mesa = false;

  OpenDisplay() {
    handle = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major = 0, minor = 0;
    if (handle == EGL_NO_DISPLAY || !eglInitialize(handle, &major, &minor)) return;
    const char* vendor = eglQueryString(handle, EGL_VENDOR);
    mesa = vendor && std::strstr(vendor, "Mesa");
  }
  ~OpenDisplay() {
    eglReleaseThread();
    if (handle != EGL_NO_DISPLAY) eglTerminate(handle);
  }
};

const OpenDisplay& openDisplay() {
  static const OpenDisplay instance;
  return instance;
}

EGLConfig chooseConfig(const SurfaceRequest& request) {
  const EGLint attributes[] = {EGL_SURFACE_TYPE,  EGL_PBUFFER_BIT,    EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_ES_BIT, EGL_RED_SIZE,       request.red,
                               EGL_GREEN_SIZE,    request.green,      EGL_BLUE_SIZE,
                               request.blue,      EGL_ALPHA_SIZE,     request.alpha,
                               EGL_DEPTH_SIZE,    request.depth,      EGL_STENCIL_SIZE,
                               request.stencil,   EGL_SAMPLE_BUFFERS, request.samples > 0 ? 1 : 0,
                               EGL_SAMPLES,       request.samples,    EGL_NONE};
  std::array<EGLConfig, 256> configs;
  EGLint count = 0;
  if (!eglChooseConfig(display(), attributes, configs.data(), configs.size(), &count)) return nullptr;
  auto attribute = [](EGLConfig config, EGLint name) {
    EGLint value = 0;
    eglGetConfigAttrib(display(), config, name, &value);
    return value;
  };
  // Deeper colours sort first (EGL 3.4.1.2), and a case wants exactly its own.
  for (EGLint i = 0; i < count; ++i) {
    const EGLConfig config = configs[static_cast<std::size_t>(i)];
    if (attribute(config, EGL_RED_SIZE) == request.red &&
        attribute(config, EGL_GREEN_SIZE) == request.green &&
        attribute(config, EGL_BLUE_SIZE) == request.blue &&
        attribute(config, EGL_ALPHA_SIZE) == request.alpha &&
        attribute(config, EGL_SAMPLES) == request.samples) {
      return config;
    }
  }
  return nullptr;
}

}  // namespace

EGLDisplay display() {
  return openDisplay().handle;
}
bool onMesa() {
  return openDisplay().mesa;
}

Vec4 Image::at(int x, int y) const {
  const std::uint8_t* texel = rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4;
  return {texel[0] / 255.0, texel[1] / 255.0, texel[2] / 255.0, texel[3] / 255.0};
}

std::string toString(const Vec4& color) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f}, {:.2f})/255", color[0] * 255, color[1] * 255, color[2] * 255,
                     color[3] * 255);
}

std::string errorName(GLenum error) {
  switch (error) {
    case GL_NO_ERROR:
      return "NO_ERROR";
    case GL_INVALID_ENUM:
      return "INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "INVALID_OPERATION";
    case GL_STACK_OVERFLOW:
      return "STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW:
      return "STACK_UNDERFLOW";
    case GL_OUT_OF_MEMORY:
      return "OUT_OF_MEMORY";
    default:
      return fmt::format("{:#06x}", error);
  }
}

Vec4 clamp01(Vec4 color) {
  for (double& c : color) c = std::clamp(c, 0.0, 1.0);
  return color;
}

double driverError(const std::string& measurement) {
  const char* renderer = std::getenv("ANTEROOM_RENDERER");
  if (renderer && !std::strcmp(renderer, "reference")) return 0;
  static std::map<std::string, double> known;
  if (const auto found = known.find(measurement); found != known.end()) return found->second;
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "anteroom-driver";
  const auto close = [](FILE* pipe) { pclose(pipe); };
  const std::unique_ptr<FILE, decltype(close)> pipe(
      popen((program.string() + ' ' + measurement).c_str(), "r"), close);
  double error = 0;
  if (!pipe || std::fscanf(pipe.get(), "%*s %lf", &error) != 1)
    ADD_FAILURE() << "no measurement " << measurement;
  return known[measurement] = error;
}

testing::AssertionResult near(const Vec4& actual, const Vec4& expected, double tolerance) {
  double worst = 0;
  for (int i = 0; i < 4; ++i) worst = std::max(worst, std::abs(actual[i] - expected[i]));
  // Half a thousandth of a step for the arithmetic of the comparison itself.
  if (worst <= tolerance + 0.0005 * kOneStep) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "got " << toString(actual) << ", want " << toString(expected)
                                     << ", off by " << fmt::format("{:.2f}/255", worst * 255);
}

testing::AssertionResult glErrorIs(GLenum expected) {
  const GLenum actual = glGetError();
  if (actual == expected) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "GL error " << errorName(actual) << ", want " << errorName(expected);
}

Session::Session(const SurfaceRequest& request, EGLContext share) {
  const EGLConfig config = chooseConfig(request);
  if (!config) return;
  const EGLint size[] = {EGL_WIDTH, request.width, EGL_HEIGHT, request.height, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  eglBindAPI(EGL_OPENGL_ES_API);
  surface_ = eglCreatePbufferSurface(display(), config, size);
  context_ = eglCreateContext(display(), config, share, version);
}

Session::~Session() {
  eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display(), context_);
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display(), surface_);
}

bool Session::makeCurrent() const {
  return valid() && eglMakeCurrent(display(), surface_, surface_, context_) == EGL_TRUE;
}

void GlTest::SetUp() {
  ASSERT_NE(display(), EGL_NO_DISPLAY) << "no surfaceless display";
  session_ = std::make_unique<Session>(request_);
  ASSERT_TRUE(session_->valid()) << "no config, pbuffer or context for the request";
  ASSERT_TRUE(session_->makeCurrent());
  // The initial contents of every buffer are undefined (4).
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void GlTest::TearDown() {
  if (session_ && session_->valid()) {
    EXPECT_EQ(errorName(glGetError()), "NO_ERROR") << "left behind by the case";
  }
  session_.reset();
}

Image GlTest::readAll() const {
  return readImage(0, 0, width(), height());
}
Vec4 GlTest::readPixel(int x, int y) const {
  return readImage(x, y, 1, 1).at(0, 0);
}

Image readImage(int x, int y, int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 4, 0xcd)};
  glReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  return image;
}

bool hasExtension(std::string_view name) {
  const GLubyte* text = glGetString(GL_EXTENSIONS);
  if (!text) return false;
  const std::string all = fmt::format(" {} ", reinterpret_cast<const char*>(text));
  return all.find(fmt::format(" {} ", name)) != std::string::npos;
}

void drawRect(const Rect& rect) {
  const GLfloat z = static_cast<GLfloat>(rect.z);
  const GLfloat x0 = static_cast<GLfloat>(rect.x0), x1 = static_cast<GLfloat>(rect.x1);
  const GLfloat y0 = static_cast<GLfloat>(rect.y0), y1 = static_cast<GLfloat>(rect.y1);
  const GLfloat positions[] = {x0, y0, z, x1, y0, z, x0, y1, z, x1, y1, z};
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, positions);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisableClientState(GL_VERTEX_ARRAY);
}

void drawTexturedRect(const Rect& rect, double s0, double t0, double s1, double t1, int unit) {
  const GLfloat a = static_cast<GLfloat>(s0), b = static_cast<GLfloat>(s1);
  const GLfloat c = static_cast<GLfloat>(t0), d = static_cast<GLfloat>(t1);
  const GLfloat coordinates[] = {a, c, b, c, a, d, b, d};
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
  drawRect(rect);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
}

void useNearest(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

GLuint solidTexture(GLenum format, const std::array<std::uint8_t, 4>& texel) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 1, 1, 0, format, GL_UNSIGNED_BYTE, texel.data());
  return name;
}

Cells::Cells(int width, int height, int cell) : width_(width), height_(height), cell_(cell) {}

Cells::~Cells() {
  check();
}

std::size_t Cells::capacity() const {
  return static_cast<std::size_t>(width_ / cell_) * static_cast<std::size_t>(height_ / cell_);
}

void Cells::begin() {
  const int index = static_cast<int>(rows_.size()), columns = width_ / cell_;
  glViewport(index % columns * cell_, index / columns * cell_, cell_, cell_);
}

void Cells::check() {
  if (rows_.empty()) return;
  const int columns = width_ / cell_;
  const Image image = readImage(0, 0, width_, height_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int index = static_cast<int>(i);
    const Vec4 actual = image.at(index % columns * cell_ + cell_ / 2, index / columns * cell_ + cell_ / 2);
    EXPECT_TRUE(near(actual, rows_[i].expected, rows_[i].tolerance)) << rows_[i].name;
  }
  rows_.clear();
  glViewport(0, 0, width_, height_);
}

}  // namespace conformance
