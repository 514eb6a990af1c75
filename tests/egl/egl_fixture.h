// What the EGL cases stand on: the surfaceless display, initialised, and checks of eglGetError.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace egl_conformance {

// A platform that exists wherever the tests run.
EGLDisplay surfacelessDisplay();
bool onMesa();
// Whether a string of eglQueryString names the extension.
bool names(const char* extensions, std::string_view extension);
std::string errorName(EGLint error);
testing::AssertionResult eglErrorIs(EGLint expected);

class EglTest : public testing::Test {
 protected:
  void SetUp() override;
  // Every case leaves nothing current and no error.
  void TearDown() override;

  // The first config of eglChooseConfig that supports pbuffers and ES 1, with what `more` asks for.
  EGLConfig choose(std::vector<EGLint> more = {EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8,
                                               EGL_ALPHA_SIZE, 8}) const;
  EGLint attribute(EGLConfig config, EGLint name) const;
  EGLSurface createPbuffer(EGLConfig config,
                           std::vector<EGLint> attributes = {EGL_WIDTH, 16, EGL_HEIGHT, 16}) const;
  EGLContext createContext(EGLConfig config, EGLContext share = EGL_NO_CONTEXT,
                           std::vector<EGLint> attributes = {EGL_CONTEXT_CLIENT_VERSION, 1}) const;

  EGLDisplay display_ = EGL_NO_DISPLAY;
};

}  // namespace egl_conformance

#define EXPECT_EGL_ERROR(code) EXPECT_TRUE(::egl_conformance::eglErrorIs(code))
#define MESA_DISAGREES(section, why) \
  if (::egl_conformance::onMesa()) GTEST_SKIP() << "Mesa departs from section " << section << ": " << why
