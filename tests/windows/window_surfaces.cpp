// EGL 1.5 sections 3.5.1 and 3.5.6: surfaces of windows, how they are made, asked and changed.
#include "window_fixture.h"

namespace windows {
namespace {

class WindowSurfaces : public WindowTest {};
ON_ALL_PLATFORMS(WindowSurfaces);

// By value, and by a pointer to the handle, which for Wayland is the wl_egl_window itself.
TEST_P(WindowSurfaces, ThreeWays) {
  const EGLConfig config = windowConfig();
  ASSERT_NE(config, nullptr);
  const EGLContext own = context(config);
  const auto platformExt = reinterpret_cast<PFNEGLCREATEPLATFORMWINDOWSURFACEEXTPROC>(
      eglGetProcAddress("eglCreatePlatformWindowSurfaceEXT"));
  ASSERT_TRUE(platformExt);
  Target target;
  target.native = native().createWindow(fitting(config));
  for (int way = 0; way < 3; ++way) {
    target.surface =
        way == 0
            ? eglCreateWindowSurface(display_, config, EGLNativeWindowType(target.native->value()), nullptr)
        : way == 1 ? eglCreatePlatformWindowSurface(display_, config, target.native->pointer(), nullptr)
                   : platformExt(display_, config, target.native->pointer(), nullptr);
    ASSERT_NE(target.surface, EGL_NO_SURFACE) << way;
    EXPECT_EQ(query(target, EGL_WIDTH), 64) << way;
    EXPECT_EQ(query(target, EGL_HEIGHT), 48) << way;
    ASSERT_TRUE(makeCurrent(target, own)) << way;
    EXPECT_TRUE(drawsAndShows(target, way)) << way;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_TRUE(eglDestroySurface(display_, target.surface)) << way;
  }
}

// Table 3.5
TEST_P(WindowSurfaces, Queries) {
  const EGLConfig config = windowConfig();
  const Target& target = open(config, {.width = 70, .height = 33});
  EXPECT_EQ(query(target, EGL_WIDTH), 70);
  EXPECT_EQ(query(target, EGL_HEIGHT), 33);
  EXPECT_EQ(query(target, EGL_CONFIG_ID), attribute(config, EGL_CONFIG_ID));
  EXPECT_EQ(query(target, EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
  EXPECT_EQ(query(target, EGL_MULTISAMPLE_RESOLVE), EGL_MULTISAMPLE_RESOLVE_DEFAULT);
  EXPECT_EQ(query(target, EGL_VG_ALPHA_FORMAT), EGL_VG_ALPHA_FORMAT_NONPRE);
  EXPECT_EQ(query(target, EGL_VG_COLORSPACE), EGL_VG_COLORSPACE_sRGB);
  const EGLint behavior = query(target, EGL_SWAP_BEHAVIOR);
  EXPECT_TRUE(behavior == EGL_BUFFER_DESTROYED || behavior == EGL_BUFFER_PRESERVED);
  // Known, or said to be unknown.
  for (EGLint name : {EGL_HORIZONTAL_RESOLUTION, EGL_VERTICAL_RESOLUTION}) {
    const EGLint dots = query(target, name);
    EXPECT_TRUE(dots == EGL_UNKNOWN || dots > 0) << dots;
  }
  const EGLint aspect = query(target, EGL_PIXEL_ASPECT_RATIO);
  EXPECT_TRUE(aspect == EGL_UNKNOWN || aspect > 0) << aspect;
  EGLint value = 77;
  EXPECT_FALSE(eglQuerySurface(display_, target.surface, EGL_RED_SIZE, &value));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(value, 77);
}

// 3.5.6: what only pbuffers have is no error, and changes nothing.
TEST_P(WindowSurfaces, QueriesOfPbuffers) {
  const Target& target = open(windowConfig());
  MESA_DISAGREES("3.5.6", "the value is modified");
  for (EGLint name :
       {EGL_LARGEST_PBUFFER, EGL_TEXTURE_FORMAT, EGL_TEXTURE_TARGET, EGL_MIPMAP_TEXTURE, EGL_MIPMAP_LEVEL}) {
    EGLint value = 77;
    EXPECT_TRUE(eglQuerySurface(display_, target.surface, name, &value)) << std::hex << name;
    EXPECT_EQ(value, 77) << std::hex << name;
  }
}

TEST_P(WindowSurfaces, SurfaceAttributes) {
  const EGLConfig config = windowConfig();
  const Target& target = open(config);
  EXPECT_TRUE(eglSurfaceAttrib(display_, target.surface, EGL_MIPMAP_LEVEL, 2));
  EXPECT_TRUE(
      eglSurfaceAttrib(display_, target.surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_DEFAULT));
  const EGLint types = attribute(config, EGL_SURFACE_TYPE);
  if (!(types & EGL_MULTISAMPLE_RESOLVE_BOX_BIT)) {
    EXPECT_FALSE(
        eglSurfaceAttrib(display_, target.surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX));
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
  EXPECT_TRUE(eglSurfaceAttrib(display_, target.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED));
  EXPECT_EQ(query(target, EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
  if (types & EGL_SWAP_BEHAVIOR_PRESERVED_BIT) {
    EXPECT_TRUE(eglSurfaceAttrib(display_, target.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
    EXPECT_EQ(query(target, EGL_SWAP_BEHAVIOR), EGL_BUFFER_PRESERVED);
  } else {
    EXPECT_FALSE(eglSurfaceAttrib(display_, target.surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
    EXPECT_EQ(query(target, EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
  }
  EXPECT_FALSE(eglSurfaceAttrib(display_, target.surface, EGL_WIDTH, 2));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
}

TEST_P(WindowSurfaces, CreationAttributes) {
  const EGLConfig config = windowConfig();
  std::vector<std::vector<EGLAttrib>> good = {{},
                                              {EGL_RENDER_BUFFER, EGL_BACK_BUFFER},
                                              {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER},
                                              {EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_sRGB},
                                              {EGL_VG_ALPHA_FORMAT, EGL_VG_ALPHA_FORMAT_NONPRE}};
  if (has("EGL_KHR_gl_colorspace")) {
    good.push_back({EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_LINEAR});
    good.push_back({EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB, EGL_RENDER_BUFFER, EGL_BACK_BUFFER});
  }
  const EGLContext own = context(config);
  for (std::size_t i = 0; i < good.size(); ++i) {
    Target& target = open(config, {}, good[i]);
    ASSERT_NE(target.surface, EGL_NO_SURFACE) << i;
    if (!good[i].empty() && good[i][0] == EGL_GL_COLORSPACE) {
      EXPECT_EQ(query(target, EGL_GL_COLORSPACE), good[i][1]);
    }
    ASSERT_TRUE(makeCurrent(target, own)) << i;
    EGLint buffer = 0;
    EXPECT_TRUE(eglQueryContext(display_, own, EGL_RENDER_BUFFER, &buffer));
    EXPECT_TRUE(buffer == EGL_BACK_BUFFER || buffer == EGL_SINGLE_BUFFER) << i;
    if (query(target, EGL_RENDER_BUFFER) == EGL_BACK_BUFFER) {
      EXPECT_EQ(buffer, EGL_BACK_BUFFER) << i;
    }
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    close(target);
  }
}

TEST_P(WindowSurfaces, BadCreationAttributes) {
  const EGLConfig config = windowConfig();
  const auto window = native().createWindow(fitting(config));
  struct Row {
    std::vector<EGLint> attributes;
    EGLint error;
  };
  std::vector<Row> rows = {{{EGL_WIDTH, 10, EGL_NONE}, EGL_BAD_ATTRIBUTE},
                           {{EGL_TEXTURE_FORMAT, EGL_NO_TEXTURE, EGL_NONE}, EGL_BAD_ATTRIBUTE},
                           {{EGL_RED_SIZE, 8, EGL_NONE}, EGL_BAD_ATTRIBUTE},
                           {{0x7777, 1, EGL_NONE}, EGL_BAD_ATTRIBUTE},
                           {{EGL_RENDER_BUFFER, EGL_BACK_BUFFER, 0x7777, 1, EGL_NONE}, EGL_BAD_ATTRIBUTE},
                           {{EGL_RENDER_BUFFER, 5, EGL_NONE}, EGL_BAD_ATTRIBUTE}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(eglCreateWindowSurface(display_, config, EGLNativeWindowType(window->value()),
                                     rows[i].attributes.data()),
              EGL_NO_SURFACE)
        << i;
    EXPECT_EGL_ERROR(rows[i].error) << i;
    const std::vector<EGLAttrib> attributes(rows[i].attributes.begin(), rows[i].attributes.end());
    EXPECT_EQ(eglCreatePlatformWindowSurface(display_, config, window->pointer(), attributes.data()),
              EGL_NO_SURFACE)
        << i;
    EXPECT_EGL_ERROR(rows[i].error) << i;
  }
  int something = 0;
  EXPECT_EQ(eglCreatePlatformWindowSurface(display_, EGLConfig(&something), window->pointer(), nullptr),
            EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
  EXPECT_EQ(eglCreateWindowSurface(display_, nullptr, EGLNativeWindowType(window->value()), nullptr),
            EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
  // None of the failures holds the window.
  const EGLSurface surface = eglCreatePlatformWindowSurface(display_, config, window->pointer(), nullptr);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
}

TEST_P(WindowSurfaces, AttributesOfOpenVg) {
  MESA_DISAGREES("3.5.1", "color space and alpha format are taken that the config does not support");
  const EGLConfig config = windowConfig();
  const auto window = native().createWindow(fitting(config));
  const EGLint types = attribute(config, EGL_SURFACE_TYPE);
  const struct {
    EGLAttrib name, value;
    EGLint bit;
  } rows[] = {{EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_LINEAR, EGL_VG_COLORSPACE_LINEAR_BIT},
              {EGL_VG_ALPHA_FORMAT, EGL_VG_ALPHA_FORMAT_PRE, EGL_VG_ALPHA_FORMAT_PRE_BIT}};
  for (const auto& row : rows) {
    if (types & row.bit) continue;
    const EGLAttrib attributes[] = {row.name, row.value, EGL_NONE};
    EXPECT_EQ(eglCreatePlatformWindowSurface(display_, config, window->pointer(), attributes),
              EGL_NO_SURFACE);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
}

TEST_P(WindowSurfaces, ConfigWithoutWindows) {
  EGLint count = 0;
  EXPECT_TRUE(eglGetConfigs(display_, nullptr, 0, &count));
  std::vector<EGLConfig> configs(std::size_t(count), nullptr);
  EXPECT_TRUE(eglGetConfigs(display_, configs.data(), count, &count));
  const auto window = native().createWindow({});
  for (EGLConfig each : configs) {
    if (attribute(each, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) continue;
    EXPECT_EQ(eglCreatePlatformWindowSurface(display_, each, window->pointer(), nullptr), EGL_NO_SURFACE);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
    EXPECT_EQ(eglCreateWindowSurface(display_, each, EGLNativeWindowType(window->value()), nullptr),
              EGL_NO_SURFACE);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
}

TEST_P(WindowSurfaces, NoWindow) {
  const EGLConfig config = windowConfig();
  EXPECT_EQ(eglCreateWindowSurface(display_, config, EGLNativeWindowType{}, nullptr), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_NATIVE_WINDOW);
}

// An id that no window has, and one that another connection's window had.
TEST_P(WindowSurfaces, InventedAndStaleWindows) {
  if (onWayland()) GTEST_SKIP() << "a wl_egl_window is its address";
  MESA_DISAGREES("3.5.1", "it crashes");
  const EGLConfig config = windowConfig();
  auto other = NativeDisplay::open(GetParam());
  const std::uintptr_t gone = other->createWindow({})->value();
  other.reset();
  for (std::uintptr_t id : {std::uintptr_t{0x7ffff}, gone}) {
    EXPECT_EQ(eglCreateWindowSurface(display_, config, EGLNativeWindowType(id), nullptr), EGL_NO_SURFACE);
    EXPECT_EGL_ERROR(EGL_BAD_NATIVE_WINDOW);
  }
}

TEST_P(WindowSurfaces, NullPointerToAWindow) {
  if (!onWayland()) MESA_DISAGREES("3.5.1", "it crashes");
  EXPECT_EQ(eglCreatePlatformWindowSurface(display_, windowConfig(), nullptr, nullptr), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_NATIVE_WINDOW);
}

// The window's visual must be the config's, where it has one: a window 24 bits deep holds no alpha.
TEST_P(WindowSurfaces, WindowOfAnotherDepth) {
  if (onWayland()) GTEST_SKIP() << "windows have no format of their own";
  const EGLConfig config = windowConfig();
  for (EGLConfig other : windowConfigs()) {
    const WindowRequest request = fitting(other);
    if (native().visualDepth(request.visual) == native().visualDepth(fitting(config).visual)) continue;
    const auto window = native().createWindow(request);
    const EGLSurface surface = eglCreatePlatformWindowSurface(display_, config, window->pointer(), nullptr);
    if (surface == EGL_NO_SURFACE) {
      EXPECT_EGL_ERROR(EGL_BAD_MATCH);
    } else {
      EXPECT_TRUE(eglDestroySurface(display_, surface));
    }
    return;
  }
}

TEST_P(WindowSurfaces, SecondSurfaceOfAWindow) {
  const EGLConfig config = windowConfig();
  Target& target = open(config);
  EXPECT_EQ(eglCreatePlatformWindowSurface(display_, config, target.native->pointer(), nullptr),
            EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_ALLOC);
  EXPECT_EQ(eglCreateWindowSurface(display_, config, EGLNativeWindowType(target.native->value()), nullptr),
            EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_ALLOC);
  EXPECT_TRUE(eglDestroySurface(display_, target.surface));
  target.surface = eglCreatePlatformWindowSurface(display_, config, target.native->pointer(), nullptr);
  ASSERT_NE(target.surface, EGL_NO_SURFACE);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  EXPECT_TRUE(drawsAndShows(target));
}

// OpenGL ES 2.11.1 and 4.1.2: viewport and scissor box become the first window's that a context is attached
// to.
TEST_P(WindowSurfaces, InitialViewport) {
  Target& target = openCurrent({.width = 50, .height = 30});
  for (GLenum name : {GL_VIEWPORT, GL_SCISSOR_BOX}) {
    GLint box[4] = {};
    glGetIntegerv(name, box);
    EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 50, 30})) << std::hex << name;
  }
  Target& other = open(windowConfig(), {.width = 20, .height = 10, .x = 100});
  ASSERT_TRUE(makeCurrent(other, eglGetCurrentContext()));
  GLint box[4] = {};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], 50);
  EXPECT_TRUE(makeCurrent(target, eglGetCurrentContext()));
}

TEST_P(WindowSurfaces, CommandsOfOtherSurfaces) {
  Target& target = openCurrent();
  EXPECT_FALSE(eglBindTexImage(display_, target.surface, EGL_BACK_BUFFER));
  const EGLint error = eglGetError();
  EXPECT_TRUE(error == EGL_BAD_SURFACE || error == EGL_BAD_MATCH) << egl_conformance::errorName(error);
  EXPECT_TRUE(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_TRUE(eglWaitClient());
  EXPECT_TRUE(eglWaitGL());
  EXPECT_FALSE(eglWaitNative(0x1234));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// 3.10.4
TEST_P(WindowSurfaces, CopyBuffers) {
  if (!onWayland()) MESA_DISAGREES("3.10.4", "a pixmap that is none makes X errors");
  Target& target = openCurrent();
  EXPECT_FALSE(eglCopyBuffers(display_, target.surface, EGLNativePixmapType{}));
  EXPECT_EGL_ERROR(EGL_BAD_NATIVE_PIXMAP);
}

}  // namespace
}  // namespace windows
