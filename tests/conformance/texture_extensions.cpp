// OES_texture_mirrored_repeat, OES_texture_env_crossbar, EXT_texture_lod_bias, APPLE_texture_max_level,
// EXT_texture_filter_anisotropic.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "extension_commands.h"

namespace conformance {
namespace {

class TextureExtensions : public GlTest {};

using Texel = std::array<std::uint8_t, 4>;
constexpr Texel kRow[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}};
constexpr Texel kLevels[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};

Vec4 colorOf(const Texel& t) {
  return {t[0] / 255.0, t[1] / 255.0, t[2] / 255.0, t[3] / 255.0};
}

void upload(GLint level, int size, const Texel& texel) {
  const std::vector<Texel> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), texel);
  glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

// Levels 8, 4, 2 and 1, each of one color.
void uploadPyramid() {
  for (GLint level = 0; level < 4; ++level) upload(level, 8 >> level, kLevels[level]);
}

// (3.13): the coordinate itself where its floor is even, mirrored where it is odd.
double mirrored(double s) {
  const double whole = std::floor(s);
  return std::fmod(whole, 2) == 0 ? s - whole : 1 - (s - whole);
}

TEST_F(TextureExtensions, MirroredRepeat) {
  NEEDS_EXTENSION("GL_OES_texture_mirrored_repeat");
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {});
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kRow);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT_OES);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT_OES);
  GLint mode = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &mode);
  EXPECT_EQ(mode, GL_MIRRORED_REPEAT_OES);
  Cells cells;
  for (int eighth = -25; eighth < 26; eighth += 2) {
    const double s = eighth / 8.0;
    const Texel& texel = kRow[std::min(static_cast<int>(mirrored(s) * 4), 3)];
    cells.add(fmt::format("NEAREST {}", s), colorOf(texel), [&] { drawTexturedRect({}, s, 0.5, s, 0.5); });
  }
  // At whole coordinates the mirror image meets the image: both neighbours are the same texel.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (int s = -3; s < 4; ++s) {
    cells.add(fmt::format("LINEAR {}", s), colorOf(kRow[s % 2 == 0 ? 0 : 3]),
              [&] { drawTexturedRect({}, s, 0.5, s, 0.5); });
  }
  cells.check();
}

// Unit 1 multiplies what units 0 and 2 sampled.
TEST_F(TextureExtensions, Crossbar) {
  NEEDS_EXTENSION("GL_OES_texture_env_crossbar");
  const Texel texels[] = {{200, 100, 50, 255}, {10, 20, 30, 40}, {100, 200, 250, 128}};
  for (unsigned unit = 0; unit < 3; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glEnable(GL_TEXTURE_2D);
    solidTexture(GL_RGBA, texels[unit]);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
  }
  glActiveTexture(GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE2);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_TEXTURE2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  GLint source = 0;
  glGetTexEnviv(GL_TEXTURE_ENV, GL_SRC1_RGB, &source);
  EXPECT_EQ(source, GL_TEXTURE2);

  glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
  Vec4 expected{};
  for (std::size_t i = 0; i < 3; ++i) expected[i] = colorOf(texels[0])[i] * colorOf(texels[2])[i];
  expected[3] = 128 / 255.0;
  drawRect();
  EXPECT_PIXEL(32, 32, expected);

  // Its own name is another word for TEXTURE.
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE1);
  for (std::size_t i = 0; i < 3; ++i) expected[i] = colorOf(texels[1])[i] * colorOf(texels[2])[i];
  drawRect();
  EXPECT_PIXEL(32, 32, expected);

  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0 + units);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// ARB_texture_env_crossbar: a unit that reads one that is off is off itself.
TEST_F(TextureExtensions, CrossbarOfAUnitThatIsOff) {
  NEEDS_EXTENSION("GL_OES_texture_env_crossbar");
  MESA_DISAGREES("OES_texture_env_crossbar", "a disabled unit reads as white");
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {0, 0, 255, 255});
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE1);
  glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
  drawRect();
  EXPECT_PIXEL(32, 32, {0.2, 0.4, 0.6, 0.8});
}

// Each bias of 1 is a level more.
TEST_F(TextureExtensions, LodBias) {
  NEEDS_EXTENSION("GL_EXT_texture_lod_bias");
  GLfloat most = 0;
  glGetFloatv(GL_MAX_TEXTURE_LOD_BIAS_EXT, &most);
  EXPECT_GE(most, 4);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {});
  uploadPyramid();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  // Twice as many texels as pixels: lambda is 1 without a bias.
  const auto draw = [&] { drawTexturedRect({}, 0, 0, 16, 16); };
  for (const auto& [bias, level] :
       {std::pair{0.0f, 1}, {1.0f, 2}, {-1.0f, 0}, {2.0f, 3}, {3.0f, 3}, {-5.0f, 0}}) {
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, bias);
    GLfloat got = 100;
    glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, &got);
    EXPECT_EQ(got, bias);
    draw();
    EXPECT_PIXEL(32, 32, colorOf(kLevels[level])) << "bias " << bias;
  }
  // Between two levels.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
  glTexEnvx(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, 0x4000);
  draw();
  EXPECT_PIXEL(32, 32, {0, 0.75, 0.25, 1});
  EXPECT_GL_ERROR(GL_NO_ERROR);

  glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS_EXT, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

TEST_F(TextureExtensions, MaxLevel) {
  NEEDS_EXTENSION("GL_APPLE_texture_max_level");
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {});
  GLint level = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, &level);
  EXPECT_EQ(level, 1000);
  // Levels beyond the maximum need not be there.
  upload(0, 8, kLevels[0]);
  upload(1, 4, kLevels[1]);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const auto draw = [&] { drawTexturedRect({}, 0, 0, 64, 64); };  // lambda is 3
  glColor4f(1, 1, 1, 1);
  draw();
  EXPECT_PIXEL(32, 32, {1, 1, 1, 1});  // not complete
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 1);
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[1]));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 0);
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[0]));
  upload(2, 2, kLevels[2]);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 2);
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[2]));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 1000);
  upload(3, 1, kLevels[3]);
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[3]));
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, -1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

// A texture seen at a slant that is 16 texels in one direction and 1 in the other: levels of lambda 4 without
// anisotropy, of lambda near 0 with it.
TEST_F(TextureExtensions, Anisotropy) {
  if (!hasExtension("GL_EXT_texture_filter_anisotropic")) GTEST_SKIP() << "the device has none";
  GLfloat most = 0;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
  EXPECT_GE(most, 2);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {});
  uploadPyramid();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const auto draw = [&] { drawTexturedRect({}, 0, 0, 16, 8); };  // 2 texels and 1 a pixel
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[1]), 0.1);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 2);
  draw();
  EXPECT_PIXEL(32, 32, colorOf(kLevels[0]), 0.1);
  GLfloat anisotropy = 0;
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &anisotropy);
  EXPECT_EQ(anisotropy, 2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (const GLfloat bad : {0.5f, 0.0f, -1.0f}) {
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, bad);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
}

}  // namespace
}  // namespace conformance
