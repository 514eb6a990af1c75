// Frames that change state and data between draws, as programs do.

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "scene.h"
#include "session.h"

namespace bench {

namespace {

void setFilter(GLfloat filter) {
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

std::vector<std::uint8_t> solidTexels(int size, Rgb color) {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{4} * std::size_t(size * size));
  for (int i = 0; i < size * size; ++i) {
    for (const int channel : color) texels.push_back(std::uint8_t(channel));
    texels.push_back(255);
  }
  return texels;
}

void setUnitQuad() {
  static constexpr std::array<float, 8> corners = {0, 0, 1, 0, 0, 1, 1, 1};
  glVertexPointer(2, GL_FLOAT, 0, corners.data());
  glTexCoordPointer(2, GL_FLOAT, 0, corners.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
}

// Every draw binds another texture and toggles blending, every fourth another environment mode.
class ManyStates : public Scene {
 public:
  ManyStates() : Scene("state.many", "1,000 quads, a texture each, blending toggled, environment changed") {}

  void begin() override {
    setPixelProjection();
    setUnitQuad();
    glGenTextures(kTextures, textures_.data());
    for (unsigned i = 0; i < kTextures; ++i) {
      glBindTexture(GL_TEXTURE_2D, textures_[i]);
      setFilter(GL_LINEAR);
      const auto texels = solidTexels(64, variedColor(i));
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    }
    glEnable(GL_TEXTURE_2D);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glColor4f(0.5f, 0.5f, 0.5f, 0.5f);
    glClearColor(0, 0, 0.2f, 1);
  }

  void frame(unsigned number) override {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (unsigned quad = 0; quad < kDraws; ++quad) {
      glBindTexture(GL_TEXTURE_2D, textures_[(quad + number) % kTextures]);
      if (blended(quad)) {
        glEnable(GL_BLEND);
      } else {
        glDisable(GL_BLEND);
      }
      glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, replaces(quad) ? GL_REPLACE : GL_MODULATE);
      glPushMatrix();
      glTranslatef(float(left(quad)), float(bottom(quad)), 0);
      glScalef(kSize, kSize, 1);
      glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
      glPopMatrix();
    }
  }

  Verdict check(unsigned number) const override {
    Picture picture;
    for (unsigned quad = 0; quad < kDraws; ++quad) {
      Rgb wanted = variedColor((quad + number) % kTextures);
      // MODULATE halves color and alpha; the blend weighs by alpha and adds the background.
      double scale = replaces(quad) ? 1 : 0.5;
      if (blended(quad)) scale *= scale;
      for (int& channel : wanted) channel = int(std::lround(channel * scale));
      if (blended(quad)) wanted[2] = std::min(wanted[2] + 51, 255);
      picture.expect(left(quad) + 8, bottom(quad) + 8, wanted, 2);
    }
    return picture.verdict();
  }

 private:
  static constexpr unsigned kDraws = 1000;
  static constexpr unsigned kTextures = 16;
  static constexpr int kSize = 16;
  static bool blended(unsigned quad) { return quad % 2 == 1; }
  static bool replaces(unsigned quad) { return quad / 4 % 2 == 1; }
  static int left(unsigned quad) { return int(quad % 50) * 20; }
  static int bottom(unsigned quad) { return int(quad / 50) * 20; }

  std::array<GLuint, kTextures> textures_{};
};

// A 512x512 RGBA texture given anew each frame, as a whole or as a part of an existing one, and drawn once.
class Upload : public Scene {
 public:
  explicit Upload(bool replacesPart)
      : Scene(replacesPart ? "upload.subimage_512" : "upload.image_512",
              replacesPart ? "glTexSubImage2D 512x512 and a draw" : "glTexImage2D 512x512 and a draw"),
        replacesPart_(replacesPart) {}

  void begin() override {
    setPixelProjection();
    setUnitQuad();
    glScalef(kSize, kSize, 1);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    setFilter(GL_NEAREST);
    for (unsigned i = 0; i < kPictures; ++i) pictures_.push_back(solidTexels(kSize, variedColor(i)));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  }

  void frame(unsigned number) override {
    const void* texels = pictures_[number % kPictures].data();
    if (replacesPart_) {
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    } else {
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }

  Verdict check(unsigned number) const override {
    Picture picture;
    for (const int at : {3, 200, 400, 508}) picture.expect(at, at, variedColor(number % kPictures));
    picture.expect(600, 600, {0, 0, 0});
    return picture.verdict();
  }

 private:
  static constexpr int kSize = 512;
  static constexpr unsigned kPictures = 3;

  bool replacesPart_;
  std::vector<std::vector<std::uint8_t>> pictures_;
};

}  // namespace

void addStateScenes(Scenes& scenes) {
  scenes.push_back(std::make_unique<ManyStates>());
  scenes.push_back(std::make_unique<Upload>(false));
  scenes.push_back(std::make_unique<Upload>(true));
}

void setPixelProjection() {
  glViewport(0, 0, kWidth, kHeight);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrthof(0, kWidth, 0, kHeight, -10, 10);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

Scenes allScenes() {
  Scenes scenes;
  addDrawScenes(scenes);
  addFillScenes(scenes);
  addStateScenes(scenes);
  addSkinningScenes(scenes);
  addTargetScenes(scenes);
  return scenes;
}

}  // namespace bench
