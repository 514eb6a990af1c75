// Ordinary points, lines, polygons and clipping: sections 2.11 and 3.3 to 3.5.
#include <cmath>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

Mesh star(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const double a = 6.28318 * i / count + 0.1;
    mesh.positions.insert(
        mesh.positions.end(),
        {static_cast<GLfloat>(0.1 * std::cos(a)), static_cast<GLfloat>(0.1 * std::sin(a)), 0,
         static_cast<GLfloat>(0.9 * std::cos(a)), static_cast<GLfloat>(0.9 * std::sin(a)), 0});
    for (float c : {0.1f, 0.9f})
      mesh.colors.insert(mesh.colors.end(), {c, static_cast<float>(i) / static_cast<float>(count), 1 - c, 1});
  }
  return mesh;
}

void lines() {
  star(15).draw(GL_LINES);
}
// Black at one end and white at the other: an error is where along the line a fragment takes its colour from
// (equation 3.5). Every tenth degree, since the error depends on the direction.
void lineColors() {
  Mesh mesh;
  for (int i = 0; i < 36; ++i) {
    const double a = 6.283185307 * i / 36 + 0.05, c = std::cos(a), s = std::sin(a);
    mesh.positions.insert(mesh.positions.end(),
                          {static_cast<GLfloat>(0.1 * c), static_cast<GLfloat>(0.1 * s), 0,
                           static_cast<GLfloat>(0.9 * c), static_cast<GLfloat>(0.9 * s), 0});
    mesh.colors.insert(mesh.colors.end(), {0, 0, 0, 1, 1, 1, 1, 1});
  }
  mesh.draw(GL_LINES);
}
void wideLines() {
  glLineWidth(5);
  star(7).draw(GL_LINES);
}
// Few enough that no two of them cover a pixel, and without alpha, whose square is stored: the driver's error
// would count twice there.
void smoothLines() {
  glLineWidth(2.5f);
  glEnable(GL_LINE_SMOOTH);
  glColorMask(1, 1, 1, 0);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  star(5).draw(GL_LINES);
}
void points() {
  glPointSize(7);
  star(6).draw(GL_POINTS);
}
void smoothPoints() {
  glPointSize(9.5f);
  glEnable(GL_POINT_SMOOTH);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  star(6).draw(GL_POINTS);
}
void sprites() {
  glPointSize(13);
  texture(8, 8, noise);
  environment(GL_REPLACE);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, 1);
  star(6).draw(GL_POINTS);
}
// Levels of one colour each: rho is 1 for every point (3.7.7), so that only level 0 shows, whatever the size.
template <int grey>
Texel solid(int, int) {
  return {grey, 255 - grey, grey / 2, 255};
}
void mipmappedPoints(bool sprites) {
  texture(16, 16, solid<20>);
  level(1, 8, 8, solid<230>);
  level(2, 4, 4, solid<90>);
  level(3, 2, 2, solid<160>);
  level(4, 1, 1, solid<255>);
  filter(GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
  if (sprites) glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, sprites);
  for (int i = 0; i < 6; ++i) {
    glPointSize(static_cast<GLfloat>(1 << i) * 0.8f);
    Mesh point;
    point.positions = {-0.8f + 0.3f * static_cast<float>(i), 0.1f, 0};
    point.texCoords = {0.3f, 0.7f};
    point.draw(GL_POINTS);
  }
}
void attenuatedPoints() {
  const GLfloat attenuation[] = {0.1f, 0.2f, 0.1f};
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  glPointSize(12);
  perspective();
  glTranslatef(0, 0, -3);
  glRotatef(60, 1, 0, 0);
  glScalef(1.5f, 1.5f, 1);
  star(9).draw(GL_POINTS);
}
void strips() {
  star(12).draw(GL_TRIANGLE_STRIP);
}
void flatFan() {
  glShadeModel(GL_FLAT);
  star(9).draw(GL_TRIANGLE_FAN);
}
void clipPlanes() {
  const GLfloat first[] = {1, 0.5f, 0, 0.3f}, second[] = {-0.3f, -1, 0, 0.4f};
  glClipPlanef(GL_CLIP_PLANE0, first);
  glClipPlanef(GL_CLIP_PLANE1, second);
  glEnable(GL_CLIP_PLANE0);
  glEnable(GL_CLIP_PLANE1);
  Mesh mesh = plane(4);
  for (std::size_t i = 0; i < mesh.texCoords.size(); i += 2)
    mesh.colors.insert(mesh.colors.end(), {mesh.texCoords[i], mesh.texCoords[i + 1], 0.5f, 1});
  mesh.draw();
}
void culled() {
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  Mesh mesh = sphere(12, 8);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.colors.push_back(mesh.positions[i] * 0.5f + 0.5f);
    if (i % 3 == 2) mesh.colors.push_back(1);
  }
  mesh.normals.clear();
  perspective();
  glTranslatef(0, 0, -2.2f);
  mesh.draw();
}
// Most of it lies outside the view, some behind the eye.
void throughTheEye() {
  perspective(0.1, 20);
  glTranslatef(0, -0.3f, 0);
  glRotatef(-90, 1, 0, 0);
  glScalef(5, 5, 1);
  Mesh mesh = plane(1);
  for (std::size_t i = 0; i < mesh.texCoords.size(); i += 2)
    mesh.colors.insert(mesh.colors.end(), {mesh.texCoords[i], mesh.texCoords[i + 1], 0.5f, 1});
  mesh.draw();
}

}  // namespace

void addPrimitiveScenes(Scenes& scenes) {
  scenes.insert(scenes.end(), {
                                  {"lines/thin", "3.4.1", lines, {}, 0, Driver::kLine},
                                  {"lines/colors", "3.4.1", lineColors, {}, 0, Driver::kLine},
                                  {"lines/wide", "3.4.2", wideLines, {}, 0, Driver::kLine},
                                  {"lines/smooth", "3.4.2", smoothLines, {}, 0, Driver::kSmoothLine},
                                  {"points/square", "3.3", points},
                                  {"points/smooth", "3.3", smoothPoints},
                                  {"points/sprites", "OES_point_sprite", sprites},
                                  {"points/sprites, mipmapped", "3.7.7", [] { mipmappedPoints(true); }},
                                  {"points/mipmapped", "3.7.7", [] { mipmappedPoints(false); }},
                                  {"points/attenuated", "3.3", attenuatedPoints},
                                  {"polygons/strip", "3.5.1", strips},
                                  {"polygons/flat fan", "2.12.6", flatFan},
                                  {"polygons/culled", "3.5.1", culled},
                                  {"clipping/planes", "2.11", clipPlanes},
                                  {"clipping/through the eye", "2.11", throughTheEye},
                              });
}

}  // namespace comparison
