#include "egl_fixture.h"

#include <cstring>

namespace egl_conformance {

EGLDisplay surfacelessDisplay() {
  static const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return display;
}

bool onMesa() {
  static const bool mesa = [] {
    eglInitialize(surfacelessDisplay(), nullptr, nullptr);
    const char* vendor = eglQueryString(surfacelessDisplay(), EGL_VENDOR);
    return vendor && std::strstr(vendor, "Mesa");
  }();
  return mesa;
}

bool names(const char* extensions, std::string_view extension) {
  const std::string all = std::string(1, ' ').append(extensions ? extensions : "").append(" ");
  return all.find(std::string(1, ' ').append(extension).append(" ")) != std::string::npos;
}

std::string errorName(EGLint error) {
  static const char* const kNames[] = {
      "SUCCESS",           "NOT_INITIALIZED",   "BAD_ACCESS",          "BAD_ALLOC",   "BAD_ATTRIBUTE",
      "BAD_CONFIG",        "BAD_CONTEXT",       "BAD_CURRENT_SURFACE", "BAD_DISPLAY", "BAD_MATCH",
      "BAD_NATIVE_PIXMAP", "BAD_NATIVE_WINDOW", "BAD_PARAMETER",       "BAD_SURFACE", "CONTEXT_LOST"};
  const EGLint index = error - EGL_SUCCESS;
  return index >= 0 && index < 15 ? kNames[index] : std::to_string(error);
}

testing::AssertionResult eglErrorIs(EGLint expected) {
  const EGLint actual = eglGetError();
  if (actual == expected) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "EGL error " << errorName(actual) << ", want " << errorName(expected);
}

void EglTest::SetUp() {
  display_ = surfacelessDisplay();
  ASSERT_NE(display_, EGL_NO_DISPLAY);
  ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
  eglBindAPI(EGL_OPENGL_ES_API);
  EXPECT_EGL_ERROR(EGL_SUCCESS);
}

void EglTest::TearDown() {
  EXPECT_EQ(errorName(eglGetError()), "SUCCESS") << "left behind by the case";
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglReleaseThread();
}

EGLConfig EglTest::choose(std::vector<EGLint> more) const {
  std::vector<EGLint> attributes = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                    EGL_OPENGL_ES_BIT};
  attributes.insert(attributes.end(), more.begin(), more.end());
  attributes.push_back(EGL_NONE);
  EGLConfig config = nullptr;
  EGLint count = 0;
  EXPECT_TRUE(eglChooseConfig(display_, attributes.data(), &config, 1, &count));
  return count ? config : nullptr;
}

EGLint EglTest::attribute(EGLConfig config, EGLint name) const {
  EGLint value = -12345;
  EXPECT_TRUE(eglGetConfigAttrib(display_, config, name, &value)) << std::hex << name;
  return value;
}

EGLSurface EglTest::createPbuffer(EGLConfig config, std::vector<EGLint> attributes) const {
  attributes.push_back(EGL_NONE);
  return eglCreatePbufferSurface(display_, config, attributes.data());
}

EGLContext EglTest::createContext(EGLConfig config, EGLContext share, std::vector<EGLint> attributes) const {
  attributes.push_back(EGL_NONE);
  return eglCreateContext(display_, config, share, attributes.data());
}

}  // namespace egl_conformance
