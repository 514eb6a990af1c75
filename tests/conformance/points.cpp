// Section 3.3: points of every size, attenuated, smooth, as sprites, and with a size array.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

#include "harness.h"

namespace conformance {
namespace {

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};

class Points : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glMatrixMode(GL_PROJECTION);
    glOrthof(0, 64, 0, 64, -100, 100);
    glMatrixMode(GL_MODELVIEW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColor4f(0, 1, 0, 1);
    glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range_);
  }
  static void drawPoint(double x, double y, double z = 0) {
    const GLfloat position[] = {static_cast<GLfloat>(x), static_cast<GLfloat>(y), static_cast<GLfloat>(z)};
    glVertexPointer(3, GL_FLOAT, 0, position);
    glDrawArrays(GL_POINTS, 0, 1);
  }
  static void clear() { glClear(GL_COLOR_BUFFER_BIT); }
  struct Box {
    int x0 = 64, y0 = 64, x1 = -1, y1 = -1, count = 0;
    int width() const { return x1 - x0 + 1; }
    int height() const { return y1 - y0 + 1; }
  };
  static Box lit(const Image& image) {
    Box box;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        if (near(image.at(x, y), kBlack, 0)) continue;
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y),
               box.count + 1};
      }
    }
    return box;
  }
  GLfloat range_[2] = {};
};

// 3.3.1: the size is rounded; odd sizes are centred on the pixel, even ones on the nearest grid point.
TEST_F(Points, Sizes) {
  for (double size : {0.3, 1.0, 1.4, 1.6, 2.0, 3.0, 4.0, 5.0, 8.0, 15.0, 16.0, 31.0}) {
    if (size > range_[1]) continue;
    clear();
    glPointSize(static_cast<GLfloat>(size));
    const int expected = std::max(1, static_cast<int>(std::lround(size)));
    // (32.4, 20.3) for odd, near the grid point (32, 20) for even sizes.
    drawPoint(32.4, 20.3);
    const Box box = lit(readAll());
    EXPECT_EQ(box.width(), expected) << size;
    EXPECT_EQ(box.height(), expected) << size;
    EXPECT_EQ(box.count, expected * expected) << size;
    EXPECT_EQ(box.x0, expected % 2 ? 32 - expected / 2 : 32 - expected / 2) << size;
    EXPECT_EQ(box.y0, 20 - expected / 2) << size;
  }
}

// 3.3.1: the square of a point that is neither smooth nor a sprite, by its size and the place of its vertex.
struct Square {
  int x = 0, y = 0, width = 0;
};
Square squareOf(double x, double y, double size) {
  const int width = std::max(1, static_cast<int>(std::floor(size + 0.5)));
  const double half = width % 2 ? 0 : 0.5;
  return {static_cast<int>(std::floor(x + half)) - width / 2,
          static_cast<int>(std::floor(y + half)) - width / 2, width};
}

// 3.3.1: odd sizes are centred on floor(x) + 1/2, even ones on floor(x + 1/2): on exact halves, on pixels'
// edges and anywhere between.
TEST_F(Points, LieOnWholePixels) {
  std::vector<double> fractions = {0, 0.25, 0.5, 0.75, 0.99};
  std::minstd_rand random(7);
  for (int i = 0; i < 4; ++i) fractions.push_back(static_cast<double>(random() % 64) / 64);
  for (double size : {1.0, 2.0, 2.4, 3.0, 4.0, 5.0, 15.0, 16.0}) {
    if (size > range_[1]) continue;
    glPointSize(static_cast<GLfloat>(size));
    for (double fx : fractions) {
      for (double fy : fractions) {
        clear();
        drawPoint(20 + fx, 30 + fy);
        const Box box = lit(readImage(0, 0, 64, 64));
        const Square square = squareOf(20 + fx, 30 + fy, size);
        const std::string what = fmt::format("size {} at ({}, {})", size, 20 + fx, 30 + fy);
        EXPECT_EQ(box.x0, square.x) << what;
        EXPECT_EQ(box.y0, square.y) << what;
        EXPECT_EQ(box.width(), square.width) << what;
        EXPECT_EQ(box.height(), square.width) << what;
        EXPECT_EQ(box.count, square.width * square.width) << what;
      }
    }
  }
}

// 3.3.1: a point for each pixel lights each once, whether it names the pixel's corner or its centre, in
// viewports whose sizes no float divides exactly.
TEST_F(Points, AFullGrid) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4f(0.25f, 0.25f, 0.25f, 1);
  for (const auto& [width, height] : {std::array{64, 64}, std::array{60, 50}, std::array{37, 59}}) {
    for (float offset : {0.0f, 0.5f, 0.9375f}) {
      std::vector<GLfloat> grid;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          grid.push_back(static_cast<GLfloat>(x) + offset);
          grid.push_back(static_cast<GLfloat>(y) + offset);
        }
      }
      glViewport(0, 0, width, height);
      glMatrixMode(GL_PROJECTION);
      glLoadIdentity();
      glOrthof(0, static_cast<GLfloat>(width), 0, static_cast<GLfloat>(height), -1, 1);
      clear();
      glVertexPointer(2, GL_FLOAT, 0, grid.data());
      glDrawArrays(GL_POINTS, 0, width * height);
      const Image image = readAll();
      int wrong = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const double expected = x < width && y < height ? 0.25 : 0;
          wrong += std::abs(image.at(x, y)[0] - expected) > kOneStep;
        }
      }
      EXPECT_EQ(wrong, 0) << width << "x" << height << ", offset " << offset;
    }
  }
}

// 2.11: a point is clipped by its vertex: a big one at the edge stays, and one whose
// centre is outside the clip volume is gone, plain, smooth or a sprite.
TEST_F(Points, ClippedByTheirCenter) {
  if (range_[1] < 16) GTEST_SKIP() << "no points of size 16";
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glPointSize(16);
  struct Row {
    double x, y, z;
    int pixels;
  };
  for (const char* kind : {"plain", "smooth", "sprite"}) {
    const bool smooth = kind == std::string_view("smooth");
    (smooth ? glEnable : glDisable)(GL_POINT_SMOOTH);
    (kind == std::string_view("sprite") ? glEnable : glDisable)(GL_POINT_SPRITE_OES);
    for (const Row& row : {Row{0, 0, 0, 256}, Row{-1, 0, 0, 128}, Row{-1.0625, 0, 0, 0}, Row{1.0625, 0, 0, 0},
                           Row{0, 1.0625, 0, 0}, Row{0, -1.0625, 0, 0}, Row{-1.0625, -1.0625, 0, 0},
                           Row{0, 0, 1.0625, 0}, Row{0, 0, -1.0625, 0}}) {
      clear();
      drawPoint(row.x, row.y, row.z);
      const int pixels = lit(readAll()).count;
      const std::string what = fmt::format("{} at ({}, {}, {})", kind, row.x, row.y, row.z);
      if (smooth)
        EXPECT_EQ(pixels > 0, row.pixels > 0) << what;
      else
        EXPECT_EQ(pixels, row.pixels) << what;
    }
    // In a viewport smaller than the surface, too.
    glViewport(16, 16, 32, 32);
    clear();
    drawPoint(1.125, 0);
    EXPECT_EQ(lit(readAll()).count, 0) << kind;
    glViewport(0, 0, 64, 64);
  }
}

// 3.3: size * sqrt(1 / (a + b d + c d^2)), clamped to [POINT_SIZE_MIN, POINT_SIZE_MAX].
TEST_F(Points, DistanceAttenuation) {
  for (const auto& [a, b, c] :
       {std::array{1.0, 0.0, 0.0}, std::array{0.25, 0.0, 0.0}, std::array{0.0, 0.25, 0.0},
        std::array{0.0, 0.0, 0.0625}, std::array{0.5, 0.1, 0.01}}) {
    for (double distance : {1.0, 4.0, 9.0, 16.0}) {
      const GLfloat attenuation[] = {static_cast<GLfloat>(a), static_cast<GLfloat>(b),
                                     static_cast<GLfloat>(c)};
      glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
      glPointSize(6);
      clear();
      glMatrixMode(GL_PROJECTION);
      glLoadIdentity();
      // The eye's axis through the centre of pixel 32, so that the distance to the eye is that along z.
      glOrthof(-32.5f, 31.5f, -32.5f, 31.5f, -100, 100);
      glMatrixMode(GL_MODELVIEW);
      drawPoint(0, 0, -distance);
      const double size = 6 * std::sqrt(1 / (a + b * distance + c * distance * distance));
      const double clamped = std::min(std::max(size, 1.0), double{range_[1]});
      // Half-way sizes may round either way.
      if (std::abs(clamped - std::floor(clamped) - 0.5) < 0.02) continue;
      EXPECT_EQ(lit(readAll()).width(), static_cast<int>(std::lround(clamped)))
          << a << " " << b << " " << c << " at " << distance;
    }
  }
}

TEST_F(Points, MinAndMaxSize) {
  glPointParameterf(GL_POINT_SIZE_MIN, 5);
  glPointParameterf(GL_POINT_SIZE_MAX, 9);
  for (const auto& [size, expected] : {std::array{1, 5}, std::array{7, 7}, std::array{20, 9}}) {
    clear();
    glPointSize(static_cast<GLfloat>(size));
    drawPoint(32.5, 32.5);
    EXPECT_EQ(lit(readAll()).width(), expected) << size;
  }
}

// OES_point_size_array: a size for every vertex, float and fixed, with strides.
TEST_F(Points, SizeArray) {
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  glPointSize(2);
  const GLfloat positions[] = {10.5f, 10.5f, 30.5f, 10.5f, 50.5f, 10.5f};
  const GLfloat sizes[] = {3, 99, 5, 99, 9, 99};
  const GLfixed fixedSizes[] = {3 * 65536, 5 * 65536, 9 * 65536};
  for (bool fixed : {false, true}) {
    clear();
    glVertexPointer(2, GL_FLOAT, 0, positions);
    if (fixed) {
      glPointSizePointerOES(GL_FIXED, 0, fixedSizes);
    } else {
      glPointSizePointerOES(GL_FLOAT, 8, sizes);
    }
    glDrawArrays(GL_POINTS, 0, 3);
    EXPECT_EQ(lit(readImage(0, 0, 20, 20)).width(), 3) << fixed;
    EXPECT_EQ(lit(readImage(20, 0, 20, 20)).width(), 5) << fixed;
    EXPECT_EQ(lit(readImage(40, 0, 20, 20)).width(), 9) << fixed;
  }
  glDisableClientState(GL_POINT_SIZE_ARRAY_OES);
  clear();
  glDrawArrays(GL_POINTS, 0, 3);
  EXPECT_EQ(lit(readImage(40, 0, 20, 20)).width(), 2);
}

// Sizes that a float cannot be a size by: at least no crash, and the points after them are drawn.
TEST_F(Points, BadSizesInTheArray) {
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  const GLfloat positions[] = {10.5f, 10.5f, 12.5f, 10.5f, 14.5f, 10.5f, 50.5f, 50.5f};
  const GLfloat sizes[] = {0, -4, 1e30f, 5};
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glPointSizePointerOES(GL_FLOAT, 0, sizes);
  glDrawArrays(GL_POINTS, 3, 1);
  EXPECT_PIXEL(50, 50, kGreen);
  glDrawArrays(GL_POINTS, 0, 4);
  EXPECT_PIXEL(50, 50, kGreen);
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    glClear(GL_COLOR_BUFFER_BIT);
    const GLfloat withBad[] = {5, 5, bad, 5};
    glPointSizePointerOES(GL_FLOAT, 0, withBad);
    glDrawArrays(GL_POINTS, 0, 4);
    EXPECT_PIXEL(8, 10, kGreen) << bad;
    EXPECT_PIXEL(50, 52, kGreen) << bad;
  }
}

// 3.3.1: a smooth point covers a disc; alpha is its coverage.
TEST_F(Points, Smooth) {
  glEnable(GL_POINT_SMOOTH);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 1, 1, 1);
  GLfloat range[2] = {};
  glGetFloatv(GL_SMOOTH_POINT_SIZE_RANGE, range);
  for (double size : {1.0, 4.0, 9.0, 20.0}) {
    // Mesa lights three pixels by a smooth point of size 1, whose disc has an area of 0.785.
    if (size > range[1] || (onMesa() && size == 1)) continue;
    clear();
    glPointSize(static_cast<GLfloat>(size));
    drawPoint(32.5, 32.5);
    const Image image = readAll();
    double sum = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) sum += image.at(x, y)[0];
    }
    const double area = std::numbers::pi * size * size / 4;
    EXPECT_NEAR(sum, area, area * 0.15 + 0.5) << size;
    if (size >= 9) {
      EXPECT_TRUE(near(image.at(32, 32), {1, 1, 1, 1}));
      const int corner = 32 + static_cast<int>((size - 1) / 2);
      EXPECT_TRUE(near(image.at(corner, corner), kBlack, 0.05)) << "the corner of the square";
    }
  }
}

class PointsOnSprites : public Points {};

// 3.3.1 (3.1): s and t run over the sprite, t from top to bottom; without COORD_REPLACE the vertex' are used.
TEST_F(PointsOnSprites, Coordinates) {
  const GLubyte texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glPointSize(16);
  drawPoint(32, 32);
  const Vec4 red = {1, 0, 0, 1}, blue = {0, 0, 1, 1}, yellow = {1, 1, 0, 1};
  EXPECT_PIXEL(28, 36, red) << "t = 0 at the top";
  EXPECT_PIXEL(36, 36, kGreen);
  EXPECT_PIXEL(28, 28, blue);
  EXPECT_PIXEL(36, 28, yellow);
  EXPECT_PIXEL(24, 39, red);
  EXPECT_PIXEL(39, 24, yellow);
  EXPECT_PIXEL(40, 32, kBlack);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_FALSE);
  glMultiTexCoord4f(GL_TEXTURE0, 0.75f, 0.25f, 0, 1);
  drawPoint(32, 32);
  EXPECT_PIXEL(28, 28, kGreen);
  glDisable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glMultiTexCoord4f(GL_TEXTURE0, 0.25f, 0.75f, 0, 1);
  drawPoint(32, 32);
  EXPECT_PIXEL(36, 36, blue) << "COORD_REPLACE without POINT_SPRITE";
}

// 3.3.1: s = 1/2 + (x_f + 1/2 - x_w) / size, exact across the sprite, whose size is not rounded.
TEST_F(PointsOnSprites, Interpolation) {
  std::vector<GLubyte> ramp;
  for (int i = 0; i < 256; ++i) ramp.push_back(static_cast<GLubyte>(i));
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 256, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, ramp.data());
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  for (double size : {20.0, 31.5}) {
    if (size > range_[1]) continue;
    clear();
    glPointSize(static_cast<GLfloat>(size));
    drawPoint(32, 32);
    for (int x = 24; x < 40; x += 3) {
      const double s = 0.5 + (x + 0.5 - 32) / size;
      EXPECT_PIXEL(x, 32,
                   {std::floor(s * 256) / 255, std::floor(s * 256) / 255, std::floor(s * 256) / 255, 1})
          << size << " at " << x;
    }
  }
}

// 3.3: smooth points are none while they are sprites.
TEST_F(PointsOnSprites, AreSquaresWhenSmooth) {
  glEnable(GL_POINT_SPRITE_OES);
  glEnable(GL_POINT_SMOOTH);
  glPointSize(16);
  drawPoint(32, 32);
  const Image image = readAll();
  EXPECT_EQ(lit(image).count, 256);
  EXPECT_TRUE(near(image.at(24, 24), kGreen, 0)) << "a corner";
}

// 3.3: COORD_REPLACE for each unit by itself.
TEST_F(PointsOnSprites, PerUnit) {
  const GLubyte texels[] = {255, 255, 255, 255, 0, 0, 0, 255};
  for (GLenum unit : {0u, 1u}) {
    glActiveTexture(GL_TEXTURE0 + unit);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, unit == 1);
  }
  glEnable(GL_POINT_SPRITE_OES);
  glMultiTexCoord4f(GL_TEXTURE0, 0.25f, 0.5f, 0, 1);
  glPointSize(16);
  drawPoint(32, 32);
  EXPECT_PIXEL(28, 32, kGreen);
  EXPECT_PIXEL(36, 32, {0, 0, 0, 1});
}

}  // namespace
}  // namespace conformance
