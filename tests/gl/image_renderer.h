// A renderer that keeps images and buffers in memory, checks what it is asked for, and can run out of memory.
#pragma once

#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "layer/render/renderer.h"

namespace anteroom::test {

using Texel = std::array<int, 4>;  // RGBA, 0 to 255

// A format's components as 8-bit ones, rounded to nearest; written apart from the code under test.
Texel decodeTexel(render::Format format, const uint8_t* texel);
void encodeTexel(render::Format format, const Texel& value, uint8_t* texel);

class FakeImage : public render::Image {
 public:
  explicit FakeImage(const render::ImageDesc& desc);
  int layers() const { return desc_.dimension == render::Dimension::Cube ? 6 : 1; }
  int width(int level) const { return std::max(desc_.width >> level, 1); }
  int height(int level) const { return std::max(desc_.height >> level, 1); }
  size_t bytes() const { return render::info(desc_.format).bytes; }
  uint8_t* at(int level, int layer, int x, int y) {
    return &texels_[static_cast<size_t>(level * layers() + layer)]
                   [(static_cast<size_t>(y) * static_cast<size_t>(width(level)) + static_cast<size_t>(x)) *
                    bytes()];
  }
  Texel texel(int level, int layer, int x, int y) {
    return decodeTexel(desc_.format, at(level, layer, x, y));
  }

 private:
  std::vector<std::vector<uint8_t>> texels_;
};

// What can fail, and what happened.
struct FakeLog {
  int failAfter = -1;  // renderer calls that can run out of memory until one does; negative: never
  int images = 0, buffers = 0, uploads = 0, copies = 0, levelCopies = 0, mipmaps = 0, draws = 0;
  int liveImages = 0;
  const void* lastUpload = nullptr;

  bool fails() { return failAfter >= 0 && failAfter-- == 0; }
};

class FakeContext : public render::Context {
 public:
  explicit FakeContext(FakeLog& log) : log_(log) {}
  bool draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) override;
  bool clear(const render::State& state, gen::Groups changed, GLbitfield mask) override;
  bool readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect, render::Format format,
                  void* out, size_t rowPitch) override;
  bool upload(render::Image& image, const render::Region& region, const void* data, size_t rowPitch,
              size_t slicePitch) override;
  bool copyFromFramebuffer(render::Image& image, const render::Region& region,
                           const render::Framebuffer& source, int x, int y) override;
  bool copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) override;
  bool generateMipmaps(render::Image& image) override;
  void flush() override {}
  void finish() override {}
  uint64_t insertFence() override { return 0; }
  bool waitFence(uint64_t, uint64_t) override { return true; }
  const render::Stats& stats() const override { return stats_; }

  // Units of the last draw.
  std::array<gen::TextureUnit, gen::kMaxTextureUnits> units;
  std::array<render::TextureBinding, gen::kMaxTextureUnits> textures;

 private:
  FakeLog& log_;
  render::Stats stats_;
};

class FakeDevice : public render::Device {
 public:
  FakeDevice();
  const render::Caps& caps() const override { return caps_; }
  std::shared_ptr<render::Image> createImage(const render::ImageDesc& desc) override;
  std::shared_ptr<render::Buffer> createBuffer(size_t size, const void* data) override;
  std::unique_ptr<render::Context> createContext() override { return std::make_unique<FakeContext>(log); }

  FakeLog log;

 private:
  render::Caps caps_;
};

}  // namespace anteroom::test
