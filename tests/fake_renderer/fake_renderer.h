// A renderer that draws nothing: it remembers what it was asked for and checks it, keeps images and buffers
// in memory, and can run out of memory.
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
  uint8_t* at(int level, int layer, int x, int y);
  Texel texel(int level, int layer, int x, int y) {
    return decodeTexel(desc_.format, at(level, layer, x, y));
  }

 private:
  std::vector<std::vector<uint8_t>> texels_;  // of levels and layers, empty until they are touched
};

// What can fail, and what happened on a device.
struct FakeLog {
  bool outOfMemory = false;
  int failAfter = -1;  // renderer calls that can run out of memory until one does; negative: never
  bool fencesPass = true;
  int images = 0, buffers = 0, uploads = 0, copies = 0, levelCopies = 0, mipmaps = 0, draws = 0;
  int flushes = 0, finishes = 0;
  uint64_t fences = 0;
  int liveImages = 0;
  const void* lastUpload = nullptr;

  bool fails() { return outOfMemory || (failAfter >= 0 && failAfter-- == 0); }
};

struct Draw {
  render::DrawCall call;
  gen::Groups changed;
  gen::PrimitiveClass primitive;
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
  void flush() override { ++log_.flushes; }
  void finish() override { ++log_.finishes; }
  uint64_t insertFence() override { return ++log_.fences; }
  bool waitFence(uint64_t, uint64_t) override { return log_.fencesPass; }
  const render::Stats& stats() const override { return stats_; }

  std::vector<Draw> draws;
  std::vector<GLbitfield> clears;
  // Units of the last draw.
  std::array<gen::TextureUnit, gen::kMaxTextureUnits> units;
  std::array<render::TextureBinding, gen::kMaxTextureUnits> textures;

 private:
  FakeLog& log_;
  render::Stats stats_;
};

class FakeDevice : public render::Device {
 public:
  FakeDevice() : FakeDevice(ownLog_) {}
  explicit FakeDevice(FakeLog& shared);
  const render::Caps& caps() const override { return caps_; }
  std::shared_ptr<render::Image> createImage(const render::ImageDesc& desc) override;
  std::shared_ptr<render::Buffer> createBuffer(size_t size, const void* data) override;
  std::unique_ptr<render::Context> createContext() override { return std::make_unique<FakeContext>(log); }

  FakeLog& log;

 protected:
  render::Caps caps_;

 private:
  FakeLog ownLog_;
};

}  // namespace anteroom::test
