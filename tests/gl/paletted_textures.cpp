// The ten paletted formats, decoded here a second time (section 3.7.4).
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

struct Paletted {
  GLenum internalFormat;
  int bits;
  render::Format entry;
  GLenum base;
};
constexpr Paletted kFormats[] = {
    {0x8B90, 4, render::Format::RGB8, GL_RGB},      {0x8B91, 4, render::Format::RGBA8, GL_RGBA},
    {0x8B92, 4, render::Format::RGB565, GL_RGB},    {0x8B93, 4, render::Format::RGBA4444, GL_RGBA},
    {0x8B94, 4, render::Format::RGBA5551, GL_RGBA}, {0x8B95, 8, render::Format::RGB8, GL_RGB},
    {0x8B96, 8, render::Format::RGBA8, GL_RGBA},    {0x8B97, 8, render::Format::RGB565, GL_RGB},
    {0x8B98, 8, render::Format::RGBA4444, GL_RGBA}, {0x8B99, 8, render::Format::RGBA5551, GL_RGBA},
};

class PalettedTextures : public Texture2DTest {
 protected:
  static int size(const Paletted& format, int width, int height, int levels) {
    int bytes = (1 << format.bits) * render::info(format.entry).bytes;
    for (int i = 0; i < levels; ++i) {
      const int texels = std::max(width >> i, 1) * std::max(height >> i, 1);
      bytes += format.bits == 8 ? texels : (texels + 1) / 2;
    }
    return bytes;
  }

  static Texel lookUp(const Paletted& format, const std::vector<uint8_t>& data, size_t levelStart,
                      int texel) {
    const size_t bytes = render::info(format.entry).bytes;
    int index = data[levelStart + static_cast<size_t>(format.bits == 8 ? texel : texel / 2)];
    if (format.bits == 4) index = texel % 2 ? index % 16 : index / 16;
    return decodeTexel(format.entry, &data[static_cast<size_t>(index) * bytes]);
  }

  static void expectLevels(FakeImage& image, const Paletted& format, const std::vector<uint8_t>& data,
                           int layer, int levels) {
    size_t start = (size_t{1} << format.bits) * render::info(format.entry).bytes;
    for (int level = 0; level < levels; ++level) {
      const int w = image.width(level), h = image.height(level);
      for (int i = 0; i < w * h; ++i) {
        ASSERT_EQ(image.texel(level, layer, i % w, i / w), lookUp(format, data, start, i))
            << "level " << level << " texel " << i;
      }
      start += static_cast<size_t>(format.bits == 8 ? w * h : (w * h + 1) / 2);
    }
  }
};

TEST_F(PalettedTextures, Decoding) {
  for (const Paletted& format : kFormats) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {8, 8}, {16, 4}, {1, 7}}) {
      const int chain = static_cast<int>(std::log2(std::max(width, height))) + 1;
      for (const int levels : {1, chain}) {
        const int bytes = size(format, width, height, levels);
        const std::vector<uint8_t> data = noise(static_cast<size_t>(bytes), format.internalFormat + width);
        filter(GL_TEXTURE_2D, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
        glCompressedTexImage2D(GL_TEXTURE_2D, 1 - levels, format.internalFormat, width, height, 0, bytes,
                               data.data());
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        FakeImage* image = draw();
        ASSERT_TRUE(image);
        ASSERT_GE(image->desc().levels, levels);
        EXPECT_EQ(renderer(context).units[0].baseFormat, format.base);
        expectLevels(*image, format, data, 0, levels);
      }
    }
  }
}

TEST_F(PalettedTextures, CubeFaces) {
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, 2);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  const Paletted& format = kFormats[3];
  const int bytes = size(format, 8, 8, 4);
  std::vector<std::vector<uint8_t>> faces;
  for (unsigned face = 0; face < 6; ++face) {
    faces.push_back(noise(static_cast<size_t>(bytes), face));
    glCompressedTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, -3, format.internalFormat, 8, 8, 0,
                           bytes, faces.back().data());
  }
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  for (int face = 0; face < 6; ++face)
    expectLevels(*image, format, faces[static_cast<size_t>(face)], face, 4);
}

TEST_F(PalettedTextures, Errors) {
  for (const Paletted& format : kFormats) {
    const int bytes = size(format, 4, 4, 1);
    const std::vector<uint8_t> data = noise(4096, 1);
    const auto error = [&](GLenum target, GLint level, GLsizei width, GLsizei height, GLint border,
                           GLsizei imageSize) {
      glCompressedTexImage2D(target, level, format.internalFormat, width, height, border, imageSize,
                             data.data());
      return glGetError();
    };
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 4, 4, 0, bytes), GLenum{GL_NO_ERROR});
    EXPECT_EQ(error(0x1234, 0, 4, 4, 0, bytes), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(error(GL_TEXTURE_CUBE_MAP_OES, 0, 4, 4, 0, bytes), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(error(GL_TEXTURE_2D, 1, 4, 4, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, -11, 4, 4, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, INT32_MIN, 4, 4, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, -1, 4, 4, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, -4, 4, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 1 << 30, 1 << 30, 0, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 4, 4, 1, bytes), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 4, 4, 0, bytes - 1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 4, 4, 0, bytes + 1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_2D, 0, 4, 4, 0, -1), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(error(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, 0, 4, 2, 0, size(format, 4, 2, 1)),
              GLenum{GL_INVALID_VALUE});

    // Neither TexImage2D nor sub-images take them.
    const auto internal = static_cast<GLint>(format.internalFormat);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, 4, 4, 0, format.base, GL_UNSIGNED_BYTE, data.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, format.base, GL_UNSIGNED_BYTE, data.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, format.internalFormat, bytes, data.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    expectLevels(*draw(), format, data, 0, 1);
  }
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, 48, nullptr);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
}

// Section 3.7.7: no automatic mipmaps for compressed levels.
TEST_F(PalettedTextures, NoAutomaticMipmaps) {
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  const int bytes = size(kFormats[0], 4, 4, 1);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, kFormats[0].internalFormat, 4, 4, 0, bytes,
                         noise(static_cast<size_t>(bytes), 1).data());
  EXPECT_FALSE(draw());
  EXPECT_EQ(device.log.mipmaps, 0);
}

// Levels of a mipmap must all have been specified with one internal format (section 3.7.9).
TEST_F(PalettedTextures, DoesNotMixWithTheSameBaseFormat) {
  filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST);
  const int bytes = size(kFormats[1], 2, 2, 2);
  glCompressedTexImage2D(GL_TEXTURE_2D, -1, kFormats[1].internalFormat, 2, 2, 0, bytes,
                         noise(static_cast<size_t>(bytes), 1).data());
  EXPECT_TRUE(draw());
  specify(1, 1, 1);
  EXPECT_FALSE(draw());
}

TEST_F(PalettedTextures, NoDataAndNoSize) {
  glCompressedTexImage2D(GL_TEXTURE_2D, -2, GL_PALETTE8_RGBA8_OES, 4, 4, 0, 1024 + 16 + 4 + 1, nullptr);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  EXPECT_TRUE(draw());
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE8_RGBA8_OES, 0, 0, 0, 1024, noise(1024, 1).data());
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  EXPECT_FALSE(draw());
}

}  // namespace
}  // namespace anteroom::test
