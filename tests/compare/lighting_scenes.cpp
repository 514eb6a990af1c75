// Ordinary lighting and fog: sections 2.12 and 3.8.
#include <cmath>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

const Surface kMedium{96, 96};

void drawSphere() {
  perspective();
  glTranslatef(0, 0, -2.6f);
  glRotatef(25, 1, 0.3f, 0);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

void directional() {
  light({1, 2, 3, 0});
  material({0.9f, 0.5f, 0.2f, 1});
  drawSphere();
}

void positionalAttenuated() {
  light({1, 1, -1, 1}, 1);
  glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5f);
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2f);
  glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.4f);
  material({0.9f, 0.9f, 0.2f, 1});
  drawSphere();
}

void specular() {
  light({1, 2, 3, 0}, 0.5f, 1);
  material({0.2f, 0.4f, 0.8f, 1}, 0.9f, 24);
  drawSphere();
}

void spot() {
  light({0.5f, 0.5f, 0, 1}, 1);
  const GLfloat direction[] = {-0.2f, -0.2f, -1};
  glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
  glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);
  glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 10);
  material({0.9f, 0.7f, 0.5f, 1});
  drawSphere();
}

void eightLights() {
  for (int i = 0; i < 8; ++i) {
    const auto a = static_cast<float>(i) * 0.785f;
    light({std::cos(a), std::sin(a), i % 2 != 0 ? 0.5f : -1.0f, i % 2 != 0 ? 0.0f : 1.0f}, 0.25f, 0.3f,
          GL_LIGHT0 + static_cast<GLenum>(i));
  }
  material({0.8f, 0.6f, 0.9f, 1}, 0.5f, 8);
  drawSphere();
}

void colorMaterial() {
  light({0, 1, 2, 0});
  glEnable(GL_COLOR_MATERIAL);
  Mesh mesh = sphere(24, 16);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    mesh.colors.insert(mesh.colors.end(),
                       {mesh.positions[i] * 0.5f + 0.5f, mesh.positions[i + 1] * 0.5f + 0.5f, 0.3f,
                        mesh.positions[i + 2] * 0.5f + 0.5f});
  }
  perspective();
  glTranslatef(0, 0, -2.6f);
  glEnable(GL_DEPTH_TEST);
  mesh.draw();
}

void twoSided() {
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light({1, 1, 2, 0}, 0.9f, 0.4f);
  material({0.3f, 0.9f, 0.5f, 1}, 0.5f, 12);
  Mesh mesh = sphere(24, 16);
  mesh.indices.resize(mesh.indices.size() / 2);
  perspective();
  glTranslatef(0, 0, -2.6f);
  glRotatef(60, 1, 0, 0);
  glEnable(GL_DEPTH_TEST);
  mesh.draw();
}

void flat() {
  glShadeModel(GL_FLAT);
  directional();
}

void normalized() {
  light({1, 2, 3, 0});
  material({0.9f, 0.5f, 0.2f, 1});
  glEnable(GL_NORMALIZE);
  perspective();
  glTranslatef(0, 0, -4);
  glScalef(0.5f, 1.5f, 1);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

void rescaled() {
  light({1, 2, 3, 0});
  material({0.9f, 0.5f, 0.2f, 1});
  glEnable(GL_RESCALE_NORMAL);
  perspective();
  glTranslatef(0, 0, -4);
  glScalef(1.5f, 1.5f, 1.5f);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

void unnormalized() {
  light({1, 2, 3, 0});
  material({0.9f, 0.5f, 0.2f, 1});
  perspective();
  glTranslatef(0, 0, -4);
  glScalef(1.4f, 1.6f, 1.1f);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

// A corridor from the eye into the distance.
void drawCorridor() {
  const GLfloat color[] = {0.6f, 0.7f, 0.8f, 1};
  glEnable(GL_FOG);
  glFogfv(GL_FOG_COLOR, color);
  perspective(0.5, 50);
  glRotatef(90, 1, 0, 0);
  glTranslatef(0, -1, 0);
  Mesh floor = plane(16);
  glTranslatef(0, -10, 1);
  glScalef(3, 12, 1);
  glColor4f(0.8f, 0.1f, 0.1f, 1);
  floor.draw();
}

void fogLinear() {
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 1);
  glFogf(GL_FOG_END, 15);
  drawCorridor();
}
void fogExp() {
  glFogf(GL_FOG_MODE, GL_EXP);
  glFogf(GL_FOG_DENSITY, 0.15f);
  drawCorridor();
}
void fogExp2() {
  glFogf(GL_FOG_MODE, GL_EXP2);
  glFogf(GL_FOG_DENSITY, 0.15f);
  drawCorridor();
}

}  // namespace

void addLightingScenes(Scenes& scenes) {
  scenes.insert(scenes.end(), {
                                  {"lighting/directional", "2.12.1", directional, kMedium},
                                  {"lighting/positional attenuated", "2.12.1", positionalAttenuated, kMedium},
                                  {"lighting/specular", "2.12.1", specular, kMedium},
                                  {"lighting/spot", "2.12.1", spot, kMedium},
                                  {"lighting/eight lights", "2.12.1", eightLights, kMedium},
                                  {"lighting/color material", "2.12.3", colorMaterial, kMedium},
                                  {"lighting/two-sided", "2.12.1", twoSided, kMedium},
                                  {"lighting/flat", "2.12.6", flat, kMedium},
                                  {"lighting/normalize", "2.10.3", normalized, kMedium},
                                  {"lighting/rescale", "2.10.3", rescaled, kMedium},
                                  {"lighting/scaled normals", "2.10.3", unnormalized, kMedium},
                                  {"fog/linear", "3.8", fogLinear, kMedium},
                                  {"fog/exp", "3.8", fogExp, kMedium},
                                  {"fog/exp2", "3.8", fogExp2, kMedium},
                              });
}

}  // namespace comparison
