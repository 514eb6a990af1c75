// Texels: every format goes in and comes out unchanged, through textures, copies and framebuffers.
#include "layer/vulkan/vulkan_device.h"
#include "tests/vulkan/scene.h"

namespace anteroom::test {
namespace {

using render::Format;

class Texels : public testing::TestWithParam<bool> {
 protected:
  void TearDown() override { EXPECT_EQ(vulkan::validationMessages(), 0u); }
};

struct Sample {
  Format format;
  GLenum baseFormat;
  std::vector<uint8_t> bytes;  // one texel
  Pixel read;                  // with texture environment REPLACE on white, into RGBA8
};
const Sample kSamples[] = {
    {Format::A8, GL_ALPHA, {100}, {255, 255, 255, 100}},
    {Format::L8, GL_LUMINANCE, {100}, {100, 100, 100, 255}},
    {Format::LA8, GL_LUMINANCE_ALPHA, {100, 50}, {100, 100, 100, 50}},
    {Format::RGB8, GL_RGB, {10, 20, 30}, {10, 20, 30, 255}},
    {Format::RGBA8, GL_RGBA, {10, 20, 30, 40}, {10, 20, 30, 40}},
    {Format::RGB565, GL_RGB, {0x1f, 0xf8}, {255, 0, 255, 255}},
    {Format::RGBA4444, GL_RGBA, {0x34, 0x12}, {0x11, 0x22, 0x33, 0x44}},
    {Format::RGBA5551, GL_RGBA, {0xc1, 0x07}, {0, 255, 0, 255}},
};

std::shared_ptr<render::Image> image(Scene& scene, Format format, int size = 4, int levels = 1,
                                     render::Dimension dimension = render::Dimension::Flat) {
  render::ImageDesc desc;
  desc.dimension = dimension;
  desc.format = format;
  desc.width = desc.height = size;
  if (dimension == render::Dimension::Volume) desc.depth = size;
  desc.levels = levels;
  return scene.device.createImage(desc);
}

void fill(Scene& scene, render::Image& image, const std::vector<uint8_t>& texel, int level = 0,
          int layer = 0) {
  const int size = std::max(1, image.desc().width >> level);
  const int depth = std::max(1, image.desc().depth >> level);
  std::vector<uint8_t> texels;
  for (int i = 0; i < size * size * depth; ++i) texels.insert(texels.end(), texel.begin(), texel.end());
  const size_t row = texel.size() * size;
  render::Region region{level, layer, 0, 0, 0, size, size, depth};
  ASSERT_TRUE(scene.context->upload(image, region, texels.data(), row, row * size));
}

void bind(Scene& scene, render::Image& image, GLenum baseFormat, GLenum minFilter = GL_NEAREST) {
  gen::TextureUnit& unit = scene.state.fixed.units[0];
  unit.target = image.desc().dimension == render::Dimension::Cube     ? gen::TextureTarget::CubeMap
                : image.desc().dimension == render::Dimension::Volume ? gen::TextureTarget::Texture3D
                                                                      : gen::TextureTarget::Texture2D;
  unit.baseFormat = baseFormat;
  unit.env.mode = GL_REPLACE;
  scene.state.textures[0].image = &image;
  scene.state.textures[0].sampler.minFilter = minFilter;
  scene.state.textures[0].sampler.magFilter = GL_NEAREST;
  scene.changed |= gen::kGroupTextures;
}

void coordinates(Scene& scene, const glm::vec3& c) {
  scene.state.fixed.attributes[gen::texCoord(0)].current = {c, 1};
  scene.changed |= gen::kGroupCurrentOther;
}

render::Framebuffer framebufferOf(const std::shared_ptr<render::Image>& image) {
  render::Framebuffer framebuffer;
  framebuffer.color.image = image;
  framebuffer.width = image->desc().width;
  framebuffer.height = image->desc().height;
  return framebuffer;
}

TEST_P(Texels, EveryFormatIsSampled) {
  Scene scene(GetParam());
  for (const Sample& sample : kSamples) {
    const auto texture = image(scene, sample.format);
    fill(scene, *texture, sample.bytes);
    bind(scene, *texture, sample.baseFormat);
    scene.clear(GL_COLOR_BUFFER_BIT);
    scene.cover();
    EXPECT_EQ(scene.at(7, 7), sample.read) << static_cast<int>(sample.format);
  }
}

TEST_P(Texels, RenderableFormatsAreReadAsTheyWereWritten) {
  Scene scene(GetParam());
  for (const Sample& sample : kSamples) {
    if (!scene.device.caps().renderable[static_cast<int>(sample.format)]) continue;
    const auto target = image(scene, sample.format);
    fill(scene, *target, sample.bytes);
    const render::Framebuffer framebuffer = framebufferOf(target);
    std::vector<uint8_t> own(sample.bytes.size());
    ASSERT_TRUE(scene.context->readPixels(framebuffer, {2, 1, 1, 1}, sample.format, own.data(), own.size()));
    EXPECT_EQ(own, sample.bytes);
    Pixel pixel;
    ASSERT_TRUE(scene.context->readPixels(framebuffer, {2, 1, 1, 1}, Format::RGBA8, pixel.data(), 4));
    EXPECT_EQ(pixel, sample.read);
  }
}

TEST_P(Texels, RenderableFormatsHoldEveryValue) {
  Scene scene(GetParam());
  for (const Format format : {Format::RGBA4444, Format::RGBA5551, Format::RGB565}) {
    ASSERT_TRUE(GetParam() || scene.device.caps().renderable[static_cast<int>(format)]);
    if (!scene.device.caps().renderable[static_cast<int>(format)]) continue;
    Scene small(GetParam(), 4, 4, format, Format::None);
    const float green = format == Format::RGBA4444 ? 7 / 15.0f
                        : format == Format::RGB565 ? 31 / 63.0f
                                                   : 9 / 31.0f;
    small.color(1, green, 0, 1);
    small.cover();
    uint16_t texel = 0;
    ASSERT_TRUE(small.context->readPixels(small.state.framebuffer, {0, 0, 1, 1}, format, &texel, 2));
    EXPECT_EQ(texel, format == Format::RGBA4444 ? 0xf70f
                     : format == Format::RGB565 ? 0xf800 | 31 << 5
                                                : 0xf800 | 9 << 6 | 1);
  }
}

TEST_P(Texels, DrawsSeeTheTexelsOfTheirTime) {
  Scene scene(GetParam());
  const auto texture = image(scene, Format::RGBA8);
  bind(scene, *texture, GL_RGBA);
  scene.state.scissorTest = true;
  for (int i = 0; i < 16; ++i) {
    fill(scene, *texture, {static_cast<uint8_t>(i * 10), 0, 0, 255});
    scene.state.scissor = {i, 0, 1, 16};
    scene.changed |= gen::kGroupViewport;
    scene.cover();
  }
  const auto pixels = scene.read();
  for (int i = 0; i < 16; ++i) EXPECT_EQ(pixels[i][0], i * 10);
}

TEST_P(Texels, PartOfATextureInUse) {
  Scene scene(GetParam());
  const auto texture = image(scene, Format::RGBA8, 512);  // too large to be kept in versions
  const auto small = image(scene, Format::RGBA8, 4);
  for (const auto& held : {texture, small}) {
    fill(scene, *held, {255, 0, 0, 255});
    bind(scene, *held, GL_RGBA);
    coordinates(scene, {0, 0, 0});
    scene.cover();
    const Pixel green{0, 255, 0, 255};
    ASSERT_TRUE(scene.context->upload(*held, {0, 0, 0, 0, 0, 1, 1, 1}, green.data(), 4, 4));
    scene.state.scissorTest = true;
    scene.state.scissor = {0, 0, 8, 16};
    scene.changed |= gen::kGroupViewport;
    scene.cover();
    EXPECT_EQ(scene.at(2, 2), green);
    EXPECT_EQ(scene.at(12, 2), (Pixel{255, 0, 0, 255}));
    coordinates(scene, {0.9f, 0.9f, 0});
    scene.cover();
    EXPECT_EQ(scene.at(2, 2), (Pixel{255, 0, 0, 255}));
    scene.state.scissorTest = false;
    scene.changed |= gen::kGroupViewport;
  }
}

TEST_P(Texels, RenderedTexturesAreSampled) {
  Scene scene(GetParam());
  const auto texture = image(scene, Format::RGBA8, 16);
  const render::Framebuffer window = scene.state.framebuffer;
  for (const float shade : {0.0f, 1.0f}) {
    scene.state.framebuffer = framebufferOf(texture);
    scene.state.fixed.units[0].target = gen::TextureTarget::None;
    scene.changed |= gen::kGroupFramebuffer | gen::kGroupTextures;
    scene.color(shade, 1, 0);
    scene.cover();
    scene.state.framebuffer = window;
    scene.changed |= gen::kGroupFramebuffer;
    bind(scene, *texture, GL_RGBA);
    scene.cover();
    EXPECT_EQ(scene.at(7, 7), (Pixel{static_cast<uint8_t>(shade * 255), 255, 0, 255}));
  }
  // A clear that nothing followed is seen too.
  scene.state.framebuffer = framebufferOf(texture);
  scene.changed |= gen::kGroupFramebuffer;
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 0, 1);
  scene.state.framebuffer = window;
  scene.changed |= gen::kGroupFramebuffer;
  scene.cover();
  EXPECT_EQ(scene.at(7, 7), (Pixel{0, 0, 255, 255}));
}

TEST_P(Texels, CopiesFromTheFramebuffer) {
  for (const bool yDown : {false, true}) {
    Scene scene(GetParam());
    scene.state.framebuffer.yDown = yDown;
    scene.clear(GL_COLOR_BUFFER_BIT, 1, 0, 0, 0.2f);
    scene.state.scissorTest = true;
    scene.state.scissor = {0, 0, 16, 8};
    scene.clear(GL_COLOR_BUFFER_BIT, 0, 1, 0, 0.4f);
    scene.state.scissorTest = false;
    for (const auto& [format, low, high] :
         {std::tuple{Format::RGBA8, Pixel{0, 255, 0, 102}, Pixel{255, 0, 0, 51}},
          std::tuple{Format::RGB8, Pixel{0, 255, 0, 255}, Pixel{255, 0, 0, 255}},
          std::tuple{Format::RGB565, Pixel{0, 255, 0, 255}, Pixel{255, 0, 0, 255}},
          std::tuple{Format::L8, Pixel{0, 0, 0, 255}, Pixel{255, 255, 255, 255}},
          std::tuple{Format::LA8, Pixel{0, 0, 0, 102}, Pixel{255, 255, 255, 51}},
          std::tuple{Format::A8, Pixel{255, 255, 255, 102}, Pixel{255, 255, 255, 51}}}) {
      const auto texture = image(scene, format, 16);
      ASSERT_TRUE(scene.context->copyFromFramebuffer(*texture, {0, 0, 0, 0, 0, 16, 16, 1},
                                                     scene.state.framebuffer, 0, 0));
      Scene other(GetParam());
      other.context = std::move(scene.context);
      const GLenum base = format == Format::A8      ? GL_ALPHA
                          : format == Format::L8    ? GL_LUMINANCE
                          : format == Format::LA8   ? GL_LUMINANCE_ALPHA
                          : format == Format::RGBA8 ? GL_RGBA
                                                    : GL_RGB;
      bind(other, *texture, base);
      coordinates(other, {0.5f, 0.25f, 0});
      other.cover();
      EXPECT_EQ(other.at(3, 3), low) << static_cast<int>(format);
      coordinates(other, {0.5f, 0.75f, 0});
      other.cover();
      EXPECT_EQ(other.at(3, 3), high) << static_cast<int>(format);
      scene.context = std::move(other.context);
      scene.changed = gen::kAllGroups;
    }
  }
}

TEST_P(Texels, CopiesOutsideTheFramebufferLeaveTexelsAlone) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 1, 0);
  const auto texture = image(scene, Format::RGBA8, 16);
  fill(scene, *texture, {255, 0, 0, 255});
  ASSERT_TRUE(scene.context->copyFromFramebuffer(*texture, {0, 0, 0, 0, 0, 16, 16, 1},
                                                 scene.state.framebuffer, -8, 2147483647 - 20));
  ASSERT_TRUE(scene.context->copyFromFramebuffer(*texture, {0, 0, 0, 0, 0, 16, 16, 1},
                                                 scene.state.framebuffer, -8, 4));
  Pixel pixel;
  const auto at = [&](int x, int y) {
    EXPECT_TRUE(
        scene.context->readPixels(framebufferOf(texture), {x, y, 1, 1}, Format::RGBA8, pixel.data(), 4));
    return pixel;
  };
  EXPECT_EQ(at(4, 4), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(at(12, 4), (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(at(12, 14), (Pixel{255, 0, 0, 255}));
}

TEST_P(Texels, MipmapsAreMeans) {
  Scene scene(GetParam());
  const auto texture = image(scene, Format::RGBA8, 4, 3);
  std::vector<Pixel> checker(16);
  for (int i = 0; i < 16; ++i) checker[i] = (i + i / 4) % 2 ? Pixel{255, 0, 0, 255} : Pixel{0, 0, 101, 255};
  ASSERT_TRUE(scene.context->upload(*texture, {0, 0, 0, 0, 0, 4, 4, 1}, checker.data(), 16, 64));
  ASSERT_TRUE(scene.context->generateMipmaps(*texture));
  bind(scene, *texture, GL_RGBA, GL_NEAREST_MIPMAP_NEAREST);
  // A constant coordinate selects level 0: levels are read through a framebuffer.
  for (int level = 1; level < 3; ++level) {
    render::Framebuffer framebuffer = framebufferOf(texture);
    framebuffer.color.level = level;
    framebuffer.width = framebuffer.height = 4 >> level;
    Pixel pixel;
    ASSERT_TRUE(scene.context->readPixels(framebuffer, {0, 0, 1, 1}, Format::RGBA8, pixel.data(), 4));
    EXPECT_NEAR(pixel[0], 128, 1);
    EXPECT_NEAR(pixel[2], 51, 1);
  }
}

TEST_P(Texels, CubesAndVolumes) {
  Scene scene(GetParam());
  const auto cube = image(scene, Format::RGBA8, 4, 1, render::Dimension::Cube);
  for (int face = 0; face < 6; ++face)
    fill(scene, *cube, {static_cast<uint8_t>(face * 40), 0, 0, 255}, 0, face);
  bind(scene, *cube, GL_RGBA);
  const glm::vec3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int face = 0; face < 6; ++face) {
    coordinates(scene, directions[face]);
    scene.cover();
    EXPECT_EQ(scene.at(7, 7)[0], face * 40);
  }
  const auto volume = image(scene, Format::L8, 4, 1, render::Dimension::Volume);
  fill(scene, *volume, {77});
  bind(scene, *volume, GL_LUMINANCE);
  scene.cover();
  EXPECT_EQ(scene.at(7, 7)[0], 77);
}

TEST_P(Texels, ReadsHangOverTheEdge) {
  Scene scene(GetParam());
  scene.clear(GL_COLOR_BUFFER_BIT, 0, 1, 0);
  std::vector<Pixel> pixels(16, Pixel{9, 9, 9, 9});
  ASSERT_TRUE(
      scene.context->readPixels(scene.state.framebuffer, {-2, 14, 4, 4}, Format::RGBA8, pixels.data(), 16));
  EXPECT_EQ(pixels[0], (Pixel{9, 9, 9, 9}));
  EXPECT_EQ(pixels[2], (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(pixels[15], (Pixel{9, 9, 9, 9}));
}

INSTANTIATE_TEST_SUITE_P(Profiles, Texels, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
