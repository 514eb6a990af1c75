// EGL 1.5 section 3.9, EGL_KHR_image_base and EGL_KHR_gl_image: what images can be made of, and the errors.
#include <cstdint>
#include <thread>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

EGLClientBuffer bufferOf(std::uintptr_t name) {
  return reinterpret_cast<EGLClientBuffer>(name);
}

class Images : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    const EGLConfig config = choose();
    surface_ = createPbuffer(config);
    context_ = createContext(config);
    ASSERT_TRUE(eglMakeCurrent(display_, surface_, surface_, context_));
  }
  EGLImage create(EGLenum target, GLuint name, std::vector<EGLAttrib> attributes = {}) const {
    attributes.push_back(EGL_NONE);
    return eglCreateImage(display_, context_, target, bufferOf(name), attributes.data());
  }
  static GLuint newTexture(GLenum target = GL_TEXTURE_2D) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    return name;
  }
  static void specify(GLint level, GLsizei size, GLenum target = GL_TEXTURE_2D, GLenum format = GL_RGBA) {
    const std::vector<GLubyte> texels(static_cast<size_t>(size * size) * 4, 255);
    glTexImage2D(target, level, static_cast<GLint>(format), size, size, 0, format, GL_UNSIGNED_BYTE,
                 texels.data());
  }
  void expectRefused(EGLImage image, EGLint error) const {
    EXPECT_EQ(image, EGL_NO_IMAGE);
    EXPECT_EGL_ERROR(error);
    if (image != EGL_NO_IMAGE) eglDestroyImage(display_, image);
  }

  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

TEST_F(Images, OfATexture) {
  const GLuint name = newTexture();
  specify(0, 2);
  const EGLImage image = create(EGL_GL_TEXTURE_2D, name);
  ASSERT_NE(image, EGL_NO_IMAGE);
  EXPECT_TRUE(eglDestroyImage(display_, image));
  EXPECT_FALSE(eglDestroyImage(display_, image));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglDestroyImage(display_, EGL_NO_IMAGE));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

TEST_F(Images, Extensions) {
  const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
  for (const char* name : {"EGL_KHR_image_base", "EGL_KHR_gl_texture_2D_image",
                           "EGL_KHR_gl_texture_cubemap_image", "EGL_KHR_gl_renderbuffer_image"}) {
    EXPECT_TRUE(names(extensions, name)) << name;
  }
  // There are no native pixmaps, of which EGL_KHR_image makes images, too.
  EXPECT_FALSE(names(extensions, "EGL_KHR_image"));
  EXPECT_FALSE(names(extensions, "EGL_KHR_image_pixmap"));
  const auto createKhr = reinterpret_cast<PFNEGLCREATEIMAGEKHRPROC>(eglGetProcAddress("eglCreateImageKHR"));
  const auto destroyKhr =
      reinterpret_cast<PFNEGLDESTROYIMAGEKHRPROC>(eglGetProcAddress("eglDestroyImageKHR"));
  ASSERT_TRUE(createKhr && destroyKhr);
  const GLuint name = newTexture();
  specify(0, 2);
  const EGLint attributes[] = {EGL_IMAGE_PRESERVED_KHR, EGL_TRUE, EGL_GL_TEXTURE_LEVEL_KHR, 0, EGL_NONE};
  const EGLImageKHR image = createKhr(display_, context_, EGL_GL_TEXTURE_2D_KHR, bufferOf(name), attributes);
  EXPECT_NE(image, EGL_NO_IMAGE_KHR);
  EXPECT_TRUE(destroyKhr(display_, image));
  EXPECT_EQ(createKhr(display_, EGL_NO_CONTEXT, EGL_NATIVE_PIXMAP_KHR, bufferOf(1), nullptr),
            EGL_NO_IMAGE_KHR);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

TEST_F(Images, DisplaysAndContexts) {
  const GLuint name = newTexture();
  specify(0, 2);
  const EGLClientBuffer buffer = bufferOf(name);
  expectRefused(eglCreateImage(EGL_NO_DISPLAY, context_, EGL_GL_TEXTURE_2D, buffer, nullptr),
                EGL_BAD_DISPLAY);
  expectRefused(eglCreateImage(display_, EGL_NO_CONTEXT, EGL_GL_TEXTURE_2D, buffer, nullptr),
                EGL_BAD_CONTEXT);
  if (!onMesa())
    expectRefused(eglCreateImage(display_, surface_, EGL_GL_TEXTURE_2D, buffer, nullptr), EGL_BAD_CONTEXT);
  expectRefused(create(0x1234, name), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_NATIVE_PIXMAP_KHR, name), EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglDestroyImage(EGL_NO_DISPLAY, EGL_NO_IMAGE));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  if (onMesa()) return;  // the next call ends the program there
  // The context need not be current.
  ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  const EGLImage image = create(EGL_GL_TEXTURE_2D, name);
  EXPECT_NE(image, EGL_NO_IMAGE);
  EXPECT_TRUE(eglDestroyImage(display_, image));
}

TEST_F(Images, Attributes) {
  const GLuint name = newTexture();
  specify(0, 2);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_WIDTH, 2}), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_ZOFFSET, 0}), EGL_BAD_MATCH);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_IMAGE_PRESERVED, 7}), EGL_BAD_PARAMETER);
  for (const EGLAttrib preserved : {EGL_TRUE, EGL_FALSE}) {
    const EGLImage image = create(EGL_GL_TEXTURE_2D, name, {EGL_IMAGE_PRESERVED, preserved});
    EXPECT_NE(image, EGL_NO_IMAGE);
    EXPECT_TRUE(eglDestroyImage(display_, image));
  }
}

TEST_F(Images, TexturesThatAreNoSources) {
  expectRefused(create(EGL_GL_TEXTURE_2D, 0), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_GL_TEXTURE_2D, 12345), EGL_BAD_PARAMETER);
  expectRefused(eglCreateImage(display_, context_, EGL_GL_TEXTURE_2D, bufferOf(~std::uintptr_t{0}), nullptr),
                EGL_BAD_PARAMETER);
  const GLuint cube = newTexture(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 5; ++face) specify(0, 2, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  expectRefused(create(EGL_GL_TEXTURE_2D, cube), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X, cube), EGL_BAD_PARAMETER);  // no sixth face
  const GLuint flat = newTexture();
  expectRefused(create(EGL_GL_TEXTURE_2D, flat), EGL_BAD_PARAMETER);  // no level 0
  specify(1, 2);
  expectRefused(create(EGL_GL_TEXTURE_2D, flat), EGL_BAD_PARAMETER);
  specify(0, 8);
  expectRefused(create(EGL_GL_TEXTURE_2D, flat), EGL_BAD_PARAMETER);  // levels that do not fit together
  expectRefused(create(EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X, flat), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_GL_RENDERBUFFER, flat), EGL_BAD_PARAMETER);
  expectRefused(create(EGL_GL_TEXTURE_3D, flat), EGL_BAD_PARAMETER);
}

TEST_F(Images, Levels) {
  const GLuint name = newTexture();
  specify(0, 4);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, 1}), EGL_BAD_PARAMETER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, 1}), EGL_BAD_MATCH);
  specify(1, 2);
  specify(2, 1);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, 3}), EGL_BAD_MATCH);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, -1}), EGL_BAD_MATCH);
  expectRefused(create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, 1 << 20}), EGL_BAD_MATCH);
  EGLImage images[3];
  for (int level = 0; level < 3; ++level) {
    images[level] = create(EGL_GL_TEXTURE_2D, name, {EGL_GL_TEXTURE_LEVEL, level});
    EXPECT_NE(images[level], EGL_NO_IMAGE) << level;
  }
  for (const EGLImage image : images) EXPECT_TRUE(eglDestroyImage(display_, image));
}

// A sibling is no source, as long as it has siblings.
TEST_F(Images, SiblingsAreNoSources) {
  MESA_DISAGREES("3.9", "siblings are accepted");
  const auto setTarget = reinterpret_cast<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>(
      eglGetProcAddress("glEGLImageTargetTexture2DOES"));
  const GLuint source = newTexture();
  specify(0, 2);
  const EGLImage image = create(EGL_GL_TEXTURE_2D, source);
  ASSERT_NE(image, EGL_NO_IMAGE);
  expectRefused(create(EGL_GL_TEXTURE_2D, source), EGL_BAD_ACCESS);
  const GLuint target = newTexture();
  setTarget(GL_TEXTURE_2D, image);
  expectRefused(create(EGL_GL_TEXTURE_2D, target), EGL_BAD_ACCESS);
  EXPECT_TRUE(eglDestroyImage(display_, image));
  expectRefused(create(EGL_GL_TEXTURE_2D, source), EGL_BAD_ACCESS);
  // Respecified, it is none any more; and then the other one has lost its last one.
  glBindTexture(GL_TEXTURE_2D, source);
  specify(0, 4);
  for (const GLuint name : {source, target}) {
    const EGLImage next = create(EGL_GL_TEXTURE_2D, name);
    EXPECT_NE(next, EGL_NO_IMAGE);
    EXPECT_TRUE(eglDestroyImage(display_, next));
  }
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Images, BoundPbuffersAreNoSources) {
  const EGLConfig config = choose({EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_BIND_TO_TEXTURE_RGBA, EGL_TRUE});
  if (config == nullptr) GTEST_SKIP() << "no pbuffers that can be bound to textures";
  const EGLSurface pbuffer = createPbuffer(config, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT,
                                                    EGL_TEXTURE_RGBA, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  const GLuint name = newTexture();
  ASSERT_TRUE(eglBindTexImage(display_, pbuffer, EGL_BACK_BUFFER));
  expectRefused(create(EGL_GL_TEXTURE_2D, name), EGL_BAD_ACCESS);
  EXPECT_TRUE(eglReleaseTexImage(display_, pbuffer, EGL_BACK_BUFFER));
}

TEST_F(Images, Renderbuffers) {
  const auto gen = reinterpret_cast<PFNGLGENRENDERBUFFERSOESPROC>(eglGetProcAddress("glGenRenderbuffersOES"));
  const auto bind =
      reinterpret_cast<PFNGLBINDRENDERBUFFEROESPROC>(eglGetProcAddress("glBindRenderbufferOES"));
  const auto storage =
      reinterpret_cast<PFNGLRENDERBUFFERSTORAGEOESPROC>(eglGetProcAddress("glRenderbufferStorageOES"));
  GLuint name = 0;
  gen(1, &name);
  expectRefused(create(EGL_GL_RENDERBUFFER, name), EGL_BAD_PARAMETER);
  bind(GL_RENDERBUFFER_OES, name);
  if (!onMesa()) expectRefused(create(EGL_GL_RENDERBUFFER, name), EGL_BAD_PARAMETER);  // no storage
  storage(GL_RENDERBUFFER_OES, GL_RGBA8_OES, 4, 4);
  expectRefused(create(EGL_GL_RENDERBUFFER, 0), EGL_BAD_PARAMETER);
  const EGLImage image = create(EGL_GL_RENDERBUFFER, name);
  ASSERT_NE(image, EGL_NO_IMAGE);
  if (!onMesa()) expectRefused(create(EGL_GL_RENDERBUFFER, name), EGL_BAD_ACCESS);
  EXPECT_TRUE(eglDestroyImage(display_, image));
}

// An image is its display's: nothing else finds it, and with the display it goes.
TEST_F(Images, GoWithTheirDisplay) {
  MESA_DISAGREES("3.2", "a display on a device is another one");
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto setTarget = reinterpret_cast<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>(
      eglGetProcAddress("glEGLImageTargetTexture2DOES"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(queryDevices(1, &device, &count));
  const EGLDisplay other = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  ASSERT_TRUE(eglInitialize(other, nullptr, nullptr));
  const GLuint name = newTexture();
  specify(0, 2);
  const EGLImage image = create(EGL_GL_TEXTURE_2D, name);
  EXPECT_FALSE(eglDestroyImage(other, image));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  const EGLContext foreign = eglCreateContext(other, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
  ASSERT_TRUE(eglMakeCurrent(other, EGL_NO_SURFACE, EGL_NO_SURFACE, foreign));
  setTarget(GL_TEXTURE_2D, image);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
  ASSERT_TRUE(eglMakeCurrent(other, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_TRUE(eglTerminate(other));
  EXPECT_TRUE(eglDestroyImage(display_, image));
}

// A context that another thread has, and that shares with no other, is that thread's alone.
TEST_F(Images, ContextsOfOtherThreads) {
  MESA_DISAGREES("3.9", "nothing keeps the threads apart");
  const GLuint name = newTexture();
  specify(0, 2);
  glFinish();
  std::thread([&] {
    expectRefused(create(EGL_GL_TEXTURE_2D, name), EGL_BAD_ACCESS);
    const EGLContext sharing = createContext(choose(), context_);
    const EGLImage image = create(EGL_GL_TEXTURE_2D, name);
    EXPECT_NE(image, EGL_NO_IMAGE);
    EXPECT_TRUE(eglDestroyImage(display_, image));
    EXPECT_TRUE(eglDestroyContext(display_, sharing));
    eglReleaseThread();
  }).join();
}

}  // namespace
}  // namespace egl_conformance
