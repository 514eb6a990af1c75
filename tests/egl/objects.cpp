// The lives of EGL's objects, and what happens when resources run out: what no program can see from outside.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/egl/fake_front_end.h"

namespace anteroom {
namespace {

using fake::world;
using render::Format;

class EglObjects : public testing::Test {
 protected:
  void SetUp() override {
    world() = {};
    for (bool& renderable : world().caps.renderable) renderable = true;
    world().caps.maxSamples = 4;
    initialize();
  }
  void TearDown() override {
    eglReleaseThread();
    eglTerminate(display);
    EXPECT_EQ(world().contexts, 0);
    EXPECT_EQ(world().log.liveImages, 0);
    EXPECT_EQ(world().devices, 0);
  }
  void initialize() {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  }
  std::vector<EGLConfig> choose(std::vector<EGLint> attributes) {
    attributes.insert(attributes.end(), {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE});
    EGLConfig configs[256];
    EGLint count = 0;
    EXPECT_TRUE(eglChooseConfig(display, attributes.data(), configs, 256, &count));
    return std::vector<EGLConfig>(configs, configs + count);
  }
  EGLint get(EGLConfig config, EGLint attribute) {
    EGLint value = -1;
    EXPECT_TRUE(eglGetConfigAttrib(display, config, attribute, &value));
    return value;
  }
  EGLConfig config() { return choose({EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8}).at(0); }
  EGLSurface pbuffer(std::vector<EGLint> attributes = {}) {
    attributes.insert(attributes.end(), {EGL_WIDTH, 64, EGL_HEIGHT, 32, EGL_NONE});
    return eglCreatePbufferSurface(display, config(), attributes.data());
  }
  EGLContext context() { return eglCreateContext(display, config(), EGL_NO_CONTEXT, nullptr); }

  EGLDisplay display = EGL_NO_DISPLAY;
};

TEST_F(EglObjects, NoDeviceIsNotInitialized) {
  ASSERT_TRUE(eglTerminate(display));
  world().noDevice = true;
  testing::internal::CaptureStderr();
  EXPECT_FALSE(eglInitialize(display, nullptr, nullptr));
  EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "anteroom: no fake device, as ordered\n");
}

TEST_F(EglObjects, UnknownRendererIsNamed) {
  ASSERT_TRUE(eglTerminate(display));
  setenv("ANTEROOM_RENDERER", "abacus", 1);
  testing::internal::CaptureStderr();
  EXPECT_FALSE(eglInitialize(display, nullptr, nullptr));
  unsetenv("ANTEROOM_RENDERER");
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_NE(log.find("abacus"), std::string::npos);
  EXPECT_NE(log.find("fake"), std::string::npos);
}

TEST_F(EglObjects, OutOfMemory) {
  const EGLSurface surface = pbuffer();
  const EGLContext current = context();
  world().log.outOfMemory = true;
  EXPECT_EQ(context(), EGL_NO_CONTEXT);
  EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
  EXPECT_FALSE(eglMakeCurrent(display, surface, surface, current));
  EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  world().log.outOfMemory = false;
  EXPECT_TRUE(eglMakeCurrent(display, surface, surface, current));
}

TEST_F(EglObjects, SurfacesHaveNoImagesBeforeTheyAreCurrent) {
  const EGLSurface surface = pbuffer();
  EXPECT_EQ(world().log.liveImages, 0);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(world().log.liveImages, 2);  // color; depth and stencil in one
  const render::Framebuffer& framebuffer = fake::currentFramebuffer();
  EXPECT_EQ(framebuffer.width, 64);
  EXPECT_EQ(framebuffer.height, 32);
  EXPECT_EQ(framebuffer.color.image->desc().format, Format::RGBA8);
  EXPECT_TRUE(framebuffer.color.image->desc().renderable);
  EXPECT_EQ(framebuffer.depth.image, framebuffer.stencil.image);
  EXPECT_EQ(framebuffer.depth.image->desc().format, Format::Depth24Stencil8);
}

TEST_F(EglObjects, DrawAndReadSurfacesMayDiffer) {
  const EGLSurface draw = pbuffer(), read = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(display, draw, read, context()));
  EXPECT_NE(fake::currentFramebuffer().color.image, fake::currentReadFramebuffer().color.image);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), draw);
  EXPECT_EQ(eglGetCurrentSurface(EGL_READ), read);
  ASSERT_TRUE(eglSwapBuffers(display, draw));
  EXPECT_FALSE(eglSwapBuffers(display, read));
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

TEST_F(EglObjects, DestroyedWhileCurrentLivesUntilReleased) {
  const EGLSurface surface = pbuffer();
  const EGLContext current = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, current));
  EXPECT_TRUE(eglDestroyContext(display, current));
  EXPECT_TRUE(eglDestroySurface(display, surface));
  EXPECT_EQ(world().contexts, 1);
  EXPECT_EQ(eglGetCurrentContext(), current);
  EXPECT_FALSE(eglDestroyContext(display, current));
  EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
  EXPECT_FALSE(eglSwapBuffers(display, surface));
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
  EXPECT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EQ(world().contexts, 0);
  EXPECT_EQ(world().log.liveImages, 0);
}

TEST_F(EglObjects, TerminatedWhileCurrentLivesUntilReleased) {
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  ASSERT_TRUE(eglTerminate(display));
  EXPECT_EQ(world().contexts, 1);
  EXPECT_EQ(world().devices, 1);
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  EXPECT_FALSE(eglDestroySurface(display, surface));
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
  EXPECT_EQ(world().devices, 1);  // the old context's is the new display's, too
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_EQ(world().contexts, 0);
  EXPECT_EQ(world().devices, 1);
}

TEST_F(EglObjects, ReleasedContextsHoldNoSurface) {
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_TRUE(eglDestroySurface(display, surface));
  EXPECT_EQ(world().log.liveImages, 0);
  EXPECT_EQ(world().contexts, 1);
}

TEST_F(EglObjects, ThreadsThatEndGiveTheirContextBack) {
  const EGLSurface surface = pbuffer();
  const EGLContext shared = context();
  std::thread([&] { EXPECT_TRUE(eglMakeCurrent(display, surface, surface, shared)); }).join();
  EXPECT_EQ(world().log.flushes, 1);
  EXPECT_TRUE(eglMakeCurrent(display, surface, surface, shared));
}

TEST_F(EglObjects, ContextsAndSurfacesBelongToOneThread) {
  const EGLSurface surface = pbuffer();
  const EGLContext shared = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, shared));
  std::thread([&] {
    EXPECT_FALSE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, shared));
    EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
    EXPECT_FALSE(eglMakeCurrent(display, surface, surface, context()));
    EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  }).join();
}

TEST_F(EglObjects, GarbageHandles) {
  const EGLSurface surface = pbuffer();
  const EGLContext valid = context();
  int local = 0;
  for (void* garbage : {static_cast<void*>(&local), reinterpret_cast<void*>(uintptr_t{1} << 40),
                        reinterpret_cast<void*>(UINTPTR_MAX)}) {
    EXPECT_FALSE(eglInitialize(garbage, nullptr, nullptr));
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_EQ(eglCreatePbufferSurface(display, garbage, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
    EXPECT_FALSE(eglDestroySurface(display, garbage));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_FALSE(eglMakeCurrent(display, surface, surface, garbage));
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    EXPECT_FALSE(eglDestroySync(display, garbage));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
  }
  // Handles of another kind.
  EXPECT_FALSE(eglDestroySurface(display, valid));
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
  EXPECT_FALSE(eglDestroyContext(display, surface));
  EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
}

TEST_F(EglObjects, BoundTexturesAreReleasedWithTheirTexture) {
  const EGLSurface target = pbuffer();
  const EGLSurface texture =
      pbuffer({EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGBA, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
  ASSERT_NE(texture, EGL_NO_SURFACE);
  EXPECT_TRUE(eglBindTexImage(display, texture, EGL_BACK_BUFFER)) << "ignored without a context";
  ASSERT_TRUE(eglMakeCurrent(display, target, target, context()));
  EXPECT_FALSE(eglBindTexImage(display, target, EGL_BACK_BUFFER));
  EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
  EXPECT_TRUE(eglBindTexImage(display, texture, EGL_BACK_BUFFER));
  EXPECT_FALSE(eglBindTexImage(display, texture, EGL_BACK_BUFFER));
  EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
  fake::deleteTexture();
  EXPECT_TRUE(eglBindTexImage(display, texture, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglReleaseTexImage(display, texture, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglReleaseTexImage(display, texture, EGL_BACK_BUFFER)) << "has no effect";
  EXPECT_TRUE(eglBindTexImage(display, texture, EGL_BACK_BUFFER));
  // The color image stays while a texture has it.
  const int images = world().log.liveImages;
  EXPECT_TRUE(eglDestroySurface(display, texture));
  EXPECT_EQ(world().log.liveImages, images - 1);
  fake::deleteTexture();
  EXPECT_EQ(world().log.liveImages, images - 2);
}

TEST_F(EglObjects, MipmapLevelIsRenderedTo) {
  const EGLSurface surface = pbuffer({EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D,
                                      EGL_MIPMAP_TEXTURE, EGL_TRUE});
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EQ(fake::currentFramebuffer().color.image->desc().levels, 7);
  ASSERT_TRUE(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, 2));
  EXPECT_EQ(fake::currentFramebuffer().color.level, 2);
  EXPECT_EQ(fake::currentFramebuffer().width, 16);
  EXPECT_EQ(fake::currentFramebuffer().height, 8);
  EXPECT_EQ(fake::currentFramebuffer().depth.image->desc().width, 16);
  ASSERT_TRUE(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, 100));
  EXPECT_EQ(fake::currentFramebuffer().color.level, 6);
  EXPECT_EQ(fake::currentFramebuffer().height, 1);
}

TEST_F(EglObjects, SyncsOutliveTheirContext) {
  const EGLContext owner = context();
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, owner));
  const EGLSync sync = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
  ASSERT_NE(sync, EGL_NO_SYNC);
  world().log.fencesPass = false;
  EXPECT_EQ(eglClientWaitSync(display, sync, 0, 0), EGL_TIMEOUT_EXPIRED);
  EGLAttrib status = 0;
  EXPECT_TRUE(eglGetSyncAttrib(display, sync, EGL_SYNC_STATUS, &status));
  EXPECT_EQ(status, EGL_UNSIGNALED);
  EXPECT_TRUE(eglDestroyContext(display, owner));
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_EQ(world().contexts, 0);
  EXPECT_EQ(world().log.finishes, 1);
  EXPECT_EQ(eglClientWaitSync(display, sync, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
}

TEST_F(EglObjects, OnlyWhatTheDeviceHasIsOffered) {
  eglTerminate(display);
  for (bool& renderable : world().caps.renderable) renderable = false;
  for (Format format : {Format::RGB565, Format::Depth24Stencil8})
    world().caps.renderable[static_cast<int>(format)] = true;
  world().caps.maxSamples = 1;
  initialize();
  EGLint count = 0;
  ASSERT_TRUE(eglGetConfigs(display, nullptr, 0, &count));
  EXPECT_EQ(count, 6);
  for (EGLConfig each : choose({})) {
    EXPECT_EQ(get(each, EGL_BUFFER_SIZE), 16);
    EXPECT_EQ(get(each, EGL_SAMPLES), 0);
  }
  // A stencil buffer alone is kept in the one format there is, and the depth in it is nobody's.
  const EGLConfig stencil = choose({EGL_STENCIL_SIZE, 8}).at(0);
  EXPECT_EQ(get(stencil, EGL_DEPTH_SIZE), 0);
  const EGLSurface surface = eglCreatePbufferSurface(display, stencil, nullptr);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface,
                             eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr)));
  EXPECT_EQ(fake::currentFramebuffer().depth.image, nullptr);
  EXPECT_EQ(fake::currentFramebuffer().stencil.image->desc().format, Format::Depth24Stencil8);
}

TEST_F(EglObjects, ConfigsAreSortedAsTheSpecificationSays) {
  // Deeper colors first only in components that were asked for.
  EXPECT_EQ(get(choose({EGL_RED_SIZE, 1}).at(0), EGL_BUFFER_SIZE), 24);
  EXPECT_EQ(get(choose({EGL_RED_SIZE, 1, EGL_ALPHA_SIZE, 1}).at(0), EGL_BUFFER_SIZE), 32);
  EXPECT_EQ(get(choose({}).at(0), EGL_BUFFER_SIZE), 16);
  const EGLConfig first = choose({EGL_ALPHA_SIZE, 1}).at(0);
  EXPECT_EQ(get(first, EGL_SAMPLES), 0);
  EXPECT_EQ(get(first, EGL_DEPTH_SIZE), 0);
  EXPECT_EQ(get(first, EGL_STENCIL_SIZE), 0);
  EXPECT_EQ(get(choose({EGL_DEPTH_SIZE, 1}).at(0), EGL_DEPTH_SIZE), 16);
  EXPECT_EQ(choose({EGL_CONFIG_ID, 17, EGL_DEPTH_SIZE, 1000}).size(), 1u);
  EGLint count = -1;
  ASSERT_TRUE(eglChooseConfig(display, nullptr, nullptr, 0, &count));
  EXPECT_EQ(count, 0) << "no windows";
}

}  // namespace
}  // namespace anteroom
