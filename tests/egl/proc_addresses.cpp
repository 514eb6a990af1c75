// EGL 1.5 section 3.11 with EGL_KHR_get_all_proc_addresses: a function for every command, and it is the right
// one.
#include "core_commands.h"
#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class ProcAddresses : public EglTest {};

TEST_F(ProcAddresses, EveryEglCommand) {
  for (const char* name : kEglCommands) EXPECT_NE(eglGetProcAddress(name), nullptr) << name;
}

TEST_F(ProcAddresses, EveryGlCommand) {
  for (const char* name : kGlCommands) EXPECT_NE(eglGetProcAddress(name), nullptr) << name;
  for (const char* name : {"glPointSizePointerOES", "glQueryMatrixxOES", "glTexGeniOES"}) {
    EXPECT_NE(eglGetProcAddress(name), nullptr) << name;
  }
}

TEST_F(ProcAddresses, UnknownNames) {
  // A dispatch library may give a stub for any name that begins with gl.
  for (const char* name : {"", "Clear", "eglNoSuchCommand", "noSuchThing", " glClear"}) {
    EXPECT_EQ(eglGetProcAddress(name), nullptr) << name;
  }
}

TEST_F(ProcAddresses, NullName) {
  MESA_DISAGREES("3.11", "a null name is not looked at before it is used");
  EXPECT_EQ(eglGetProcAddress(nullptr), nullptr);
}

TEST_F(ProcAddresses, TheyWork) {
  const auto makeCurrent = reinterpret_cast<decltype(&eglMakeCurrent)>(eglGetProcAddress("eglMakeCurrent"));
  const auto clearColor = reinterpret_cast<decltype(&glClearColor)>(eglGetProcAddress("glClearColor"));
  const auto clear = reinterpret_cast<decltype(&glClear)>(eglGetProcAddress("glClear"));
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(makeCurrent(display_, surface, surface, createContext(config)));
  clearColor(0, 1, 0, 1);
  clear(GL_COLOR_BUFFER_BIT);
  GLubyte pixel[4] = {};
  glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[1], 255);
}

}  // namespace
}  // namespace egl_conformance
