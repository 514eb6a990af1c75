// Section 2.10.2: every matrix command against float64, the stacks, and what a matrix does to a vertex
// (2.10, 2.10.1).
#include <fmt/format.h>

#include <functional>
#include <random>

#include "harness.h"
#include "reference_math.h"

namespace conformance {
namespace {

class Matrices : public GlTest {
 protected:
  // 2.1.1: individual operations are accurate to about 1 part in 10^5; ours are float64, rounded once.
  static double tolerance() { return onMesa() ? 1e-5 : 2e-7; }

  static void expectMatrix(GLenum name, const Mat4& expected, const std::string& what) {
    GLfloat actual[16];
    glGetFloatv(name, actual);
    double largest = 0;
    for (double value : expected.m) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_NEAR(actual[i], expected.m[i], tolerance() * std::max(largest, 1e-30))
          << what << ", element " << i;
    }
  }
  static GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
  }
};

struct Stack {
  GLenum mode, matrix, depth, most;
};
constexpr Stack kStacks[] = {
    {GL_MODELVIEW, GL_MODELVIEW_MATRIX, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH},
    {GL_PROJECTION, GL_PROJECTION_MATRIX, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH},
    {GL_TEXTURE, GL_TEXTURE_MATRIX, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH}};

struct Operation {
  std::string name;
  std::function<void()> call;
  Mat4 expected;
};

GLfixed fixed(double value) {
  return static_cast<GLfixed>(std::lround(value * 65536));
}

std::vector<Operation> operations() {
  std::vector<Operation> list;
  for (const auto& [x, y, z] :
       {std::array{1.5, -2.25, 3.0}, std::array{0.0, 0.0, 0.0}, std::array{-100.5, 0.25, 7.0}}) {
    const auto fx = static_cast<GLfloat>(x), fy = static_cast<GLfloat>(y), fz = static_cast<GLfloat>(z);
    list.push_back({"Translatef", [=] { glTranslatef(fx, fy, fz); }, translation(x, y, z)});
    list.push_back({"Translatex", [=] { glTranslatex(fixed(x), fixed(y), fixed(z)); }, translation(x, y, z)});
    list.push_back({"Scalef", [=] { glScalef(fx, fy, fz); }, scaling(x, y, z)});
    list.push_back({"Scalex", [=] { glScalex(fixed(x), fixed(y), fixed(z)); }, scaling(x, y, z)});
  }
  for (double angle : {0.0, 30.0, 45.0, 90.0, 180.0, 270.0, 360.0, -77.5, 721.0}) {
    for (const auto& [x, y, z] :
         {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, 0.0, -1.0},
          std::array{1.0, 2.0, -2.0}, std::array{0.0, 3.0, 4.0}}) {
      const auto fa = static_cast<GLfloat>(angle), fx = static_cast<GLfloat>(x), fy = static_cast<GLfloat>(y),
                 fz = static_cast<GLfloat>(z);
      const std::string what = fmt::format("({}; {}, {}, {})", angle, x, y, z);
      list.push_back({"Rotatef" + what, [=] { glRotatef(fa, fx, fy, fz); }, rotation(angle, x, y, z)});
      list.push_back({"Rotatex" + what, [=] { glRotatex(fixed(angle), fixed(x), fixed(y), fixed(z)); },
                      rotation(angle, x, y, z)});
    }
  }
  list.push_back(
      {"Frustumf", [] { glFrustumf(-1, 2, -0.5f, 1.5f, 1, 100); }, frustum(-1, 2, -0.5, 1.5, 1, 100)});
  list.push_back(
      {"Frustumf flipped", [] { glFrustumf(2, -1, 1.5f, -0.5f, 10, 1); }, frustum(2, -1, 1.5, -0.5, 10, 1)});
  list.push_back({"Frustumx", [] { glFrustumx(-65536, 131072, -32768, 98304, 65536, 6553600); },
                  frustum(-1, 2, -0.5, 1.5, 1, 100)});
  list.push_back({"Orthof", [] { glOrthof(-3, 5, -7, 11, -13, 17); }, ortho(-3, 5, -7, 11, -13, 17)});
  list.push_back({"Orthox",
                  [] { glOrthox(-3 * 65536, 5 * 65536, -7 * 65536, 11 * 65536, -13 * 65536, 17 * 65536); },
                  ortho(-3, 5, -7, 11, -13, 17)});
  Mat4 any;
  GLfloat values[16];
  GLfixed fixedValues[16];
  for (std::size_t i = 0; i < 16; ++i) {
    any.m[i] = (static_cast<double>(i) - 6.5) / 4;
    values[i] = static_cast<GLfloat>(any.m[i]);
    fixedValues[i] = fixed(any.m[i]);
  }
  list.push_back({"MultMatrixf", [=] { glMultMatrixf(values); }, any});
  list.push_back({"MultMatrixx", [=] { glMultMatrixx(fixedValues); }, any});
  return list;
}

// 2.10.2: each command multiplies the current matrix from the right, in every mode.
TEST_F(Matrices, EveryCommand) {
  Mat4 start;
  GLfloat startValues[16];
  for (std::size_t i = 0; i < 16; ++i) {
    start.m[i] = static_cast<double>(i % 5) - 2 + (i % 4 == i / 4 ? 3 : 0);
    startValues[i] = static_cast<GLfloat>(start.m[i]);
  }
  for (const Stack& stack : kStacks) {
    glMatrixMode(stack.mode);
    for (const Operation& operation : operations()) {
      glLoadIdentity();
      operation.call();
      expectMatrix(stack.matrix, operation.expected, operation.name);
      glLoadMatrixf(startValues);
      operation.call();
      expectMatrix(stack.matrix, start * operation.expected, operation.name + " on a matrix");
    }
  }
}

TEST_F(Matrices, Load) {
  GLfloat values[16];
  GLfixed fixedValues[16];
  for (int i = 0; i < 16; ++i) {
    values[i] = static_cast<GLfloat>(i) * 0.3f - 2;
    fixedValues[i] = i * 10000 - 80000;
  }
  for (const Stack& stack : kStacks) {
    glMatrixMode(stack.mode);
    GLfloat actual[16];
    glLoadMatrixf(values);
    glGetFloatv(stack.matrix, actual);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(actual[i], values[i]) << i;
    glLoadMatrixx(fixedValues);
    glGetFloatv(stack.matrix, actual);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(actual[i], static_cast<GLfloat>(fixedValues[i]) / 65536) << i;
    GLfixed back[16];
    glGetFixedv(stack.matrix, back);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(back[i], fixedValues[i]) << i;
    glLoadIdentity();
    expectMatrix(stack.matrix, Mat4{}, "LoadIdentity");
  }
}

// 2.10.2: push duplicates, pop restores, the depth counts.
TEST_F(Matrices, Stacks) {
  for (const Stack& stack : kStacks) {
    glMatrixMode(stack.mode);
    const GLint most = integer(stack.most);
    for (GLint depth = 1; depth < most; ++depth) {
      EXPECT_EQ(integer(stack.depth), depth);
      glTranslatef(1, 0, 0);
      glPushMatrix();
    }
    EXPECT_EQ(integer(stack.depth), most);
    for (GLint depth = most - 1; depth >= 1; --depth) {
      glTranslatef(100, 100, 100);
      glPopMatrix();
      expectMatrix(stack.matrix, translation(depth, 0, 0), fmt::format("depth {}", depth));
    }
    EXPECT_EQ(integer(stack.depth), 1);
  }
}

// 2.10.2: a texture matrix stack for every unit.
TEST_F(Matrices, TextureStacksAreSeparate) {
  glMatrixMode(GL_TEXTURE);
  const GLint units = integer(GL_MAX_TEXTURE_UNITS);
  for (GLint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glTranslatef(static_cast<GLfloat>(unit), 0, 0);
    if (unit % 2) glPushMatrix();
  }
  for (GLint unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    expectMatrix(GL_TEXTURE_MATRIX, translation(unit, 0, 0), fmt::format("unit {}", unit));
    EXPECT_EQ(integer(GL_TEXTURE_STACK_DEPTH), unit % 2 + 1);
  }
}

// 2.10: projection * modelview * vertex, then the viewport.
TEST_F(Matrices, VertexTransform) {
  glMatrixMode(GL_PROJECTION);
  glFrustumf(-1, 1, -1, 1, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -2);
  glRotatef(90, 0, 0, 1);
  glTranslatef(1, 0, 0);
  glColor4f(0, 1, 0, 1);
  // The centre goes to (0, 1, -2): half way up. Its half side of 0.5 becomes a quarter of the viewport's.
  drawRect({-0.5, -0.5, 0.5, 0.5});
  const Image image = readAll();
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const double ndcX = (x + 0.5) / 32 - 1, ndcY = (y + 0.5) / 32 - 1;
      const bool inside = std::abs(ndcX) < 0.25 && std::abs(ndcY - 0.5) < 0.25;
      ASSERT_TRUE(near(image.at(x, y), inside ? Vec4{0, 1, 0, 1} : Vec4{0, 0, 0, 0})) << x << " " << y;
    }
  }
}

// 2.10.1: the viewport places and sizes; nothing outside it is drawn.
TEST_F(Matrices, Viewport) {
  glColor4f(0, 1, 0, 1);
  glViewport(10, 20, 7, 5);
  drawRect({-3, -3, 3, 3});
  const Image image = readAll();
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const bool inside = x >= 10 && x < 17 && y >= 20 && y < 25;
      ASSERT_TRUE(near(image.at(x, y), inside ? Vec4{0, 1, 0, 1} : Vec4{0, 0, 0, 0})) << x << " " << y;
    }
  }
}

// 2.10.1: a viewport that leaves the framebuffer on every side.
TEST_F(Matrices, ViewportBeyondTheFramebuffer) {
  glColor4f(0, 1, 0, 1);
  glViewport(-64, -128, 192, 256);
  // [0, 48) x [-32, 32) in window coordinates.
  drawRect({-1.0 / 3, -0.25, 1.0 / 6, 0.25});
  EXPECT_PIXEL(0, 0, {0, 1, 0, 1});
  EXPECT_PIXEL(47, 31, {0, 1, 0, 1});
  EXPECT_PIXEL(48, 31, {0, 0, 0, 0});
  EXPECT_PIXEL(47, 32, {0, 0, 0, 0});
}

// 2.10.1: depth range, n < f, n = f and n > f.
TEST_F(Matrices, DepthRange) {
  glEnable(GL_DEPTH_TEST);
  const struct { float n, f; } ranges[] = {{0, 1}, {0.25f, 0.75f}, {0.5f, 0.5f}, {1, 0}, {0.875f, 0.125f}};
  Cells cells;
  for (const auto& range : ranges) {
    glDepthRangef(range.n, range.f);
    for (double z : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double depth = range.n + (range.f - range.n) * (z + 1) / 2;
      for (double side : {-1e-4, 1e-4}) {
        const double against = depth + side;
        if (against < 0 || against > 1) continue;
        glClearDepthf(static_cast<GLfloat>(against));
        const Vec4 expected = depth < against ? Vec4{1, 1, 1, 1} : Vec4{0, 0, 0, 0};
        cells.add(fmt::format("range {} {}, z {}, against {}", range.n, range.f, z, against), expected, [&] {
          glClear(GL_DEPTH_BUFFER_BIT);
          drawRect({-2, -2, 2, 2, z});
        });
      }
    }
  }
}

// 2.10.2, 2.10.3, 3.7: the texture matrix is applied to (s, t, r, q).
TEST_F(Matrices, TextureMatrix) {
  std::vector<GLubyte> texels;
  for (int t = 0; t < 8; ++t) {
    for (int s = 0; s < 8; ++s) texels.insert(texels.end(), {GLubyte(s * 36), GLubyte(t * 36), 0, 255});
  }
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glMatrixMode(GL_TEXTURE);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.3, 1.0);
  Cells cells;
  for (int i = 0; i < 100; ++i) {
    Mat4 matrix;
    GLfloat values[16];
    for (std::size_t k = 0; k < 16; ++k) values[k] = static_cast<GLfloat>(uniform(random));
    for (std::size_t k = 0; k < 16; ++k) matrix.m[k] = values[k];
    glLoadMatrixf(values);
    const GLfloat coordinates[] = {
        static_cast<GLfloat>(uniform(random)), static_cast<GLfloat>(uniform(random)),
        static_cast<GLfloat>(uniform(random)), static_cast<GLfloat>(uniform(random))};
    const Vec4 result = matrix * Vec4{coordinates[0], coordinates[1], coordinates[2], coordinates[3]};
    const double s = result[0] / result[3] * 8, t = result[1] / result[3] * 8;
    // A coordinate on the edge of two texels says nothing.
    if (std::abs(s - std::round(s)) < 0.01 || std::abs(t - std::round(t)) < 0.01) continue;
    const int column = static_cast<int>(std::floor(s)) & 7, row = static_cast<int>(std::floor(t)) & 7;
    cells.add(fmt::format("matrix {}", i), {column * 36 / 255.0, row * 36 / 255.0, 0, 1}, [&] {
      glMultiTexCoord4f(GL_TEXTURE0, coordinates[0], coordinates[1], coordinates[2], coordinates[3]);
      drawRect();
    });
  }
}

// 10^5 rotations: the drift of the product stays that of float64.
TEST_F(Matrices, LongProducts) {
  MESA_DISAGREES("2.1.1", "matrices are kept in float32");
  Mat4 expected;
  const Mat4 step = rotation(0.7f, 1, 2, 3);
  for (int i = 0; i < 100000; ++i) {
    glRotatef(0.7f, 1, 2, 3);
    expected = expected * step;
  }
  expectMatrix(GL_MODELVIEW_MATRIX, expected, "100000 rotations");
}

}  // namespace
}  // namespace conformance
