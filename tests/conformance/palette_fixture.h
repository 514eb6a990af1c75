// What the chapters on OES_matrix_palette share: its commands, and quads whose vertices choose from the
// palette.
#pragma once

#include <algorithm>
#include <cmath>

#include "extension_commands.h"
#include "reference_math.h"

namespace conformance {

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};
constexpr GLfloat kFull[] = {-1, -1, 1, -1, -1, 1, 1, 1};
constexpr GLfloat kHalf[] = {-0.5f, -0.5f, 0.5f, -0.5f, -0.5f, 0.5f, 0.5f, 0.5f};

inline GLint get(GLenum name) {
  GLint value = -1;
  glGetIntegerv(name, &value);
  return value;
}

inline std::array<GLfloat, 16> floats(const Mat4& matrix) {
  std::array<GLfloat, 16> result;
  std::transform(matrix.m.begin(), matrix.m.end(), result.begin(),
                 [](double v) { return static_cast<GLfloat>(v); });
  return result;
}

// What a vertex chooses.
struct Choice {
  GLubyte index;
  double weight;
};
using Choices = std::vector<Choice>;

class PaletteFixture : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_OES_matrix_palette");
    NEEDS_EXTENSION("GL_OES_extended_matrix_palette");
    currentPaletteMatrix = command<PFNGLCURRENTPALETTEMATRIXOESPROC>("glCurrentPaletteMatrixOES");
    loadFromModelView =
        command<PFNGLLOADPALETTEFROMMODELVIEWMATRIXOESPROC>("glLoadPaletteFromModelViewMatrixOES");
    matrixIndexPointer = command<PFNGLMATRIXINDEXPOINTEROESPROC>("glMatrixIndexPointerOES");
    weightPointer = command<PFNGLWEIGHTPOINTEROESPROC>("glWeightPointerOES");
    queryMatrix = command<PFNGLQUERYMATRIXXOESPROC>("glQueryMatrixxOES");
    ASSERT_TRUE(currentPaletteMatrix && loadFromModelView && matrixIndexPointer && weightPointer &&
                queryMatrix);
    glColor4f(0, 1, 0, 1);
  }

  void setMatrix(GLuint index, const Mat4& matrix) {
    GLint mode = get(GL_MATRIX_MODE);
    glMatrixMode(GL_MATRIX_PALETTE_OES);
    currentPaletteMatrix(index);
    glLoadMatrixf(floats(matrix).data());
    glMatrixMode(static_cast<GLenum>(mode));
  }

  // The current matrix, of whatever mode.
  Mat4 current() const {
    GLfixed mantissa[16];
    GLint exponent[16];
    EXPECT_EQ(queryMatrix(mantissa, exponent), 0u);
    Mat4 result;
    for (std::size_t i = 0; i < 16; ++i) result.m[i] = std::ldexp(mantissa[i] / 65536.0, exponent[i]);
    return result;
  }

  // Four vertices of a strip, every one with the same choices.
  void drawChosen(const Choices& choices, const GLfloat* corners = kFull) {
    indices_.clear();
    weights_.clear();
    for (int vertex = 0; vertex < 4; ++vertex) {
      for (const Choice& choice : choices) {
        indices_.push_back(choice.index);
        weights_.push_back(static_cast<GLfloat>(choice.weight));
      }
    }
    const auto size = static_cast<GLint>(choices.size());
    matrixIndexPointer(size, GL_UNSIGNED_BYTE, 0, indices_.data());
    weightPointer(size, GL_FLOAT, 0, weights_.data());
    drawEnabled(corners);
  }

  // The arrays as they are.
  void drawEnabled(const GLfloat* corners) {
    glEnable(GL_MATRIX_PALETTE_OES);
    for (GLenum array : kArrays) glEnableClientState(array);
    glVertexPointer(2, GL_FLOAT, 0, corners);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    for (GLenum array : kArrays) glDisableClientState(array);
    glDisable(GL_MATRIX_PALETTE_OES);
  }

  // Green inside the rectangle in normalised device coordinates, black outside; edges lie between pixel
  // centres.
  void expectRect(double x0, double y0, double x1, double y1, const std::string& what) {
    const Image image = readAll();
    int wrong = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        const double u = (x + 0.5) / 32 - 1, v = (y + 0.5) / 32 - 1;
        const bool inside = u > x0 && u < x1 && v > y0 && v < y1;
        wrong += !near(image.at(x, y), inside ? kGreen : kBlack);
      }
    }
    EXPECT_EQ(wrong, 0) << what;
    glClear(GL_COLOR_BUFFER_BIT);
  }

  static constexpr GLenum kArrays[] = {GL_VERTEX_ARRAY, GL_MATRIX_INDEX_ARRAY_OES, GL_WEIGHT_ARRAY_OES};
  PFNGLCURRENTPALETTEMATRIXOESPROC currentPaletteMatrix = nullptr;
  PFNGLLOADPALETTEFROMMODELVIEWMATRIXOESPROC loadFromModelView = nullptr;
  PFNGLMATRIXINDEXPOINTEROESPROC matrixIndexPointer = nullptr;
  PFNGLWEIGHTPOINTEROESPROC weightPointer = nullptr;
  PFNGLQUERYMATRIXXOESPROC queryMatrix = nullptr;

 private:
  std::vector<GLubyte> indices_;
  std::vector<GLfloat> weights_;
};

}  // namespace conformance
