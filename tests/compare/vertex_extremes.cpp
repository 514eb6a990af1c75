// Stiff and extreme: vertices, sizes and values that are no numbers (2.1.1, 2.3, 2.8, 2.11).
#include <cmath>
#include <functional>
#include <limits>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// One triangle with a value that is no number, then, in the same draw, triangles that cover everything: what
// is undefined (2.1.1) is the first one's alone.
void poisoned(std::vector<GLfloat> Mesh::*attribute, std::size_t component, float value) {
  light({1, 2, 3, 0}, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 8);
  glEnable(GL_COLOR_MATERIAL);
  texture(8, 8, noise);
  Mesh mesh = plane(4);
  for (std::size_t i = 0; i < mesh.texCoords.size(); i += 2)
    mesh.colors.insert(mesh.colors.end(), {mesh.texCoords[i], mesh.texCoords[i + 1], 0.5f, 1});
  const auto extra = static_cast<GLushort>(mesh.positions.size() / 3);
  const auto repeat = [](std::vector<GLfloat>& values, std::size_t size) {
    for (std::size_t i = 0; i < 3 * size; ++i) values.push_back(values[i]);
  };
  repeat(mesh.positions, 3);
  repeat(mesh.normals, 3);
  repeat(mesh.texCoords, 2);
  repeat(mesh.colors, 4);
  mesh.positions[mesh.positions.size() - 2] = 0.5f;
  std::vector<GLfloat>& values = mesh.*attribute;
  values[values.size() - 1 - component] = value;
  const GLushort first[] = {extra, static_cast<GLushort>(extra + 1), static_cast<GLushort>(extra + 2)};
  mesh.indices.insert(mesh.indices.begin(), first, first + 3);
  mesh.draw();
}

// State that is no number, a draw with it, then the state set right again and a draw that covers everything.
template <class Poison, class Heal>
void poisonedState(Poison poison, Heal heal) {
  light({1, 2, 3, 0}, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 8);
  poison();
  plane(2).draw();
  heal();
  plane(4).draw();
}

template <class Value>
void integers(GLenum type, Value least, Value most) {
  const Value corners[] = {least, least, most, least, most, most, least, least, most, most, least, most};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, type, 0, corners);
  const auto scale = static_cast<GLfloat>(1.5 / (static_cast<double>(most) - static_cast<double>(least)));
  glScalef(scale, scale, 1);
  glRotatef(10, 0, 0, 1);
  glColor4f(0.3f, 0.9f, 0.5f, 1);
  glDrawArrays(GL_TRIANGLES, 0, 6);
}

void fixedEnds() {
  glScalef(65536, 65536, 1);
  integers<GLfixed>(GL_FIXED, std::numeric_limits<GLfixed>::min(), std::numeric_limits<GLfixed>::max());
}

// One unit in the last place, 2^-16, enlarged to half the picture.
void fixedUnit() {
  const GLfixed corners[] = {-1, -1, 1, -1, 0, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FIXED, 0, corners);
  glScalef(32768, 32768, 1);
  glColor4x(1, 65536, 32768, 65535);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void denormalPositions() {
  projection();
  glScalef(1e38f, 1e38f, 1);
  glMatrixMode(GL_MODELVIEW);
  glColor4f(0.3f, 0.9f, 0.5f, 1);
  Mesh mesh = rectangle(-0.6, -0.6, 0.6, 0.6);
  for (GLfloat& p : mesh.positions) p *= 1e-38f;
  mesh.draw();
}

void denormalColors() {
  glColor4f(1e-40f, 1e-45f, 0.5f, 1);
  rectangle(-0.6, -0.6, 0.6, 0.6).draw();
}

void hugeColors() {
  Mesh mesh = rectangle(-1, -1, 1, 1);
  for (int i = 0; i < 6; ++i) mesh.colors.insert(mesh.colors.end(), {1e30f, -1e30f, 0.5f, 3e38f});
  mesh.draw();
}

void tinyTriangles() {
  Mesh mesh;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      // 10^-3 pixels, around every third pixel's centre.
      const double cx = (x + 0.5) / 32 - 1, cy = (y + 0.5) / 32 - 1, d = 1e-3 / 32;
      if ((x + y) % 3 != 0) continue;
      for (const auto& [dx, dy] : {std::array{-d, -d}, std::array{d, -d}, std::array{0.0, d}})
        mesh.positions.insert(mesh.positions.end(),
                              {static_cast<GLfloat>(cx + dx), static_cast<GLfloat>(cy + dy), 0});
    }
  }
  glColor4f(1, 1, 1, 1);
  mesh.draw();
}

void hugeTriangle(double size) {
  const auto h = static_cast<GLfloat>(size / 32);
  Mesh mesh;
  mesh.positions = {-h, -h * 0.7f, 0, h, -h * 0.9f, 0, 0.3f, h, 0};
  mesh.colors = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  mesh.draw();
}

// An edge of a huge triangle runs through the picture.
void hugeEdge() {
  Mesh mesh;
  mesh.positions = {-3000, -2999.7f, 0, 3000, 3000.2f, 0, 3000, -3000, 0};
  glColor4f(0.9f, 0.6f, 0.1f, 1);
  mesh.draw();
}

void slivers() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4f(0.4f, 0.3f, 0.2f, 0.4f);
  Mesh mesh;
  for (int i = 0; i < 90; ++i) {
    const double a = 6.283185307 * i / 90, b = 6.283185307 * (i + 1) / 90;
    mesh.positions.insert(
        mesh.positions.end(),
        {0.03f, 0.02f, 0, static_cast<GLfloat>(0.9 * std::cos(a)), static_cast<GLfloat>(0.9 * std::sin(a)), 0,
         static_cast<GLfloat>(0.9 * std::cos(b)), static_cast<GLfloat>(0.9 * std::sin(b)), 0});
  }
  mesh.draw();
}

void clipCoordinates(std::array<float, 3> w) {
  const GLfloat corners[] = {-0.8f, -0.8f, 0, w[0], 0.8f, -0.8f, 0, w[1], 0, 0.8f, 0, w[2]};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(4, GL_FLOAT, 0, corners);
  glColor4f(0.9f, 0.6f, 0.1f, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void longLines() {
  Mesh mesh;
  mesh.positions = {-3000, -2000, 0, 3000, 2000.1f, 0, -1,   0.3f, 0,
                    1e4f,  0.3f,  0, 0.5f, 0.5f,    0, 0.5f, 0.5f, 0};
  glColor4f(0.9f, 0.6f, 0.1f, 1);
  mesh.draw(GL_LINES);
}

void sizes(float size, GLenum mode) {
  glPointSize(size);
  glLineWidth(size);
  glColor4f(0.9f, 0.6f, 0.1f, 1);
  Mesh mesh;
  mesh.positions = {-0.47f, -0.53f, 0, 0.41f, 0.47f, 0};
  mesh.draw(mode);
}

void drawTextureExtremes() {
  texture(4, 4, noise);
  environment(GL_REPLACE);
  const GLint crop[] = {0, 0, 4, 4};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crop);
  const auto drawTexture = command<PFNGLDRAWTEXFOESPROC>("glDrawTexfOES");
  drawTexture(-1e5f, -1e5f, 1e30f, 2e5f, 2e5f);
  drawTexture(10.25f, 20.75f, -1e30f, 20, 30);
}

void setModelview(float value) {
  GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  m[5] = value;
  glLoadMatrixf(m);
}

}  // namespace

void addVertexExtremes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, const char* section, void (*draw)()) {
    scenes.push_back({name, section, draw, {64, 64}});
  };
  add("nan/position", "2.1.1", [] { poisoned(&Mesh::positions, 1, kNan); });
  add("nan/normal", "2.1.1", [] { poisoned(&Mesh::normals, 0, kNan); });
  add("nan/color", "2.1.1", [] { poisoned(&Mesh::colors, 2, kNan); });
  add("nan/texture coordinate", "2.1.1", [] { poisoned(&Mesh::texCoords, 0, kNan); });
  add("infinity/position", "2.1.1", [] { poisoned(&Mesh::positions, 1, kInfinity); });
  add("infinity/minus, depth", "2.1.1", [] { poisoned(&Mesh::positions, 0, -kInfinity); });
  add("infinity/normal", "2.1.1", [] { poisoned(&Mesh::normals, 0, kInfinity); });
  add("infinity/color", "2.1.1", [] { poisoned(&Mesh::colors, 2, kInfinity); });
  add("infinity/texture coordinate", "2.1.1", [] { poisoned(&Mesh::texCoords, 0, -kInfinity); });
  add("nan/modelview", "2.1.1", [] { poisonedState([] { setModelview(kNan); }, [] { glLoadIdentity(); }); });
  add("infinity/modelview", "2.1.1",
      [] { poisonedState([] { setModelview(kInfinity); }, [] { glLoadIdentity(); }); });
  add("nan/light position", "2.1.1", [] {
    poisonedState([] { light({kNan, 0, 1, 1}); }, [] { light({1, 2, 3, 0}); });
  });
  add("nan/material", "2.1.1", [] {
    poisonedState([] { material({kNan, 1, 1, 1}); }, [] { material({0.9f, 0.6f, 0.3f, 1}); });
  });
  add("nan/current color", "2.1.1", [] {
    glEnable(GL_COLOR_MATERIAL);
    poisonedState([] { glColor4f(kNan, 1, 1, 1); }, [] { glColor4f(0.3f, 0.6f, 0.8f, 1); });
  });
  add("nan/fog", "2.1.1", [] {
    glEnable(GL_FOG);
    glFogf(GL_FOG_MODE, GL_LINEAR);
    poisonedState([] { glFogf(GL_FOG_END, kNan); }, [] { glFogf(GL_FOG_END, 3); });
  });
  add("nan/clip plane", "2.1.1", [] {
    glEnable(GL_CLIP_PLANE0);
    poisonedState(
        [] {
          const GLfloat plane[] = {kNan, 0, 0, 1};
          glClipPlanef(GL_CLIP_PLANE0, plane);
        },
        [] {
          const GLfloat plane[] = {0, 0, 0, 1};
          glClipPlanef(GL_CLIP_PLANE0, plane);
        });
  });
  add("nan/texture matrix", "2.1.1", [] {
    texture(4, 4, noise);
    poisonedState(
        [] {
          glMatrixMode(GL_TEXTURE);
          setModelview(kNan);
          glMatrixMode(GL_MODELVIEW);
        },
        [] {
          glMatrixMode(GL_TEXTURE);
          glLoadIdentity();
          glMatrixMode(GL_MODELVIEW);
        });
  });
  add("integers/fixed ends", "2.3", fixedEnds);
  add("integers/fixed unit", "2.3", fixedUnit);
  add("integers/byte", "2.8", [] { integers<GLbyte>(GL_BYTE, -128, 127); });
  add("integers/short", "2.8", [] { integers<GLshort>(GL_SHORT, -32768, 32767); });
  add("denormals/positions", "2.1.1", denormalPositions);
  add("denormals/color", "2.1.1", denormalColors);
  add("colors/1e30", "2.12.5", hugeColors);
  add("triangles/1e-3 pixels", "3.5.1", tinyTriangles);
  add("triangles/1e3 pixels", "3.5.1", [] { hugeTriangle(1e3); });
  add("triangles/1e5 pixels", "3.5.1", [] { hugeTriangle(1e5); });
  add("triangles/edge of 1e5 pixels", "3.5.1", hugeEdge);
  add("triangles/slivers that share edges", "3.5.1", slivers);
  add("clip coordinates/w 1e-30", "2.11", [] { clipCoordinates({1, 1, 1e-30f}); });
  add("clip coordinates/w 0", "2.11", [] { clipCoordinates({1, 1, 0}); });
  add("clip coordinates/w negative", "2.11", [] { clipCoordinates({1, 1, -1}); });
  add("clip coordinates/w 1e30", "2.11", [] { clipCoordinates({1, 1e30f, 1}); });
  add("lines/of 1e5 pixels", "3.4.1", longLines);
  add("points/size 1e-3", "3.3", [] { sizes(1e-3f, GL_POINTS); });
  add("points/size 1e30", "3.3", [] { sizes(1e30f, GL_POINTS); });
  add("lines/width 1e-3", "3.4.2", [] { sizes(1e-3f, GL_LINES); });
  add("lines/width 100", "3.4.2", [] { sizes(100, GL_LINES); });
  add("draw texture/far outside", "OES_draw_texture", drawTextureExtremes);
}

}  // namespace comparison
