// OES_compressed_ETC1_RGB8_texture, EXT_compressed_ETC1_RGB8_sub_texture, EXT_texture_compression_dxt1,
// ANGLE_texture_compression_dxt, AMD_compressed_3DC_texture, IMG_texture_compression_pvrtc.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "compressed_reference.h"
#include "extension_commands.h"

namespace conformance {
namespace {

constexpr GLenum kDxt3 = 0x83F2, kDxt5 = 0x83F3;
// Decoded to bytes, rounded to nearest.
constexpr double kRounding = 0.502 * kOneStep;

struct Format {
  const char* name;
  const char* extension;
  GLenum value;
  int blockBytes;
  int pvrtcBits;  // 0: blocks of 4x4
  bool alpha;
};
constexpr Format kFormats[] = {
    {"ETC1_RGB8", "GL_OES_compressed_ETC1_RGB8_texture", GL_ETC1_RGB8_OES, 8, 0, false},
    {"RGB_S3TC_DXT1", "GL_EXT_texture_compression_dxt1", GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, 0, false},
    {"RGBA_S3TC_DXT1", "GL_EXT_texture_compression_dxt1", GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8, 0, true},
    {"RGBA_S3TC_DXT3", "GL_ANGLE_texture_compression_dxt3", kDxt3, 16, 0, true},
    {"RGBA_S3TC_DXT5", "GL_ANGLE_texture_compression_dxt5", kDxt5, 16, 0, true},
    {"3DC_X", "GL_AMD_compressed_3DC_texture", GL_3DC_X_AMD, 8, 0, false},
    {"3DC_XY", "GL_AMD_compressed_3DC_texture", GL_3DC_XY_AMD, 16, 0, false},
    {"RGB_PVRTC_4BPP", "GL_IMG_texture_compression_pvrtc", GL_COMPRESSED_RGB_PVRTC_4BPPV1_IMG, 8, 4, false},
    {"RGB_PVRTC_2BPP", "GL_IMG_texture_compression_pvrtc", GL_COMPRESSED_RGB_PVRTC_2BPPV1_IMG, 8, 2, false},
    {"RGBA_PVRTC_4BPP", "GL_IMG_texture_compression_pvrtc", GL_COMPRESSED_RGBA_PVRTC_4BPPV1_IMG, 8, 4, true},
    {"RGBA_PVRTC_2BPP", "GL_IMG_texture_compression_pvrtc", GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG, 8, 2, true},
};

bool wholeBlocksOnly(const Format& format) {
  return format.value == kDxt3 || format.value == kDxt5;
}
bool isS3tc(const Format& format) {
  return format.value >= GL_COMPRESSED_RGB_S3TC_DXT1_EXT && format.value <= kDxt5;
}
bool is3dc(const Format& format) {
  return format.value == GL_3DC_X_AMD || format.value == GL_3DC_XY_AMD;
}
bool blocksToTheEdge(const Format& format) {
  return format.value == GL_ETC1_RGB8_OES || is3dc(format);
}

int sizeOf(const Format& format, int width, int height) {
  if (format.pvrtcBits == 4) return (std::max(width, 8) * std::max(height, 8) * 4 + 7) / 8;
  if (format.pvrtcBits == 2) return (std::max(width, 16) * std::max(height, 8) * 2 + 7) / 8;
  return (width + 3) / 4 * ((height + 3) / 4) * format.blockBytes;
}

// Noise as an image of a format.
class Compressed {
 public:
  Compressed(const Format& format, int width, int height, unsigned seed)
      : format_(format), width_(width), height_(height) {
    unsigned state = seed * 77 + format.value;
    for (int i = 0; i < sizeOf(format, width, height); ++i) {
      data_.push_back(static_cast<GLubyte>((state = state * 1664525u + 1013904223u) >> 24));
    }
    if (format.value != GL_ETC1_RGB8_OES) return;
    for (std::size_t i = 0; i < data_.size(); i += 8) {
      if (etc1Overflows(&data_[i])) data_[i + 3] &= 0xfd;  // differences that are not defined
    }
  }

  GLsizei size() const { return static_cast<GLsizei>(data_.size()); }
  const void* data() const { return data_.data(); }

  void specify(GLint level = 0, GLenum target = GL_TEXTURE_2D) const {
    glCompressedTexImage2D(target, level, format_.value, width_, height_, 0, size(), data());
  }
  void replace(GLint x, GLint y) const {
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width_, height_, format_.value, size(), data());
  }

  Vec4 color(int x, int y) const {
    if (format_.pvrtcBits != 0) {
      Vec4 color = pvrtcTexel(format_.pvrtcBits, data_.data(), width_, height_, x, y);
      if (!format_.alpha) color[3] = 1;
      return color;
    }
    const int index = y / 4 * ((width_ + 3) / 4) + x / 4;
    const GLubyte* block = &data_[static_cast<std::size_t>(index * format_.blockBytes)];
    const int bx = x % 4, by = y % 4;
    switch (format_.value) {
      case GL_ETC1_RGB8_OES:
        return etc1Texel(block, bx, by);
      case GL_COMPRESSED_RGB_S3TC_DXT1_EXT:
        return dxtTexel(Dxt::Rgb1, block, bx, by);
      case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT:
        return dxtTexel(Dxt::Rgba1, block, bx, by);
      case kDxt3:
        return dxtTexel(Dxt::Rgba3, block, bx, by);
      case kDxt5:
        return dxtTexel(Dxt::Rgba5, block, bx, by);
      case GL_3DC_X_AMD:
        return {threeDcValue(block, bx, by), 0, 0, 1};
      default:
        return {threeDcValue(block, bx, by), threeDcValue(block + 8, bx, by), 0, 1};
    }
  }

 private:
  Format format_;
  int width_, height_;
  std::vector<GLubyte> data_;
};

class CompressedTextures : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    for (const Format& format : kFormats) {
      // Mesa advertises DXT1 to ES 1.1 and then refuses it.
      if (onMesa() && format.value != GL_ETC1_RGB8_OES) continue;
      ASSERT_TRUE(hasExtension(format.extension)) << format.extension;
      formats_.push_back(format);
    }
    if (formats_.empty()) GTEST_SKIP() << "no compressed formats";
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  }

  static GLuint bindNew() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    return name;
  }

  // One pixel a texel.
  static Image draw(int width, int height) {
    glViewport(0, 0, width, height);
    drawTexturedRect({}, 0, 0, 1, 1);
    return readImage(0, 0, width, height);
  }

  // How many texels of the rectangle are not those of `image`, which begins at (x, y).
  static int differences(const Image& drawn, const Compressed& image, int x, int y, int width, int height) {
    int wrong = 0;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        wrong += !near(drawn.at(x + i, y + j), image.color(i, j), kRounding);
      }
    }
    return wrong;
  }

  // Sizes that a format takes, the interesting ones.
  static std::vector<std::array<int, 2>> sizesOf(const Format& format) {
    std::vector<std::array<int, 2>> sizes = {{16, 16}, {4, 4},  {2, 2},   {1, 1},
                                             {32, 8},  {4, 16}, {64, 64}, {8, 1}};
    if (format.pvrtcBits != 0) return sizes;
    sizes.insert(sizes.end(), {{12, 20}, {28, 1}});
    if (!wholeBlocksOnly(format)) sizes.insert(sizes.end(), {{6, 5}, {13, 7}, {3, 9}, {61, 63}});
    return sizes;
  }

  std::vector<Format> formats_;
};

TEST_F(CompressedTextures, EveryFormatAndSize) {
  for (const Format& format : formats_) {
    for (const auto& [width, height] : sizesOf(format)) {
      const Compressed image(format, width, height, 1);
      bindNew();
      image.specify();
      EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
      EXPECT_EQ(differences(draw(width, height), image, 0, 0, width, height), 0)
          << format.name << " " << width << "x" << height;
    }
  }
}

// Every level is an image of its own.
TEST_F(CompressedTextures, MipLevels) {
  for (const Format& format : formats_) {
    bindNew();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (int level = 0; level < 5; ++level) {
      Compressed(format, 16 >> level, 16 >> level, static_cast<unsigned>(level)).specify(level);
    }
    EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
    for (int level = 0; level < 5; ++level) {
      const int size = 16 >> level;
      const Compressed image(format, size, size, static_cast<unsigned>(level));
      EXPECT_EQ(differences(draw(size, size), image, 0, 0, size, size), 0)
          << format.name << " level " << level;
    }
  }
}

// 3.7.7: no automatic mipmaps for a compressed level 0.
TEST_F(CompressedTextures, NoAutomaticMipmaps) {
  MESA_DISAGREES("3.7.7", "compressed images are stored decompressed, and their mipmaps are derived");
  for (const Format& format : formats_) {
    bindNew();
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    Compressed(format, 8, 8, 3).specify();
    glColor4f(0, 1, 0, 1);
    draw(8, 8);
    EXPECT_PIXEL(4, 4, {0, 1, 0, 1}) << format.name;
  }
}

TEST_F(CompressedTextures, CubeFaces) {
  NEEDS_EXTENSION("GL_OES_texture_cube_map");
  constexpr float kCenters[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  glDisable(GL_TEXTURE_2D);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glViewport(0, 0, width(), height());
  for (const Format& format : formats_) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
    useNearest(GL_TEXTURE_CUBE_MAP_OES);
    std::vector<Compressed> faces;
    for (unsigned face = 0; face < 6; ++face) {
      faces.emplace_back(format, 8, 8, face);
      faces.back().specify(0, GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face);
    }
    EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
    for (std::size_t face = 0; face < 6; ++face) {
      // Just beside the center, where four texels meet.
      const float* c = kCenters[face];
      glMultiTexCoord4f(GL_TEXTURE0, c[0] == 0 ? 0.1f : c[0], c[1] == 0 ? 0.1f : c[1],
                        c[2] == 0 ? 0.1f : c[2], 1);
      drawRect();
      // sc and tc of each face are +0.1 or -0.1 there.
      constexpr int kX[6] = {3, 4, 4, 4, 4, 3}, kY[6] = {3, 3, 4, 3, 3, 3};
      EXPECT_PIXEL(4, 4, faces[face].color(kX[face], kY[face]), kRounding) << format.name << " " << face;
    }
  }
}

TEST_F(CompressedTextures, SubImages) {
  struct Part {
    int x, y, width, height;
  };
  for (const Format& format : formats_) {
    std::vector<Part> parts = {{4, 8, 8, 4}, {0, 0, 4, 16}, {0, 0, 16, 16}};
    if (format.pvrtcBits != 0) parts = {{0, 0, 16, 16}};
    for (const Part& part : parts) {
      const Compressed all(format, 16, 16, 5), piece(format, part.width, part.height, 6);
      bindNew();
      all.specify();
      draw(16, 16);  // with the texels in an image already
      piece.replace(part.x, part.y);
      EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
      const Image drawn = draw(16, 16);
      EXPECT_EQ(differences(drawn, piece, part.x, part.y, part.width, part.height), 0) << format.name;
      for (const auto& [x, y] :
           {std::array{15, 0}, std::array{15, 15}, std::array{4, 4}, std::array{12, 8}}) {
        const bool inside = x >= part.x && x < part.x + part.width && y >= part.y && y < part.y + part.height;
        EXPECT_TRUE(inside || near(drawn.at(x, y), all.color(x, y), kRounding)) << format.name;
      }
    }
  }
}

// EXT_compressed_ETC1_RGB8_sub_texture: the last block may be a part of one. EXT_texture_compression_dxt1: a
// width or height that is the image's is no multiple of four.
TEST_F(CompressedTextures, SubImagesAtTheEdge) {
  for (const Format& format : formats_) {
    if (format.pvrtcBits != 0 || wholeBlocksOnly(format)) continue;
    const bool toTheEdge = blocksToTheEdge(format);
    const Compressed all(format, 14, 11, 7), piece(format, toTheEdge ? 6 : 14, 3, 8);
    bindNew();
    all.specify();
    const int x = toTheEdge ? 8 : 0;
    if (toTheEdge) {
      piece.replace(x, 8);
    } else {
      Compressed(format, 14, 8, 8).replace(0, 0);
    }
    EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
    const Image drawn = draw(14, 11);
    if (toTheEdge) {
      EXPECT_EQ(differences(drawn, piece, 8, 8, 6, 3), 0) << format.name;
      EXPECT_EQ(differences(drawn, all, 0, 0, 14, 8), 0) << format.name;
    } else {
      EXPECT_EQ(differences(drawn, Compressed(format, 14, 8, 8), 0, 0, 14, 8), 0) << format.name;
    }
  }
}

TEST_F(CompressedTextures, ErrorsOfImages) {
  const std::vector<GLubyte> data(1 << 16);
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  for (const Format& format : formats_) {
    SCOPED_TRACE(format.name);
    bindNew();
    const auto specify = [&](GLint level, GLsizei width, GLsizei height, GLint border, GLsizei size,
                             GLenum target = GL_TEXTURE_2D) {
      glCompressedTexImage2D(target, level, format.value, width, height, border, size, data.data());
    };
    const GLsizei size = sizeOf(format, 8, 8);
    specify(0, 8, 8, 0, size, 0x9999);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    specify(0, 8, 8, 0, size - 1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(0, 8, 8, 0, size + 1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(0, 8, 8, 0, -1);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(-1, 8, 8, 0, size);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(31, 8, 8, 0, size);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(0, -8, 8, 0, size);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    specify(0, largest * 2, 8, 0, size);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    if (!onMesa()) {
      specify(0, 8, 8, 1, size);
      const bool stated = format.value == GL_ETC1_RGB8_OES || isS3tc(format);
      EXPECT_GL_ERROR(stated ? GL_INVALID_OPERATION : GL_INVALID_VALUE);
      specify(0, 12, 6, 0, sizeOf(format, 12, 6));
      EXPECT_GL_ERROR(format.pvrtcBits != 0     ? GL_INVALID_VALUE
                      : wholeBlocksOnly(format) ? GL_INVALID_OPERATION
                                                : GL_NO_ERROR);
    }
    // Nothing was specified by what failed.
    specify(0, 8, 8, 0, size);
    EXPECT_GL_ERROR(GL_NO_ERROR);

    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format.value, 0, 0, 0, sizeOf(format, 0, 0), nullptr);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    if (onMesa()) continue;
    // Not for the commands that take texels.
    specify(0, 8, 8, 0, size);
    const GLenum base = format.alpha ? GL_RGBA : GL_RGB;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.value), 8, 8, 0, base, GL_UNSIGNED_BYTE,
                 data.data());
    EXPECT_GL_ERROR(isS3tc(format) || is3dc(format) ? GL_INVALID_OPERATION : GL_INVALID_VALUE);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, base, GL_UNSIGNED_BYTE, data.data());
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, format.value, 0, 0, 4, 4, 0);
    EXPECT_GL_ERROR(isS3tc(format) ? GL_INVALID_OPERATION : GL_INVALID_ENUM);
  }
}

TEST_F(CompressedTextures, ErrorsOfSubImages) {
  if (onMesa()) GTEST_SKIP() << "Mesa checks by the format's desktop extension";
  const std::vector<GLubyte> data(4096);
  for (const Format& format : formats_) {
    SCOPED_TRACE(format.name);
    const bool pvrtc = format.pvrtcBits != 0;
    const auto replace = [&](GLint x, GLint y, GLsizei width, GLsizei height, int more = 0, GLint level = 0,
                             GLenum value = 0) {
      glCompressedTexSubImage2D(GL_TEXTURE_2D, level, x, y, width, height, value != 0 ? value : format.value,
                                sizeOf(format, width, height) + more, data.data());
      return glGetError();
    };
    bindNew();
    EXPECT_EQ(replace(0, 0, 4, 4), GLenum{GL_INVALID_OPERATION}) << "no level";
    const Compressed all(format, 16, 16, 9);
    all.specify();
    const GLenum aligned = pvrtc ? GL_INVALID_OPERATION : GL_NO_ERROR;
    EXPECT_EQ(replace(4, 4, 8, 4), aligned);
    EXPECT_EQ(replace(2, 0, 4, 4), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(replace(0, 1, 4, 4), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(replace(0, 0, 5, 4), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(replace(0, 0, 4, 2), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(replace(0, 0, 20, 4), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(16, 0, 4, 4), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(-4, 0, 4, 4), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(0, 0, 16, 16, -1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(0, 0, 16, 16, 1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(0, 0, 4, 4, 0, 1), GLenum{GL_INVALID_OPERATION}) << "no such level";
    EXPECT_EQ(replace(0, 0, 4, 4, 0, -1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(replace(0, 0, 16, 16, 0, 0, GL_PALETTE4_RGB8_OES), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(replace(0, 0, 16, 16, 0, 0,
                      format.value == GL_ETC1_RGB8_OES ? GL_COMPRESSED_RGB_S3TC_DXT1_EXT : GL_ETC1_RGB8_OES),
              GLenum{GL_INVALID_OPERATION});
    if (!pvrtc) all.replace(0, 0);
    EXPECT_EQ(differences(draw(16, 16), all, 0, 0, 16, 16), 0) << "what failed changed something";

    // A last block that hangs over the edge.
    if (pvrtc || wholeBlocksOnly(format)) continue;
    Compressed(format, 14, 14, 9).specify();
    EXPECT_EQ(replace(12, 12, 2, 2), GLenum(blocksToTheEdge(format) ? GL_NO_ERROR : GL_INVALID_OPERATION));
    EXPECT_EQ(replace(0, 0, 14, 14), GLenum{GL_NO_ERROR});
    EXPECT_EQ(replace(0, 0, 6, 4), GLenum{GL_INVALID_OPERATION});
  }
}

TEST_F(CompressedTextures, AreListed) {
  GLint count = 0;
  glGetIntegerv(GL_NUM_COMPRESSED_TEXTURE_FORMATS, &count);
  std::vector<GLint> listed(static_cast<std::size_t>(count));
  glGetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, listed.data());
  for (const Format& format : formats_) {
    EXPECT_EQ(std::count(listed.begin(), listed.end(), static_cast<GLint>(format.value)), 1) << format.name;
  }
  EXPECT_TRUE(onMesa() || hasExtension("GL_EXT_compressed_ETC1_RGB8_sub_texture"));
}

// OES_framebuffer_object: only RGB and RGBA are color-renderable.
TEST_F(CompressedTextures, AreNoRenderTargets) {
  NEEDS_EXTENSION("GL_OES_framebuffer_object");
  COMMAND(PFNGLGENFRAMEBUFFERSOESPROC, GenFramebuffersOES);
  COMMAND(PFNGLBINDFRAMEBUFFEROESPROC, BindFramebufferOES);
  COMMAND(PFNGLFRAMEBUFFERTEXTURE2DOESPROC, FramebufferTexture2DOES);
  COMMAND(PFNGLCHECKFRAMEBUFFERSTATUSOESPROC, CheckFramebufferStatusOES);
  GLuint object = 0;
  GenFramebuffersOES(1, &object);
  BindFramebufferOES(GL_FRAMEBUFFER_OES, object);
  for (const Format& format : formats_) {
    const GLuint name = bindNew();
    Compressed(format, 8, 8, 2).specify();
    FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
    EXPECT_EQ(CheckFramebufferStatusOES(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES})
        << format.name;
  }
  BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
}

}  // namespace
}  // namespace conformance
