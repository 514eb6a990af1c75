// ATI_texture_mirror_once, EXT_texture_mirror_clamp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ati.h"
#include "bitmap.h"
#include "extension_commands.h"

namespace conformance {
namespace {

class WrapExtensions : public GlTest {};

constexpr GLenum kModes[] = {GL_MIRROR_CLAMP_ATI, GL_MIRROR_CLAMP_TO_EDGE_ATI, GL_MIRROR_CLAMP_TO_BORDER_EXT};
constexpr double kCoordinates[] = {0,      0.01, -0.01, 0.3,   -0.3,   0.7, -0.7, 0.93, -0.93, 0.985,
                                   -0.985, 1.02, -1.02, 1.045, -1.045, 1.2, -1.2, 3.7,  -3.7,  1000};

void setParameter(GLenum name, GLenum value) {
  glTexParameterx(GL_TEXTURE_2D, name, static_cast<GLfixed>(value));
}

// EXT_texture_mirror_clamp, section 3.8.7, then section 3.7.7 along one axis of N texels; the border is 0.
Vec4 expected(const Bitmap& image, double f, GLenum mode, bool linear) {
  const int n = image.width;
  const double half = 0.5 / n, away = std::max(half, std::abs(f));
  const double most = mode == GL_MIRROR_CLAMP_ATI           ? 1
                      : mode == GL_MIRROR_CLAMP_TO_EDGE_ATI ? 1 - half
                                                            : 1 + half;
  const double u = std::min(most, away) * n;
  const auto texel = [&](int i) { return i >= 0 && i < n ? image.color(i, 0) : Vec4{0, 0, 0, 0}; };
  if (!linear) {
    // Without a filter 1 is the last texel (section 3.7.7), unless the mode clamps beyond it.
    const int i = static_cast<int>(std::floor(u));
    return texel(mode == GL_MIRROR_CLAMP_ATI ? std::min(i, n - 1) : i);
  }
  const double below = std::floor(u - 0.5), weight = u - 0.5 - below;
  const Vec4 a = texel(static_cast<int>(below)), b = texel(static_cast<int>(below) + 1);
  Vec4 v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = a[i] * (1 - weight) + b[i] * weight;
  return v;
}

TEST_F(WrapExtensions, MirroredAndClampedOnce) {
  NEEDS_EXTENSION("GL_ATI_texture_mirror_once");
  NEEDS_EXTENSION("GL_EXT_texture_mirror_clamp");
  const Bitmap image = noise(8, 1);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glEnable(GL_TEXTURE_2D);
  glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  image.upload();
  setParameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  Cells cells;
  for (GLenum mode : kModes)
    for (GLenum filter : {GL_NEAREST, GL_LINEAR})
      for (double f : kCoordinates)
        // Filter weights have 8 bits.
        cells.add(
            fmt::format("mode {:#x} filter {:#x} s {}", mode, filter, f),
            expected(image, f, mode, filter == GL_LINEAR),
            [&] {
              setParameter(GL_TEXTURE_WRAP_S, mode);
              setParameter(GL_TEXTURE_MIN_FILTER, static_cast<GLenum>(filter));
              setParameter(GL_TEXTURE_MAG_FILTER, static_cast<GLenum>(filter));
              drawTexturedRect({}, f, 0.5, f, 0.5);
            },
            filter == GL_LINEAR ? 2 * kOneStep : kOneStep);
}

// Both axes; and no dark line along the mirror on small mip levels.
TEST_F(WrapExtensions, MirrorOnSmallLevels) {
  NEEDS_EXTENSION("GL_EXT_texture_mirror_clamp");
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glEnable(GL_TEXTURE_2D);
  glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  setParameter(GL_GENERATE_MIPMAP, GL_TRUE);
  const std::vector<GLubyte> white(64 * 64 * 4, 255);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  setParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  setParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (GLenum mode : kModes) {
    setParameter(GL_TEXTURE_WRAP_S, mode);
    setParameter(GL_TEXTURE_WRAP_T, mode);
    glClear(GL_COLOR_BUFFER_BIT);
    drawTexturedRect({}, -8, -8, 8, 8);
    for (int x = 28; x < 36; ++x) EXPECT_PIXEL(x, 32, (Vec4{1, 1, 1, 1}));
    const bool border = mode == GL_MIRROR_CLAMP_TO_BORDER_EXT;
    EXPECT_PIXEL(4, 60,
                 border                        ? Vec4{0, 0, 0, 0}
                 : mode == GL_MIRROR_CLAMP_ATI ? Vec4{0.25, 0.25, 0.25, 0.25}
                                               : Vec4{1, 1, 1, 1});
  }
}

TEST_F(WrapExtensions, ModesAreQueriedAndChecked) {
  NEEDS_EXTENSION("GL_ATI_texture_mirror_once");
  for (GLenum mode : kModes)
    for (GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      setParameter(static_cast<GLenum>(name), mode);
      GLint value = 0;
      glGetTexParameteriv(GL_TEXTURE_2D, static_cast<GLenum>(name), &value);
      EXPECT_EQ(value, static_cast<GLint>(mode));
    }
  EXPECT_GL_ERROR(GL_NO_ERROR);
  setParameter(GL_TEXTURE_WRAP_S, 0x8741);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

}  // namespace
}  // namespace conformance
