// OES_texture_3D's commands in ES 1.1, and EXT_texture_storage's of three dimensions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "environment_reference.h"
#include "extension_commands.h"

// <GLES/glext.h> lacks the extension: the registry's numbers.
#ifndef GL_TEXTURE_3D_OES
#define GL_TEXTURE_3D_OES 0x806F
#define GL_TEXTURE_WRAP_R_OES 0x8072
#define GL_MAX_3D_TEXTURE_SIZE_OES 0x8073
#define GL_TEXTURE_BINDING_3D_OES 0x806A
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_3D_ZOFFSET_OES 0x8CD4
#endif

namespace conformance {
namespace {

using TexImage3D = void(GL_APIENTRYP)(GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum,
                                      const void*);
using TexSubImage3D = void(GL_APIENTRYP)(GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei,
                                         GLenum, GLenum, const void*);
using CopyTexSubImage3D = void(GL_APIENTRYP)(GLenum, GLint, GLint, GLint, GLint, GLint, GLint, GLsizei,
                                             GLsizei);
using CompressedTexImage3D = void(GL_APIENTRYP)(GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint,
                                                GLsizei, const void*);
using CompressedTexSubImage3D = void(GL_APIENTRYP)(GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei,
                                                   GLsizei, GLenum, GLsizei, const void*);
using FramebufferTexture3D = void(GL_APIENTRYP)(GLenum, GLenum, GLenum, GLuint, GLint, GLint);

class VolumeTextures : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_OES_texture_3D");
    image_ = command<TexImage3D>("glTexImage3DOES");
    subImage_ = command<TexSubImage3D>("glTexSubImage3DOES");
    ASSERT_NE(image_, nullptr);
    ASSERT_NE(subImage_, nullptr);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_3D_OES, name);
    glEnable(GL_TEXTURE_3D_OES);
    useNearest(GL_TEXTURE_3D_OES);
    glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  }

  TexImage3D image_ = nullptr;
  TexSubImage3D subImage_ = nullptr;
};

// Texels that tell where they are.
struct Volume {
  int width, height, depth;
  std::vector<GLubyte> bytes;

  Volume(int w, int h, int d) : width(w), height(h), depth(d) {
    unsigned state = 99;
    bytes.resize(static_cast<std::size_t>(w * h * d) * 4);
    for (GLubyte& byte : bytes) byte = static_cast<GLubyte>((state = state * 1664525u + 1013904223u) >> 24);
  }
  GLubyte* at(int x, int y, int z) {
    return bytes.data() + (static_cast<std::size_t>(z * height + y) * width + x) * 4;
  }
  Vec4 color(int x, int y, int z) {
    const GLubyte* t = at(x, y, z);
    return {t[0] / 255.0, t[1] / 255.0, t[2] / 255.0, t[3] / 255.0};
  }
};

// The viewport, with the one coordinate everywhere.
void drawAt(double s, double t, double r, double q = 1) {
  glMultiTexCoord4f(GL_TEXTURE0, static_cast<GLfloat>(s), static_cast<GLfloat>(t), static_cast<GLfloat>(r),
                    static_cast<GLfloat>(q));
  drawRect();
}

void expectTexels(Volume& volume, const char* what) {
  Cells cells;
  for (int z = 0; z < volume.depth; ++z)
    for (int y = 0; y < volume.height; ++y)
      for (int x = 0; x < volume.width; ++x)
        cells.add(fmt::format("{} texel {} {} {}", what, x, y, z), volume.color(x, y, z), [&] {
          drawAt((x + 0.5) / volume.width, (y + 0.5) / volume.height, (z + 0.5) / volume.depth);
        });
}

TEST_F(VolumeTextures, ImagesAndTheirParts) {
  Volume volume(4, 3, 5);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 4, 3, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const auto change = [&](int x, int y, int z, int w, int h, int d, GLubyte value) {
    const std::vector<GLubyte> part(static_cast<std::size_t>(w * h * d) * 4, value);
    subImage_(GL_TEXTURE_3D_OES, 0, x, y, z, w, h, d, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    for (int k = z; k < z + d; ++k)
      for (int j = y; j < y + h; ++j)
        for (int i = x; i < x + w; ++i) std::fill_n(volume.at(i, j, k), 4, value);
  };
  change(1, 1, 2, 2, 2, 3, 40);
  expectTexels(volume, "before it is used");
  change(0, 0, 0, 4, 3, 1, 90);
  change(3, 2, 4, 1, 1, 1, 200);
  expectTexels(volume, "after it was used");
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Section 3.6.2: rows are aligned, slices follow without gaps; every format.
TEST_F(VolumeTextures, AlignedRowsOfEveryFormat) {
  const struct {
    GLenum format, type;
    int bytes;
  } kFormats[] = {{GL_RGB, GL_UNSIGNED_BYTE, 3},
                  {GL_ALPHA, GL_UNSIGNED_BYTE, 1},
                  {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
                  {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2}};
  glColor4f(0, 0, 0, 0);
  Cells cells;
  for (const auto& format : kFormats)
    for (int alignment : {1, 4, 8}) {
      const int row = (3 * format.bytes + alignment - 1) / alignment * alignment;
      std::vector<GLubyte> data(static_cast<std::size_t>(row * 2 * 2), 0);
      // The last texel of the last slice.
      std::fill_n(data.begin() + row * 3 + 2 * format.bytes, format.bytes, GLubyte{255});
      Vec4 expected = {1, 1, 1, 1};
      if (format.format == GL_ALPHA) expected = {0, 0, 0, 1};
      if (format.format == GL_RGB) expected[3] = 0;
      cells.add(fmt::format("format {:#x} type {:#x} alignment {}", format.format, format.type, alignment),
                expected, [&] {
                  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
                  image_(GL_TEXTURE_3D_OES, 0, format.format, 3, 2, 2, 0, format.format, format.type,
                         data.data());
                  drawAt(0.9, 0.9, 0.9);
                });
    }
}

// Section 3.7.7 with a third axis: the eight texels about a coordinate, wrapped along r as along s and t.
TEST_F(VolumeTextures, LinearFilterAndWrapOfR) {
  Volume volume(2, 2, 4);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 2, 2, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  const auto wrapped = [](int i, int n, GLenum mode) {
    if (mode == GL_CLAMP_TO_EDGE) return std::clamp(i, 0, n - 1);
    const int period = mode == GL_REPEAT ? n : 2 * n;
    const int at = ((i % period) + period) % period;
    return at < n ? at : 2 * n - 1 - at;
  };
  Cells cells;
  for (GLenum mode : {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT_OES})
    for (double r : {-1.3, -0.2, 0.0, 0.31, 0.5, 0.9, 1.05, 2.6}) {
      const double s = 0.4, t = 0.55;
      const double u = s * 2 - 0.5, v = t * 2 - 0.5, w = r * 4 - 0.5;
      Vec4 expected{};
      for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const auto weight = [](double at, int upper) {
          const double fraction = at - std::floor(at);
          return upper ? fraction : 1 - fraction;
        };
        const Vec4 texel =
            volume.color(std::clamp(static_cast<int>(std::floor(u)) + dx, 0, 1),
                         std::clamp(static_cast<int>(std::floor(v)) + dy, 0, 1),
                         wrapped(static_cast<int>(std::floor(w)) + dz, 4, static_cast<GLenum>(mode)));
        for (std::size_t i = 0; i < 4; ++i)
          expected[i] += texel[i] * weight(u, dx) * weight(v, dy) * weight(w, dz);
      }
      cells.add(
          fmt::format("wrap {:#x} r {}", mode, r), expected,
          [&] {
            glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_R_OES, static_cast<GLfixed>(mode));
            drawAt(s, t, r);
          },
          2 * kOneStep);
    }
}

// Section 2.10.2: r and q through the texture matrix, divided by q; the environment as for any texture.
TEST_F(VolumeTextures, MatrixAndEnvironment) {
  Volume volume(4, 4, 4);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.25f, 0, 0.5f);
  Cells cells;
  cells.add("translated", volume.color(1, 2, 3), [] { drawAt(0.1, 0.6, 0.3); });
  cells.add("divided", volume.color(1, 0, 2), [] { drawAt(0.2, 0.4, 0.4, 2); });
  glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glColor4f(0.5f, 0.25f, 1, 0.75f);
  const Vec4 texel = volume.color(1, 2, 3);
  cells.add("modulated", {texel[0] * 0.5, texel[1] * 0.25, texel[2], texel[3] * 0.75},
            [] { drawAt(0.1, 0.6, 0.3); });
  cells.check();
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

// Before TEXTURE_2D, after cube maps; a texture that is not complete switches its unit off.
TEST_F(VolumeTextures, PriorityAndCompleteness) {
  const GLubyte green[4] = {0, 255, 0, 255};
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, green);
  glEnable(GL_TEXTURE_2D);
  solidTexture(GL_RGBA, {255, 0, 0, 255});
  drawRect();
  EXPECT_PIXEL(32, 32, (Vec4{0, 1, 0, 1}));
  glColor4f(0, 0, 1, 1);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 2, 2, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  drawRect();
  EXPECT_PIXEL(32, 32, (Vec4{0, 0, 1, 1}));
  const std::vector<GLubyte> level1(1 * 1 * 2 * 4, 255);
  image_(GL_TEXTURE_3D_OES, 1, GL_RGBA, 1, 1, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, level1.data());
  drawRect();
  EXPECT_PIXEL(32, 32, (Vec4{0, 0, 1, 1}));
  image_(GL_TEXTURE_3D_OES, 2, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, green);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  drawTexturedRect({}, 0, 0, 64 * 4, 64 * 4);
  EXPECT_PIXEL(32, 32, (Vec4{0, 1, 0, 1}));
}

// Section 3.7.8: a derived level is the mean of eight texels.
TEST_F(VolumeTextures, GeneratedLevels) {
  Volume volume(2, 2, 2);
  Vec4 mean{};
  for (int i = 0; i < 8; ++i)
    for (std::size_t k = 0; k < 4; ++k) mean[k] += volume.color(i & 1, i >> 1 & 1, i >> 2)[k] / 8;
  glTexParameterx(GL_TEXTURE_3D_OES, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  drawTexturedRect({}, 0, 0, 64, 64);
  EXPECT_PIXEL(32, 32, mean);
}

// CopyTexSubImage3DOES, FramebufferTexture3DOES: a slice from and as the framebuffer.
TEST_F(VolumeTextures, SlicesAndFramebuffers) {
  const auto copy = command<CopyTexSubImage3D>("glCopyTexSubImage3DOES");
  const auto attach = command<FramebufferTexture3D>("glFramebufferTexture3DOES");
  COMMAND(PFNGLGENFRAMEBUFFERSOESPROC, GenFramebuffersOES);
  COMMAND(PFNGLBINDFRAMEBUFFEROESPROC, BindFramebufferOES);
  COMMAND(PFNGLCHECKFRAMEBUFFERSTATUSOESPROC, CheckFramebufferStatusOES);
  COMMAND(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC, GetFramebufferAttachmentParameterivOES);
  Volume volume(4, 4, 3);
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 4, 4, 3, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  copy(GL_TEXTURE_3D_OES, 0, 1, 1, 1, 0, 0, 2, 2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int y = 1; y < 3; ++y)
    for (int x = 1; x < 3; ++x) {
      const GLubyte red[4] = {255, 0, 0, 255};
      std::copy_n(red, 4, volume.at(x, y, 1));
    }
  expectTexels(volume, "copied");

  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_3D_OES, &name);
  GLuint framebuffer = 0;
  GenFramebuffersOES(1, &framebuffer);
  BindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_3D_OES, static_cast<GLuint>(name), 0, 2);
  GLint slice = -1;
  GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES,
                                         GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_3D_ZOFFSET_OES, &slice);
  EXPECT_EQ(slice, 2);
  ASSERT_EQ(CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_PIXEL(1, 1, (Vec4{0, 1, 0, 1}));
  attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_3D_OES, static_cast<GLuint>(name), 0, 3);
  EXPECT_NE(CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const GLubyte green[4] = {0, 255, 0, 255};
      std::copy_n(green, 4, volume.at(x, y, 2));
    }
  expectTexels(volume, "drawn to");
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// EXT_texture_storage with three dimensions.
TEST_F(VolumeTextures, ImmutableStorage) {
  NEEDS_EXTENSION("GL_EXT_texture_storage");
  COMMAND(PFNGLTEXSTORAGE3DEXTPROC, TexStorage3DEXT);
  Volume volume(4, 2, 2);
  TexStorage3DEXT(GL_TEXTURE_3D_OES, 4, GL_RGBA8_OES, 4, 2, 2);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // three levels at most
  TexStorage3DEXT(GL_TEXTURE_2D, 1, GL_RGBA8_OES, 4, 2, 2);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  TexStorage3DEXT(GL_TEXTURE_3D_OES, 1, GL_RGBA8_OES, 4, 2, 0);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  TexStorage3DEXT(GL_TEXTURE_3D_OES, 1, GL_RGBA8_OES, 4, 2, 2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  subImage_(GL_TEXTURE_3D_OES, 0, 0, 0, 0, 4, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, volume.bytes.data());
  expectTexels(volume, "immutable");
  image_(GL_TEXTURE_3D_OES, 0, GL_RGBA, 4, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST_F(VolumeTextures, StateIsQueried) {
  GLint value = -1;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE_OES, &value);
  EXPECT_GE(value, 16);
  glGetTexParameteriv(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_R_OES, &value);
  EXPECT_EQ(value, GL_REPEAT);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_R_OES, GL_CLAMP_TO_EDGE);
  glGetTexParameteriv(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_R_OES, &value);
  EXPECT_EQ(value, GL_CLAMP_TO_EDGE);
  glTexParameterx(GL_TEXTURE_3D_OES, GL_TEXTURE_WRAP_R_OES, GL_LINEAR);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(glIsEnabled(GL_TEXTURE_3D_OES), GL_TRUE);
  glDisable(GL_TEXTURE_3D_OES);
  EXPECT_EQ(glIsEnabled(GL_TEXTURE_3D_OES), GL_FALSE);
  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_3D_OES, &name);
  EXPECT_NE(name, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(name));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glBindTexture(GL_TEXTURE_3D_OES, 0);
  glGetIntegerv(GL_TEXTURE_BINDING_3D_OES, &name);
  EXPECT_EQ(name, 0);
}

TEST_F(VolumeTextures, Errors) {
  const auto copy = command<CopyTexSubImage3D>("glCopyTexSubImage3DOES");
  const auto compressed = command<CompressedTexImage3D>("glCompressedTexImage3DOES");
  const auto compressedPart = command<CompressedTexSubImage3D>("glCompressedTexSubImage3DOES");
  const auto attach = command<FramebufferTexture3D>("glFramebufferTexture3DOES");
  GLint most = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE_OES, &most);
  const auto image = [&](GLenum target, GLint level, GLenum internal, GLsizei w, GLsizei h, GLsizei d,
                         GLint border, GLenum format, GLenum type) {
    image_(target, level, internal, w, h, d, border, format, type, nullptr);
    return glGetError();
  };
  constexpr GLenum kByte = GL_UNSIGNED_BYTE;
  EXPECT_EQ(image(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, kByte), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, -1, GL_RGBA, 1, 1, 1, 0, GL_RGBA, kByte), GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, -1, 0, GL_RGBA, kByte), GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, most + 1, 0, GL_RGBA, kByte),
            GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, 1, 1, GL_RGBA, kByte), GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, 1, 0, GL_RGB, kByte), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_FLOAT), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, 7, 1, 1, 1, 0, GL_RGBA, kByte), GLenum{GL_INVALID_VALUE});
  GLubyte texel[4 * 8] = {};
  subImage_(GL_TEXTURE_3D_OES, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, kByte, texel);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // never specified
  EXPECT_EQ(image(GL_TEXTURE_3D_OES, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, kByte), GLenum{GL_NO_ERROR});
  subImage_(GL_TEXTURE_3D_OES, 0, 0, 0, 1, 2, 2, 2, GL_RGBA, kByte, texel);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  subImage_(GL_TEXTURE_3D_OES, 0, 0, 0, -1, 1, 1, 1, GL_RGBA, kByte, texel);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  copy(GL_TEXTURE_3D_OES, 0, 0, 0, 2, 0, 0, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  copy(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 0, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  compressed(GL_TEXTURE_3D_OES, 0, GL_PALETTE8_RGBA8_OES, 1, 1, 1, 0, 1028, texel);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  compressedPart(GL_TEXTURE_3D_OES, 0, 0, 0, 0, 1, 1, 1, GL_PALETTE8_RGBA8_OES, 1, texel);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_3D_OES, 1, 0, 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // the window's framebuffer
}

}  // namespace
}  // namespace conformance
