// Completeness (section 3.7.9, OES_texture_cube_map), and when texels get into images.
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

class TextureStorageCompleteness : public TexturesTest {
 protected:
  static void image(GLenum target, int level, int width, int height, GLenum format = GL_RGBA,
                    GLenum type = GL_UNSIGNED_BYTE) {
    glTexImage2D(target, level, static_cast<GLint>(format), width, height, 0, format, type, nullptr);
  }
  static void mipmaps(GLenum target, int width, int height, int levels) {
    for (int level = 0; level < levels; ++level) {
      image(target, level, std::max(width >> level, 1), std::max(height >> level, 1));
    }
  }
  static void all(int levels) {
    for (GLenum face = 0; face < 6; ++face) {
      mipmaps(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 8, 8, levels);
    }
  }
};

constexpr GLenum kFirst = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES;

TEST_F(TextureStorageCompleteness, Flat) {
  constexpr GLenum k2D = GL_TEXTURE_2D;
  struct Case {
    const char* what;
    bool withoutMipmaps, withMipmaps;
    void (*specify)();
  };
  const Case cases[] = {
      {"nothing", false, false, [] {}},
      {"level 0", true, false, [] { image(k2D, 0, 8, 8); }},
      {"1 x 1", true, true, [] { image(k2D, 0, 1, 1); }},
      {"all levels", true, true, [] { mipmaps(k2D, 8, 8, 4); }},
      {"tall", true, true, [] { mipmaps(k2D, 2, 16, 5); }},
      {"no power of two", true, true, [] { mipmaps(k2D, 13, 6, 4); }},
      {"last level missing", true, false, [] { mipmaps(k2D, 8, 8, 3); }},
      {"one level more", true, true, [] { mipmaps(k2D, 8, 8, 5); }},
      {"level 0 missing", false, false,
       [] {
         mipmaps(k2D, 8, 8, 4);
         image(k2D, 0, 0, 0);
       }},
      {"zero width", false, false, [] { image(k2D, 0, 0, 8); }},
      {"zero height", false, false, [] { image(k2D, 0, 8, 0); }},
      {"a level of another format", true, false,
       [] {
         mipmaps(k2D, 8, 8, 4);
         image(k2D, 2, 2, 2, GL_RGB);
       }},
      {"a level of another type", true, true,
       [] {
         mipmaps(k2D, 8, 8, 4);
         image(k2D, 2, 2, 2, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4);
       }},
      {"a level too wide", true, false,
       [] {
         mipmaps(k2D, 8, 8, 4);
         image(k2D, 1, 8, 4);
       }},
      {"a level too high", true, false,
       [] {
         mipmaps(k2D, 8, 8, 4);
         image(k2D, 3, 1, 2);
       }},
      {"only higher levels", false, false, [] { image(k2D, 1, 4, 4); }},
  };
  glEnable(GL_TEXTURE_2D);
  GLuint name = 1;
  for (const Case& test : cases) {
    SCOPED_TRACE(test.what);
    glBindTexture(GL_TEXTURE_2D, name++);
    test.specify();
    for (const GLenum plain : {GL_NEAREST, GL_LINEAR}) {
      filter(GL_TEXTURE_2D, plain);
      EXPECT_EQ(draw() != nullptr, test.withoutMipmaps);
    }
    for (GLenum mipmapped = GL_NEAREST_MIPMAP_NEAREST; mipmapped <= GL_LINEAR_MIPMAP_LINEAR; ++mipmapped) {
      filter(GL_TEXTURE_2D, mipmapped);
      EXPECT_EQ(draw() != nullptr, test.withMipmaps);
    }
  }
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(TextureStorageCompleteness, Cube) {
  struct Case {
    const char* what;
    bool withoutMipmaps, withMipmaps;
    void (*specify)();
  };
  const Case cases[] = {
      {"nothing", false, false, [] {}},
      {"one face", false, false, [] { image(kFirst, 0, 8, 8); }},
      {"level 0", true, false, [] { all(1); }},
      {"all levels", true, true, [] { all(4); }},
      {"a face of another size", false, false,
       [] {
         all(4);
         mipmaps(kFirst + 3, 4, 4, 3);
       }},
      {"a face of another format", false, false,
       [] {
         all(4);
         image(kFirst + 5, 0, 8, 8, GL_RGB);
       }},
      {"a level of one face missing", true, false,
       [] {
         all(4);
         image(kFirst + 4, 2, 0, 0);
       }},
      {"a level of one face of another format", true, false,
       [] {
         all(4);
         image(kFirst + 1, 1, 4, 4, GL_ALPHA);
       }},
  };
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  GLuint name = 1;
  for (const Case& test : cases) {
    SCOPED_TRACE(test.what);
    glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name++);
    test.specify();
    filter(GL_TEXTURE_CUBE_MAP_OES, GL_LINEAR);
    EXPECT_EQ(draw() != nullptr, test.withoutMipmaps);
    filter(GL_TEXTURE_CUBE_MAP_OES, GL_LINEAR_MIPMAP_LINEAR);
    EXPECT_EQ(draw() != nullptr, test.withMipmaps);
  }
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// OES_texture_cube_map: with both targets enabled the cube map counts, complete or not.
TEST_F(TextureStorageCompleteness, CubeMapBeats2DOnEveryUnit) {
  for (GLenum unit = 0; unit < 8; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, 1);
    glBindTexture(GL_TEXTURE_CUBE_MAP_OES, 2);
    glEnable(GL_TEXTURE_2D);
  }
  image(GL_TEXTURE_2D, 0, 1, 1, GL_LUMINANCE);
  draw();
  for (const gen::TextureUnit& unit : renderer(context).units) {
    EXPECT_EQ(unit.target, gen::TextureTarget::Texture2D);
    EXPECT_EQ(unit.baseFormat, GLenum{GL_LUMINANCE});
  }
  for (GLenum unit = 0; unit < 8; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glEnable(GL_TEXTURE_CUBE_MAP_OES);
  }
  draw();
  for (const gen::TextureUnit& unit : renderer(context).units)
    EXPECT_EQ(unit.target, gen::TextureTarget::None);
  for (GLenum face = 0; face < 6; ++face) image(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, 1, 1);
  draw();
  for (const gen::TextureUnit& unit : renderer(context).units)
    EXPECT_EQ(unit.target, gen::TextureTarget::CubeMap);
}

using TextureStorage = Texture2DTest;

TEST_F(TextureStorage, NothingBeforeTheFirstUse) {
  const std::vector<uint8_t> data = noise(16 * 16 * 4, 1);
  specify(0, 16, 16, GL_RGBA, data.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  EXPECT_EQ(device.log.images, 0);
  EXPECT_EQ(draw()->desc().levels, 1);
  EXPECT_EQ(device.log.images, 1);
  EXPECT_EQ(device.log.uploads, 1);
  draw();
  EXPECT_EQ(device.log.images, 1);
  EXPECT_EQ(device.log.uploads, 1);
}

TEST_F(TextureStorage, GrowsWhenMoreLevelsCanBeSelected) {
  const std::vector<uint8_t> data = noise(8 * 8 * 4, 1);
  for (int level = 0; level < 4; ++level) specify(level, 8 >> level, 8 >> level, GL_RGBA, data.data());
  EXPECT_EQ(draw()->desc().levels, 1);
  EXPECT_EQ(device.log.uploads, 1);
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_NEAREST);
  FakeImage* image = draw();
  EXPECT_EQ(image->desc().levels, 4);
  EXPECT_EQ(device.log.uploads, 4);
  EXPECT_EQ(device.log.levelCopies, 1);
  EXPECT_EQ(device.log.liveImages, 1);
  for (int level = 0; level < 4; ++level) {
    const auto bytes = static_cast<size_t>(4 * (8 >> level) * (8 >> level));
    EXPECT_EQ(std::memcmp(image->at(level, 0, 0, 0), data.data(), bytes), 0);
  }
  filter(GL_TEXTURE_2D, GL_LINEAR);  // and stays
  EXPECT_EQ(draw(), image);
}

TEST_F(TextureStorage, SubImageThenDrawIsOneUploadFromClientMemory) {
  const std::vector<uint8_t> data = noise(512 * 512 * 4, 1);
  specify(0, 512, 512);
  FakeImage* image = draw();
  for (int frame = 1; frame <= 3; ++frame) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 512, 512, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    EXPECT_EQ(draw(), image);
    EXPECT_EQ(device.log.uploads, frame);
    EXPECT_EQ(device.log.lastUpload, data.data());
  }
  EXPECT_EQ(device.log.images, 1);
}

// Levels of one internal format but different types are complete; they are kept in the wider format.
TEST_F(TextureStorage, LevelsOfDifferentTypes) {
  filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST);
  const std::vector<uint8_t> data = noise(64, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, data.data());
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->desc().format, render::Format::RGBA8);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(image->texel(0, 0, i % 2, i / 2),
              decodeTexel(render::Format::RGBA4444, &data[static_cast<size_t>(i) * 2]));
  }
  EXPECT_EQ(image->texel(1, 0, 0, 0), (Texel{data[0], data[1], data[2], data[3]}));
}

// What another level said survives while level 0 has another size for a while.
TEST_F(TextureStorage, LevelsOutliveTheImage) {
  filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST);
  const std::vector<uint8_t> data = noise(8 * 8 * 4, 1);
  for (int level = 0; level < 4; ++level) specify(level, 8 >> level, 8 >> level, GL_RGBA, data.data());
  draw();
  specify(0, 5, 7, GL_RGBA, data.data());
  EXPECT_FALSE(draw());
  filter(GL_TEXTURE_2D, GL_NEAREST);
  EXPECT_TRUE(draw());
  specify(0, 8, 8, GL_RGBA, data.data());
  filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST);
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  for (int level = 0; level < 4; ++level) {
    const auto bytes = static_cast<size_t>(4 * (8 >> level) * (8 >> level));
    EXPECT_EQ(std::memcmp(image->at(level, 0, 0, 0), data.data(), bytes), 0) << "level " << level;
  }
  EXPECT_EQ(device.log.liveImages, 1);
}

TEST_F(TextureStorage, AutomaticMipmapsAreMadeWhenTheyAreSampled) {
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  const std::vector<uint8_t> data(8 * 8 * 4, 200), other(8 * 8 * 4, 100);
  specify(0, 8, 8, GL_RGBA, data.data());
  draw();
  EXPECT_EQ(device.log.mipmaps, 0);
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  EXPECT_EQ(device.log.mipmaps, 1);
  EXPECT_EQ(image->texel(3, 0, 0, 0), (Texel{200, 200, 200, 200}));
  draw();
  EXPECT_EQ(device.log.mipmaps, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, other.data());
  EXPECT_EQ(draw(), image);
  EXPECT_EQ(device.log.mipmaps, 2);
  EXPECT_EQ(image->texel(3, 0, 0, 0), (Texel{100, 100, 100, 100}));
  // A level specified afterwards stands.
  specify(3, 1, 1, GL_RGBA, data.data());
  EXPECT_EQ(draw()->texel(3, 0, 0, 0), (Texel{200, 200, 200, 200}));
  EXPECT_EQ(device.log.mipmaps, 2);
  EXPECT_EQ(device.log.images, 2);
}

// Levels that were derived keep what they were derived from.
TEST_F(TextureStorage, DerivedLevelsSurviveAnUnderivedBase) {
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  const std::vector<uint8_t> data(8 * 8 * 4, 200), other(8 * 8 * 4, 100);
  specify(0, 8, 8, GL_RGBA, data.data());
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
  specify(0, 8, 8, GL_RGBA, other.data());
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  FakeImage* image = draw();
  EXPECT_EQ(image->texel(0, 0, 0, 0), (Texel{100, 100, 100, 100}));
  EXPECT_EQ(image->texel(1, 0, 0, 0), (Texel{200, 200, 200, 200}));
}

// Whatever call runs out of memory: the error, nothing changed, and the next try works.
TEST_F(TextureStorage, OutOfMemory) {
  const std::vector<uint8_t> data = noise(8 * 8 * 4, 1), other = noise(8 * 8 * 4, 2);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  specify(0, 8, 8, GL_RGBA, data.data());
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  for (int calls = 0; calls < 3; ++calls) {  // image, upload, mipmaps
    device.log.failAfter = calls;
    EXPECT_FALSE(draw());
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  }
  device.log.failAfter = -1;
  FakeImage* image = draw();
  ASSERT_TRUE(image);
  EXPECT_EQ(std::memcmp(image->at(0, 0, 0, 0), data.data(), data.size()), 0);

  const std::function<void()> commands[] = {
      [&] { specify(0, 8, 8, GL_RGBA, other.data()); },
      [&] { glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, other.data()); },
      [&] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8, 8, 0); },
      [&] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0); },
      [&] { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8); },
  };
  for (const auto& command : commands) {
    device.log.failAfter = 0;
    command();
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    device.log.failAfter = -1;
    EXPECT_EQ(draw(), image);
    EXPECT_EQ(std::memcmp(image->at(0, 0, 0, 0), data.data(), data.size()), 0);
  }
}

TEST_F(TextureStorage, SamplerState) {
  specify(0, 4, 4);
  draw();
  const render::TextureBinding& binding = renderer(context).textures[0];
  EXPECT_EQ(binding.sampler.minFilter, GLenum{GL_NEAREST});
  EXPECT_EQ(binding.sampler.magFilter, GLenum{GL_LINEAR});
  EXPECT_EQ(binding.sampler.wrapS, GLenum{GL_REPEAT});
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT_OES);
  draw();
  EXPECT_EQ(binding.sampler.magFilter, GLenum{GL_NEAREST});
  EXPECT_EQ(binding.sampler.wrapS, GLenum{GL_CLAMP_TO_EDGE});
  EXPECT_EQ(binding.sampler.wrapT, GLenum{GL_MIRRORED_REPEAT_OES});
}

TEST_F(TextureStorage, ImagesGoWithTheirTextures) {
  specify(0, 4, 4);
  draw();
  EXPECT_EQ(device.log.liveImages, 1);
  const GLuint name = 1;
  glDeleteTextures(1, &name);
  EXPECT_EQ(device.log.liveImages, 0);
  EXPECT_FALSE(draw());
}

}  // namespace
}  // namespace anteroom::test
