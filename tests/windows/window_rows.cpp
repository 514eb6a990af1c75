// Windows may keep their rows in another order than pbuffers do. Whatever depends on y must not show it: each
// row of the table draws the same into both, and the window's screen shows what was read from it.
#include <algorithm>
#include <functional>

#include "window_fixture.h"

namespace windows {
namespace {

constexpr int kWidth = 64, kHeight = 47;

struct Scene {
  const char* name;
  std::function<void()> draw;
  const char* extension = nullptr;
};

void useUnitMatrices() {
  for (GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(mode);
    glLoadIdentity();
  }
}

void drawVertices(GLenum mode, std::vector<GLfloat> vertices) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, vertices.data());
  glDrawArrays(mode, 0, GLsizei(vertices.size() / 2));
  glDisableClientState(GL_VERTEX_ARRAY);
}

// Window coordinates, for the vertices that follow.
void usePixels() {
  useUnitMatrices();
  glMatrixMode(GL_PROJECTION);
  glOrthof(0, kWidth, 0, kHeight, -1, 1);
  glMatrixMode(GL_MODELVIEW);
}

// 8x8 texels, all different.
GLuint makeTexture() {
  std::vector<GLubyte> texels;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      texels.insert(texels.end(), {GLubyte(x * 36), GLubyte(y * 36), GLubyte((x ^ y) * 36), 255});
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glEnable(GL_TEXTURE_2D);
  return texture;
}

void drawTextured(float x, float y, float width, float height) {
  const GLfloat coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
  drawVertices(GL_TRIANGLE_STRIP, {x, y, x + width, y, x, y + height, x + width, y + height});
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void drawViewports() {
  useUnitMatrices();
  const int boxes[][4] = {{3, 5, 20, 10}, {30, 20, 33, 27}, {-8, 30, 16, 30}, {50, -4, 20, 12}};
  for (int i = 0; i < 4; ++i) {
    glViewport(boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
    glColor4f(float(i & 1), float(i >> 1), 0.5f, 1);
    drawVertices(GL_TRIANGLES, {-0.9f, -0.95f, 0.93f, -0.9f, -0.6f, 0.97f});
  }
}

void drawScissored() {
  usePixels();
  glEnable(GL_SCISSOR_TEST);
  const int boxes[][4] = {{2, 3, 30, 7}, {40, 30, 50, 50}, {-5, 20, 15, 9}, {20, 46, 10, 1}, {33, 0, 4, 1}};
  for (int i = 0; i < 5; ++i) {
    glScissor(boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
    glColor4f(0, float(i) / 5, 1, 1);
    drawVertices(GL_TRIANGLE_STRIP, {0, 0, kWidth, 0, 0, kHeight, kWidth, kHeight});
  }
  glScissor(10, 12, 3, 5);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void drawPoints() {
  usePixels();
  for (const auto& [x, y, size] :
       {std::array{5.5f, 7.5f, 1.f}, {20.5f, 10.5f, 5.f}, {40.f, 30.f, 8.f}, {60.f, 44.f, 10.f}}) {
    glPointSize(size);
    glColor4f(x / 64, y / 48, 1, 1);
    drawVertices(GL_POINTS, {x, y});
  }
}

// 3.3: t runs downwards on a point sprite.
void drawSprites() {
  usePixels();
  const GLuint texture = makeTexture();
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glPointSize(16);
  drawVertices(GL_POINTS, {12, 12, 40, 30});
  glDisable(GL_POINT_SPRITE_OES);
  glDeleteTextures(1, &texture);
}

// Ends are no pixel's centre: which of two pixels such an end belongs to is the driver's (3.4.1).
void drawLines() {
  usePixels();
  glColor4f(1, 1, 0, 1);
  drawVertices(GL_LINES, {2.2f, 3.4f, 60.3f, 3.6f, 5.4f, 6.3f, 5.6f, 40.2f, 10.3f, 8.4f, 50.8f, 20.1f});
  glLineWidth(3);
  drawVertices(GL_LINES, {2.2f, 42.4f, 60.3f, 42.6f});
  glLineWidth(1);
}

// 3.4: which side faces the viewer is told from window coordinates; both ways, culled, and lit on two sides.
void drawFaces() {
  usePixels();
  glEnable(GL_CULL_FACE);
  for (int i = 0; i < 4; ++i) {
    glFrontFace(i & 1 ? GL_CW : GL_CCW);
    glCullFace(i & 2 ? GL_FRONT : GL_BACK);
    const float x = float(i) * 15 + 1.3f;
    glColor4f(1, float(i) / 4, 0, 1);
    drawVertices(GL_TRIANGLES, {x, 2.2f, x + 12, 3.2f, x + 2, 20.3f});
    drawVertices(GL_TRIANGLES, {x, 24.2f, x + 2, 44.3f, x + 12, 25.2f});
  }
  glDisable(GL_CULL_FACE);
  glFrontFace(GL_CCW);
  glCullFace(GL_BACK);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const GLfloat toViewer[] = {0, 0, 1, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, toViewer);
  glNormal3f(0, 0, 1);
  drawVertices(GL_TRIANGLES, {20.3f, 20.2f, 50.4f, 22.1f, 30.2f, 28.3f});
  drawVertices(GL_TRIANGLES, {20.3f, 32.2f, 30.2f, 40.3f, 50.4f, 34.1f});
  glDisable(GL_LIGHTING);
}

void drawTexImages() {
  usePixels();
  const auto drawTex = reinterpret_cast<PFNGLDRAWTEXFOESPROC>(eglGetProcAddress("glDrawTexfOES"));
  const GLuint texture = makeTexture();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const GLint crops[][4] = {{0, 0, 8, 8}, {1, 2, 5, 3}, {0, 8, 8, -8}};
  for (int i = 0; i < 3; ++i) {
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crops[i]);
    drawTex(float(2 + 20 * i), float(3 + 12 * i), 0, 16, 16);
  }
  drawTex(50, 40, 0, 16, 16);
  glDeleteTextures(1, &texture);
}

// Copies from the framebuffer, from its middle and from over its edges.
void copyTextures() {
  usePixels();
  drawPicture(kWidth, kHeight);
  drawPoints();
  const GLuint texture = makeTexture();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 6, 32, 16, 0);
  drawTextured(30, 2, 32, 16);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 3, 14, 1, 20, 9);
  drawTextured(2, 25, 32, 16);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE,
               std::vector<GLubyte>(16 * 16 * 3, 99).data());
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, kHeight - 16, 16, 16);
  drawTextured(44, 28, 16, 16);
  glDeleteTextures(1, &texture);
}

// What is read here and there is drawn again at the same place, on black.
void readParts() {
  drawPicture(kWidth, kHeight);
  std::vector<std::pair<int, Image>> parts;
  for (int y : {0, 9, 30, 46}) parts.emplace_back(y, readPixels(y / 2, y, 7, 1));
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const auto& [y, part] : parts)
    for (int x = 0; x < part.width; ++x) draw({y / 2 + x, y, 1, 1, part.at(x, 0)});
}

void drawMaskedStencils() {
  usePixels();
  glClearStencil(0);
  glClear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(5, 7, 30, 11);
  glClearStencil(1);
  glClear(GL_STENCIL_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
  glColor4f(1, 1, 1, 1);
  drawVertices(GL_TRIANGLES, {0.3f, 0.2f, 60.3f, 1.2f, 4.1f, 46.3f});
  drawVertices(GL_TRIANGLE_STRIP, {0, 0, kWidth, 0, 0, kHeight, kWidth, kHeight});
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

void drawClipped() {
  usePixels();
  const GLfloat plane[] = {0.1f, 1, 0, -20.3f};
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glColor4f(0, 1, 1, 1);
  drawVertices(GL_TRIANGLE_STRIP, {3.2f, 2.1f, 60.2f, 4.3f, 2.1f, 40.2f, 58.3f, 44.1f});
  glDisable(GL_CLIP_PLANE0);
}

void blendSmoothColors() {
  usePixels();
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  const GLfloat colors[] = {1, 0, 0, 1, 0, 1, 0, 0.5f, 0, 0, 1, 0.2f, 1, 1, 1, 0.7f};
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_FLOAT, 0, colors);
  drawVertices(GL_TRIANGLE_STRIP, {0, 0, kWidth, 0, 0, kHeight, kWidth, kHeight});
  glDisableClientState(GL_COLOR_ARRAY);
  glDisable(GL_BLEND);
}

void drawLogic() {
  usePixels();
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  glColor4f(1, 0, 1, 1);
  drawVertices(GL_TRIANGLE_STRIP, {5, 9, 50, 9, 5, 33, 50, 33});
  glColor4f(1, 1, 0, 1);
  drawVertices(GL_TRIANGLE_STRIP, {15, 3, 60, 3, 15, 21, 60, 21});
  glDisable(GL_COLOR_LOGIC_OP);
}

// To an object and back, several times: the order of rows changes with every binding.
void switchFramebuffers() {
  const auto gen = reinterpret_cast<PFNGLGENFRAMEBUFFERSOESPROC>(eglGetProcAddress("glGenFramebuffersOES"));
  const auto bind = reinterpret_cast<PFNGLBINDFRAMEBUFFEROESPROC>(eglGetProcAddress("glBindFramebufferOES"));
  const auto erase =
      reinterpret_cast<PFNGLDELETEFRAMEBUFFERSOESPROC>(eglGetProcAddress("glDeleteFramebuffersOES"));
  const auto attach =
      reinterpret_cast<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>(eglGetProcAddress("glFramebufferTexture2DOES"));
  GLuint object = 0;
  const GLuint texture = makeTexture();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gen(1, &object);
  for (int i = 0; i < 3; ++i) {
    bind(GL_FRAMEBUFFER_OES, object);
    attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, 16, 16);
    glDisable(GL_TEXTURE_2D);
    useUnitMatrices();
    drawPicture(16, 16, i);
    glEnable(GL_CULL_FACE);
    glColor4f(0, 0, 0, 1);
    drawVertices(GL_TRIANGLES, {-0.9f, -0.93f, 0.1f, -0.9f, -0.8f, 0.3f});
    bind(GL_FRAMEBUFFER_OES, 0);
    glViewport(0, 0, kWidth, kHeight);
    usePixels();
    drawVertices(GL_TRIANGLES, {1.3f, 30.2f + float(i), 30.2f, 31.4f, 3.2f, 46.1f});
    glDisable(GL_CULL_FACE);
    glEnable(GL_TEXTURE_2D);
    drawTextured(float(20 * i + 3), float(5 * i + 2), 16, 16);
  }
  erase(1, &object);
  glDeleteTextures(1, &texture);
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {
      {"viewports", drawViewports},
      {"scissor boxes", drawScissored},
      {"points", drawPoints},
      {"point sprites", drawSprites, "GL_OES_point_sprite"},
      {"lines", drawLines},
      {"faces", drawFaces},
      {"texture rectangles", drawTexImages, "GL_OES_draw_texture"},
      {"copies to textures", copyTextures},
      {"reads of parts", readParts},
      {"stencils and masks", drawMaskedStencils},
      {"clip planes", drawClipped},
      {"smooth colors", blendSmoothColors},
      {"logic operations", drawLogic},
      {"framebuffer objects", switchFramebuffers, "GL_OES_framebuffer_object"}};
  return all;
}

void drawScene(const Scene& scene) {
  glViewport(0, 0, kWidth, kHeight);
  glDisable(GL_DITHER);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.2f, 0.2f, 0.2f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  scene.draw();
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_SCISSOR_TEST);
}

// Samples do not lie alike above and below a pixel's centre: on edges the color is one between those around.
Image withEdgesOf(const Image& drawn, const Image& expected) {
  Image result = expected;
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint8_t least = 255, most = 0;
        for (int row = std::max(y - 1, 0); row <= std::min(y + 1, expected.height - 1); ++row) {
          for (int column = std::max(x - 1, 0); column <= std::min(x + 1, expected.width - 1); ++column) {
            least = std::min(least, expected.at(column, row)[i]);
            most = std::max(most, expected.at(column, row)[i]);
          }
        }
        result.at(x, y)[i] = std::clamp(drawn.at(x, y)[i], least, most);
      }
    }
  }
  return result;
}

class WindowRows : public WindowTest {};
ON_ALL_PLATFORMS(WindowRows);

TEST_P(WindowRows, AsInPbuffers) {
  for (EGLint samples : {0, 4}) {
    const EGLConfig config = windowConfig({EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8, EGL_SAMPLES, samples});
    if (!config || attribute(config, EGL_SAMPLES) != samples) continue;
    const EGLConfig offScreen = pbufferConfig(config);
    if (!offScreen) continue;
    // On edges Mesa does not read what it shows, the resolved color (OpenGL ES 4.3.1).
    if (samples > 0 && egl_conformance::onMesa()) continue;
    Target& window = open(config, {.width = kWidth, .height = kHeight, .x = samples * 20});
    const EGLSurface pbuffer = createPbuffer(offScreen, {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight});
    const EGLContext here = context(config), there = context(offScreen);
    for (const Scene& scene : scenes()) {
      SCOPED_TRACE(testing::Message() << scene.name << ", " << samples << " samples");
      ASSERT_TRUE(eglMakeCurrent(display_, pbuffer, pbuffer, there));
      if (scene.extension && !glHas(scene.extension)) continue;
      drawScene(scene);
      const Image expected = readPixels(0, 0, kWidth, kHeight);
      EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
      ASSERT_TRUE(makeCurrent(window, here));
      drawScene(scene);
      const Image drawn = readPixels(0, 0, kWidth, kHeight);
      EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
      EXPECT_TRUE(same(drawn, samples > 0 ? withEdgesOf(drawn, expected) : expected, 1));
      EXPECT_TRUE(swap(window));
      EXPECT_TRUE(shows(*window.native, drawn));
    }
    EXPECT_TRUE(eglDestroySurface(display_, pbuffer));
  }
}

// Draws here, reads there, and the other way round.
TEST_P(WindowRows, DrawAndReadOfDifferentKinds) {
  const EGLConfig config = windowConfig(), offScreen = pbufferConfig(config);
  if (!offScreen) GTEST_SKIP() << "no pbuffers that are compatible";
  Target& window = open(config, {.width = kWidth, .height = kHeight});
  const EGLSurface pbuffer = createPbuffer(offScreen, {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight});
  const EGLContext own = context(config);
  ASSERT_TRUE(eglMakeCurrent(display_, window.surface, pbuffer, own));
  drawPicture(kWidth, kHeight, 0);
  ASSERT_TRUE(eglMakeCurrent(display_, pbuffer, window.surface, own));
  drawPicture(kWidth, kHeight, 1);
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, 0)));
  EXPECT_TRUE(same(readPixels(3, 5, 20, 31), picture(kWidth, kHeight, 0).part(3, 5, 20, 31)));
  // A copy of the window's upper half into the pbuffer's lower one.
  usePixels();
  const GLuint texture = makeTexture();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, kHeight - 16, 64, 16, 0);
  glViewport(0, 0, kWidth, kHeight);
  drawTextured(0, 0, 64, 16);
  glDeleteTextures(1, &texture);
  ASSERT_TRUE(eglMakeCurrent(display_, window.surface, pbuffer, own));
  Image expected = picture(kWidth, kHeight, 1);
  const Image upper = picture(kWidth, kHeight, 0).part(0, kHeight - 16, 64, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x) expected.at(x, y) = upper.at(x, y);
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected));
  EXPECT_TRUE(swap(window));
  EXPECT_TRUE(shows(*window.native, picture(kWidth, kHeight, 0)));
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  EXPECT_TRUE(eglDestroySurface(display_, pbuffer));
}

}  // namespace
}  // namespace windows
