// Section 3.7.4 and OES_compressed_paletted_texture: the ten formats, with mip levels.
#include <fmt/format.h>

#include <algorithm>

#include "harness.h"

namespace conformance {
namespace {

class PalettedTextures : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glColor4f(1, 1, 1, 1);
  }
};

struct Format {
  const char* name;
  GLenum value;
  int bits;        // a texel
  int entryBytes;  // of the palette
  bool alpha;
};
constexpr Format kFormats[] = {{"PALETTE4_RGB8", GL_PALETTE4_RGB8_OES, 4, 3, false},
                               {"PALETTE4_RGBA8", GL_PALETTE4_RGBA8_OES, 4, 4, true},
                               {"PALETTE4_R5_G6_B5", GL_PALETTE4_R5_G6_B5_OES, 4, 2, false},
                               {"PALETTE4_RGBA4", GL_PALETTE4_RGBA4_OES, 4, 2, true},
                               {"PALETTE4_RGB5_A1", GL_PALETTE4_RGB5_A1_OES, 4, 2, true},
                               {"PALETTE8_RGB8", GL_PALETTE8_RGB8_OES, 8, 3, false},
                               {"PALETTE8_RGBA8", GL_PALETTE8_RGBA8_OES, 8, 4, true},
                               {"PALETTE8_R5_G6_B5", GL_PALETTE8_R5_G6_B5_OES, 8, 2, false},
                               {"PALETTE8_RGBA4", GL_PALETTE8_RGBA4_OES, 8, 2, true},
                               {"PALETTE8_RGB5_A1", GL_PALETTE8_RGB5_A1_OES, 8, 2, true}};

// An entry's bytes as colour, by tables 3.11 and 3.6.
Vec4 entryColor(const Format& format, const GLubyte* e) {
  const unsigned packed = e[0] | (format.entryBytes > 1 ? e[1] << 8 : 0);
  const auto field = [&](int shift, int bits) {
    return (packed >> shift & ((1u << bits) - 1)) / double((1u << bits) - 1);
  };
  switch (format.value) {
    case GL_PALETTE4_R5_G6_B5_OES:
    case GL_PALETTE8_R5_G6_B5_OES:
      return {field(11, 5), field(5, 6), field(0, 5), 1};
    case GL_PALETTE4_RGBA4_OES:
    case GL_PALETTE8_RGBA4_OES:
      return {field(12, 4), field(8, 4), field(4, 4), field(0, 4)};
    case GL_PALETTE4_RGB5_A1_OES:
    case GL_PALETTE8_RGB5_A1_OES:
      return {field(11, 5), field(6, 5), field(1, 5), field(0, 1)};
    default:
      return {e[0] / 255.0, e[1] / 255.0, e[2] / 255.0, format.alpha ? e[3] / 255.0 : 1};
  }
}

// Palette and levels as CompressedTexImage2D takes them; the index of a texel is a hash of where it is.
class Paletted {
 public:
  Paletted(const Format& format, int width, int height, int levels)
      : format_(format), width_(width), height_(height) {
    const int entries = 1 << format.bits;
    unsigned state = format.value;
    for (int i = 0; i < entries * format.entryBytes; ++i) {
      data_.push_back(static_cast<GLubyte>((state = state * 1664525u + 1013904223u) >> 24));
    }
    for (int level = 0; level < levels; ++level) {
      const int w = std::max(width >> level, 1), h = std::max(height >> level, 1), texels = w * h;
      if (format.bits == 8) {
        for (int i = 0; i < texels; ++i) data_.push_back(static_cast<GLubyte>(index(level, i)));
      } else {
        // Table 3.12: the first texel in the high half; rows are packed without a gap.
        for (int i = 0; i < texels; i += 2) {
          data_.push_back(
              static_cast<GLubyte>(index(level, i) << 4 | (i + 1 < texels ? index(level, i + 1) : 0)));
        }
      }
    }
  }
  int index(int level, int texel) const { return (texel * 37 + level * 11 + 5) % (1 << format_.bits); }
  Vec4 color(int level, int x, int y) const {
    const int w = std::max(width_ >> level, 1);
    return entryColor(format_, data_.data() + index(level, y * w + x) * format_.entryBytes);
  }
  void upload(int levels) const {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    glCompressedTexImage2D(GL_TEXTURE_2D, 1 - levels, format_.value, width_, height_, 0,
                           static_cast<GLsizei>(data_.size()), data_.data());
  }

 private:
  Format format_;
  int width_, height_;
  std::vector<GLubyte> data_;
};

// Tables 3.10-3.12
TEST_F(PalettedTextures, EveryFormat) {
  for (const Format& format : kFormats) {
    const Paletted image(format, 16, 16, 1);
    image.upload(1);
    EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
    drawTexturedRect({}, 0, 0, 1, 1);
    const Image result = readAll();
    int wrong = 0;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) wrong += !near(result.at(x * 4 + 1, y * 4 + 1), image.color(0, x, y));
    }
    EXPECT_EQ(wrong, 0) << format.name;
  }
}

// OES_compressed_paletted_texture: a level of -n holds n + 1 images; odd sizes at the end of the pyramid.
TEST_F(PalettedTextures, MipLevels) {
  for (const Format& format : kFormats) {
    for (const auto& [w, h, levels] : {std::array{8, 8, 4}, std::array{16, 4, 5}, std::array{1, 2, 2}}) {
      const Paletted image(format, w, h, levels);
      image.upload(levels);
      EXPECT_GL_ERROR(GL_NO_ERROR) << format.name;
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
      for (int level = 0; level < levels; ++level) {
        // One pixel a texel of the level: the viewport of its size shows exactly that level.
        const int lw = std::max(w >> level, 1), lh = std::max(h >> level, 1);
        // A side that has reached 1 would make the scale of the other rule; draw with it repeated.
        glViewport(0, 0, w >> level ? lw : 1, lh);
        drawTexturedRect({}, 0, 0, 1, 1);
        const Image result = readImage(0, 0, lw, lh);
        for (int y = 0; y < lh; ++y) {
          for (int x = 0; x < lw; ++x) {
            EXPECT_TRUE(near(result.at(x, y), image.color(level, x, y)))
                << format.name << " " << w << "x" << h << " level " << level << " texel " << x << " " << y;
          }
        }
      }
    }
  }
}

// 3.7.4: fewer levels than a whole pyramid are accepted, and incomplete for a mipmap filter (3.7.9).
TEST_F(PalettedTextures, PartOfAPyramid) {
  const Paletted image(kFormats[1], 8, 8, 2);
  image.upload(2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(4, 4, image.color(0, 0, 0));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glColor4f(0, 1, 0, 1);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(4, 4, {0, 1, 0, 1});
}

// 3.7.3: the size must be exact, for every format and number of levels.
TEST_F(PalettedTextures, ImageSize) {
  const std::vector<GLubyte> data(8192);
  for (const Format& format : kFormats) {
    for (int levels : {1, 3, 5}) {
      int size = (1 << format.bits) * format.entryBytes;
      for (int level = 0; level < levels; ++level) {
        const int texels = std::max(16 >> level, 1) * std::max(8 >> level, 1);
        size += format.bits == 8 ? texels : (texels + 1) / 2;
      }
      for (int off : {-1, 1}) {
        glCompressedTexImage2D(GL_TEXTURE_2D, 1 - levels, format.value, 16, 8, 0, size + off, data.data());
        EXPECT_GL_ERROR(GL_INVALID_VALUE) << format.name << " levels " << levels << " off by " << off;
      }
      glCompressedTexImage2D(GL_TEXTURE_2D, 1 - levels, format.value, 16, 8, 0, size, data.data());
      EXPECT_GL_ERROR(GL_NO_ERROR) << format.name << " levels " << levels;
    }
  }
}

// 3.7.3: UNPACK_ALIGNMENT has no say.
TEST_F(PalettedTextures, AlignmentIsIgnored) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  const Paletted image(kFormats[5], 2, 2, 1);
  image.upload(1);
  drawTexturedRect({}, 0, 0, 1, 1);
  for (int i = 0; i < 4; ++i)
    EXPECT_PIXEL(16 + i % 2 * 32, 16 + i / 2 * 32, image.color(0, i % 2, i / 2)) << i;
}

// 3.7.7: no automatic mipmaps for a compressed level 0.
TEST_F(PalettedTextures, NoAutomaticMipmaps) {
  MESA_DISAGREES("3.7.7", "paletted images are stored decompressed, and their mipmaps are derived");
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const std::vector<GLubyte> data(16 * 3 + 8);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, 56, data.data());
  glColor4f(0, 1, 0, 1);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
}

}  // namespace
}  // namespace conformance
