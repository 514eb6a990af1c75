// Operations on images alone, through a recorder: no context, no draw.
#include <cstring>

#include "layer/vulkan/images/attachments.h"
#include "layer/vulkan/images/clear.h"
#include "layer/vulkan/images/copy.h"
#include "layer/vulkan/images/hud.h"
#include "layer/vulkan/images/mipmaps.h"
#include "layer/vulkan/images/read_back.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/images/upload.h"
#include "tests/vulkan/parts.h"

namespace anteroom::test {
namespace {

constexpr Pixel kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};

class Images : public Part {
 protected:
  void SetUp() override { ASSERT_TRUE(recorder_.initialise()); }

  Pixel at(const render::Framebuffer& framebuffer, int x, int y) {
    Pixel pixel{};
    EXPECT_TRUE(vulkan::readPixels(recorder_, framebuffer, {x, y, 1, 1}, render::Format::RGBA8, &pixel, 4));
    return pixel;
  }
  // All of a level in one color.
  void fill(Picture& picture, int level, Pixel color) {
    render::Region region;
    region.level = level;
    region.width = picture.image().levelWidth(level);
    region.height = picture.image().levelHeight(level);
    const std::vector<Pixel> texels(static_cast<size_t>(region.width) * region.height, color);
    const size_t pitch = static_cast<size_t>(region.width) * 4;
    ASSERT_TRUE(vulkan::upload(recorder_, picture.image(), region, texels.data(), pitch, 0));
  }
  static render::Framebuffer levelOf(Picture& picture, int level) {
    render::Framebuffer framebuffer = picture.framebuffer;
    framebuffer.color.level = level;
    framebuffer.width = picture.image().levelWidth(level);
    framebuffer.height = picture.image().levelHeight(level);
    return framebuffer;
  }

  vulkan::Recorder recorder_{device()};
};

TEST_P(Images, ClearsWaitUntilSomebodyLooks) {
  Picture picture(device());
  render::State state;
  state.clear.color = {1, 0, 0, 1};
  ASSERT_TRUE(vulkan::clear(recorder_, picture.target(), state, GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(recorder_.passes(), 0u);
  EXPECT_EQ(at(picture.framebuffer, 3, 3), kRed);
  EXPECT_EQ(recorder_.passes(), 1u);
  state.clear.color = {0, 0, 1, 1};
  state.scissorTest = true;
  state.scissor = {0, 0, 4, 8};
  ASSERT_TRUE(vulkan::clear(recorder_, picture.target(), state, GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(at(picture.framebuffer, 3, 3), kBlue);
  EXPECT_EQ(at(picture.framebuffer, 4, 3), kRed);
  state.ops.colorMask = {false, true, false, false};
  state.clear.color = {1, 1, 1, 1};
  ASSERT_TRUE(vulkan::clear(recorder_, picture.target(), state, GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(at(picture.framebuffer, 3, 3), (Pixel{0, 255, 255, 255}));
}

TEST_P(Images, TexelsAreUploadedCopiedAndHalved) {
  Picture source(device(), 4, 4, 3), copy(device(), 4, 4, 3);
  fill(source, 0, kRed);
  ASSERT_TRUE(vulkan::generateMipmaps(recorder_, source.image()));
  EXPECT_EQ(at(levelOf(source, 2), 0, 0), kRed);
  fill(source, 1, kBlue);
  ASSERT_TRUE(vulkan::copyLevel(recorder_, copy.image(), 1, source.image(), 1));
  EXPECT_EQ(at(levelOf(copy, 1), 1, 1), kBlue);
  render::Region region;
  region.x = region.y = 2;
  region.width = region.height = 2;
  ASSERT_TRUE(vulkan::copyFromFramebuffer(recorder_, copy.image(), region, source.framebuffer, 0, 0));
  EXPECT_EQ(at(copy.framebuffer, 2, 2), kRed);
  EXPECT_EQ(at(copy.framebuffer, 1, 1), (Pixel{0, 0, 0, 0}));
  EXPECT_EQ(recorder_.uploaded(), 16u * 4 + 4 * 4);
}

TEST_P(Images, AStoreInUseIsReplacedByTheNextVersion) {
  Picture picture(device());
  fill(picture, 0, kRed);
  const auto first = picture.image().held();  // as a recording would
  fill(picture, 0, kBlue);
  EXPECT_EQ(first->mapped != nullptr, picture.image().held() != first);
  EXPECT_EQ(at(picture.framebuffer, 0, 0), kBlue);
}

// EXT_multisampled_render_to_texture: samples start with what the texture holds.
TEST_P(Images, SamplesAreLoadedWhenTheTextureChanged) {
  Picture texture(device());
  fill(texture, 0, kRed);
  render::ImageDesc desc = texture.image().desc();
  desc.samples = device().caps().maxSamples;
  ASSERT_GT(desc.samples, 1);
  render::Framebuffer framebuffer = texture.framebuffer;
  framebuffer.resolve = framebuffer.color;
  framebuffer.color.image = device().createImage(desc);
  framebuffer.samples = desc.samples;
  const vulkan::Target target = vulkan::targetOf(framebuffer);
  ASSERT_TRUE(vulkan::prepareAttachments(recorder_, target));
  EXPECT_EQ(recorder_.passes(), 1u);
  ASSERT_TRUE(recorder_.openPass(target, false));
  recorder_.endPass();
  EXPECT_EQ(at(framebuffer, 4, 4), kRed) << "resolved from the samples";
  ASSERT_TRUE(vulkan::prepareAttachments(recorder_, target));
  EXPECT_EQ(recorder_.passes(), 2u) << "they still hold what the texture does";
  fill(texture, 0, kBlue);
  ASSERT_TRUE(vulkan::prepareAttachments(recorder_, target));
  EXPECT_EQ(recorder_.passes(), 3u);
}

TEST_P(Images, TheHudIsDrawnAndNotCounted) {
  Picture picture(device(), 256, 128);
  render::Hud hud;
  hud.lines = 1;
  hud.text[0].fill('M');
  ASSERT_TRUE(vulkan::drawHud(recorder_, picture.target(), hud));
  EXPECT_EQ(recorder_.passes(), 0u);
  int lit = 0;
  for (int x = 0; x < 64; ++x) lit += at(picture.framebuffer, x, 128 - 12)[0] > 200;
  EXPECT_GT(lit, 8) << "letters";
  EXPECT_EQ(at(picture.framebuffer, 128, 20), (Pixel{0, 0, 0, 0})) << "below the plate";
}

INSTANTIATE_TEST_SUITE_P(Profiles, Images, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
