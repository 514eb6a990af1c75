// Many small draws: what a draw costs.

#include <GLES/gl.h>

#include <array>

#include "scene.h"
#include "session.h"

namespace bench {

namespace {

constexpr unsigned kDraws = 5000;
constexpr unsigned kColumns = 100;
constexpr int kCellWidth = 10;
constexpr int kCellHeight = 15;
constexpr Rgb kBackground = {0, 0, 51};
constexpr std::array<float, 6> kTriangle = {0, 0, 6, 0, 0, 6};

int cellX(unsigned cell) {
  return int(cell % kColumns) * kCellWidth + 2;
}
int cellY(unsigned cell) {
  return int(cell / kColumns) * kCellHeight + 2;
}

void clearBackground() {
  glClearColor(0, 0, 0.2f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// A triangle in every cell, in the colour that `color(cell)` names, and nothing between them.
template <typename Color>
Verdict checkCells(Color color) {
  Picture picture;
  for (unsigned cell = 0; cell < kDraws; cell += 7) {
    picture.expect(cellX(cell) + 1, cellY(cell) + 1, color(cell));
    picture.expect(cellX(cell) + 5, cellY(cell) + 5, kBackground);
  }
  return picture.verdict();
}

class ClientColorDraws : public Scene {
 public:
  ClientColorDraws() : Scene("draws.client_color", "5,000 client-array triangles, glColor4f between") {}

  void begin() override {
    setPixelProjection();
    for (unsigned cell = 0; cell < kDraws; ++cell)
      for (unsigned i = 0; i < 6; i += 2) {
        vertices_.push_back(kTriangle[i] + float(cellX(cell)));
        vertices_.push_back(kTriangle[i + 1] + float(cellY(cell)));
      }
    glEnableClientState(GL_VERTEX_ARRAY);
  }

  void frame(unsigned number) override {
    clearBackground();
    for (unsigned cell = 0; cell < kDraws; ++cell) {
      const Rgb color = variedColor(cell + number);
      glColor4f(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, 1);
      glVertexPointer(2, GL_FLOAT, 0, &vertices_[std::size_t{6} * cell]);
      glDrawArrays(GL_TRIANGLES, 0, 3);
    }
  }

  Verdict check(unsigned number) const override {
    return checkCells([number](unsigned cell) { return variedColor(cell + number); });
  }

 private:
  std::vector<float> vertices_;
};

class BufferMatrixDraws : public Scene {
 public:
  BufferMatrixDraws()
      : Scene("draws.buffer_matrix", "5,000 buffer-object triangles, push/translate/pop between") {}

  void begin() override {
    setPixelProjection();
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle.data(), GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
  }

  void frame(unsigned number) override {
    clearBackground();
    const Rgb color = variedColor(number);
    glColor4f(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, 1);
    for (unsigned cell = 0; cell < kDraws; ++cell) {
      glPushMatrix();
      glTranslatef(float(cellX(cell)), float(cellY(cell)), 0);
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glPopMatrix();
    }
  }

  Verdict check(unsigned number) const override {
    return checkCells([number](unsigned) { return variedColor(number); });
  }
};

}  // namespace

void addDrawScenes(Scenes& scenes) {
  scenes.push_back(std::make_unique<ClientColorDraws>());
  scenes.push_back(std::make_unique<BufferMatrixDraws>());
}

}  // namespace bench
