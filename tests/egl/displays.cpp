// EGL 1.5 sections 3.1-3.3: displays, initialisation, strings.
#include <cstring>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Displays : public EglTest {};

// 3.3: client extensions and version without a display.
TEST_F(Displays, ClientStrings) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  ASSERT_NE(extensions, nullptr);
  for (const char* name :
       {"EGL_EXT_client_extensions", "EGL_EXT_platform_base", "EGL_MESA_platform_surfaceless",
        "EGL_EXT_platform_device", "EGL_KHR_client_get_all_proc_addresses"}) {
    EXPECT_TRUE(names(extensions, name)) << name;
  }
  const char* version = eglQueryString(EGL_NO_DISPLAY, EGL_VERSION);
  ASSERT_NE(version, nullptr);
  EXPECT_EQ(std::strncmp(version, "1.5", 3), 0) << version;
  EXPECT_EQ(eglQueryString(EGL_NO_DISPLAY, EGL_VENDOR), nullptr);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
}

TEST_F(Displays, DisplayStrings) {
  EGLint major = 0, minor = 0;
  ASSERT_TRUE(eglInitialize(display_, &major, &minor));
  EXPECT_EQ(major, 1);
  // Mesa's own display version is 1.5 as well; with less, EGL 1.5 commands could not be used.
  EXPECT_EQ(minor, 5);
  EXPECT_EQ(std::strncmp(eglQueryString(display_, EGL_VERSION), "1.5", 3), 0);
  EXPECT_TRUE(names(eglQueryString(display_, EGL_CLIENT_APIS), "OpenGL_ES"));
  EXPECT_NE(eglQueryString(display_, EGL_VENDOR), nullptr);
  const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
  ASSERT_NE(extensions, nullptr);
  for (const char* name : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context",
                           "EGL_KHR_create_context", "EGL_KHR_get_all_proc_addresses"}) {
    EXPECT_TRUE(names(extensions, name)) << name;
  }
  // 3.3: the two sets are disjoint.
  EXPECT_FALSE(names(extensions, "EGL_EXT_platform_base"));
  EXPECT_EQ(eglQueryString(display_, EGL_WIDTH), nullptr);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// 3.2
TEST_F(Displays, PlatformDisplay) {
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), display_);
  EXPECT_EQ(eglGetPlatformDisplay(0x1234, EGL_DEFAULT_DISPLAY, nullptr), EGL_NO_DISPLAY);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  const auto extended =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  ASSERT_NE(extended, nullptr);
  EXPECT_EQ(extended(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), display_);
}

// 3.2: a list of only EGL_NONE is as good as none.
TEST_F(Displays, EmptyAttributeList) {
  MESA_DISAGREES("3.2", "an empty list makes another display");
  const EGLAttrib none[] = {EGL_NONE};
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, none), display_);
}

TEST_F(Displays, PlatformDisplayAttributes) {
  const EGLAttrib unknown[] = {0x1234, 5, EGL_NONE};
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, unknown),
            EGL_NO_DISPLAY);
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
}

// 3.2: the default display works where there is no window system.
TEST_F(Displays, DefaultDisplay) {
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  ASSERT_NE(display, EGL_NO_DISPLAY);
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), display);
  EXPECT_TRUE(eglInitialize(display, nullptr, nullptr));
  EGLint count = 0;
  EXPECT_TRUE(eglGetConfigs(display, nullptr, 0, &count));
  EXPECT_GT(count, 0);
}

// EGL_EXT_platform_device: the first device of eglQueryDevicesEXT has a display.
TEST_F(Displays, DeviceDisplay) {
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  ASSERT_NE(queryDevices, nullptr);
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(queryDevices(1, &device, &count));
  ASSERT_GE(count, 1);
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  ASSERT_NE(display, EGL_NO_DISPLAY);
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr), display);
  EXPECT_TRUE(eglInitialize(display, nullptr, nullptr));
  EXPECT_TRUE(eglTerminate(display));
  EXPECT_FALSE(queryDevices(0, &device, &count));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// EGL_ANTEROOM_origin: its numbers are of no registry.
TEST_F(Displays, Origin) {
  if (!names(eglQueryString(display_, EGL_EXTENSIONS), "EGL_ANTEROOM_origin")) GTEST_SKIP() << "not there";
  constexpr EGLint kDevices = 0x3FE4, kChoice = 0x3FE5, kDriver = 0x3FE6, kCache = 0x3FE7, kQuirks = 0x3FE8;
  const char* devices = eglQueryString(display_, kDevices);
  ASSERT_NE(devices, nullptr);
  EXPECT_EQ(std::strncmp(devices, "0: ", 3), 0) << devices;
  EXPECT_NE(std::strstr(devices, ": chosen"), nullptr) << devices;
  for (EGLint name : {kChoice, kDriver, kCache}) {
    const char* text = eglQueryString(display_, name);
    ASSERT_NE(text, nullptr) << name;
    EXPECT_NE(*text, '\0') << name;
  }
  EXPECT_NE(eglQueryString(display_, kQuirks), nullptr);  // empty where the driver has no known fault
  EXPECT_EGL_ERROR(EGL_SUCCESS);
  EXPECT_EQ(eglQueryString(display_, kQuirks + 1), nullptr);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_EQ(eglQueryString(EGL_NO_DISPLAY, kDevices), nullptr);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  ASSERT_TRUE(eglTerminate(display_));
  EXPECT_EQ(eglQueryString(display_, kDevices), nullptr);
  EXPECT_EGL_ERROR(EGL_NOT_INITIALIZED);
  ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
}

// 3.1.2, 3.2: handles that are no display.
TEST_F(Displays, BadDisplay) {
  EGLint value = 0;
  EXPECT_FALSE(eglInitialize(EGL_NO_DISPLAY, nullptr, nullptr));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_FALSE(eglTerminate(EGL_NO_DISPLAY));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_FALSE(eglGetConfigs(EGL_NO_DISPLAY, nullptr, 0, &value));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_EQ(eglCreateContext(EGL_NO_DISPLAY, nullptr, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_EQ(eglCreatePbufferSurface(EGL_NO_DISPLAY, nullptr, nullptr), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
}

// 3.2: uninitialised and terminated displays; a terminated one can be initialised again.
TEST_F(Displays, Termination) {
  const bool mesa = onMesa();
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  ASSERT_NE(context, EGL_NO_CONTEXT);
  EXPECT_TRUE(eglTerminate(display_));
  EXPECT_TRUE(eglTerminate(display_));
  EGLint value = 0;
  EXPECT_FALSE(eglGetConfigs(display_, nullptr, 0, &value));
  EXPECT_EGL_ERROR(EGL_NOT_INITIALIZED);
  if (!mesa) {  // Which gives BAD_DISPLAY.
    EXPECT_EQ(eglQueryString(display_, EGL_VENDOR), nullptr);
    EXPECT_EGL_ERROR(EGL_NOT_INITIALIZED);
    EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, context));
    EXPECT_EGL_ERROR(EGL_NOT_INITIALIZED);
  }
  // 3.7.3: the one case in which an uninitialised display may be passed.
  EXPECT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
  EXPECT_FALSE(eglQuerySurface(display_, surface, EGL_WIDTH, &value)) << "handles stay invalid";
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglDestroyContext(display_, context));
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
}

// 3.2: what is current while its display is terminated may still be used without a crash.
TEST_F(Displays, TerminationWhileCurrent) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  EXPECT_TRUE(eglTerminate(display_));
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glFinish();
  EXPECT_TRUE(eglReleaseThread());
  ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
}

// 3.1: the error is per call: a call that succeeds sets EGL_SUCCESS.
TEST_F(Displays, ErrorOfTheLastCall) {
  EXPECT_FALSE(eglTerminate(EGL_NO_DISPLAY));
  EGLint count = 0;
  EXPECT_TRUE(eglGetConfigs(display_, nullptr, 0, &count));
  EXPECT_EGL_ERROR(EGL_SUCCESS);
  EXPECT_FALSE(eglTerminate(EGL_NO_DISPLAY));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_EGL_ERROR(EGL_SUCCESS);
}

// 3.7, 3.12
TEST_F(Displays, ApiOfTheThread) {
  EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
  EXPECT_FALSE(eglBindAPI(0x1234));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglBindAPI(EGL_OPENVG_API));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
}

}  // namespace
}  // namespace egl_conformance
