#include "state_mixes.h"

#include <GLES/gl.h>

#include <array>
#include <cstdint>

#include "session.h"

namespace bench {

namespace {

// Filled by beginMixes: solid (128, 255, 64), solid (255, 64, 128) and the normal (0, 0.6, 0.8) biased.
std::array<GLuint, 3> textures;
enum Texture : std::size_t { kGreen, kPink, kNormal };

constexpr GLenum kLastUnit = GL_TEXTURE2;

using Vector4 = std::array<GLfloat, 4>;

void makeSolidTexture(Texture name, Rgb color) {
  constexpr int size = 32;
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < size * size; ++i) {
    for (const int channel : color) texels.push_back(std::uint8_t(channel));
    texels.push_back(255);
  }
  glBindTexture(GL_TEXTURE_2D, textures[name]);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

void useTexture(GLenum unit, Texture name, GLint mode = GL_MODULATE) {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, textures[name]);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
}

void combine(GLint function, GLint source0, GLint source1) {
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, function);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, source0);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, source1);
}

// Light and material such that each light contributes `diffuse` where it meets the quad head on, and no
// ambient.
void light(GLenum name, Vector4 position, GLfloat diffuse) {
  const Vector4 grey = {diffuse, diffuse, diffuse, 1};
  const Vector4 black = {0, 0, 0, 1};
  glLightfv(name, GL_POSITION, position.data());
  glLightfv(name, GL_DIFFUSE, grey.data());
  glLightfv(name, GL_SPECULAR, black.data());
  glEnable(name);
}

void lighting(Vector4 materialDiffuse) {
  const Vector4 black = {0, 0, 0, 1};
  glEnable(GL_LIGHTING);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black.data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, black.data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, materialDiffuse.data());
}

void fog(GLfloat mode, Vector4 color) {
  glEnable(GL_FOG);
  glFogf(GL_FOG_MODE, mode);
  glFogfv(GL_FOG_COLOR, color.data());
}

constexpr Vector4 kHeadOn = {0, 0, 1, 0};
constexpr Vector4 kFarAway = {0, 0, 100000, 1};
constexpr Vector4 kOrange = {1, 0.6f, 0.2f, 1};
constexpr Vector4 kBlue = {0, 0, 1, 1};

void texturedModulate() {
  useTexture(GL_TEXTURE0, kGreen);
}

void oneLight() {
  lighting(kOrange);
  light(GL_LIGHT0, kHeadOn, 1);
}

void eightLights() {
  lighting(kOrange);
  for (GLenum i = 0; i < 8; ++i) light(GL_LIGHT0 + i, i % 2 ? kHeadOn : kFarAway, 0.125f);
}

void spotLight() {
  const std::array<GLfloat, 3> downwards = {0, 0, -1};
  lighting(kOrange);
  light(GL_LIGHT0, kFarAway, 1);
  glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45);
  glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
  glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, downwards.data());
  glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 2);
}

// The specular half of the sum is exponent-free: the half vector is the normal.
void specularTwoSided() {
  const Vector4 third = {0.3f, 0.3f, 0.3f, 1};
  oneLight();
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  glLightfv(GL_LIGHT0, GL_SPECULAR, third.data());
  const Vector4 white = {1, 1, 1, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white.data());
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

void linearFogTextured() {
  useTexture(GL_TEXTURE0, kGreen, GL_REPLACE);
  fog(GL_LINEAR, kBlue);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 2);
}

// exp(-(0.8326 * 1)^2) = 1/2
void squaredFogLit() {
  oneLight();
  fog(GL_EXP2, kBlue);
  glFogf(GL_FOG_DENSITY, 0.83255461f);
}

void interpolateTwoTextures() {
  const Vector4 constant = {0.25f, 0.25f, 0.25f, 1};
  useTexture(GL_TEXTURE0, kGreen, GL_REPLACE);
  useTexture(GL_TEXTURE1, kPink);
  combine(GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant.data());
}

// The light vector (0, 0.6, 0.8) against the same normal: 1.
void dot3Modulate() {
  glColor4f(0.5f, 0.8f, 0.9f, 1);
  useTexture(GL_TEXTURE0, kNormal);
  combine(GL_DOT3_RGB, GL_TEXTURE, GL_PRIMARY_COLOR);
  useTexture(GL_TEXTURE1, kPink);
}

void threeUnits() {
  glColor4f(1, 0.5f, 0.5f, 1);
  useTexture(GL_TEXTURE0, kGreen);
  useTexture(GL_TEXTURE1, kPink);
  combine(GL_ADD_SIGNED, GL_TEXTURE, GL_PREVIOUS);
  useTexture(GL_TEXTURE2, kGreen);
  combine(GL_SUBTRACT, GL_PREVIOUS, GL_TEXTURE);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
}

void alphaTestBlendClip() {
  const Vector4 keepsAll = {0, 0, 0, 1};
  glColor4f(1, 0.5f, 0.5f, 0.5f);
  useTexture(GL_TEXTURE0, kPink);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.25f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glClipPlanef(GL_CLIP_PLANE0, keepsAll.data());
  glEnable(GL_CLIP_PLANE0);
}

void everything() {
  lighting({1, 1, 1, 1});
  for (GLenum i = 0; i < 4; ++i) light(GL_LIGHT0 + i, i % 2 ? kHeadOn : kFarAway, 0.25f);
  useTexture(GL_TEXTURE0, kGreen);
  useTexture(GL_TEXTURE1, kPink, GL_ADD);
  fog(GL_EXP, kBlue);
  glFogf(GL_FOG_DENSITY, 0.69314718f);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace

const std::vector<StateMix>& stateMixes() {
  static const std::vector<StateMix> mixes = {
      {"textured_modulate", texturedModulate, {128, 255, 64}},
      {"one_light", oneLight, {255, 153, 51}},
      {"eight_lights", eightLights, {255, 153, 51}},
      {"spot_light", spotLight, {128, 77, 26}},
      {"specular_two_sided", specularTwoSided, {255, 230, 128}},
      {"linear_fog_textured", linearFogTextured, {64, 128, 160}},
      {"squared_fog_lit", squaredFogLit, {128, 77, 153}},
      {"interpolate_two_textures", interpolateTwoTextures, {160, 207, 80}},
      {"dot3_modulate", dot3Modulate, {255, 64, 128}},
      {"three_units", threeUnits, {255, 0, 0}},
      {"alpha_test_blend_clip", alphaTestBlendClip, {128, 16, 32}},
      {"everything", everything, {128, 128, 224}},
  };
  return mixes;
}

void beginMixes() {
  static constexpr std::array<GLfloat, 12> corners = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1};
  static constexpr std::array<GLfloat, 12> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  static constexpr std::array<GLfloat, 8> coordinates = {0, 0, 1, 0, 0, 1, 1, 1};
  glViewport(0, 0, kWidth, kHeight);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrthof(-2, 2, -2, 2, 0, 10);
  glMatrixMode(GL_MODELVIEW);
  glVertexPointer(3, GL_FLOAT, 0, corners.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glNormalPointer(GL_FLOAT, 0, normals.data());
  glEnableClientState(GL_NORMAL_ARRAY);
  for (GLenum unit = GL_TEXTURE0; unit <= kLastUnit; ++unit) {
    glClientActiveTexture(unit);
    glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glGenTextures(GLsizei(textures.size()), textures.data());
  makeSolidTexture(kGreen, {128, 255, 64});
  makeSolidTexture(kPink, {255, 64, 128});
  makeSolidTexture(kNormal, {128, 204, 230});
}

void resetMixState() {
  for (GLenum unit = GL_TEXTURE0; unit <= kLastUnit; ++unit) {
    glActiveTexture(unit);
    glDisable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);
  }
  for (GLenum i = 0; i < 8; ++i) glDisable(GL_LIGHT0 + i);
  glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180);
  glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 0);
  const Vector4 black = {0, 0, 0, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, black.data());
  for (const GLenum capability :
       {GL_LIGHTING, GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_CLIP_PLANE0, GL_DEPTH_TEST})
    glDisable(capability);
  glColor4f(1, 1, 1, 1);
}

void drawMixQuad() {
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace bench
