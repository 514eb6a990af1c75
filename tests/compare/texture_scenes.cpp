// Ordinary texturing: section 3.7 and the extensions of textures.
#include <algorithm>
#include <cmath>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

// Colours vary over the picture, so that every argument of an environment shows.
void drawColored(const Mesh& base) {
  Mesh mesh = base;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const float x = mesh.positions[i] * 0.5f + 0.5f, y = mesh.positions[i + 1] * 0.5f + 0.5f;
    mesh.colors.insert(mesh.colors.end(), {x, y, 1 - x, 1 - 0.5f * y});
  }
  mesh.draw();
}

void drawEnvironment(GLenum mode, GLenum format = GL_RGBA) {
  texture(8, 8, noise, format);
  const GLfloat color[] = {0.2f, 0.9f, 0.4f, 0.7f};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  environment(mode);
  drawColored(textured(0, 0, 1, 1));
}

void combine(GLenum function, GLenum alphaFunction, float scale) {
  environment(GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(function));
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, static_cast<GLint>(alphaFunction));
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
  glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, scale);
}

void drawCombiner(GLenum function, GLenum alphaFunction, float scale) {
  texture(8, 8, noise);
  const GLfloat color[] = {0.2f, 0.9f, 0.4f, 0.7f};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  combine(function, alphaFunction, scale);
  drawColored(textured(0, 0, 1, 1));
}

void twoUnits() {
  texture(8, 8, noise);
  environment(GL_MODULATE);
  glActiveTexture(GL_TEXTURE1);
  texture(4, 4, ramp);
  combine(GL_INTERPOLATE, GL_ADD, 1);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);
  glClientActiveTexture(GL_TEXTURE1);
  const Mesh mesh = textured(0, 0, 3, 3);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, mesh.texCoords.data());
  glClientActiveTexture(GL_TEXTURE0);
  drawColored(textured(0, 0, 1, 1));
}

void crossbar() {
  texture(8, 8, noise);
  environment(GL_REPLACE);
  glActiveTexture(GL_TEXTURE1);
  texture(4, 4, ramp);
  combine(GL_ADD_SIGNED, GL_MODULATE, 1);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE1);
  glMultiTexCoord4f(GL_TEXTURE1, 0.3f, 0.6f, 0, 1);
  drawColored(textured(0, 0, 1, 1));
}

template <int grey>
Texel solid(int, int) {
  return {grey, 255 - grey, grey / 2, 255};
}

void mipmapped(GLenum minFilter, GLenum magFilter = GL_NEAREST) {
  // Every level has one colour, so that the picture is the levels' choice and nothing else.
  constexpr Texel (*kLevels[])(int, int) = {solid<20>,  solid<230>, solid<90>,
                                            solid<160>, solid<0>,   solid<255>};
  texture(32, 32, kLevels[0]);
  for (int i = 1; i <= 5; ++i) level(i, 32 >> i, 32 >> i, kLevels[i]);
  // With a LINEAR magFilter the switch-over may be at c = 0.5, which is another scene.
  filter(minFilter, magFilter);
  environment(GL_REPLACE);
  drawFloor();
}

void nearest() {
  texture(32, 32, noise);
  environment(GL_REPLACE);
  drawFloor();
}
void linear() {
  texture(32, 32, noise);
  filter(GL_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
  drawFloor();
}

// Neighbours at the greatest contrast there is: no other picture can suffer more from the weights.
Texel contrast(int x, int y) {
  const std::uint8_t c = (x + y) % 2 != 0 ? 255 : 0;
  return {c, c, static_cast<std::uint8_t>(255 - c), c};
}
void linearContrast() {
  texture(2, 2, contrast);
  filter(GL_LINEAR, GL_LINEAR);
  wrap(GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
  environment(GL_REPLACE);
  textured(0.25, 0.25, 0.75, 0.75).draw();
}

// Levels are black and white in turn, so that a pixel is its level of detail.
void blackAndWhiteLevels(int levels) {
  texture(1, 1, solid<0>);
  for (int i = 0; i < levels; ++i) {
    const int side = 1 << (levels - 1 - i);
    level(i, side, side, i % 2 != 0 ? solid<255> : solid<0>);
  }
  filter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
}
// A row of 2x2 pixels has one scale in both directions, 2^(1/8) from one to the next.
void levelsByScale() {
  constexpr int kLevels = 8, kRows = 96;
  blackAndWhiteLevels(kLevels);
  for (int row = 0; row < kRows; row += 2) {
    const double low = 2.0 * row / kRows - 1, high = 2.0 * (row + 2) / kRows - 1;
    const double texelsAPixel = std::exp2(row / 16.0), side = texelsAPixel * kRows / (1 << (kLevels - 1));
    Mesh mesh = rectangle(-1, low, 1, high);
    const auto s = static_cast<GLfloat>(side), t = static_cast<GLfloat>(side * 2 / kRows);
    mesh.texCoords = {0, 0, s, 0, s, t, 0, 0, s, t, 0, t};
    mesh.draw();
  }
}
void levelsOfFloor() {
  blackAndWhiteLevels(8);
  drawFloor();
}

void wrapped(GLenum mode) {
  texture(8, 8, noise);
  filter(GL_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
  wrap(mode, mode);
  textured(-1.3, -2.1, 2.2, 1.7).draw();
}

void format(GLenum format) {
  texture(8, 8, noise, format);
  environment(GL_MODULATE);
  drawColored(textured(0, 0, 1, 1));
}

void generatedMipmaps() {
  texture(1, 1, noise);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
  // Every level but 0 has one colour.
  level(0, 32, 32, checker);
  filter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
  environment(GL_REPLACE);
  drawFloor();
}

void textureMatrix() {
  texture(8, 8, noise);
  environment(GL_REPLACE);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.3f, 0.1f, 0);
  glRotatef(33, 0, 0, 1);
  glScalef(2, 3, 1);
  glMatrixMode(GL_MODELVIEW);
  textured(0, 0, 1, 1).draw();
}

// q varies over the rectangle.
void projective() {
  texture(8, 8, noise);
  environment(GL_REPLACE);
  Mesh mesh = rectangle(-1, -1, 1, 1);
  const GLfloat coordinates[] = {0, 0, 0, 1, 2, 0, 0, 2, 3, 3,    0, 3,
                                 0, 0, 0, 1, 3, 3, 0, 3, 0, 1.5f, 0, 1.5f};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glTexCoordPointer(4, GL_FLOAT, 0, coordinates);
  glDrawArrays(GL_TRIANGLES, 0, 6);
}

void cubeMap(GLenum mode) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
  filter(GL_NEAREST, GL_NEAREST, GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) {
    level(0, 4, 4, face % 2 != 0 ? noise : ramp, GL_RGBA, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
  }
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  command<PFNGLTEXGENIOESPROC>("glTexGeniOES")(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES,
                                               static_cast<GLint>(mode));
  environment(GL_REPLACE);
  perspective();
  glTranslatef(0, 0, -2.6f);
  glRotatef(33, 1, 2, 0);
  glEnable(GL_DEPTH_TEST);
  sphere(24, 16).draw();
}

void drawTexture() {
  texture(16, 16, noise);
  environment(GL_REPLACE);
  const GLint crop[] = {2, 3, 11, 9};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crop);
  command<PFNGLDRAWTEXFOESPROC>("glDrawTexfOES")(5, 7, 0.5f, 44, 36);
}

}  // namespace

void addTextureScenes(Scenes& scenes) {
  const Surface medium{96, 96};
  const auto add = [&scenes](const char* name, const char* section, void (*draw)(), Surface surface = {},
                             Driver driver = Driver::kExact) {
    scenes.push_back({name, section, draw, surface, 0, driver, ""});
  };
  add("environment/replace", "3.7.12", [] { drawEnvironment(GL_REPLACE); });
  add("environment/modulate", "3.7.12", [] { drawEnvironment(GL_MODULATE); });
  add("environment/decal", "3.7.12", [] { drawEnvironment(GL_DECAL); });
  add("environment/blend", "3.7.12", [] { drawEnvironment(GL_BLEND); });
  add("environment/add", "3.7.12", [] { drawEnvironment(GL_ADD); });
  add("environment/blend luminance alpha", "3.7.12", [] { drawEnvironment(GL_BLEND, GL_LUMINANCE_ALPHA); });
  add("combiner/interpolate", "3.7.12", [] { drawCombiner(GL_INTERPOLATE, GL_INTERPOLATE, 1); });
  add("combiner/subtract", "3.7.12", [] { drawCombiner(GL_SUBTRACT, GL_SUBTRACT, 2); });
  add("combiner/add signed", "3.7.12", [] { drawCombiner(GL_ADD_SIGNED, GL_ADD_SIGNED, 4); });
  add("combiner/dot3", "3.7.12", [] { drawCombiner(GL_DOT3_RGB, GL_REPLACE, 1); });
  add("combiner/dot3 alpha", "3.7.12", [] { drawCombiner(GL_DOT3_RGBA, GL_REPLACE, 2); });
  add("combiner/two units", "3.7.12", twoUnits);
  add("combiner/crossbar", "OES_texture_env_crossbar", crossbar);
  add("filter/nearest", "3.7.7", nearest, medium);
  add("filter/linear", "3.7.7", linear, medium, Driver::kFilter);
  add("filter/greatest contrast", "3.7.7", linearContrast, {128, 128}, Driver::kFilter);
  add("mipmaps/levels by scale", "3.7.7", levelsByScale, medium, Driver::kLevelOfDetail);
  add("mipmaps/levels of a floor", "3.7.7", levelsOfFloor, medium, Driver::kLevelOfDetail);
  add(
      "mipmaps/nearest nearest", "3.7.7", [] { mipmapped(GL_NEAREST_MIPMAP_NEAREST); }, medium,
      Driver::kLevelOfDetail);
  add(
      "mipmaps/linear nearest", "3.7.7", [] { mipmapped(GL_LINEAR_MIPMAP_NEAREST); }, medium,
      Driver::kLevelOfDetail);
  add(
      "mipmaps/nearest linear", "3.7.7", [] { mipmapped(GL_NEAREST_MIPMAP_LINEAR); }, medium,
      Driver::kLevelOfDetail);
  add(
      "mipmaps/linear linear", "3.7.7", [] { mipmapped(GL_LINEAR_MIPMAP_LINEAR); }, medium,
      Driver::kLevelOfDetail);
  add(
      "mipmaps/switch-over at 0.5", "3.7.7", [] { mipmapped(GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR); }, medium,
      Driver::kLevelOfDetail);
  add("mipmaps/generated", "3.7.7", generatedMipmaps, medium, Driver::kLevelOfDetail);
  add(
      "wrap/repeat", "3.7.6", [] { wrapped(GL_REPEAT); }, {}, Driver::kFilter);
  add(
      "wrap/clamp to edge", "3.7.6", [] { wrapped(GL_CLAMP_TO_EDGE); }, {}, Driver::kFilter);
  add(
      "wrap/mirrored repeat", "OES_texture_mirrored_repeat", [] { wrapped(GL_MIRRORED_REPEAT_OES); }, {},
      Driver::kFilter);
  add("format/alpha", "3.7.1", [] { format(GL_ALPHA); });
  add("format/luminance", "3.7.1", [] { format(GL_LUMINANCE); });
  add("format/rgb", "3.7.1", [] { format(GL_RGB); });
  add("texture/matrix", "2.10.2", textureMatrix);
  add("texture/projective", "3.5.1", projective);
  add(
      "cube map/reflection", "OES_texture_cube_map", [] { cubeMap(GL_REFLECTION_MAP_OES); }, medium);
  add(
      "cube map/normal", "OES_texture_cube_map", [] { cubeMap(GL_NORMAL_MAP_OES); }, medium);
  add("texture/draw", "OES_draw_texture", drawTexture);
}

}  // namespace comparison
