// OES_draw_texture: the rectangle, its texels and depth, and what of the state it leaves alone.
#include <fmt/format.h>

#include "extension_commands.h"

namespace conformance {
namespace {

class DrawTexture : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_OES_draw_texture");
    draw = command<PFNGLDRAWTEXFOESPROC>("glDrawTexfOES");
    ASSERT_NE(draw, nullptr);
  }
  PFNGLDRAWTEXFOESPROC draw = nullptr;
};

constexpr Vec4 kBlack = {0, 0, 0, 0};

// Every texel of the 8 x 8 texture is of another color.
std::array<std::uint8_t, 4> texel(int x, int y) {
  return {static_cast<std::uint8_t>(x * 32), static_cast<std::uint8_t>(y * 32), 128, 255};
}
Vec4 color(int x, int y) {
  return {x * 32 / 255.0, y * 32 / 255.0, 128 / 255.0, 1};
}

void useTexture(GLint x, GLint y, GLint width, GLint height) {
  std::vector<std::array<std::uint8_t, 4>> texels;
  for (int i = 0; i < 64; ++i) texels.push_back(texel(i % 8, i / 8));
  glEnable(GL_TEXTURE_2D);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLint crop[] = {x, y, width, height};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crop);
  glColor4f(1, 1, 1, 1);
}

// Texels and pixels one to one, upright, mirrored in x, in y.
TEST_F(DrawTexture, CropRectangles) {
  const struct {
    int x, y, width, height;
  } crops[] = {{0, 0, 8, 8}, {2, 1, 5, 6}, {8, 0, -8, 8}, {0, 8, 8, -8}, {7, 6, -3, -4}};
  for (const auto& crop : crops) {
    glClear(GL_COLOR_BUFFER_BIT);
    useTexture(crop.x, crop.y, crop.width, crop.height);
    const int w = std::abs(crop.width), h = std::abs(crop.height);
    draw(20, 30, 0, static_cast<GLfloat>(w), static_cast<GLfloat>(h));
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        const int i = x - 20, j = y - 30;
        const bool inside = i >= 0 && i < w && j >= 0 && j < h;
        const int u = crop.width > 0 ? crop.x + i : crop.x - 1 - i;
        const int v = crop.height > 0 ? crop.y + j : crop.y - 1 - j;
        wrong += !near(image.at(x, y), inside ? color(u, v) : kBlack);
      }
    }
    EXPECT_EQ(wrong, 0) << crop.x << " " << crop.y << " " << crop.width << " " << crop.height;
  }
}

// Four pixels a texel; every form of the command.
TEST_F(DrawTexture, ScaledInEveryForm) {
  useTexture(0, 0, 8, 8);
  COMMAND(PFNGLDRAWTEXIOESPROC, DrawTexiOES);
  COMMAND(PFNGLDRAWTEXSOESPROC, DrawTexsOES);
  COMMAND(PFNGLDRAWTEXXOESPROC, DrawTexxOES);
  COMMAND(PFNGLDRAWTEXIVOESPROC, DrawTexivOES);
  COMMAND(PFNGLDRAWTEXSVOESPROC, DrawTexsvOES);
  COMMAND(PFNGLDRAWTEXXVOESPROC, DrawTexxvOES);
  COMMAND(PFNGLDRAWTEXFVOESPROC, DrawTexfvOES);
  for (int form = 0; form < 8; ++form) {
    glClear(GL_COLOR_BUFFER_BIT);
    const GLint i[] = {8, 16, 0, 32, 16};
    const GLshort s[] = {8, 16, 0, 32, 16};
    const GLfloat f[] = {8, 16, 0, 32, 16};
    const GLfixed x[] = {8 << 16, 16 << 16, 0, 32 << 16, 16 << 16};
    if (form == 0) draw(8, 16, 0, 32, 16);
    if (form == 1) DrawTexiOES(8, 16, 0, 32, 16);
    if (form == 2) DrawTexsOES(8, 16, 0, 32, 16);
    if (form == 3) DrawTexxOES(x[0], x[1], x[2], x[3], x[4]);
    if (form == 4) DrawTexivOES(i);
    if (form == 5) DrawTexsvOES(s);
    if (form == 6) DrawTexxvOES(x);
    if (form == 7) DrawTexfvOES(f);
    for (const auto& [u, v] : {std::pair{0, 0}, {7, 0}, {0, 7}, {7, 7}, {3, 5}}) {
      EXPECT_PIXEL(8 + u * 4 + 2, 16 + v * 2 + 1, color(u, v)) << form << " " << u << " " << v;
    }
    EXPECT_PIXEL(7, 20, kBlack);
    EXPECT_PIXEL(40, 20, kBlack);
    EXPECT_PIXEL(20, 15, kBlack);
    EXPECT_PIXEL(20, 32, kBlack);
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Matrices, viewport, lighting, clip planes, culling and arrays have no say, and stay as they are.
TEST_F(DrawTexture, StateThatDoesNotMatter) {
  MESA_DISAGREES("OES_draw_texture", "with culling and a clip plane nothing is drawn");
  useTexture(0, 0, 8, 8);
  glViewport(40, 40, 10, 10);
  for (const GLenum mode : {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(mode);
    glScalef(3, 0.25f, 1);
    glRotatef(30, 0, 0, 1);
  }
  glEnable(GL_LIGHTING);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);
  const GLfloat plane[] = {0, 0, 0, -1};
  glEnable(GL_CLIP_PLANE0);
  glClipPlanef(GL_CLIP_PLANE0, plane);
  const GLubyte black[16] = {};
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, black);
  draw(0, 0, 0, 64, 64);
  EXPECT_PIXEL(4, 4, color(0, 0));
  EXPECT_PIXEL(60, 4, color(7, 0));
  EXPECT_PIXEL(4, 60, color(0, 7));
  EXPECT_TRUE(glIsEnabled(GL_LIGHTING));
  EXPECT_TRUE(glIsEnabled(GL_COLOR_ARRAY));
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(viewport[0], 40);
  EXPECT_EQ(viewport[2], 10);

  // What the state means for other draws is unchanged: the viewport, and white unlit vertices.
  glDisable(GL_LIGHTING);
  glDisable(GL_CLIP_PLANE0);
  glDisable(GL_CULL_FACE);
  glDisable(GL_TEXTURE_2D);
  glDisableClientState(GL_COLOR_ARRAY);
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(mode);
    glLoadIdentity();
  }
  glClear(GL_COLOR_BUFFER_BIT);
  drawRect();
  EXPECT_PIXEL(45, 45, {1, 1, 1, 1});
  EXPECT_PIXEL(39, 45, kBlack);
}

// Depth by the depth range, clamped; fog at distance 0; the current color; the other fragment operations.
TEST_F(DrawTexture, DepthFogAndColor) {
  MESA_DISAGREES("5.7 of OES_draw_texture", "without a texture the rectangle is white at any depth");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthRangef(0.2f, 0.8f);
  const struct {
    GLfloat z;
    double depth;
  } rows[] = {{-1, 0.2}, {0, 0.2}, {0.5f, 0.5}, {1, 0.8}, {7, 0.8}};
  glColor4f(1, 0.5f, 0, 1);
  glEnable(GL_FOG);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 0.1f);
  for (const auto& row : rows) {
    for (const double margin : {-0.01, 0.01}) {
      glClearDepthf(static_cast<GLfloat>(row.depth + margin));
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      draw(10, 10, row.z, 20, 20);
      EXPECT_PIXEL(20, 20, margin > 0 ? Vec4{1, 128 / 255.0, 0, 1} : kBlack) << row.z << " " << margin;
    }
  }
}

TEST_F(DrawTexture, TwoUnitsHaveRectanglesOfTheirOwn) {
  MESA_DISAGREES("OES_draw_texture", "the second unit adds nothing");
  useTexture(0, 0, 8, 8);
  glActiveTexture(GL_TEXTURE1);
  useTexture(8, 0, -8, 8);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  draw(0, 0, 0, 8, 8);
  for (int x = 0; x < 8; ++x) {
    EXPECT_PIXEL(x, 2, clamp01({(x + 7 - x) * 32 / 255.0, 4 * 32 / 255.0, 1, 1})) << x;
  }
}

TEST_F(DrawTexture, Errors) {
  useTexture(0, 0, 8, 8);
  for (const auto& [w, h] : {std::pair{0.0f, 8.0f}, {8.0f, 0.0f}, {-1.0f, 8.0f}, {8.0f, -8.0f}}) {
    draw(0, 0, 0, w, h);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
  EXPECT_PIXEL(4, 4, kBlack);
}

}  // namespace
}  // namespace conformance
