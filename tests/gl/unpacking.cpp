// Every format and type, with every alignment, against equations 3.10 and 3.11.
#include "layer/gl/textures/pixel.h"
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

class Unpacking : public Texture2DTest {
 protected:
  // Client memory that ends with the last texel, at an odd address when `odd`.
  struct Memory {
    std::vector<uint8_t> bytes;
    size_t start, pitch;
    const uint8_t* data() const { return bytes.data() + start; }
  };
  static Memory memory(const Pair& pair, int width, int height, int alignment, bool odd, unsigned seed) {
    const size_t pitch = specifiedPitch(pair, width, static_cast<size_t>(alignment));
    const size_t size = pitch * static_cast<size_t>(height - 1) + specifiedPitch(pair, width, 1);
    return {noise(size + odd, seed), odd, pitch};
  }

  static void expectTexels(FakeImage& image, const Pair& pair, const Memory& memory, int x, int y, int width,
                           int height) {
    const size_t bytes = pair.element * pair.perTexel;
    ASSERT_EQ(image.desc().format, pair.stored);
    for (int j = 0; j < height; ++j) {
      ASSERT_EQ(std::memcmp(image.at(0, 0, x, y + j), memory.data() + memory.pitch * static_cast<size_t>(j),
                            bytes * static_cast<size_t>(width)),
                0)
          << "row " << j;
    }
  }
};

TEST_F(Unpacking, TexImage) {
  unsigned seed = 0;
  for (const Pair& pair : kPairs) {
    for (const int alignment : {1, 2, 4, 8}) {
      glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
      for (const int width : {1, 2, 3, 4, 5, 7, 8, 13}) {
        for (const int height : {1, 3}) {
          const Memory m = memory(pair, width, height, alignment, seed % 2 == 1, seed);
          ++seed;
          glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(pair.format), width, height, 0, pair.format,
                       pair.type, m.data());
          ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
          FakeImage* image = draw();
          ASSERT_TRUE(image);
          EXPECT_EQ(renderer(context).units[0].baseFormat, pair.format);
          expectTexels(*image, pair, m, 0, 0, width, height);
          // The same again goes straight into the image.
          const Memory again = memory(pair, width, height, alignment, false, seed);
          glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(pair.format), width, height, 0, pair.format,
                       pair.type, again.data());
          EXPECT_EQ(device.log.lastUpload, again.data());
          EXPECT_EQ(draw(), image);
          expectTexels(*image, pair, again, 0, 0, width, height);
        }
      }
    }
  }
}

TEST_F(Unpacking, TexSubImage) {
  unsigned seed = 1000;
  for (const Pair& pair : kPairs) {
    for (const int alignment : {1, 2, 4, 8}) {
      glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
      glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(pair.format), 17, 9, 0, pair.format, pair.type,
                   nullptr);
      for (const bool resident : {false, true}) {
        const Memory m = memory(pair, 5, 4, alignment, resident, ++seed);
        if (resident) draw();
        glTexSubImage2D(GL_TEXTURE_2D, 0, 11, 3, 5, 4, pair.format, pair.type, m.data());
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        if (resident) {
          EXPECT_EQ(device.log.lastUpload, m.data());
        }
        expectTexels(*draw(), pair, m, 11, 3, 5, 4);
      }
    }
  }
}

// Sub-images may come in another type than the level: each component goes to the nearest value.
TEST_F(Unpacking, TexSubImageOfAnotherType) {
  const auto exact = [](const Pair& pair, const uint8_t* texel) {
    std::array<double, 4> value{0, 0, 0, 1};
    if (pair.element == 1) {
      for (size_t i = 0; i < pair.perTexel; ++i) value[i] = texel[i] / 255.0;
      return value;
    }
    uint16_t packed;
    std::memcpy(&packed, texel, 2);
    const std::array<int, 4> bits = pair.stored == render::Format::RGB565     ? std::array{5, 6, 5, 0}
                                    : pair.stored == render::Format::RGBA4444 ? std::array{4, 4, 4, 4}
                                                                              : std::array{5, 5, 5, 1};
    int shift = 16;
    for (size_t i = 0; i < 4; ++i) {
      shift -= bits[i];
      if (bits[i])
        value[i] = (packed >> shift & ((1 << bits[i]) - 1)) / static_cast<double>((1 << bits[i]) - 1);
    }
    return value;
  };
  unsigned seed = 0;
  for (const Pair& stored : kPairs) {
    for (const Pair& given : kPairs) {
      if (stored.format != given.format || stored.type == given.type) continue;
      for (const bool resident : {false, true}) {
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(stored.format), 64, 16, 0, stored.format,
                     stored.type, nullptr);
        if (resident) draw();
        const size_t bytes = given.element * given.perTexel;
        const std::vector<uint8_t> data = noise(64 * 16 * bytes, ++seed);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 64, 16, given.format, given.type, data.data());
        FakeImage* image = draw();
        ASSERT_EQ(image->desc().format, stored.stored);
        const render::FormatInfo& info = render::info(stored.stored);
        const std::array<int, 4> bits{info.red, info.green, info.blue, info.alpha};
        for (int i = 0; i < 64 * 16; ++i) {
          const auto wanted = exact(given, &data[static_cast<size_t>(i) * bytes]);
          const auto got = exact(stored, image->at(0, 0, i % 64, i / 64));
          for (size_t k = 0; k < 4; ++k) {
            if (bits[k] == 0) continue;
            ASSERT_LE(std::abs(wanted[k] - got[k]), 0.5 / ((1 << bits[k]) - 1) + 1e-9) << "texel " << i;
          }
        }
      }
    }
  }
}

TEST_F(Unpacking, NullPixelsMakeALevel) {
  specify(0, 5, 6);
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->desc().width, 5);
  EXPECT_EQ(image->desc().height, 6);
  EXPECT_EQ(device.log.uploads, 0);
}

// What a sub-image does not touch of a level that never had texels is zero, not somebody's memory.
TEST_F(Unpacking, PartialSubImageOfUndefinedLevel) {
  specify(0, 4, 4);
  const std::vector<uint8_t> data = noise(4, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  FakeImage* image = draw();
  for (int i = 0; i < 16; ++i) {
    const bool touched = i % 4 == 2 && i / 4 == 1;
    EXPECT_EQ(image->texel(0, 0, i % 4, i / 4),
              touched ? (Texel{data[0], data[1], data[2], data[3]}) : Texel{});
  }
}

TEST_F(Unpacking, PixelStore) {
  for (const GLenum pname : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) {
    GLint value = 0;
    for (const GLint legal : {1, 2, 4, 8}) {
      glPixelStorei(pname, legal);
      glGetIntegerv(pname, &value);
      EXPECT_EQ(value, legal);
    }
    for (const GLint illegal : {-1, 0, 3, 16}) {
      glPixelStorei(pname, illegal);
      EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    glGetIntegerv(pname, &value);
    EXPECT_EQ(value, 8);
  }
}

}  // namespace
}  // namespace anteroom::test
