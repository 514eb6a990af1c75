// Stiff and extreme: texture coordinates and combiners (3.7).
#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

// At 10^6 float32 tells 1/16 apart, and a plane equation adds three terms, each of them rounded by half of
// that.
constexpr double kUlpAtMillion = 1.5 / 16;

// Eight texels a repeat over 64 pixels, `base` repeats from the origin; float32 holds eighths of it at 10^6.
void farCoordinates(double base, GLenum wrapMode, GLenum magFilter = GL_NEAREST) {
  texture(4, 4, noise);
  filter(magFilter, magFilter);
  wrap(wrapMode, wrapMode);
  environment(GL_REPLACE);
  textured(base, -base, base + 2, -base + 2).draw();
}

// The matrix brings far coordinates back.
void farTextureMatrix() {
  texture(4, 4, noise);
  environment(GL_REPLACE);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(1e6f + 0.25f, -1e6f, 0);
  glTranslatef(-1e6f, 1e6f, 0);
  glMatrixMode(GL_MODELVIEW);
  textured(0, 0, 2, 2).draw();
}

void homogeneous(const std::array<float, 4>& qs) {
  texture(4, 4, noise);
  environment(GL_REPLACE);
  const Mesh mesh = rectangle(-1, -1, 1, 1);
  const GLfloat coordinates[] = {0, 0, 0, qs[0], 1, 0, 0, qs[1], 1, 1, 0, qs[2],
                                 0, 0, 0, qs[0], 1, 1, 0, qs[2], 0, 1, 0, qs[3]};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glTexCoordPointer(4, GL_FLOAT, 0, coordinates);
  glDrawArrays(GL_TRIANGLES, 0, 6);
}

// s, t and q share a factor, which the division takes out again.
void scaledHomogeneous(float q) {
  texture(4, 4, noise);
  environment(GL_REPLACE);
  const Mesh mesh = rectangle(-1, -1, 1, 1);
  const GLfloat coordinates[] = {0, 0, 0, q, 2 * q, 0,     0, q, 2 * q, 2 * q, 0, q,
                                 0, 0, 0, q, 2 * q, 2 * q, 0, q, 0,     2 * q, 0, q};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  glTexCoordPointer(4, GL_FLOAT, 0, coordinates);
  glDrawArrays(GL_TRIANGLES, 0, 6);
}

Texel ends(int x, int y) {
  constexpr std::uint8_t values[] = {0, 1, 127, 128, 254, 255};
  return {values[x % 6], values[y % 6], values[(x + y) % 6], values[(x * y) % 6]};
}

void dot3(GLenum function, float scale) {
  texture(8, 8, ends);
  environment(GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(function));
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
  textured(0, 0, 1, 1).draw();
}

void eightStages(GLenum function, float scale) {
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  for (int unit = 0; unit < 8 && unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    texture(4, 4, unit % 2 != 0 ? ramp : noise);
    environment(GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, static_cast<GLint>(function));
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
    glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, scale);
    glMultiTexCoord4f(GL_TEXTURE0 + static_cast<GLenum>(unit), 0.1f * static_cast<float>(unit), 0.4f, 0, 1);
  }
  glActiveTexture(GL_TEXTURE0);
  glClientActiveTexture(GL_TEXTURE0);
  glColor4f(0.02f, 0.04f, 0.06f, 0.08f);
  textured(0, 0, 1, 1).draw();
}

void environmentColor(float size) {
  texture(4, 4, noise);
  environment(GL_BLEND);
  const GLfloat color[] = {size, -size, 0.5f, size};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  glColor4f(0.3f, 0.5f, 0.7f, 0.9f);
  textured(0, 0, 1, 1).draw();
}

void minified() {
  texture(64, 64, noise);
  for (int i = 1; i <= 6; ++i) level(i, 64 >> i, 64 >> i, ramp);
  filter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
  textured(0, 0, 1e6, 1e6).draw();
}

void magnified() {
  texture(64, 64, noise);
  filter(GL_LINEAR, GL_LINEAR);
  environment(GL_REPLACE);
  textured(0.5, 0.5, 0.5 + 1e-3, 0.5 + 1e-3).draw();
}

void widest() {
  texture(2048, 1, noise);
  environment(GL_REPLACE);
  textured(0, 0, 1, 1).draw();
}

void farSprite() {
  texture(4, 4, noise);
  environment(GL_REPLACE);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, 1);
  glPointSize(60);
  Mesh mesh;
  mesh.positions = {0.01f, -0.02f, 0};
  mesh.draw(GL_POINTS);
}

}  // namespace

void addTextureExtremes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, const char* section, void (*draw)(),
                             Driver driver = Driver::kExact, double coordinateUlp = 0) {
    scenes.push_back({name, section, draw, {64, 64}, 0, driver, "", coordinateUlp});
  };
  add("coordinates/1e3 repeat", "3.7.6", [] { farCoordinates(1e3, GL_REPEAT); });
  add(
      "coordinates/1e6 repeat", "3.7.6", [] { farCoordinates(1e6, GL_REPEAT); }, Driver::kExact,
      kUlpAtMillion);
  add(
      "coordinates/1e6 mirrored", "OES_texture_mirrored_repeat",
      [] { farCoordinates(1e6, GL_MIRRORED_REPEAT_OES); }, Driver::kExact, kUlpAtMillion);
  add("coordinates/1e6 clamped", "3.7.6", [] { farCoordinates(1e6, GL_CLAMP_TO_EDGE); });
  add("coordinates/1e9 clamped", "3.7.6", [] { farCoordinates(1e9, GL_CLAMP_TO_EDGE); });
  add(
      "coordinates/1e6 repeat linear", "3.7.6", [] { farCoordinates(1e6, GL_REPEAT, GL_LINEAR); },
      Driver::kFilter, kUlpAtMillion);
  add("coordinates/matrix at 1e6", "2.10.2", farTextureMatrix);
  add("coordinates/minified 1e6", "3.7.7", minified, Driver::kLevelOfDetail);
  add("coordinates/magnified 1e3", "3.7.7", magnified, Driver::kFilter);
  add("coordinates/widest texture", "3.7.1", widest);
  add("coordinates/large sprite", "OES_point_sprite", farSprite);
  add("q/1e-30", "3.7.7", [] { scaledHomogeneous(1e-30f); });
  add("q/1e30", "3.7.7", [] { scaledHomogeneous(1e30f); });
  add("q/from 1e-3 to 1", "3.5.1", [] { homogeneous({1, 1e-3f, 1, 1}); });
  add("q/from 1e-6 to 1", "3.5.1", [] { homogeneous({1, 1, 1e-6f, 1}); });
  add("dot3/ends of the range", "3.7.12", [] { dot3(GL_DOT3_RGB, 1); });
  add("dot3/ends of the range times 4", "3.7.12", [] { dot3(GL_DOT3_RGBA, 4); });
  add("combiner/scale 4 through eight", "3.7.12", [] { eightStages(GL_MODULATE, 4); });
  add("combiner/add signed through eight", "3.7.12", [] { eightStages(GL_ADD_SIGNED, 4); });
  add("combiner/subtract through eight", "3.7.12", [] { eightStages(GL_SUBTRACT, 4); });
  add("environment/color 1e30", "3.7.12", [] { environmentColor(1e30f); });
}

}  // namespace comparison
