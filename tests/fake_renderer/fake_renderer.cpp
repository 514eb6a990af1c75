#include "tests/fake_renderer/fake_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace anteroom::test {

using render::Format;

namespace {

int scale(int value, int from, int to) {
  return static_cast<int>(std::lround(static_cast<double>(value) / from * to));
}

// Fields of a packed format, from the highest bit.
std::array<int, 4> fieldBits(Format format) {
  switch (format) {
    case Format::RGB565:
      return {5, 6, 5, 0};
    case Format::RGBA4444:
      return {4, 4, 4, 4};
    case Format::RGBA5551:
      return {5, 5, 5, 1};
    default:
      return {};
  }
}

FakeImage& fake(render::Image& image) {
  return dynamic_cast<FakeImage&>(image);
}

class FakeBuffer : public render::Buffer {
 public:
  FakeBuffer(size_t size, const void* data, FakeLog& log) : Buffer(size), bytes_(size), log_(log) {
    if (data) std::memcpy(bytes_.data(), data, size);
  }
  const std::byte* contents() const override { return bytes_.data(); }
  bool write(size_t offset, const void* data, size_t size) override {
    EXPECT_LE(offset, bytes_.size());
    EXPECT_LE(size, bytes_.size() - offset);
    if (log_.fails()) return false;
    std::memcpy(bytes_.data() + offset, data, size);
    return true;
  }

 private:
  std::vector<std::byte> bytes_;
  FakeLog& log_;
};

void expectInside(FakeImage& image, const render::Region& r) {
  ASSERT_GT(image.bytes(), 0u);
  ASSERT_GE(r.level, 0);
  ASSERT_LT(r.level, image.desc().levels);
  ASSERT_GE(r.layer, 0);
  ASSERT_LT(r.layer, image.layers());
  ASSERT_TRUE(r.x >= 0 && r.y >= 0 && r.z == 0 && r.width > 0 && r.height > 0 && r.depth == 1);
  ASSERT_LE(r.x + r.width, image.width(r.level));
  ASSERT_LE(r.y + r.height, image.height(r.level));
}

}  // namespace

Texel decodeTexel(Format format, const uint8_t* t) {
  switch (format) {
    case Format::A8:
      return {0, 0, 0, t[0]};
    case Format::L8:
      return {t[0], t[0], t[0], 255};
    case Format::LA8:
      return {t[0], t[0], t[0], t[1]};
    case Format::RGB8:
    case Format::SRGB8:
      return {t[0], t[1], t[2], 255};
    case Format::RGBA8:
    case Format::SRGB8Alpha8:
      return {t[0], t[1], t[2], t[3]};
    default:
      break;
  }
  uint16_t packed;
  std::memcpy(&packed, t, 2);
  Texel value{0, 0, 0, 255};
  int shift = 16;
  for (size_t i = 0; i < 4; ++i) {
    const int bits = fieldBits(format)[i];
    if (bits == 0) continue;
    shift -= bits;
    value[i] = scale(packed >> shift & ((1 << bits) - 1), (1 << bits) - 1, 255);
  }
  return value;
}

void encodeTexel(Format format, const Texel& value, uint8_t* t) {
  const auto byte = [](int v) { return static_cast<uint8_t>(v); };
  switch (format) {
    case Format::A8:
      t[0] = byte(value[3]);
      return;
    case Format::LA8:
      t[1] = byte(value[3]);
      [[fallthrough]];
    case Format::L8:
      t[0] = byte(value[0]);
      return;
    case Format::RGBA8:
    case Format::SRGB8Alpha8:
      t[3] = byte(value[3]);
      [[fallthrough]];
    case Format::RGB8:
    case Format::SRGB8:
      for (size_t i = 0; i < 3; ++i) t[i] = byte(value[i]);
      return;
    default:
      break;
  }
  uint16_t packed = 0;
  int shift = 16;
  for (size_t i = 0; i < 4; ++i) {
    const int bits = fieldBits(format)[i];
    if (bits == 0) continue;
    shift -= bits;
    packed = static_cast<uint16_t>(packed | scale(value[i], 255, (1 << bits) - 1) << shift);
  }
  std::memcpy(t, &packed, 2);
}

FakeImage::FakeImage(const render::ImageDesc& desc)
    : Image(desc), texels_(static_cast<size_t>(desc.levels * layers())) {}

uint8_t* FakeImage::at(int level, int layer, int x, int y) {
  const auto pitch = static_cast<size_t>(width(level)) * bytes();
  std::vector<uint8_t>& texels = texels_[static_cast<size_t>(level * layers() + layer)];
  if (texels.empty()) texels.assign(pitch * static_cast<size_t>(height(level)), uint8_t{0xcd});
  return &texels[static_cast<size_t>(y) * pitch + static_cast<size_t>(x) * bytes()];
}

FakeDevice::FakeDevice(FakeLog& shared) : log(shared) {
  caps_.deviceName = "a fake";
  caps_.pointSizeRange[1] = 64;
  caps_.smoothPointSizeRange[1] = 32;
}

std::shared_ptr<render::Image> FakeDevice::createImage(const render::ImageDesc& desc) {
  EXPECT_TRUE(desc.width > 0 && desc.height > 0 && desc.depth > 0 && desc.levels > 0 && desc.samples > 0);
  EXPECT_LE(desc.levels, static_cast<int>(std::log2(std::max(desc.width, desc.height))) + 1);
  if (log.fails()) return nullptr;
  ++log.images;
  ++log.liveImages;
  return {new FakeImage(desc), [&log = log](FakeImage* image) {
            --log.liveImages;
            delete image;
          }};
}

std::shared_ptr<render::Buffer> FakeDevice::createBuffer(size_t size, const void* data) {
  EXPECT_GT(size, 0u);
  if (log.fails() || size > (1u << 24)) return nullptr;
  ++log.buffers;
  return std::make_shared<FakeBuffer>(size, data, log);
}

bool FakeContext::draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) {
  ++log_.draws;
  draws.push_back({call, changed, state.fixed.primitive});
  units = state.fixed.units;
  textures = state.textures;
  for (size_t i = 0; i < units.size(); ++i) {
    const bool on = units[i].target != gen::TextureTarget::None;
    EXPECT_EQ(textures[i].image != nullptr, on) << "unit " << i;
    if (!on) continue;
    const bool cube = units[i].target == gen::TextureTarget::CubeMap;
    EXPECT_EQ(textures[i].image->desc().dimension, cube ? render::Dimension::Cube : render::Dimension::Flat);
  }
  return !log_.fails();
}

bool FakeContext::clear(const render::State&, gen::Groups, GLbitfield mask) {
  clears.push_back(mask);
  return true;
}

bool FakeContext::readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect, Format format,
                             void* out, size_t rowPitch) {
  if (log_.fails()) return false;
  FakeImage& image = fake(*framebuffer.color.image);
  EXPECT_TRUE(format == Format::RGBA8 || format == image.desc().format);
  for (int y = std::max(rect.y, 0); y < std::min(rect.y + rect.height, framebuffer.height); ++y) {
    for (int x = std::max(rect.x, 0); x < std::min(rect.x + rect.width, framebuffer.width); ++x) {
      uint8_t* texel = static_cast<uint8_t*>(out) + static_cast<size_t>(y - rect.y) * rowPitch +
                       static_cast<size_t>(x - rect.x) * render::info(format).bytes;
      encodeTexel(format, image.texel(framebuffer.color.level, framebuffer.color.layer, x, y), texel);
    }
  }
  return true;
}

bool FakeContext::upload(render::Image& image, const render::Region& region, const void* data,
                         size_t rowPitch, size_t) {
  if (log_.fails()) return false;
  FakeImage& target = fake(image);
  expectInside(target, region);
  ++log_.uploads;
  log_.lastUpload = data;
  for (int y = 0; y < region.height; ++y) {
    std::memcpy(target.at(region.level, region.layer, region.x, region.y + y),
                static_cast<const uint8_t*>(data) + static_cast<size_t>(y) * rowPitch,
                static_cast<size_t>(region.width) * target.bytes());
  }
  return true;
}

bool FakeContext::copyFromFramebuffer(render::Image& image, const render::Region& region,
                                      const render::Framebuffer& source, int x, int y) {
  if (log_.fails()) return false;
  FakeImage& target = fake(image);
  FakeImage& from = fake(*source.color.image);
  expectInside(target, region);
  EXPECT_EQ(source.width, from.width(source.color.level));
  EXPECT_EQ(source.height, from.height(source.color.level));
  ++log_.copies;
  for (int j = 0; j < region.height; ++j) {
    for (int i = 0; i < region.width; ++i) {
      const int64_t sx = int64_t{x} + i, sy = int64_t{y} + j;
      if (sx < 0 || sy < 0 || sx >= source.width || sy >= source.height) continue;
      encodeTexel(
          target.desc().format,
          from.texel(source.color.level, source.color.layer, static_cast<int>(sx), static_cast<int>(sy)),
          target.at(region.level, region.layer, region.x + i, region.y + j));
    }
  }
  return true;
}

bool FakeContext::copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) {
  if (log_.fails()) return false;
  FakeImage &to = fake(image), &from = fake(source);
  EXPECT_EQ(to.desc().format, from.desc().format);
  EXPECT_EQ(to.desc().dimension, from.desc().dimension);
  EXPECT_TRUE(to.width(level) == from.width(sourceLevel) && to.height(level) == from.height(sourceLevel));
  ++log_.levelCopies;
  for (int layer = 0; layer < to.layers(); ++layer) {
    std::memcpy(to.at(level, layer, 0, 0), from.at(sourceLevel, layer, 0, 0),
                static_cast<size_t>(to.width(level)) * static_cast<size_t>(to.height(level)) * to.bytes());
  }
  return true;
}

// The mean of the texels below, rounded down: what counts here is which texels it is made of.
bool FakeContext::generateMipmaps(render::Image& image) {
  if (log_.fails()) return false;
  FakeImage& target = fake(image);
  ++log_.mipmaps;
  for (int level = 1; level < target.desc().levels; ++level) {
    const int w = target.width(level - 1), h = target.height(level - 1);
    for (int layer = 0; layer < target.layers(); ++layer) {
      for (int y = 0; y < target.height(level); ++y) {
        for (int x = 0; x < target.width(level); ++x) {
          Texel sum{};
          for (int k = 0; k < 4; ++k) {
            const Texel t = target.texel(level - 1, layer, std::min(2 * x + k % 2, w - 1),
                                         std::min(2 * y + k / 2, h - 1));
            for (size_t i = 0; i < 4; ++i) sum[i] += t[i];
          }
          for (int& component : sum) component /= 4;
          encodeTexel(target.desc().format, sum, target.at(level, layer, x, y));
        }
      }
    }
  }
  return true;
}

}  // namespace anteroom::test
