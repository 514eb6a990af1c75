// Stiff and extreme: matrices, viewports and framebuffers (2.10, 2.11).
#include <cmath>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

const Surface kMedium{96, 96};

void drawBox() {
  light({1, 2, 3, 0}, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 16);
  glEnable(GL_DEPTH_TEST);
  glRotatef(30, 1, 1, 0);
  sphere(16, 12).draw();
}

// Camera and object are `distance` away from the origin, three units from each other.
void farCamera(float distance, float angle) {
  perspective();
  glTranslatef(0, 0, -3);
  glRotatef(angle, 0.3f, 1, 0.2f);
  glTranslatef(-distance, distance, -distance);
  glTranslatef(distance, -distance, distance);
  glRotatef(-angle, 0.3f, 1, 0.2f);
  drawBox();
}

void deepFrustum(double nearPlane, double farPlane) {
  perspective(nearPlane, farPlane);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  for (double z = nearPlane * 2; z < farPlane; z *= 10) {
    const auto shade = static_cast<float>(std::fmod(std::log10(z) + 10, 5) / 5);
    glPushMatrix();
    glTranslatef(static_cast<GLfloat>(z * 0.3), 0, static_cast<GLfloat>(-z));
    glRotatef(static_cast<GLfloat>(std::log10(z) * 40), 0, 0, 1);
    glColor4f(shade, 1 - shade, 0.5f, 1);
    rectangle(-0.2 * z, -0.4 * z, 0.2 * z, 0.4 * z).draw();
    glPopMatrix();
  }
}

void millionRotations() {
  perspective();
  glTranslatef(0, 0, -3);
  for (int i = 0; i < 1000000; ++i) glRotatef(360.0f / 1024, 0.6f, 0, 0.8f);
  drawBox();
}

void millionTranslations() {
  for (int i = 0; i < 500000; ++i) glTranslatef(0.1f, -0.7f, 0.3f);
  for (int i = 0; i < 500000; ++i) glTranslatef(-0.1f, 0.7f, -0.3f);
  glColor4f(0.2f, 0.8f, 0.6f, 1);
  glRotatef(20, 0, 0, 1);
  rectangle(-0.6, -0.6, 0.6, 0.6).draw();
}

void scaledLight(float x, float y, float z, GLenum how) {
  perspective();
  glTranslatef(0, 0, -3);
  glEnable(how);
  light({1, 2, 3, 0}, 0.9f);
  material({0.9f, 0.6f, 0.3f, 1});
  glScalef(x, y, z);
  sphere(16, 12).draw();
}

// A plane whose modelview is singular: it keeps its normal when the scale along that is 0.
void flattened(float z) {
  glEnable(GL_NORMALIZE);
  light({1, 2, 3, 0}, 0.9f);
  material({0.9f, 0.6f, 0.3f, 1});
  glScalef(0.9f, 0.8f, z);
  plane(4).draw();
}

void tinyWorld(float scale) {
  perspective();
  glTranslatef(0, 0, -3);
  glScalef(1 / scale, 1 / scale, 1 / scale);
  glScalef(scale, scale, scale);
  drawBox();
}

// The scale is split between the projection and the vertices.
void tinyVertices(float scale) {
  projection();
  glScalef(1 / scale, 1 / scale, 1 / scale);
  glMatrixMode(GL_MODELVIEW);
  Mesh mesh = plane(4);
  for (GLfloat& p : mesh.positions) p *= 0.7f * scale;
  mesh.normals.clear();
  mesh.texCoords.clear();
  glColor4f(0.2f, 0.8f, 0.6f, 1);
  glRotatef(20, 0, 0, 1);
  mesh.draw();
}

// Whole numbers: a map sheet far from its origin.
void farOrtho() {
  projection();
  glOrthof(1e6f, 1e6f + 8, 2e6f, 2e6f + 8, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glColor4f(0.9f, 0.4f, 0.1f, 1);
  rectangle(1e6 + 1, 2e6 + 2, 1e6 + 5, 2e6 + 7).draw();
}

void depthRange(float nearValue, float farValue) {
  glDepthRangef(nearValue, farValue);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glRotatef(40, 1, 0.5f, 0);
  glColor4f(0.9f, 0.4f, 0.1f, 1);
  rectangle(-0.8, -0.6, 0.8, 0.6).draw();
  glRotatef(40, 0, 1, 0);
  glColor4f(0.1f, 0.4f, 0.9f, 1);
  rectangle(-0.8, -0.6, 0.8, 0.6).draw();
}

void deepStack() {
  for (int i = 0; i < 15; ++i) {
    glPushMatrix();
    glTranslatef(1e5f, 0, 0);
    glRotatef(7, 0, 0, 1);
  }
  for (int i = 0; i < 15; ++i) {
    glRotatef(-7, 0, 0, 1);
    glTranslatef(-1e5f, 0, 0);
  }
  glColor4f(0.1f, 0.9f, 0.4f, 1);
  rectangle(-0.5, -0.5, 0.5, 0.5).draw();
  for (int i = 0; i < 15; ++i) glPopMatrix();
}

void clipPlane(float scale) {
  const GLfloat plane[] = {0.5f * scale, 0.8f * scale, 0, 0.1f * scale};
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glColor4f(0.1f, 0.9f, 0.4f, 1);
  rectangle(-0.9, -0.9, 0.9, 0.9).draw();
}

void farClipPlane() {
  perspective();
  glTranslatef(0, 0, -3);
  glTranslatef(-1e6f, 0, 0);
  const GLfloat plane[] = {1, 0, 0, -1e6f};
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glTranslatef(1e6f, 0, 0);
  drawBox();
}

void hugeViewport() {
  glViewport(-2000, -1000, 4064, 2064);
  projection();
  glMatrixMode(GL_MODELVIEW);
  glColor4f(0.1f, 0.9f, 0.4f, 1);
  glRotatef(3, 0, 0, 1);
  rectangle(-0.01, -0.02, 0.01, 0.02).draw();
}

void gradient() {
  Mesh mesh = rectangle(-1, -1, 1, 1);
  for (std::size_t i = 0; i < 6; ++i) {
    const float x = mesh.positions[3 * i] * 0.5f + 0.5f, y = mesh.positions[3 * i + 1] * 0.5f + 0.5f;
    mesh.colors.insert(mesh.colors.end(), {x, y, 1 - x, 1});
  }
  mesh.draw();
}

}  // namespace

void addMatrixExtremes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, const char* section, void (*draw)(),
                             Surface surface = kMedium) {
    scenes.push_back({name, section, draw, surface});
  };
  add("far camera/1e4", "2.10.2", [] { farCamera(1e4f, 0); });
  add("far camera/1e6", "2.10.2", [] { farCamera(1e6f, 0); });
  add("far camera/1e7", "2.10.2", [] { farCamera(1e7f, 0); });
  add("far camera/1e6 turned", "2.10.2", [] { farCamera(1e6f, 33); });
  add("far camera/1e7 turned", "2.10.2", [] { farCamera(1e7f, 77); });
  add("depth/1e-3 to 1e7", "2.10.2", [] { deepFrustum(1e-3, 1e7); });
  add("depth/1e-6 to 1e6", "2.10.2", [] { deepFrustum(1e-6, 1e6); });
  add("depth/range reversed", "2.10.1", [] { depthRange(1, 0); });
  add("depth/range empty", "2.10.1", [] { depthRange(0.25f, 0.25f); });
  add("depth/range 1e-6", "2.10.1", [] { depthRange(0, 1e-6f); });
  add("matrix/million rotations", "2.10.2", millionRotations);
  add("matrix/million translations", "2.10.2", millionTranslations);
  add("matrix/stack of far moves", "2.10.2", deepStack);
  add("matrix/world of 1e-18", "2.10.2", [] { tinyWorld(1e-18f); });
  add("matrix/world of 1e18", "2.10.2", [] { tinyWorld(1e18f); });
  add("matrix/vertices of 1e-30", "2.10.2", [] { tinyVertices(1e-30f); });
  add("matrix/vertices of 1e30", "2.10.2", [] { tinyVertices(1e30f); });
  add("matrix/ortho at 1e6", "2.10.2", farOrtho);
  add("singular/nearly, NORMALIZE", "2.10.3", [] { scaledLight(1, 1e-4f, 0.7f, GL_NORMALIZE); });
  add("singular/nearly, stretched", "2.10.3", [] { scaledLight(1, 0.5f, 1e-6f, GL_NORMALIZE); });
  add("singular/RESCALE_NORMAL at 1e-4", "2.10.3", [] {
    glTranslatef(0, 0, 0);
    perspective();
    glTranslatef(0, 0, -3);
    glScalef(1e4f, 1e4f, 1e4f);
    glScalef(1e-4f, 1e-4f, 1e-4f);
    scaledLight(1, 1, 1, GL_RESCALE_NORMAL);
  });
  add("singular/flattened along the normal", "2.10.3", [] { flattened(0); });
  add("singular/flattened to 1e-30", "2.10.3", [] { flattened(1e-30f); });
  add("clip plane/1e-30", "2.11", [] { clipPlane(1e-30f); });
  add("clip plane/1e30", "2.11", [] { clipPlane(1e30f); });
  add("clip plane/at 1e6", "2.11", farClipPlane);
  add("viewport/far beyond the surface", "2.10.1", hugeViewport);
  add("framebuffer/1x1", "2.10.1", gradient, {1, 1});
  add("framebuffer/widest", "2.10.1", gradient, {4096, 1});
  add("framebuffer/highest", "2.10.1", gradient, {1, 4096});
}

}  // namespace comparison
