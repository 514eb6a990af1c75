// Full-screen quads: what a fragment costs.

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "scene.h"
#include "session.h"

namespace bench {

namespace {

constexpr int kQuads = 8;
constexpr int kTextureSize = 256;

// Texture colours in the quadrants: lower left, lower right, upper left, upper right.
using Quadrants = std::array<Rgb, 4>;
constexpr Quadrants kBase = {{{255, 128, 64}, {64, 255, 128}, {128, 64, 255}, {200, 200, 100}}};
constexpr Quadrants kNormals = {{{128, 128, 255}, {255, 128, 128}, {128, 255, 128}, {201, 128, 201}}};

GLuint makeTexture(const Quadrants& colors) {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{4} * kTextureSize * kTextureSize);
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x) {
      const Rgb& color = colors[std::size_t(2 * (y >= kTextureSize / 2) + (x >= kTextureSize / 2))];
      for (const int channel : color) texels.push_back(std::uint8_t(channel));
      texels.push_back(255);
    }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kTextureSize, kTextureSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  return texture;
}

class FillScene : public Scene {
 public:
  FillScene(std::string name, std::string what, bool textured) : Scene(std::move(name), std::move(what)) {
    textured_ = textured;
  }

  void begin() override {
    static constexpr std::array<float, 8> corners = {0, 0, kWidth, 0, 0, kHeight, kWidth, kHeight};
    static constexpr std::array<float, 8> coordinates = {0, 0, 1, 0, 0, 1, 1, 1};
    setPixelProjection();
    glVertexPointer(2, GL_FLOAT, 0, corners.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
      glClientActiveTexture(unit);
      glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
      if (textured_) glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    glClearColor(0.2f, 0.2f, 0.2f, 1);
    setState();
  }

  void frame(unsigned number) override {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int quad = 0; quad < kQuads; ++quad) {
      setColor(color(number, quad));
      glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
  }

  Verdict check(unsigned number) const override {
    Picture picture;
    for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
      Rgb wanted = {51, 51, 51};
      for (int quad = 0; quad < kQuads; ++quad) wanted = blend(wanted, color(number, quad), quadrant);
      const int left = quadrant % 2 ? kWidth / 2 : 0;
      const int bottom = quadrant / 2 ? kHeight / 2 : 0;
      for (const int step : {20, 150, 300}) picture.expect(left + step, bottom + step, wanted, 2);
    }
    return picture.verdict();
  }

 protected:
  virtual void setState() = 0;
  virtual Rgb color(unsigned number, int quad) const { return variedColor(number * kQuads + unsigned(quad)); }
  virtual void setColor(Rgb color) {
    glColor4f(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, 0.5f);
  }
  virtual Rgb blend(Rgb below, Rgb color, std::size_t quadrant) const = 0;

 private:
  bool textured_;
};

class Blended : public FillScene {
 public:
  Blended() : FillScene("fill.blended", "8 full-screen quads, SRC_ALPHA blending", false) {}

 protected:
  void setState() override {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  Rgb blend(Rgb below, Rgb color, std::size_t) const override {
    for (std::size_t i = 0; i < 3; ++i) below[i] = int(std::lround((below[i] + color[i]) / 2.0));
    return below;
  }
};

// MODULATE; opaque, or halved with what lies below so that no quad can be skipped for the next one.
class Textured : public FillScene {
 public:
  explicit Textured(bool blended)
      : FillScene(blended ? "fill.textured_blended" : "fill.textured",
                  blended ? "8 full-screen bilinear quads, blended" : "8 full-screen bilinear quads, opaque",
                  true),
        blended_(blended) {}

 protected:
  void setState() override {
    makeTexture(kBase);
    glEnable(GL_TEXTURE_2D);
    if (!blended_) return;
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  Rgb blend(Rgb below, Rgb color, std::size_t quadrant) const override {
    for (std::size_t i = 0; i < 3; ++i) {
      const double product = color[i] * kBase[quadrant][i] / 255.0;
      below[i] = int(std::lround(blended_ ? (below[i] + product) / 2 : product));
    }
    return below;
  }

 private:
  bool blended_;
};

// The light vector as primary color, DOT3 with a normal map, times a base texture: bump mapping as ES 1.1
// does it.
class Dot3 : public FillScene {
 public:
  explicit Dot3(bool blended)
      : FillScene(blended ? "fill.dot3_blended" : "fill.dot3",
                  blended ? "8 full-screen quads, DOT3 and a base texture, blended"
                          : "8 full-screen quads, DOT3 and a base texture, opaque",
                  true),
        blended_(blended) {}

 protected:
  void setState() override {
    const GLuint normals = makeTexture(kNormals);
    const GLuint base = makeTexture(kBase);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, base);
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, normals);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
    if (!blended_) return;
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  // Unit vectors between x and z, biased into [0, 1].
  Rgb color(unsigned number, int quad) const override {
    const double angle = 0.3 + 0.1 * ((int(number) + quad) % 8);
    return {int(std::lround(127.5 + 127.5 * std::sin(angle))), 128,
            int(std::lround(127.5 + 127.5 * std::cos(angle)))};
  }
  Rgb blend(Rgb below, Rgb color, std::size_t quadrant) const override {
    double dot = 0;
    for (std::size_t i = 0; i < 3; ++i)
      dot += 4 * (color[i] / 255.0 - 0.5) * (kNormals[quadrant][i] / 255.0 - 0.5);
    dot = std::fmin(std::fmax(dot, 0), 1);
    for (std::size_t i = 0; i < 3; ++i) {
      const double product = dot * kBase[quadrant][i];
      below[i] = int(std::lround(blended_ ? (below[i] + product) / 2 : product));
    }
    return below;
  }

 private:
  bool blended_;
};

}  // namespace

void addFillScenes(Scenes& scenes) {
  scenes.push_back(std::make_unique<Blended>());
  scenes.push_back(std::make_unique<Textured>(false));
  scenes.push_back(std::make_unique<Textured>(true));
  scenes.push_back(std::make_unique<Dot3>(false));
  scenes.push_back(std::make_unique<Dot3>(true));
}

}  // namespace bench
