// EGL 1.5 sections 3.5, 3.6 and 3.10: pbuffers, their attributes, binding them to textures, swapping.
#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Surfaces : public EglTest {
 protected:
  EGLint query(EGLSurface surface, EGLint name) const {
    EGLint value = -12345;
    EXPECT_TRUE(eglQuerySurface(display_, surface, name, &value)) << std::hex << name;
    return value;
  }
};

// Table 3.5
TEST_F(Surfaces, PbufferAttributes) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config, {EGL_WIDTH, 20, EGL_HEIGHT, 30});
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_WIDTH), 20);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 30);
  EXPECT_EQ(query(surface, EGL_CONFIG_ID), attribute(config, EGL_CONFIG_ID));
  EXPECT_EQ(query(surface, EGL_LARGEST_PBUFFER), EGL_FALSE);
  EXPECT_EQ(query(surface, EGL_TEXTURE_FORMAT), EGL_NO_TEXTURE);
  EXPECT_EQ(query(surface, EGL_TEXTURE_TARGET), EGL_NO_TEXTURE);
  EXPECT_EQ(query(surface, EGL_MIPMAP_TEXTURE), EGL_FALSE);
  EXPECT_EQ(query(surface, EGL_MIPMAP_LEVEL), 0);
  EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
  EXPECT_EQ(query(surface, EGL_MULTISAMPLE_RESOLVE), EGL_MULTISAMPLE_RESOLVE_DEFAULT);
  EXPECT_EQ(query(surface, EGL_HORIZONTAL_RESOLUTION), EGL_UNKNOWN);
  EXPECT_EQ(query(surface, EGL_VERTICAL_RESOLUTION), EGL_UNKNOWN);
  EXPECT_EQ(query(surface, EGL_PIXEL_ASPECT_RATIO), EGL_UNKNOWN);
  EGLint value = 77;
  EXPECT_FALSE(eglQuerySurface(display_, surface, EGL_RED_SIZE, &value));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(value, 77);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
  EXPECT_FALSE(eglDestroySurface(display_, surface));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglQuerySurface(display_, surface, EGL_WIDTH, &value));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
}

// 3.5.2: the default size is 0 by 0; both are legal.
TEST_F(Surfaces, PbufferOfNoSize) {
  const EGLSurface surface = createPbuffer(choose(), {});
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_WIDTH), 0);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 0);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
}

TEST_F(Surfaces, PbufferErrors) {
  const EGLConfig config = choose();
  const struct {
    std::vector<EGLint> attributes;
    EGLint error;
  } rows[] = {
      {{EGL_WIDTH, -1, EGL_HEIGHT, 4}, EGL_BAD_PARAMETER},
      {{EGL_WIDTH, 4, EGL_HEIGHT, -1}, EGL_BAD_PARAMETER},
      {{EGL_RED_SIZE, 8}, EGL_BAD_ATTRIBUTE},
      {{0x7777, 1}, EGL_BAD_ATTRIBUTE},
      {{EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGBA}, EGL_BAD_MATCH},
      {{EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D}, EGL_BAD_MATCH},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(createPbuffer(config, row.attributes), EGL_NO_SURFACE) << std::hex << row.attributes[0];
    EXPECT_EGL_ERROR(row.error) << std::hex << row.attributes[0];
  }
  int something = 0;
  EXPECT_EQ(createPbuffer(reinterpret_cast<EGLConfig>(&something)), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
  EXPECT_EQ(createPbuffer(nullptr), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
}

// 3.5.2: LARGEST_PBUFFER never exceeds the request, and gives what there is.
TEST_F(Surfaces, LargestPbuffer) {
  const EGLConfig config = choose();
  const EGLint most = attribute(config, EGL_MAX_PBUFFER_WIDTH);
  const EGLSurface surface =
      createPbuffer(config, {EGL_WIDTH, 8, EGL_HEIGHT, 4, EGL_LARGEST_PBUFFER, EGL_TRUE});
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EXPECT_EQ(query(surface, EGL_WIDTH), 8);
  EXPECT_EQ(query(surface, EGL_HEIGHT), 4);
  EXPECT_EQ(query(surface, EGL_LARGEST_PBUFFER), EGL_TRUE);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
  const EGLSurface wide =
      createPbuffer(config, {EGL_WIDTH, most + 1000, EGL_HEIGHT, 1, EGL_LARGEST_PBUFFER, EGL_TRUE});
  if (wide == EGL_NO_SURFACE) {
    EXPECT_EGL_ERROR(EGL_BAD_ALLOC);
    return;
  }
  EXPECT_LE(query(wide, EGL_WIDTH), most + 1000);
  EXPECT_TRUE(eglDestroySurface(display_, wide));
}

// 3.5.6
TEST_F(Surfaces, SurfaceAttributes) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  EXPECT_TRUE(eglSurfaceAttrib(display_, surface, EGL_MIPMAP_LEVEL, 2));
  EXPECT_EQ(query(surface, EGL_MIPMAP_LEVEL), 2);
  EXPECT_TRUE(eglSurfaceAttrib(display_, surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_DEFAULT));
  if (!(attribute(config, EGL_SURFACE_TYPE) & EGL_MULTISAMPLE_RESOLVE_BOX_BIT)) {
    EXPECT_FALSE(eglSurfaceAttrib(display_, surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX));
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
  if (!(attribute(config, EGL_SURFACE_TYPE) & EGL_SWAP_BEHAVIOR_PRESERVED_BIT)) {
    EXPECT_FALSE(eglSurfaceAttrib(display_, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
  EXPECT_FALSE(eglSurfaceAttrib(display_, surface, EGL_WIDTH, 2));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglSurfaceAttrib(display_, EGL_NO_SURFACE, EGL_MIPMAP_LEVEL, 2));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
}

// 3.6: render into a pbuffer, bind it to a texture, draw with it, release it.
TEST_F(Surfaces, BindTexImage) {
  MESA_DISAGREES("3.6.1", "a texture that a pbuffer is bound to has no image");
  const EGLConfig config = choose({EGL_BIND_TO_TEXTURE_RGBA, EGL_TRUE, EGL_ALPHA_SIZE, 8});
  ASSERT_NE(config, nullptr) << "no config with EGL_BIND_TO_TEXTURE_RGBA";
  const EGLSurface target = createPbuffer(config);
  const EGLSurface source = createPbuffer(config, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT,
                                                   EGL_TEXTURE_RGBA, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  const EGLContext context = createContext(config);
  ASSERT_NE(source, EGL_NO_SURFACE);
  EXPECT_EQ(query(source, EGL_TEXTURE_FORMAT), EGL_TEXTURE_RGBA);
  EXPECT_EQ(query(source, EGL_TEXTURE_TARGET), EGL_TEXTURE_2D);
  ASSERT_TRUE(eglMakeCurrent(display_, source, source, context));
  glClearColor(0, 1, 0, 0.4f);
  glClear(GL_COLOR_BUFFER_BIT);
  ASSERT_TRUE(eglMakeCurrent(display_, target, target, context));
  EXPECT_FALSE(eglBindTexImage(display_, target, EGL_BACK_BUFFER));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_FALSE(eglBindTexImage(display_, source, EGL_SINGLE_BUFFER));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglBindTexImage(display_, EGL_NO_SURFACE, EGL_BACK_BUFFER));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_TEXTURE_2D);
  ASSERT_TRUE(eglBindTexImage(display_, source, EGL_BACK_BUFFER));
  EXPECT_FALSE(eglBindTexImage(display_, source, EGL_BACK_BUFFER)) << "bound already";
  EXPECT_EGL_ERROR(EGL_BAD_ACCESS);
  const GLfloat quad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, quad);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  GLubyte pixel[4] = {};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 0);
  EXPECT_EQ(pixel[1], 255);
  EXPECT_EQ(pixel[3], 102);
  EXPECT_TRUE(eglReleaseTexImage(display_, source, EGL_BACK_BUFFER));
  // 3.6.2: the images are null now, as if texturing were disabled.
  glColor4f(0, 0, 1, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[1], 0);
  EXPECT_EQ(pixel[2], 255);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  // The surface can be rendered to again.
  ASSERT_TRUE(eglMakeCurrent(display_, source, source, context));
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 255);
}

// 3.10: swapping a pbuffer has no effect; errors.
TEST_F(Surfaces, SwapBuffers) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config), other = createPbuffer(config);
  const EGLContext context = createContext(config);
  EXPECT_FALSE(eglSwapInterval(display_, 1));
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_TRUE(eglSwapBuffers(display_, surface));
  GLubyte pixel[4] = {};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[1], 255) << "a pbuffer keeps what is in it";
  EXPECT_FALSE(eglSwapBuffers(display_, EGL_NO_SURFACE));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglSwapBuffers(display_, other)) << "not the current draw surface";
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  EXPECT_TRUE(eglWaitClient());
  EXPECT_TRUE(eglWaitGL());
  EXPECT_TRUE(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
}

TEST_F(Surfaces, WaitNativeEngine) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  EXPECT_FALSE(eglWaitNative(0x1234));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// 3.5.1, 3.5.4, 3.5.3, 3.10.2: what a headless implementation has not.
TEST_F(Surfaces, WindowsAndPixmapsOfNobody) {
  MESA_DISAGREES("3.5.1", "windows and pixmaps of the surfaceless platform give other errors, or crash");
  const EGLConfig config = choose();
  EXPECT_EQ(eglCreateWindowSurface(display_, config, EGLNativeWindowType{}, nullptr), EGL_NO_SURFACE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  EXPECT_EQ(eglCreatePixmapSurface(display_, config, EGLNativePixmapType{}, nullptr), EGL_NO_SURFACE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  EXPECT_EQ(eglCreatePlatformWindowSurface(display_, config, nullptr, nullptr), EGL_NO_SURFACE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  EXPECT_EQ(eglCreatePlatformPixmapSurface(display_, config, nullptr, nullptr), EGL_NO_SURFACE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  EXPECT_EQ(eglCreatePbufferFromClientBuffer(display_, EGL_OPENVG_IMAGE, nullptr, config, nullptr),
            EGL_NO_SURFACE);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  EXPECT_FALSE(eglCopyBuffers(display_, surface, EGLNativePixmapType{}));
  EXPECT_EGL_ERROR(EGL_BAD_NATIVE_PIXMAP);
}

}  // namespace
}  // namespace egl_conformance
