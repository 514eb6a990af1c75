// Sections 3.7.7-3.7.9: level of detail, automatic mipmaps, completeness.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bitmap.h"
#include "harness.h"

namespace conformance {
namespace {

class Mipmaps : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }
};

constexpr Vec4 kGreen = {0, 1, 0, 1};

// A pyramid whose level k is one colour.
constexpr std::array<GLubyte, 4> kLevels[] = {{255, 0, 0, 255},    {0, 255, 0, 255},   {0, 0, 255, 255},
                                              {255, 255, 0, 255},  {0, 255, 255, 255}, {255, 0, 255, 255},
                                              {255, 255, 255, 255}};

void uploadPyramid(int size) {
  for (int level = 0; size >> level; ++level)
    solid(size >> level, size >> level, kLevels[level]).upload(level);
}

Vec4 levelColor(int level) {
  const auto& c = kLevels[level];
  return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0, c[3] / 255.0};
}

// (3.14), (3.19)-(3.21): the level by lambda for the six minification filters, and the switch to
// magnification.
TEST_F(Mipmaps, MipmapSelection) {
  bindNew();
  uploadPyramid(64);
  Cells cells(64, 64, 8);
  const GLenum minFilters[] = {GL_NEAREST,
                               GL_LINEAR,
                               GL_NEAREST_MIPMAP_NEAREST,
                               GL_LINEAR_MIPMAP_NEAREST,
                               GL_NEAREST_MIPMAP_LINEAR,
                               GL_LINEAR_MIPMAP_LINEAR};
  for (GLenum minFilter : minFilters) {
    for (GLenum magFilter : {GLenum{GL_NEAREST}, GLenum{GL_LINEAR}}) {
      for (double lambda : {-2.0, -0.3, 0.3, 0.8, 1.3, 2.0, 2.7, 3.2, 5.0, 6.0, 9.0}) {
        // 3.7.8: c is 0.5 where LINEAR magnification meets NEAREST_MIPMAP_*.
        const bool half = magFilter == GL_LINEAR &&
                          (minFilter == GL_NEAREST_MIPMAP_NEAREST || minFilter == GL_NEAREST_MIPMAP_LINEAR);
        Vec4 expected = levelColor(0);
        const bool magnified = lambda <= (half ? 0.5 : 0.0);
        double tolerance = 0;
        if (!magnified && (minFilter == GL_NEAREST_MIPMAP_NEAREST || minFilter == GL_LINEAR_MIPMAP_NEAREST)) {
          expected =
              levelColor(lambda <= 0.5 ? 0 : std::min(static_cast<int>(std::ceil(lambda + 0.5)) - 1, 6));
        } else if (!magnified && minFilter != GL_NEAREST && minFilter != GL_LINEAR) {
          const int d = std::min(static_cast<int>(std::floor(lambda)), 6);
          const double f = lambda >= 6 ? 0 : lambda - d;
          for (std::size_t i = 0; i < 4; ++i) {
            expected[i] = (1 - f) * levelColor(d)[i] + f * levelColor(std::min(d + 1, 6))[i];
          }
          tolerance = driverError("level-of-detail") + kOneStep;
        }
        // Mesa has c = 0 always.
        if (onMesa() && half && lambda > 0 && lambda <= 0.5) continue;
        cells.add(
            fmt::format("min {:#x} mag {:#x} lambda {}", minFilter, magFilter, lambda), expected,
            [&] {
              glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
              glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magFilter));
              // 8 pixels over 8 * 2^lambda texels of 64.
              const double side = std::exp2(lambda) * 8 / 64;
              drawTexturedRect({}, 0, 0, side, side);
            },
            tolerance);
      }
    }
  }
}

// 3.7.8: LINEAR magnification reaches to a level of detail of 0.5 where NEAREST_MIPMAP_* minification begins.
TEST_F(Mipmaps, SwitchOverAtHalf) {
  MESA_DISAGREES("3.7.8", "it always switches over at 0");
  bindNew();
  uploadPyramid(64);
  Bitmap stripes(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) std::fill_n(stripes.at(x, y), 4, GLubyte(x % 2 * 255));
  }
  stripes.upload();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (GLenum minFilter : {GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR}) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
    for (double lambda : {-0.4, 0.1, 0.3, 0.45}) {
      const double texels = std::exp2(lambda);
      glClear(GL_COLOR_BUFFER_BIT);
      drawTexturedRect({}, 0, 0, texels, texels);
      for (int x = 0; x < 64; x += 5) {
        // Between the middles of an even texel, which is 0, and an odd one the filter is a ramp.
        const double u = std::fmod((x + 0.5) * texels + 1.5, 2), c = u < 1 ? u : 2 - u;
        EXPECT_PIXEL(x, 32, {c, c, c, c}) << std::hex << minFilter << " at " << lambda;
      }
    }
    drawTexturedRect({}, 0, 0, 2, 2);
    EXPECT_PIXEL(32, 32, levelColor(1)) << std::hex << minFilter;
  }
}

// (3.14): rho is the larger of the two directions.
TEST_F(Mipmaps, AnisotropicScale) {
  bindNew();
  uploadPyramid(64);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  Cells cells(64, 64, 8);
  for (const auto& [s, t, level] :
       {std::array{4.0, 1.0, 2.0}, std::array{1.0, 8.0, 3.0}, std::array{0.25, 2.0, 1.0}}) {
    cells.add(fmt::format("{} x {}", s, t), levelColor(static_cast<int>(level)),
              [&] { drawTexturedRect({}, 0, 0, s / 8, t / 8); });
  }
}

// 3.7.9: what makes a texture incomplete, and that it is then as if the unit were disabled.
TEST_F(Mipmaps, Completeness) {
  Cells cells;
  glColor4f(0, 1, 0, 1);
  const Vec4 red = {1, 0, 0, 1};
  const auto level = [](GLint number, int w, int h) { solid(w, h, {255, 0, 0, 255}).upload(number); };
  const auto begin = [](GLint filter) {
    bindNew();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  };
  const auto draw = [] { drawTexturedRect({}, 0, 0, 1, 1); };
  const auto add = [&](const char* name, bool complete, auto&& specify) {
    cells.add(name, complete ? red : kGreen, [&] {
      specify();
      draw();
    });
  };
  add("no image", false, [&] { begin(GL_NEAREST); });
  add("one level, no mipmap filter", true, [&] {
    begin(GL_NEAREST);
    level(0, 4, 4);
  });
  add("one level, mipmap filter", false, [&] {
    begin(GL_NEAREST_MIPMAP_NEAREST);
    level(0, 4, 4);
  });
  add("the default filter needs mipmaps", false, [&] {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    level(0, 4, 4);
  });
  add("all levels", true, [&] {
    begin(GL_NEAREST_MIPMAP_NEAREST);
    level(0, 4, 2);
    level(1, 2, 1);
    level(2, 1, 1);
  });
  add("1x1 is its own pyramid", true, [&] {
    begin(GL_LINEAR_MIPMAP_LINEAR);
    level(0, 1, 1);
  });
  add("last level missing", false, [&] {
    begin(GL_NEAREST_MIPMAP_NEAREST);
    level(0, 4, 4);
    level(1, 2, 2);
  });
  add("a level of another size", false, [&] {
    begin(GL_LINEAR_MIPMAP_NEAREST);
    level(0, 4, 4);
    level(1, 4, 4);
    level(2, 1, 1);
  });
  add("a level of another format", false, [&] {
    begin(GL_NEAREST_MIPMAP_LINEAR);
    level(0, 4, 4);
    level(1, 2, 2);
    const GLubyte texel[] = {255, 0, 0};
    glTexImage2D(GL_TEXTURE_2D, 2, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
  });
  add("levels before level 0", true, [&] {
    begin(GL_NEAREST_MIPMAP_NEAREST);
    level(2, 1, 1);
    level(1, 2, 2);
    level(0, 4, 4);
  });
  add("level 0 of no size", false, [&] {
    begin(GL_NEAREST);
    level(0, 4, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  });
  add("filter changed after the image", true, [&] {
    begin(GL_NEAREST_MIPMAP_NEAREST);
    level(0, 4, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  });
}

// 3.7.9: an incomplete unit passes the fragment on to the next one.
TEST_F(Mipmaps, IncompleteUnitPassesOn) {
  glColor4f(1, 1, 1, 1);
  bindNew();
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {0, 255, 0, 255});
  drawRect();
  EXPECT_PIXEL(32, 32, kGreen);
}

// 3.7.7: GENERATE_MIPMAP derives every level from changes of level 0, by TexImage, TexSubImage and the
// copies.
TEST_F(Mipmaps, GenerateMipmap) {
  bindNew();
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  Bitmap image(16, 16);
  Vec4 mean{};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const GLubyte texel[] = {GLubyte(x * 16), GLubyte(y * 16), GLubyte((x ^ y) * 16), 255};
      std::copy_n(texel, 4, image.at(x, y));
      for (std::size_t i = 0; i < 4; ++i) mean[i] += texel[i] / 255.0 / 256;
    }
  }
  image.upload();
  // The last level is the mean, whatever filter derives it from what is recommended; four roundings on the
  // way.
  const auto drawLevel4 = [] {
    glViewport(0, 0, 1, 1);
    drawTexturedRect({}, 0, 0, 1, 1);
    glViewport(0, 0, 64, 64);
  };
  drawLevel4();
  EXPECT_PIXEL(0, 0, mean, 3 * kOneStep);
  // Level 1, texel (2, 3): the box of four.
  glViewport(0, 0, 8, 8);
  drawTexturedRect({}, 0, 0, 1, 1);
  Vec4 box{};
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      for (std::size_t c = 0; c < 4; ++c) box[c] += image.color(4 + i, 6 + j)[c] / 4;
    }
  }
  EXPECT_PIXEL(2, 3, box, 1.5 * kOneStep);
  const Bitmap white = solid(16, 16, {255, 255, 255, 255});
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, white.bytes.data());
  drawLevel4();
  EXPECT_PIXEL(0, 0, {1, 1, 1, 1});
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 16, 16);
  drawLevel4();
  EXPECT_PIXEL(0, 0, kGreen);
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 16, 16, 0);
  drawLevel4();
  EXPECT_PIXEL(0, 0, {0, 0, 1, 1});
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
  solid(16, 16, {255, 0, 0, 255}).upload();
  drawLevel4();
  EXPECT_PIXEL(0, 0, {0, 0, 1, 1}) << "derived although it is off";
}

}  // namespace
}  // namespace conformance
