// Stiff and extreme: lighting, fog and the sizes of points (2.12, 3.3, 3.8).
#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

const Surface kMedium{96, 96};

void drawSphere() {
  perspective();
  glTranslatef(0, 0, -2.6f);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

void shininess(float exponent) {
  light({1, 2, 3, 0}, 0.3f, 1);
  material({0.2f, 0.4f, 0.8f, 1}, 0.9f, exponent);
  drawSphere();
}

void spot(float exponent, float cutoff) {
  light({0, 0, 0, 1}, 1, 0);
  glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff);
  glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent);
  const GLfloat direction[] = {0.1f, 0.1f, -1};
  glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
  material({0.9f, 0.7f, 0.5f, 1});
  drawSphere();
}

void attenuation(float constant, float linear, float quadratic) {
  light({0.3f, 0.2f, -1, 1}, 0.8f);
  glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant);
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear);
  glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, quadratic);
  material({0.9f, 0.7f, 0.5f, 1});
  drawSphere();
}

// A plane before the eye, one vertex of which is where the light is.
void lightAtVertex(float constant, float linear) {
  perspective();
  light({0, 0, -2, 1}, 0.8f, 0.5f);
  glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant);
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear);
  material({0.9f, 0.7f, 0.5f, 1}, 0.5f, 4);
  glTranslatef(0, 0, -2);
  plane(4).draw();
}

void normalLength(float length, bool normalize) {
  light({1, 2, 3, 0}, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 8);
  if (normalize) glEnable(GL_NORMALIZE);
  perspective();
  glTranslatef(0, 0, -2.6f);
  glEnable(GL_DEPTH_TEST);
  Mesh mesh = sphere(24, 16);
  for (GLfloat& n : mesh.normals) n *= length;
  mesh.draw();
}

void distantLight(std::array<float, 4> position) {
  light(position, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 8);
  drawSphere();
}

// Specular light straight from behind: the half vector is 0 where only rounding is left.
void oppositeHalfVector() {
  light({0, 0, -1, 0}, 0.2f, 1);
  material({0.2f, 0.4f, 0.8f, 1}, 0.9f, 2);
  drawSphere();
}

void brightColors(float lightColor, float materialColor) {
  light({1, 2, 3, 0}, lightColor);
  material({0.9f * materialColor, 0.5f * materialColor, 0.2f * materialColor, 1});
  drawSphere();
}

void negativeColors() {
  light({1, 2, 3, 0}, 0.9f);
  light({-1, 2, 3, 0}, -0.7f, 0, GL_LIGHT1);
  material({0.9f, -0.5f, 0.2f, 1});
  drawSphere();
}

// Black to the distance `far` under white fog.
void fog(GLenum mode, float density, float start, float end, float distance) {
  const GLfloat white[] = {1, 1, 1, 1};
  glEnable(GL_FOG);
  glFogfv(GL_FOG_COLOR, white);
  glFogf(GL_FOG_MODE, static_cast<GLfloat>(mode));
  glFogf(GL_FOG_DENSITY, density);
  glFogf(GL_FOG_START, start);
  glFogf(GL_FOG_END, end);
  projection();
  glScalef(1, 1, 0);
  glMatrixMode(GL_MODELVIEW);
  glColor4f(0.1f, 0.3f, 0.2f, 1);
  // z runs from 0 to -distance from left to right; what a pixel has is its centre's.
  Mesh mesh = rectangle(-1, -1, 1, 1);
  for (std::size_t i = 0; i < 6; ++i)
    mesh.positions[3 * i + 2] = -distance * (mesh.positions[3 * i] * 0.5f + 0.5f);
  mesh.draw();
}

void pointSizes(float constant, float linear, float quadratic) {
  const GLfloat attenuation[] = {constant, linear, quadratic};
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  glPointParameterf(GL_POINT_SIZE_MAX, 16);
  glPointSize(4);
  glColor4f(0.4f, 0.9f, 0.2f, 1);
  projection();
  glScalef(1, 1, 0);
  glMatrixMode(GL_MODELVIEW);
  Mesh mesh;
  mesh.positions = {-0.7f, -0.7f, 0,     0.03f,  -0.7f, -1,   0.67f,  -0.73f,
                    -100,  -0.7f, 0.31f, -1e10f, 0.3f,  0.3f, -1e-10f};
  mesh.draw(GL_POINTS);
}

}  // namespace

void addLightingExtremes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, const char* section, void (*draw)(),
                             Surface surface = kMedium) {
    scenes.push_back({name, section, draw, surface});
  };
  add("shininess/0", "2.12.1", [] { shininess(0); });
  add("shininess/1e-6", "2.12.1", [] { shininess(1e-6f); });
  add("shininess/128", "2.12.1", [] { shininess(128); });
  add("spot/exponent 0 cutoff 0", "2.12.1", [] { spot(0, 0); });
  add("spot/exponent 0 cutoff 90", "2.12.1", [] { spot(0, 90); });
  add("spot/exponent 0 cutoff 180", "2.12.1", [] { spot(0, 180); });
  add("spot/exponent 128 cutoff 0", "2.12.1", [] { spot(128, 0); });
  add("spot/exponent 128 cutoff 90", "2.12.1", [] { spot(128, 90); });
  add("spot/exponent 128 cutoff 180", "2.12.1", [] { spot(128, 180); });
  add("attenuation/0", "2.12.1", [] { attenuation(0, 0, 0); });
  add("attenuation/1e-30", "2.12.1", [] { attenuation(1e-30f, 0, 0); });
  add("attenuation/1e30", "2.12.1", [] { attenuation(1e30f, 0, 1e30f); });
  add("attenuation/quadratic 1e-6", "2.12.1", [] { attenuation(0, 0, 1e-6f); });
  add("light at a vertex/constant", "2.12.1", [] { lightAtVertex(1, 0); });
  add("light at a vertex/linear", "2.12.1", [] { lightAtVertex(0, 1); });
  add("normals/1e-30", "2.10.3", [] { normalLength(1e-30f, true); });
  add("normals/1e-10", "2.10.3", [] { normalLength(1e-10f, true); });
  add("normals/1e10", "2.10.3", [] { normalLength(1e10f, true); });
  add("normals/1e30", "2.10.3", [] { normalLength(1e30f, true); });
  add("normals/0", "2.10.3", [] { normalLength(0, true); });
  add("normals/1e30 as they are", "2.10.3", [] { normalLength(1e30f, false); });
  add("normals/1e-30 as they are", "2.10.3", [] { normalLength(1e-30f, false); });
  add("light/at 1e18", "2.12.1", [] { distantLight({5e17f, 5e17f, 1e18f, 1}); });
  add("light/at 1e30", "2.12.1", [] { distantLight({5e29f, 5e29f, 1e30f, 1}); });
  add("light/direction 1e-30", "2.12.1", [] { distantLight({5e-31f, 5e-31f, 1e-30f, 0}); });
  add("light/direction 1e30", "2.12.1", [] { distantLight({5e29f, 5e29f, 1e30f, 0}); });
  add("light/direction 0", "2.12.1", [] { distantLight({0, 0, 0, 0}); });
  add("light/w 1e-30", "2.12.1", [] { distantLight({1e-30f, 2e-30f, 3e-30f, 1e-30f}); });
  add("light/opposite half vector", "2.12.1", oppositeHalfVector);
  add("light/1e6 on material 1e-6", "2.12.1", [] { brightColors(1e6f, 1e-6f); });
  add("light/1e30", "2.12.1", [] { brightColors(1e30f, 1e-30f); });
  add("light/negative colors", "2.12.1", negativeColors);
  add("fog/density 0", "3.8", [] { fog(GL_EXP, 0, 0, 1, 1e6f); });
  add("fog/density 1e-6", "3.8", [] { fog(GL_EXP, 1e-6f, 0, 1, 3e6f); });
  add("fog/density 1e6", "3.8", [] { fog(GL_EXP, 1e6f, 0, 1, 3e-6f); });
  add("fog/exp2 density 1e-6", "3.8", [] { fog(GL_EXP2, 1e-6f, 0, 1, 3e6f); });
  add("fog/exp2 density 1e6", "3.8", [] { fog(GL_EXP2, 1e6f, 0, 1, 3e-6f); });
  add("fog/exp2 1e30 at 1e30", "3.8", [] { fog(GL_EXP2, 1e30f, 0, 1, 1e30f); });
  add("fog/start is end", "3.8", [] { fog(GL_LINEAR, 1, 5, 5, 10); });
  add("fog/start behind end", "3.8", [] { fog(GL_LINEAR, 1, 8, 2, 10); });
  add("fog/a millionth wide", "3.8", [] { fog(GL_LINEAR, 1, 5, 5.000005f, 10); });
  add("fog/to 1e30", "3.8", [] { fog(GL_LINEAR, 1, 0, 1e30f, 1e30f); });
  add("point size/denominator 0", "3.3", [] { pointSizes(0, 0, 0); });
  add("point size/1e-30", "3.3", [] { pointSizes(1e-30f, 0, 0); });
  add("point size/1e30", "3.3", [] { pointSizes(1e30f, 0, 0); });
  add("point size/quadratic at 0", "3.3", [] { pointSizes(0, 0, 1); });
}

}  // namespace comparison
