#include "scene.h"

#include <GLES/gl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace programs {
namespace {

constexpr int kMark = 6;
using Color = std::array<std::uint8_t, 3>;

struct Mark {
  bool right, top;
  Color color;
};
constexpr std::array kMarks = {Mark{false, false, {255, 0, 0}}, Mark{true, false, {0, 255, 0}},
                               Mark{false, true, {0, 0, 255}}, Mark{true, true, {255, 255, 0}}};

void drawMarks(int width, int height) {
  glEnable(GL_SCISSOR_TEST);
  for (const Mark& mark : kMarks) {
    glScissor(mark.right ? width - kMark : 0, mark.top ? height - kMark : 0, kMark, kMark);
    glClearColor(mark.color[0] / 255.f, mark.color[1] / 255.f, mark.color[2] / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
}

// A cube's side towards +z, turned to all six directions.
void drawCube() {
  static constexpr std::array<GLfloat, 12> kCorners = {-1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
  static constexpr std::array<GLfloat, 8> kCoordinates = {0, 0, 1, 0, 0, 1, 1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, kCorners.data());
  glTexCoordPointer(2, GL_FLOAT, 0, kCoordinates.data());
  glNormal3f(0, 0, 1);
  for (int side = 0; side < 6; ++side) {
    glPushMatrix();
    if (side < 4)
      glRotatef(90.f * static_cast<float>(side), 0, 1, 0);
    else
      glRotatef(side == 4 ? 90.f : -90.f, 1, 0, 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glPopMatrix();
  }
}

}  // namespace

unsigned uploadTexture() {
  constexpr int kSize = 32;
  std::vector<std::uint8_t> texels;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const bool dark = ((x / 8) ^ (y / 8)) & 1;
      for (int value : {dark ? 70 : 250, dark ? 90 + 4 * x : 240, dark ? 200 : 250 - 4 * y})
        texels.push_back(static_cast<std::uint8_t>(value));
    }
  }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, kSize, kSize, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  return texture;
}

void drawScene(int width, int height, float turn, unsigned texture) {
  glViewport(0, 0, width, height);
  glClearColor(0.13f, 0.15f, 0.22f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  const float small = static_cast<float>(std::min(width, height));
  const float x = 0.3f * static_cast<float>(width) / small, y = 0.3f * static_cast<float>(height) / small;
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-x, x, -y, y, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -6.5f);
  glRotatef(25, 1, 0, 0);
  glRotatef(turn, 0, 1, 0);

  static constexpr std::array<GLfloat, 4> kTowards = {0.4f, 0.6f, 1, 0};
  static constexpr std::array<GLfloat, 4> kShine = {0.9f, 0.9f, 0.8f, 1};
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kShine.data());
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
  glPushMatrix();
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, kTowards.data());
  glPopMatrix();
  if (texture != 0) glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, texture);
  drawCube();
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_LIGHTING);
  drawMarks(width, height);
}

bool cornersAreRight(int width, int height) {
  for (const Mark& mark : kMarks) {
    for (int inner : {0, 1}) {
      // The outermost pixel of the mark, and the one diagonally behind it.
      const int in = inner ? kMark : 0;
      const int x = mark.right ? width - 1 - in : in, y = mark.top ? height - 1 - in : in;
      std::array<std::uint8_t, 4> pixel{};
      glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      const bool marked = std::equal(mark.color.begin(), mark.color.end(), pixel.begin());
      if (marked == (inner == 0)) continue;
      std::fprintf(stderr, "the pixel (%d, %d) of %dx%d is %d %d %d\n", x, y, width, height, pixel[0],
                   pixel[1], pixel[2]);
      return false;
    }
  }
  return true;
}

}  // namespace programs
