// EGL 1.5 section 3.7: contexts, versions, share groups, MakeCurrent.
#include <cstring>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Contexts : public EglTest {
 protected:
  static std::string glVersion() {
    const GLubyte* text = glGetString(GL_VERSION);
    return text ? reinterpret_cast<const char*>(text) : "";
  }
};

// 3.7.1.1
TEST_F(Contexts, Versions) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  for (const std::vector<EGLint>& attributes :
       {std::vector<EGLint>{},
        {EGL_CONTEXT_CLIENT_VERSION, 1},
        {EGL_CONTEXT_MAJOR_VERSION, 1},
        {EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 0},
        {EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 1}}) {
    const EGLContext context = createContext(config, EGL_NO_CONTEXT, attributes);
    ASSERT_NE(context, EGL_NO_CONTEXT) << attributes.size();
    ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
    EXPECT_EQ(glVersion().substr(0, 16), "OpenGL ES-CM 1.1");
    EGLint value = 0;
    EXPECT_TRUE(eglQueryContext(display_, context, EGL_CONTEXT_CLIENT_VERSION, &value));
    EXPECT_EQ(value, 1);
    EXPECT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    EXPECT_TRUE(eglDestroyContext(display_, context));
  }
}

// 3.7.1: versions that are none, and attributes that are none.
TEST_F(Contexts, CreationErrors) {
  const EGLConfig config = choose();
  const struct {
    std::vector<EGLint> attributes;
    EGLint error;
  } rows[] = {
      {{EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 7}, EGL_BAD_MATCH},
      {{EGL_CONTEXT_MAJOR_VERSION, 9}, EGL_BAD_MATCH},
      {{EGL_CONTEXT_MAJOR_VERSION, 0}, EGL_BAD_MATCH},
      {{EGL_CONTEXT_MAJOR_VERSION, -1}, EGL_BAD_MATCH},
      {{EGL_RED_SIZE, 8}, EGL_BAD_ATTRIBUTE},
      {{0x7777, 8}, EGL_BAD_ATTRIBUTE},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(createContext(config, EGL_NO_CONTEXT, row.attributes), EGL_NO_CONTEXT);
    EXPECT_EGL_ERROR(row.error) << std::hex << row.attributes[0] << " " << row.attributes[1];
  }
  int something = 0;
  EXPECT_EQ(createContext(reinterpret_cast<EGLConfig>(&something)), EGL_NO_CONTEXT);
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
  EXPECT_EQ(createContext(config, reinterpret_cast<EGLContext>(&something)), EGL_NO_CONTEXT);
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
}

// 3.7.1.1: a version of ES that is not implemented.
TEST_F(Contexts, OtherVersions) {
  MESA_DISAGREES("3.7.1.1", "ES 2 and 3 are implemented there");
  const EGLConfig config = choose();
  for (EGLint version : {2, 3}) {
    EXPECT_EQ(createContext(config, EGL_NO_CONTEXT, {EGL_CONTEXT_MAJOR_VERSION, version}), EGL_NO_CONTEXT);
    const EGLint error = eglGetError();
    EXPECT_TRUE(error == EGL_BAD_MATCH || error == EGL_BAD_CONFIG) << errorName(error);
  }
}

// 3.7.4
TEST_F(Contexts, Queries) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config), other = createPbuffer(config);
  const EGLContext context = createContext(config);
  EGLint value = 0;
  EXPECT_TRUE(eglQueryContext(display_, context, EGL_CONFIG_ID, &value));
  EXPECT_EQ(value, attribute(config, EGL_CONFIG_ID));
  EXPECT_TRUE(eglQueryContext(display_, context, EGL_CONTEXT_CLIENT_TYPE, &value));
  EXPECT_EQ(value, EGL_OPENGL_ES_API);
  EXPECT_TRUE(eglQueryContext(display_, context, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_NONE);
  EXPECT_FALSE(eglQueryContext(display_, context, EGL_WIDTH, &value));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglQueryContext(display_, EGL_NO_CONTEXT, EGL_CONFIG_ID, &value));
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  EXPECT_EQ(eglGetCurrentDisplay(), EGL_NO_DISPLAY);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, other, context));
  EXPECT_EQ(eglGetCurrentContext(), context);
  EXPECT_EQ(eglGetCurrentDisplay(), display_);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
  EXPECT_EQ(eglGetCurrentSurface(EGL_READ), other);
  EXPECT_EQ(eglGetCurrentSurface(EGL_WIDTH), EGL_NO_SURFACE);
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_TRUE(eglQueryContext(display_, context, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_BACK_BUFFER);
}

// EGL_ANTEROOM_context_counters
TEST_F(Contexts, CountersTellOfTheCurrentContext) {
  constexpr EGLint kDraws = 0x3FE0, kUploadedBytes = 0x3FE3;
  const EGLConfig config = choose();
  const EGLContext context = createContext(config);
  EGLint before = -1, after = -1;
  if (!names(eglQueryString(display_, EGL_EXTENSIONS), "EGL_ANTEROOM_context_counters")) {
    EXPECT_TRUE(onMesa());
    EXPECT_FALSE(eglQueryContext(display_, context, kDraws, &before));
    EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
    return;
  }
  EXPECT_FALSE(eglQueryContext(display_, context, kDraws, &before));
  EXPECT_EGL_ERROR(EGL_BAD_ACCESS);
  EXPECT_FALSE(eglQueryContext(display_, context, kUploadedBytes + 1, &before));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  const EGLSurface surface = createPbuffer(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  for (EGLint counter = kDraws; counter <= kUploadedBytes; ++counter) {
    EXPECT_TRUE(eglQueryContext(display_, context, counter, &before));
    EXPECT_GE(before, 0);
  }
  const GLfloat corners[] = {-1, -1, 1, -1, 0, 1};
  EXPECT_TRUE(eglQueryContext(display_, context, kDraws, &before));
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFinish();
  EXPECT_TRUE(eglQueryContext(display_, context, kDraws, &after));
  EXPECT_EQ(after, before + 1);
}

// 3.7.3
TEST_F(Contexts, MakeCurrentErrors) {
  const EGLConfig config = choose({EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24});
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  int something = 0;
  EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, EGL_NO_CONTEXT));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_FALSE(eglMakeCurrent(display_, surface, EGL_NO_SURFACE, context));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_FALSE(eglMakeCurrent(display_, EGL_NO_SURFACE, surface, context));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, reinterpret_cast<EGLContext>(&something)));
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
  EXPECT_FALSE(eglMakeCurrent(display_, reinterpret_cast<EGLSurface>(&something), surface, context));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglMakeCurrent(EGL_NO_DISPLAY, surface, surface, context));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  // A failed call leaves what was current.
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  EXPECT_FALSE(eglMakeCurrent(display_, surface, EGL_NO_SURFACE, context));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  EXPECT_EQ(eglGetCurrentContext(), context);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
}

// 2.2: a surface of other colour sizes does not fit the context.
TEST_F(Contexts, IncompatibleSurface) {
  MESA_DISAGREES("2.2", "surfaces of other formats may be made current");
  const EGLConfig wide = choose({EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 8});
  const EGLConfig narrow = choose({EGL_BUFFER_SIZE, 16, EGL_ALPHA_SIZE, 0, EGL_RED_SIZE, 0});
  ASSERT_NE(attribute(narrow, EGL_BUFFER_SIZE), attribute(wide, EGL_BUFFER_SIZE));
  const EGLSurface surface = createPbuffer(narrow);
  const EGLContext context = createContext(wide);
  EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, context));
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
}

// 3.7.3: viewport and scissor are set the first time only.
TEST_F(Contexts, InitialViewport) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config, {EGL_WIDTH, 20, EGL_HEIGHT, 30});
  const EGLSurface larger = createPbuffer(config, {EGL_WIDTH, 50, EGL_HEIGHT, 60});
  const EGLContext context = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  GLint box[4] = {};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 20, 30}));
  glGetIntegerv(GL_SCISSOR_BOX, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 20, 30}));
  ASSERT_TRUE(eglMakeCurrent(display_, larger, larger, context));
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 20, 30}));
}

// EGL_KHR_surfaceless_context: state works, and the first viewport is empty.
TEST_F(Contexts, Surfaceless) {
  const EGLContext context = createContext(choose());
  ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
  EXPECT_EQ(eglGetCurrentContext(), context);
  GLint box[4] = {9, 9, 9, 9};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 0, 0}));
  glGetIntegerv(GL_SCISSOR_BOX, box);
  EXPECT_EQ(std::vector<GLint>(box, box + 4), (std::vector<GLint>{0, 0, 0, 0}));
  const auto status =
      reinterpret_cast<PFNGLCHECKFRAMEBUFFERSTATUSOESPROC>(eglGetProcAddress("glCheckFramebufferStatusOES"));
  EXPECT_EQ(status(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_UNDEFINED_OES});
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLubyte texel[4] = {};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// OES_surfaceless_context: what would touch the missing framebuffer is an error of its own, and never a
// crash.
TEST_F(Contexts, SurfacelessDrawing) {
  ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, createContext(choose())));
  const GLfloat triangle[] = {-1, -1, 3, -1, -1, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, triangle);
  GLubyte pixel[4] = {};
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glFinish();
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// EGL_KHR_no_config_context: a context without a config works with surfaces of different ones.
TEST_F(Contexts, NoConfig) {
  const EGLContext context = createContext(EGL_NO_CONFIG_KHR);
  ASSERT_NE(context, EGL_NO_CONTEXT);
  EGLint value = -1;
  EXPECT_TRUE(eglQueryContext(display_, context, EGL_CONFIG_ID, &value));
  EXPECT_EQ(value, 0);
  for (EGLint alpha : {0, 8}) {
    const EGLConfig config = choose({EGL_ALPHA_SIZE, alpha});
    const EGLSurface surface = createPbuffer(config);
    ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    GLubyte pixel[4] = {};
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[1], 255);
  }
}

// 3.7.1, 3.7.2: textures and buffers are shared, state and texture 0 are not; they outlive the context that
// made them.
TEST_F(Contexts, ShareGroup) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext first = createContext(config), second = createContext(config, first);
  const EGLContext third = createContext(config, second), alone = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, first));
  GLuint texture = 0, buffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  const GLubyte green[] = {0, 255, 0, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, green);
  const GLfloat quad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof quad, quad, GL_STATIC_DRAW);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, alone));
  EXPECT_FALSE(glIsTexture(texture));
  EXPECT_FALSE(glIsBuffer(buffer));
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, third));
  EXPECT_TRUE(eglDestroyContext(display_, first));
  EXPECT_TRUE(glIsTexture(texture));
  EXPECT_TRUE(glIsBuffer(buffer));
  GLint bound = -1;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  EXPECT_EQ(bound, 0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glEnable(GL_TEXTURE_2D);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  GLubyte pixel[4] = {};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 0);
  EXPECT_EQ(pixel[1], 255);
  glDeleteTextures(1, &texture);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, second));
  EXPECT_FALSE(glIsTexture(texture));
  EXPECT_TRUE(eglDestroyContext(display_, second));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// 3.7.2: a current context is destroyed when it is released; its handle is invalid at once.
TEST_F(Contexts, DestroyWhileCurrent) {
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context));
  EXPECT_TRUE(eglDestroyContext(display_, context));
  EXPECT_TRUE(eglDestroySurface(display_, surface));
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glFinish();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_FALSE(eglMakeCurrent(display_, surface, surface, context));
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
}

// 3.7.3: draws go to `draw`, reads come from `read`; contents stay with the surfaces.
TEST_F(Contexts, SeparateReadSurface) {
  const EGLConfig config = choose();
  const EGLSurface a = createPbuffer(config), b = createPbuffer(config);
  const EGLContext context = createContext(config);
  GLubyte pixel[4] = {};
  ASSERT_TRUE(eglMakeCurrent(display_, b, b, context));
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ASSERT_TRUE(eglMakeCurrent(display_, a, b, context));
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[2], 255);
  EXPECT_EQ(pixel[0], 0);
  ASSERT_TRUE(eglMakeCurrent(display_, a, a, context));
  glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 255);
}

// Calls without a current context do nothing and do not crash.
TEST_F(Contexts, GlWithoutAContext) {
  ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  GLint value = 0;
  GLfloat values[16] = {};
  const GLfloat triangle[] = {-1, -1, 3, -1, -1, 3};
  GLubyte pixel[4] = {};
  glEnable(GL_LIGHTING);
  glGetIntegerv(GL_MAX_LIGHTS, &value);
  glGetFloatv(GL_MODELVIEW_MATRIX, values);
  glGetString(GL_VERSION);
  glVertexPointer(2, GL_FLOAT, 0, triangle);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  glLoadIdentity();
  glPushMatrix();
  glFlush();
  glFinish();
  EXPECT_FALSE(glIsEnabled(GL_LIGHTING));
  EXPECT_FALSE(glIsTexture(1));
}

// Creating and destroying in turn leaks nothing that would stop it (run under a leak checker as well).
TEST_F(Contexts, ManyTimes) {
  const EGLConfig config = choose();
  for (int i = 0; i < 50; ++i) {
    const EGLSurface surface = createPbuffer(config);
    const EGLContext context = createContext(config);
    ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, context)) << i;
    glClear(GL_COLOR_BUFFER_BIT);
    GLubyte pixel[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    ASSERT_TRUE(eglDestroyContext(display_, context));
    ASSERT_TRUE(eglDestroySurface(display_, surface));
  }
}

// 3.7.1.5, 3.7.1.6 and EGL_EXT_create_context_robustness, by the names of each.
TEST_F(Contexts, Robust) {
  EXPECT_TRUE(names(eglQueryString(display_, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness"));
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  for (const bool core : {true, false}) {
    const EGLint access = core ? EGL_CONTEXT_OPENGL_ROBUST_ACCESS : EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT;
    const EGLint strategy = core ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY
                                 : EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT;
    const EGLContext plain = createContext(config);
    const EGLContext robust =
        createContext(config, EGL_NO_CONTEXT, {access, EGL_TRUE, strategy, EGL_LOSE_CONTEXT_ON_RESET_EXT});
    ASSERT_NE(robust, EGL_NO_CONTEXT) << core;
    if (!onMesa()) {
      ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, robust));
      GLint value = 0;
      glGetIntegerv(GL_CONTEXT_ROBUST_ACCESS_EXT, &value);
      EXPECT_EQ(value, GL_TRUE);
      glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &value);
      EXPECT_EQ(value, GL_LOSE_CONTEXT_ON_RESET_EXT);
      ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, plain));
      glGetIntegerv(GL_CONTEXT_ROBUST_ACCESS_EXT, &value);
      EXPECT_EQ(value, GL_FALSE);
      glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &value);
      EXPECT_EQ(value, GL_NO_RESET_NOTIFICATION_EXT);
      EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    // Contexts that share have the same strategy.
    EXPECT_EQ(createContext(config, plain, {strategy, EGL_LOSE_CONTEXT_ON_RESET_EXT}), EGL_NO_CONTEXT);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
    EXPECT_EQ(createContext(config, robust), EGL_NO_CONTEXT);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
    EXPECT_EQ(createContext(config, EGL_NO_CONTEXT, {strategy, 7}), EGL_NO_CONTEXT);
    EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
    // EGL_KHR_create_context_no_error: checks cannot be asked for and renounced at once.
    EXPECT_EQ(
        createContext(config, EGL_NO_CONTEXT, {access, EGL_TRUE, EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE}),
        EGL_NO_CONTEXT);
    EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  }
}

// EGL_KHR_create_context_no_error
TEST_F(Contexts, NoError) {
  MESA_DISAGREES("2.5", "ES 1.1 contexts have errors all the same");
  constexpr GLenum kContextFlags = 0x821E;
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext quiet = createContext(config, EGL_NO_CONTEXT, {EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE});
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, quiet));
  GLint flags = 0;
  glGetIntegerv(kContextFlags, &flags);
  EXPECT_EQ(flags, 8);
  glEnable(GL_TEXTURE);
  glMatrixMode(0);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(createContext(config, quiet), EGL_NO_CONTEXT);
  EXPECT_EGL_ERROR(EGL_BAD_MATCH);
  ASSERT_TRUE(eglMakeCurrent(display_, surface, surface, createContext(config)));
  glGetIntegerv(kContextFlags, &flags);
  EXPECT_EQ(flags, 0);
  glEnable(GL_TEXTURE);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
}

}  // namespace
}  // namespace egl_conformance
