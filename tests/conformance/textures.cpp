// Sections 3.6 and 3.7: formats and types, unpacking, wrap modes, filters, objects, copies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bitmap.h"
#include "harness.h"

namespace conformance {
namespace {

class Textures : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }
};

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};

int wrapped(GLenum mode, int i, int size) {
  if (mode == GL_REPEAT) return ((i % size) + size) % size;
  return std::clamp(i, 0, size - 1);
}

// 3.7.7 and 3.7.8 on one level: NEAREST and LINEAR under the wrap modes of 3.7.6.
Vec4 sampled(const Bitmap& image, double s, double t, GLenum filter, GLenum wrapS, GLenum wrapT) {
  const double u = s * image.width, v = t * image.height;
  if (filter == GL_NEAREST) {
    return image.color(wrapped(wrapS, static_cast<int>(std::floor(u)), image.width),
                       wrapped(wrapT, static_cast<int>(std::floor(v)), image.height));
  }
  const int i = static_cast<int>(std::floor(u - 0.5)), j = static_cast<int>(std::floor(v - 0.5));
  const double a = u - 0.5 - i, b = v - 0.5 - j;
  Vec4 result{};
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const Vec4 texel =
          image.color(wrapped(wrapS, i + di, image.width), wrapped(wrapT, j + dj, image.height));
      for (std::size_t c = 0; c < 4; ++c) result[c] += (di ? a : 1 - a) * (dj ? b : 1 - b) * texel[c];
    }
  }
  return result;
}

// 3.7.1, Tables 3.4 and 3.8: every format and type, read back through the sampler. 5 and 4 bits are c / (2^n
// - 1).
TEST_F(Textures, EveryFormatAndType) {
  const struct {
    const char* name;
    GLenum format, type;
    std::vector<GLubyte> bytes;
    Vec4 expected;
  } rows[] = {
      {"RGBA ubyte",
       GL_RGBA,
       GL_UNSIGNED_BYTE,
       {10, 120, 200, 77},
       {10 / 255.0, 120 / 255.0, 200 / 255.0, 77 / 255.0}},
      {"RGB ubyte", GL_RGB, GL_UNSIGNED_BYTE, {10, 120, 200}, {10 / 255.0, 120 / 255.0, 200 / 255.0, 0.5}},
      {"L", GL_LUMINANCE, GL_UNSIGNED_BYTE, {99}, {99 / 255.0, 99 / 255.0, 99 / 255.0, 0.5}},
      {"LA",
       GL_LUMINANCE_ALPHA,
       GL_UNSIGNED_BYTE,
       {99, 33},
       {99 / 255.0, 99 / 255.0, 99 / 255.0, 33 / 255.0}},
      {"A", GL_ALPHA, GL_UNSIGNED_BYTE, {42}, {0.2, 0.4, 0.6, 42 / 255.0}},
      {"RGB 565", GL_RGB, GL_UNSIGNED_SHORT_5_6_5, {0x4d, 0xb3}, {22 / 31.0, 26 / 63.0, 13 / 31.0, 0.5}},
      {"RGBA 4444",
       GL_RGBA,
       GL_UNSIGNED_SHORT_4_4_4_4,
       {0xb3, 0x71},
       {7 / 15.0, 1 / 15.0, 11 / 15.0, 3 / 15.0}},
      {"RGBA 5551 opaque",
       GL_RGBA,
       GL_UNSIGNED_SHORT_5_5_5_1,
       {0x4d, 0xb3},
       {22 / 31.0, 13 / 31.0, 6 / 31.0, 1}},
      {"RGBA 5551 clear",
       GL_RGBA,
       GL_UNSIGNED_SHORT_5_5_5_1,
       {0x4c, 0xb3},
       {22 / 31.0, 13 / 31.0, 6 / 31.0, 0}},
  };
  glColor4f(0.2f, 0.4f, 0.6f, 0.5f);
  Cells cells;
  for (const auto& row : rows) {
    cells.add(row.name, row.expected, [&] {
      bindNew();
      glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(row.format), 1, 1, 0, row.format, row.type,
                   row.bytes.data());
      drawTexturedRect({}, 0, 0, 1, 1);
    });
  }
}

struct PixelFormat {
  GLenum format, type;
  int bytes;
};
constexpr PixelFormat kPixelFormats[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, 4},          {GL_RGB, GL_UNSIGNED_BYTE, 3},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2}, {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2},
    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
    {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},     {GL_ALPHA, GL_UNSIGNED_BYTE, 1}};

// (3.11): rows start at multiples of the alignment. The last texel of the last row is lit, the padding is
// not.
TEST_F(Textures, UnpackAlignment) {
  Cells cells;
  glColor4f(0, 0, 0, 0);
  for (const PixelFormat& format : kPixelFormats) {
    for (int alignment : {1, 2, 4, 8}) {
      for (int width : {1, 2, 4, 8}) {
        const int row = (width * format.bytes + alignment - 1) / alignment * alignment;
        std::vector<GLubyte> data(
            static_cast<std::size_t>(row) + static_cast<std::size_t>(width * format.bytes), 0);
        std::fill(data.end() - format.bytes, data.end(), GLubyte{255});
        Vec4 expected = {1, 1, 1, 1};
        if (format.format == GL_ALPHA) expected = {0, 0, 0, 1};
        if (format.format == GL_RGB || format.format == GL_LUMINANCE) expected[3] = 0;
        for (bool sub : {false, true}) {
          cells.add(fmt::format("format {:#x} type {:#x} alignment {} width {} sub {}", format.format,
                                format.type, alignment, width, sub),
                    expected, [&] {
                      bindNew();
                      glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
                      const GLint internal = static_cast<GLint>(format.format);
                      glTexImage2D(GL_TEXTURE_2D, 0, internal, width, 2, 0, format.format, format.type,
                                   sub ? nullptr : data.data());
                      if (sub) {
                        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, 2, format.format, format.type,
                                        data.data());
                      }
                      const double s = (width - 0.5) / width;
                      drawTexturedRect({}, s, 0.75, s, 0.75);
                    });
        }
      }
    }
  }
}

// 3.7.1: the first row is the lower one, sizes of every power of two, and not square.
TEST_F(Textures, SizesAndOrientation) {
  for (const auto& [w, h] : {std::array{1, 1}, std::array{2, 1}, std::array{1, 4}, std::array{8, 2},
                             std::array{16, 16}, std::array{64, 8}, std::array{1, 64}, std::array{64, 64}}) {
    const Bitmap image = noise(w, h);
    bindNew();
    image.upload();
    drawTexturedRect({}, 0, 0, 1, 1);
    const Image result = readAll();
    int wrong = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) wrong += !near(result.at(x, y), image.color(x * w / 64, y * h / 64), 0);
    }
    EXPECT_EQ(wrong, 0) << w << "x" << h;
  }
}

// 3.7.2
TEST_F(Textures, SubImage) {
  Bitmap image = noise(16, 16);
  bindNew();
  image.upload();
  const struct {
    int x, y, w, h;
  } boxes[] = {{0, 0, 1, 1}, {15, 15, 1, 1}, {3, 5, 7, 4}, {0, 8, 16, 2}, {8, 0, 3, 16}, {5, 5, 0, 3}};
  GLubyte value = 40;
  for (const auto& box : boxes) {
    std::vector<GLubyte> patch(static_cast<std::size_t>(box.w * box.h) * 4);
    for (GLubyte& byte : patch) byte = value = static_cast<GLubyte>(value + 37);
    glTexSubImage2D(GL_TEXTURE_2D, 0, box.x, box.y, box.w, box.h, GL_RGBA, GL_UNSIGNED_BYTE, patch.data());
    for (int j = 0; j < box.h; ++j) {
      for (int i = 0; i < box.w; ++i)
        std::copy_n(patch.data() + (j * box.w + i) * 4, 4, image.at(box.x + i, box.y + j));
    }
    // Drawn in between: a subimage after use must not touch what was drawn before.
    drawTexturedRect({}, 0, 0, 1, 1);
  }
  const Image result = readAll();
  int wrong = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) wrong += !near(result.at(x, y), image.color(x / 4, y / 4), 0);
  }
  EXPECT_EQ(wrong, 0);
}

// 2.1: an image respecified or deleted after a draw; the draw keeps what it used.
TEST_F(Textures, ChangedWhileInUse) {
  GLuint name = bindNew();
  const auto drawAt = [](int x) {
    glViewport(x, 0, 16, 64);
    drawTexturedRect({}, 0, 0, 1, 1);
  };
  solid(4, 4, {255, 0, 0, 255}).upload();
  drawAt(0);
  const Bitmap green = solid(4, 4, {0, 255, 0, 255});
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, green.bytes.data());
  drawAt(16);
  solid(8, 2, {0, 0, 255, 255}).upload();
  drawAt(32);
  glDeleteTextures(1, &name);
  glColor4f(1, 1, 0, 1);
  drawAt(48);
  EXPECT_PIXEL(8, 32, {1, 0, 0, 1});
  EXPECT_PIXEL(24, 32, {0, 1, 0, 1});
  EXPECT_PIXEL(40, 32, {0, 0, 1, 1});
  // Texture 0 is bound now and has no image: as if texturing were disabled (3.7.1).
  EXPECT_PIXEL(56, 32, {1, 1, 0, 1});
}

// 3.7.6-3.7.8: both filters under every pair of wrap modes, coordinates far outside [0, 1].
TEST_F(Textures, WrapAndFilter) {
  const Bitmap image = noise(4, 8);
  bindNew();
  image.upload();
  for (GLenum filter : {GLenum{GL_NEAREST}, GLenum{GL_LINEAR}}) {
    for (GLenum wrapS : {GLenum{GL_REPEAT}, GLenum{GL_CLAMP_TO_EDGE}}) {
      for (GLenum wrapT : {GLenum{GL_REPEAT}, GLenum{GL_CLAMP_TO_EDGE}}) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapS));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrapT));
        drawTexturedRect({}, -1.5, -0.75, 2.5, 1.25);
        const Image result = readAll();
        int wrong = 0;
        for (int y = 0; y < 64; ++y) {
          for (int x = 0; x < 64; ++x) {
            const double s = -1.5 + 4 * (x + 0.5) / 64, t = -0.75 + 2 * (y + 0.5) / 64;
            const double tolerance =
                filter == GL_NEAREST ? 0 : std::max(kOneStep, driverError("filter-weights"));
            wrong += !near(result.at(x, y), sampled(image, s, t, filter, wrapS, wrapT), tolerance);
          }
        }
        EXPECT_EQ(wrong, 0) << std::hex << filter << " " << wrapS << " " << wrapT;
      }
    }
  }
}

// 3.7.2, Table 3.9: from an RGBA framebuffer to every format.
TEST_F(Textures, CopyTexImage) {
  const Bitmap pattern = noise(64, 64);
  bindNew();
  pattern.upload();
  drawTexturedRect({}, 0, 0, 1, 1);
  const struct {
    GLenum format;
    bool color, alpha, luminance;
  } rows[] = {{GL_ALPHA, false, true, false},
              {GL_LUMINANCE, true, false, true},
              {GL_LUMINANCE_ALPHA, true, true, true},
              {GL_RGB, true, false, false},
              {GL_RGBA, true, true, false}};
  std::vector<GLuint> names;
  for (const auto& row : rows) {
    names.push_back(bindNew());
    glCopyTexImage2D(GL_TEXTURE_2D, 0, row.format, 8, 16, 32, 16, 0);
    EXPECT_GL_ERROR(GL_NO_ERROR) << row.format;
  }
  glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
  for (std::size_t i = 0; i < names.size(); ++i) {
    glBindTexture(GL_TEXTURE_2D, names[i]);
    glViewport(0, 0, 32, 16);
    drawTexturedRect({}, 0, 0, 1, 1);
    const Image result = readAll();
    int wrong = 0;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 32; ++x) {
        const Vec4 source = pattern.color(x + 8, y + 16);
        Vec4 expected = {0.2, 0.4, 0.6, 0.8};
        for (std::size_t c = 0; c < 3 && rows[i].color; ++c)
          expected[c] = rows[i].luminance ? source[0] : source[c];
        if (rows[i].alpha) expected[3] = source[3];
        wrong += !near(result.at(x, y), expected);
      }
    }
    EXPECT_EQ(wrong, 0) << std::hex << rows[i].format;
  }
}

// 3.7.2: a copy into a part of an image; what lies outside the framebuffer is undefined, what lies inside is
// not.
TEST_F(Textures, CopyTexSubImage) {
  const Bitmap pattern = noise(64, 64);
  bindNew();
  pattern.upload();
  drawTexturedRect({}, 0, 0, 1, 1);
  Bitmap expected = solid(16, 16, {1, 2, 3, 4});
  bindNew();
  expected.upload();
  const struct {
    int toX, toY, x, y, w, h;
  } copies[] = {{0, 0, 5, 6, 4, 4}, {8, 4, 60, 60, 4, 4}, {3, 9, 0, 0, 13, 7}, {4, 4, 1, 1, 0, 5}};
  for (const auto& copy : copies) {
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, copy.toX, copy.toY, copy.x, copy.y, copy.w, copy.h);
    for (int j = 0; j < copy.h; ++j) {
      for (int i = 0; i < copy.w; ++i) {
        const GLubyte* from = pattern.bytes.data() + ((copy.y + j) * 64 + copy.x + i) * 4;
        std::copy_n(from, 4, expected.at(copy.toX + i, copy.toY + j));
      }
    }
  }
  // The pixels of this one that have a source.
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 12, 0, -2, -2, 4, 4);
  for (int j = 2; j < 4; ++j) {
    for (int i = 2; i < 4; ++i)
      std::copy_n(pattern.bytes.data() + ((j - 2) * 64 + i - 2) * 4, 4, expected.at(12 + i, j));
  }
  drawTexturedRect({}, 0, 0, 1, 1);
  const Image result = readAll();
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      if (x >= 12 && y < 4 && (x < 14 || y < 2)) continue;
      EXPECT_TRUE(near(result.at(x * 4 + 1, y * 4 + 1), expected.color(x, y))) << x << " " << y;
    }
  }
}

// A copy of what has just been drawn, then drawn with: the framebuffer is complete before it is read (2.1).
TEST_F(Textures, CopyThenDraw) {
  bindNew();
  const Bitmap empty = solid(64, 64, {0, 0, 0, 0});
  empty.upload();
  for (int i = 0; i < 6; ++i) {
    glDisable(GL_TEXTURE_2D);
    glColor4ub(GLubyte(40 * i), GLubyte(255 - 40 * i), 100, 255);
    drawRect({-1, -1, 0, 1});
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 32, 64);
    glEnable(GL_TEXTURE_2D);
    drawTexturedRect({0, -1, 1, 1}, 0, 0, 0.5, 1);
    EXPECT_PIXEL(48, 32, {40 * i / 255.0, (255 - 40 * i) / 255.0, 100 / 255.0, 1}) << i;
  }
}

// 3.7.11: objects keep their own images and parameters; two units may share one.
TEST_F(Textures, Objects) {
  const GLuint red = solidTexture(GL_RGBA, {255, 0, 0, 255}), green = solidTexture(GL_RGBA, {0, 255, 0, 255});
  glBindTexture(GL_TEXTURE_2D, red);
  drawRect({-1, -1, 0, 1});
  glBindTexture(GL_TEXTURE_2D, green);
  drawRect({0, -1, 1, 1});
  EXPECT_PIXEL(16, 32, {1, 0, 0, 1});
  EXPECT_PIXEL(48, 32, kGreen);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, red);
  GLint wrap = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
  EXPECT_EQ(wrap, GL_REPEAT);
  // The same object on unit 1, changed there.
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, red);
  const GLubyte half[] = {128, 128, 128, 255};
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, half);
  drawRect();
  EXPECT_PIXEL(32, 32, {128 * 128 / 65025.0, 128 * 128 / 65025.0, 128 * 128 / 65025.0, 1});
  // Deleting it unbinds it from both units (3.7.11).
  glDeleteTextures(1, &red);
  glColor4f(0, 0, 1, 1);
  drawRect();
  EXPECT_PIXEL(32, 32, {0, 0, 1, 1});
}

// 3.7.11: texture 0 is a texture like the others.
TEST_F(Textures, TextureZero) {
  glBindTexture(GL_TEXTURE_2D, 0);
  useNearest();
  solid(2, 2, {0, 255, 0, 255}).upload();
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kGreen);
  bindNew();
  glBindTexture(GL_TEXTURE_2D, 0);
  drawTexturedRect({0, 0, 1, 1}, 0, 0, 1, 1);
  EXPECT_PIXEL(48, 48, kGreen);
}

// (3.6): texture coordinates are perspective-correct, q divides per fragment.
TEST_F(Textures, Perspective) {
  const Bitmap image = noise(8, 8);
  bindNew();
  image.upload();
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  // A parallelogram in clip space with w of 1 on the left and 3 on the right.
  const GLfloat positions[] = {-1, -1, 0, 1, 3, -1, 0, 3, -1, 1, 0, 1, 3, 1, 0, 3};
  const GLfloat coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
  glVertexPointer(4, GL_FLOAT, 0, positions);
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  const Image result = readAll();
  int wrong = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double ndcX = (x + 0.5) / 32 - 1, ndcY = (y + 0.5) / 32 - 1;
      const double s = (ndcX + 1) / (4 - 2 * ndcX), t = (ndcY * (1 + 2 * s) + 1) / 2;
      const bool inside = t > 0 && t < 1;
      const double column = s * 8, row = t * 8;
      if (std::abs(column - std::round(column)) < 0.02 || std::abs(row - std::round(row)) < 0.02) continue;
      wrong += !near(result.at(x, y),
                     inside ? image.color(static_cast<int>(column), static_cast<int>(row)) : kBlack, 0);
    }
  }
  EXPECT_EQ(wrong, 0);
}

// 3.7.1: the largest texture works up to its last texel.
TEST_F(Textures, LargestSize) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  bindNew();
  std::vector<GLubyte> row(static_cast<std::size_t>(most), 10);
  row.back() = 250;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, most, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, row.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const double last = 1 - 0.5 / most;
  drawTexturedRect({}, last, 0, last, 0);
  EXPECT_PIXEL(32, 32, {250 / 255.0, 250 / 255.0, 250 / 255.0, 1});
}

// OES_texture_npot: any size, with every wrap mode and filter, and mip levels that halve downwards.
TEST_F(Textures, SizesThatAreNoPowerOfTwo) {
  if (!hasExtension("GL_OES_texture_npot")) GTEST_SKIP() << "no GL_OES_texture_npot";
  for (const auto& [w, h] : {std::array{3, 5}, std::array{1, 7}, std::array{33, 12}, std::array{63, 63}}) {
    const Bitmap image = noise(w, h);
    bindNew();
    image.upload();
    for (GLenum wrap : {GLenum{GL_REPEAT}, GLenum{GL_CLAMP_TO_EDGE}}) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
      drawTexturedRect({}, -0.5, -0.25, 1.5, 1.75);
      const Image result = readAll();
      int wrong = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const double s = -0.5 + 2 * (x + 0.5) / 64, t = -0.25 + 2 * (y + 0.5) / 64;
          const double u = s * w, v = t * h;
          if (std::abs(u - std::round(u)) < 0.01 || std::abs(v - std::round(v)) < 0.01) continue;
          wrong += !near(result.at(x, y), sampled(image, s, t, GL_NEAREST, wrap, wrap), 0);
        }
      }
      EXPECT_EQ(wrong, 0) << w << "x" << h << " " << std::hex << wrap;
    }
  }
  // 5x3, 2x1, 1x1 is a whole pyramid.
  bindNew();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  solid(5, 3, {0, 255, 0, 255}).upload(0);
  solid(2, 1, {0, 255, 0, 255}).upload(1);
  solid(1, 1, {0, 255, 0, 255}).upload(2);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, kGreen);
}

class TexturesOn565 : public GlTest {
 protected:
  TexturesOn565() : GlTest({64, 64, 5, 6, 5, 0, 24, 8, 0}) {}
};

// 3.7.2, Table 3.9: components cannot be added to what an RGB framebuffer has.
TEST_F(TexturesOn565, CopyTexImageNeedsTheComponents) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  for (GLenum format : {GL_RGB, GL_LUMINANCE}) {
    glCopyTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(format), 0, 0, 8, 8, 0);
    EXPECT_GL_ERROR(GL_NO_ERROR) << std::hex << format;
  }
  for (GLenum format : {GL_RGBA, GL_ALPHA, GL_LUMINANCE_ALPHA}) {
    glCopyTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(format), 0, 0, 8, 8, 0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION) << std::hex << format;
  }
}

}  // namespace
}  // namespace conformance
