#include "window_fixture.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

namespace windows {

EGLenum eglPlatform(Platform platform) {
  return platform == Platform::Xlib  ? EGL_PLATFORM_X11_KHR
         : platform == Platform::Xcb ? EGL_PLATFORM_XCB_EXT
                                     : EGL_PLATFORM_WAYLAND_KHR;
}

std::vector<Block> quarters(int width, int height, int frame) {
  static constexpr Rgb kColors[] = {{255, 0, 0},     {0, 255, 0},   {0, 0, 255},
                                    {255, 255, 255}, {255, 255, 0}, {0, 255, 255}};
  const auto color = [frame](int i) { return kColors[std::size_t(i + frame) % std::size(kColors)]; };
  const int x = width / 2, y = height / 2;
  return {{0, 0, x, y, color(0)},
          {x, 0, width - x, y, color(1)},
          {0, y, x, height - y, color(2)},
          {x, y, width - x, height - y, color(3)},
          {width / 8, height / 4, width / 4, height / 8, color(4)}};
}

void paint(Image& image, const Block& block) {
  for (int y = std::max(block.y, 0); y < std::min(block.y + block.height, image.height); ++y)
    for (int x = std::max(block.x, 0); x < std::min(block.x + block.width, image.width); ++x)
      image.at(x, y) = block.color;
}

Image picture(int width, int height, int frame) {
  Image image(width, height);
  for (const Block& block : quarters(width, height, frame)) paint(image, block);
  return image;
}

void draw(const Block& block) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(block.x, block.y, block.width, block.height);
  glClearColor(float(block.color[0]) / 255, float(block.color[1]) / 255, float(block.color[2]) / 255, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

void drawPicture(int width, int height, int frame) {
  for (const Block& block : quarters(width, height, frame)) draw(block);
}

void drawRect(float x, float y, float width, float height, float z, int surfaceWidth, int surfaceHeight) {
  const float right = x + width, top = y + height;
  const GLfloat vertices[] = {x, y, z, right, y, z, x, top, z, right, top, z};
  glViewport(0, 0, surfaceWidth, surfaceHeight);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrthof(0, float(surfaceWidth), 0, float(surfaceHeight), -1, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, vertices);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisableClientState(GL_VERTEX_ARRAY);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

Image readPixels(int x, int y, int width, int height) {
  Image image(width, height);
  std::vector<GLubyte> rgba(image.pixels.size() * 4, 0x5a);
  glReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]};
  return image;
}

bool glHas(std::string_view extension) {
  return names(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), extension);
}

testing::AssertionResult same(const Image& actual, const Image& expected, int tolerance) {
  if (actual.width != expected.width || actual.height != expected.height)
    return testing::AssertionFailure() << "size " << actual.width << "x" << actual.height << ", want "
                                       << expected.width << "x" << expected.height;
  const Difference found = difference(actual, expected, tolerance);
  if (found.most <= tolerance) return testing::AssertionSuccess();
  const auto text = [&](const Image& image) {
    std::string words;
    for (std::uint8_t channel : image.at(found.x, found.y)) words.append(" ").append(std::to_string(channel));
    return words;
  };
  return testing::AssertionFailure() << found.pixels << " of " << expected.pixels.size()
                                     << " pixels differ, most at (" << found.x << ", " << found.y
                                     << "): " << text(actual) << ", want " << text(expected);
}

testing::AssertionResult shows(NativeWindow& window, const Image& expected, int tolerance) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(60);
  for (;;) {
    const testing::AssertionResult result = same(window.onScreen(), expected, tolerance);
    if (result || Clock::now() > end) return result;
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
  }
}

void WindowTest::SetUp() {
  // A display is dear: a process has one a platform.
  struct Displays {
    std::unique_ptr<NativeDisplay> native;
    EGLDisplay egl = EGL_NO_DISPLAY;
  };
  static std::map<Platform, Displays> displays;
  Displays& own = displays[GetParam()];
  if (!own.native) {
    own.native = NativeDisplay::open(GetParam());
    own.egl = eglGetPlatformDisplay(eglPlatform(GetParam()), own.native->handle(), nullptr);
  }
  native_ = own.native.get();
  display_ = own.egl;
  ASSERT_NE(display_, EGL_NO_DISPLAY);
  ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
  eglBindAPI(EGL_OPENGL_ES_API);
  EXPECT_EGL_ERROR(EGL_SUCCESS);
}

void WindowTest::TearDown() {
  EglTest::TearDown();
  if (!native_) return;
  for (Target& target : targets_) close(target);
  for (EGLContext each : contexts_) eglDestroyContext(display_, each);
  EXPECT_EGL_ERROR(EGL_SUCCESS);
  for (const std::string& complaint : native_->complaints())
    ADD_FAILURE() << "the server says: " << complaint;
}

bool WindowTest::has(std::string_view extension) const {
  return names(eglQueryString(display_, EGL_EXTENSIONS), extension);
}

std::vector<EGLConfig> WindowTest::windowConfigs(std::vector<EGLint> more) const {
  more.insert(more.end(),
              {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_NONE});
  EGLint count = 0;
  EXPECT_TRUE(eglChooseConfig(display_, more.data(), nullptr, 0, &count));
  std::vector<EGLConfig> configs(std::size_t(count), nullptr);
  EXPECT_TRUE(eglChooseConfig(display_, more.data(), configs.data(), count, &count));
  return configs;
}

EGLConfig WindowTest::windowConfig(std::vector<EGLint> more) const {
  more.insert(more.end(), {EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8});
  for (EGLConfig each : windowConfigs(more))
    if (attribute(each, EGL_RED_SIZE) == 8 && attribute(each, EGL_ALPHA_SIZE) == 0) return each;
  return nullptr;
}

EGLConfig WindowTest::pbufferConfig(EGLConfig like) const {
  std::vector<EGLint> attributes = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                    EGL_OPENGL_ES_BIT};
  for (EGLint name : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE, EGL_DEPTH_SIZE,
                      EGL_STENCIL_SIZE, EGL_SAMPLES})
    attributes.insert(attributes.end(), {name, attribute(like, name)});
  attributes.push_back(EGL_NONE);
  EGLConfig config = nullptr;
  EGLint count = 0;
  EXPECT_TRUE(eglChooseConfig(display_, attributes.data(), &config, 1, &count));
  for (EGLint name : {EGL_ALPHA_SIZE, EGL_DEPTH_SIZE, EGL_STENCIL_SIZE, EGL_SAMPLES})
    if (count == 0 || attribute(config, name) != attribute(like, name)) return nullptr;
  return config;
}

WindowRequest WindowTest::fitting(EGLConfig config, WindowRequest request) const {
  request.visual = std::uint32_t(attribute(config, EGL_NATIVE_VISUAL_ID));
  return request;
}

Target& WindowTest::open(EGLConfig config, const WindowRequest& request, std::vector<EGLAttrib> attributes) {
  Target& target = targets_.emplace_back();
  target.native = native_->createWindow(fitting(config, request));
  attributes.push_back(EGL_NONE);
  target.surface =
      eglCreatePlatformWindowSurface(display_, config, target.native->pointer(), attributes.data());
  EXPECT_NE(target.surface, EGL_NO_SURFACE);
  return target;
}

EGLContext WindowTest::context(EGLConfig config, EGLContext share) {
  contexts_.push_back(createContext(config, share));
  EXPECT_NE(contexts_.back(), EGL_NO_CONTEXT);
  return contexts_.back();
}

Target& WindowTest::openCurrent(const WindowRequest& request, std::vector<EGLint> more) {
  const EGLConfig config = windowConfig(std::move(more));
  EXPECT_NE(config, nullptr);
  Target& target = open(config, request);
  EXPECT_TRUE(makeCurrent(target, context(config)));
  return target;
}

void WindowTest::close(Target& target) {
  if (target.surface != EGL_NO_SURFACE) {
    EXPECT_TRUE(eglDestroySurface(display_, target.surface));
  }
  target.surface = EGL_NO_SURFACE;
  target.native.reset();
}

EGLint WindowTest::query(const Target& target, EGLint name) const {
  EGLint value = -12345;
  EXPECT_TRUE(eglQuerySurface(display_, target.surface, name, &value)) << std::hex << name;
  return value;
}

testing::AssertionResult WindowTest::drawsAndShows(Target& target, int frame) {
  const int width = query(target, EGL_WIDTH), height = query(target, EGL_HEIGHT);
  drawPicture(width, height, frame);
  const Image expected = picture(width, height, frame);
  if (const auto read = same(readPixels(0, 0, width, height), expected); !read)
    return testing::AssertionFailure() << "read before the swap: " << read.message();
  if (!swap(target)) return egl_conformance::eglErrorIs(EGL_SUCCESS) << " of eglSwapBuffers";
  return shows(*target.native, expected);
}

std::string platformName(const testing::TestParamInfo<Platform>& info) {
  return name(info.param);
}

}  // namespace windows
