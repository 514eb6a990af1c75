// CopyTexImage2D, CopyTexSubImage2D and ReadPixels (sections 3.7.2, 4.3).
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

using TextureCopies = Texture2DTest;

TEST_F(TextureCopies, FormatFollowsInternalFormatAndFramebuffer) {
  using render::Format;
  struct Case {
    Format framebuffer;
    GLenum internalFormat;
    Format stored;
  };
  for (const Case& test :
       {Case{Format::RGBA8, GL_RGBA, Format::RGBA8}, Case{Format::RGBA8, GL_RGB, Format::RGB8},
        Case{Format::RGBA8, GL_ALPHA, Format::A8}, Case{Format::RGBA8, GL_LUMINANCE, Format::L8},
        Case{Format::RGBA8, GL_LUMINANCE_ALPHA, Format::LA8}, Case{Format::RGB8, GL_RGB, Format::RGB8},
        Case{Format::RGB565, GL_RGB, Format::RGB565}, Case{Format::RGB565, GL_LUMINANCE, Format::L8},
        Case{Format::RGBA4444, GL_RGBA, Format::RGBA4444}, Case{Format::RGBA4444, GL_RGB, Format::RGB8},
        Case{Format::RGBA5551, GL_RGBA, Format::RGBA5551}}) {
    useFramebuffer(test.framebuffer);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, test.internalFormat, 3, 2, 9, 5, 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    FakeImage* image = draw();
    ASSERT_TRUE(image);
    EXPECT_EQ(image->desc().format, test.stored);
    EXPECT_EQ(renderer(context).units[0].baseFormat, test.internalFormat);
    for (int i = 0; i < 45; ++i) {
      uint8_t texel[4];
      encodeTexel(test.stored, color->texel(0, 0, 3 + i % 9, 2 + i / 9), texel);
      ASSERT_EQ(image->texel(0, 0, i % 9, i / 9), decodeTexel(test.stored, texel));
    }
  }
}

TEST_F(TextureCopies, BeyondTheFramebuffer) {
  for (const auto& [x, y] : {std::pair{-3, -2}, {kWidth - 2, kHeight - 1}, {INT32_MAX, INT32_MIN}}) {
    const GLuint name = 1;
    glDeleteTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    filter(GL_TEXTURE_2D, GL_NEAREST);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, x, y, 8, 8, 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    FakeImage* image = draw();
    for (int i = 0; i < 64; ++i) {
      const int64_t sx = int64_t{x} + i % 8, sy = int64_t{y} + i / 8;
      const bool inside = sx >= 0 && sy >= 0 && sx < kWidth && sy < kHeight;
      const Texel expected = inside ? framebufferTexel(static_cast<int>(sx), static_cast<int>(sy)) : Texel{};
      ASSERT_EQ(image->texel(0, 0, i % 8, i / 8), expected);
    }
  }
}

TEST_F(TextureCopies, SubImage) {
  const std::vector<uint8_t> data = noise(16 * 16 * 4, 1);
  for (const bool resident : {false, true}) {
    specify(0, 16, 16, GL_RGBA, data.data());
    if (resident) draw();
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 5, 6, 1, 2, 4, 3);
    FakeImage* image = draw();
    for (int i = 0; i < 256; ++i) {
      const int x = i % 16, y = i / 16;
      const uint8_t* t = &data[static_cast<size_t>(i) * 4];
      const bool copied = x >= 5 && x < 9 && y >= 6 && y < 9;
      ASSERT_EQ(image->texel(0, 0, x, y),
                copied ? framebufferTexel(x - 4, y - 4) : (Texel{t[0], t[1], t[2], t[3]}));
    }
  }
}

// Levels that do not fit together yet can be copied to; they come together when they do.
TEST_F(TextureCopies, LevelsInAnyOrder) {
  filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST);
  for (const int level : {2, 0, 3, 1})
    glCopyTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, level, 1, 8 >> level, 8 >> level, 0);
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  for (int level = 0; level < 4; ++level) {
    for (int i = 0; i < (8 >> level) * (8 >> level); ++i) {
      const int x = i % (8 >> level), y = i / (8 >> level);
      ASSERT_EQ(image->texel(level, 0, x, y), framebufferTexel(level + x, 1 + y));
    }
  }
  EXPECT_EQ(device.log.liveImages, 1);
}

TEST_F(TextureCopies, CubeFaces) {
  constexpr GLenum kFirst = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES;
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, 2);
  filter(GL_TEXTURE_CUBE_MAP_OES, GL_NEAREST);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  for (GLint face = 0; face < 6; ++face) {
    glCopyTexImage2D(kFirst + static_cast<GLenum>(face), 0, GL_RGBA, face, 0, 4, 4, 0);
  }
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  for (int face = 0; face < 6; ++face) EXPECT_EQ(image->texel(0, face, 1, 2), framebufferTexel(face + 1, 2));
  EXPECT_EQ(device.log.liveImages, 1);
  glCopyTexSubImage2D(kFirst + 3, 0, 1, 1, 20, 9, 2, 2);
  EXPECT_EQ(draw()->texel(0, 3, 1, 1), framebufferTexel(20, 9));
  EXPECT_EQ(draw()->texel(0, 3, 0, 0), framebufferTexel(3, 0));
  // Another size, face by face.
  for (GLint face = 0; face < 6; ++face) {
    glCopyTexImage2D(kFirst + static_cast<GLenum>(face), 0, GL_RGBA, face, 1, 8, 8, 0);
    EXPECT_EQ(draw() != nullptr, face == 5);
  }
  for (int face = 0; face < 6; ++face) EXPECT_EQ(draw()->texel(0, face, 7, 0), framebufferTexel(face + 7, 1));
  EXPECT_EQ(device.log.liveImages, 1);
}

TEST_F(TextureCopies, AutomaticMipmaps) {
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  for (int frame = 1; frame <= 2; ++frame) {
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8, 8, 0);
    EXPECT_EQ(draw()->desc().levels, 4);
    EXPECT_EQ(device.log.mipmaps, frame);
  }
  EXPECT_EQ(device.log.images, 1);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1);
  EXPECT_TRUE(draw());
  EXPECT_EQ(device.log.mipmaps, 3);
}

TEST_F(TextureCopies, ReadPixels) {
  using render::Format;
  for (const Format format :
       {Format::RGBA8, Format::RGB8, Format::RGB565, Format::RGBA4444, Format::RGBA5551}) {
    useFramebuffer(format);
    GLint ownFormat = 0, ownType = 0;
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES, &ownFormat);
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE_OES, &ownType);
    for (const Pair& pair : kPairs) {
      const bool own = pair.stored == format;
      if (own) {
        EXPECT_EQ(ownFormat, static_cast<GLint>(pair.format));
        EXPECT_EQ(ownType, static_cast<GLint>(pair.type));
      }
      for (const int alignment : {1, 2, 4, 8}) {
        glPixelStorei(GL_PACK_ALIGNMENT, alignment);
        for (const int width : {1, 3, 6}) {
          const size_t pitch = specifiedPitch(pair, width, static_cast<size_t>(alignment));
          std::vector<uint8_t> out(pitch * 3 + specifiedPitch(pair, width, 1), 0x5a);
          std::vector<uint8_t> expected = out;
          // Hangs over the right and the upper edge, or the left and the lower one.
          for (const auto& [x, y] : {std::pair{4, 5}, {kWidth - 2, kHeight - 2}, {-1, -2}}) {
            out.assign(out.size(), 0x5a);
            expected = out;
            glReadPixels(x, y, width, 4, pair.format, pair.type, out.data());
            const bool legal = own || pair.stored == Format::RGBA8;
            EXPECT_EQ(glGetError(), static_cast<GLenum>(legal ? GL_NO_ERROR : GL_INVALID_OPERATION));
            for (int i = 0; legal && i < width * 4; ++i) {
              const int px = x + i % width, py = y + i / width;
              if (px < 0 || py < 0 || px >= kWidth || py >= kHeight) continue;
              encodeTexel(pair.stored, color->texel(0, 0, px, py),
                          &expected[static_cast<size_t>(i / width) * pitch +
                                    static_cast<size_t>(i % width) * pair.element * pair.perTexel]);
            }
            ASSERT_EQ(out, expected);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace anteroom::test
