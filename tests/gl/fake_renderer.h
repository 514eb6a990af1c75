// A renderer that draws nothing: it remembers what it was asked for, and keeps images and buffers in memory.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "layer/gl/context/context.h"
#include "layer/gl/front_end.h"
#include "layer/render/renderer.h"

namespace anteroom::gl::test {

class FakeImage : public render::Image {
 public:
  explicit FakeImage(const render::ImageDesc& desc) : Image(desc) {}

  int width(int level) const { return std::max(1, desc_.width >> level); }
  int height(int level) const { return std::max(1, desc_.height >> level); }
  size_t pitch(int level) const {
    return static_cast<size_t>(width(level)) * render::info(desc_.format).bytes;
  }
  // Texels of one level and layer without gaps, GL's lowest row first.
  std::vector<std::byte>& texels(int level, int layer) {
    auto& bytes = texels_[{level, layer}];
    bytes.resize(pitch(level) * static_cast<size_t>(height(level)));
    return bytes;
  }

 private:
  std::map<std::pair<int, int>, std::vector<std::byte>> texels_;
};

class FakeBuffer : public render::Buffer {
 public:
  FakeBuffer(size_t size, const void* data) : Buffer(size), bytes_(size) {
    if (data) std::memcpy(bytes_.data(), data, size);
  }
  const std::byte* contents() const override { return bytes_.data(); }
  bool write(size_t offset, const void* data, size_t size) override {
    std::memcpy(bytes_.data() + offset, data, size);
    return true;
  }

 private:
  std::vector<std::byte> bytes_;
};

struct Draw {
  render::DrawCall call;
  gen::Groups changed;
  gen::PrimitiveClass primitive;
};

class FakeContext : public render::Context {
 public:
  std::vector<Draw> draws;
  std::vector<GLbitfield> clears;
  int flushes = 0, finishes = 0, uploads = 0;
  bool outOfMemory = false;  // what draws say

  bool draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) override {
    draws.push_back({call, changed, state.fixed.primitive});
    return !outOfMemory;
  }
  bool clear(const render::State&, gen::Groups, GLbitfield mask) override {
    clears.push_back(mask);
    return true;
  }
  bool readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect, render::Format format,
                  void* out, size_t rowPitch) override {
    auto& image = static_cast<FakeImage&>(*framebuffer.color.image);
    if (format != image.desc().format) return true;
    copyRows(image, framebuffer.color.level, framebuffer.color.layer, rect, static_cast<std::byte*>(out),
             rowPitch);
    return true;
  }
  bool upload(render::Image& target, const render::Region& region, const void* data, size_t rowPitch,
              size_t) override {
    ++uploads;
    auto& image = static_cast<FakeImage&>(target);
    auto& texels = image.texels(region.level, region.layer);
    const size_t bytes = render::info(image.desc().format).bytes;
    for (int y = 0; y < region.height; ++y) {
      std::memcpy(&texels[static_cast<size_t>(region.y + y) * image.pitch(region.level) +
                          static_cast<size_t>(region.x) * bytes],
                  static_cast<const std::byte*>(data) + static_cast<size_t>(y) * rowPitch,
                  static_cast<size_t>(region.width) * bytes);
    }
    return true;
  }
  bool copyFromFramebuffer(render::Image& target, const render::Region& region,
                           const render::Framebuffer& source, int x, int y) override {
    auto& image = static_cast<FakeImage&>(target);
    auto& from = static_cast<FakeImage&>(*source.color.image);
    if (from.desc().format != image.desc().format) return true;
    const size_t bytes = render::info(image.desc().format).bytes;
    std::byte* out =
        &image.texels(region.level, region.layer)[static_cast<size_t>(region.y) * image.pitch(region.level) +
                                                  static_cast<size_t>(region.x) * bytes];
    copyRows(from, source.color.level, source.color.layer, {x, y, region.width, region.height}, out,
             image.pitch(region.level));
    return true;
  }
  bool copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) override {
    const int layers = image.desc().dimension == render::Dimension::Cube ? 6 : 1;
    for (int layer = 0; layer < layers; ++layer) {
      static_cast<FakeImage&>(image).texels(level, layer) =
          static_cast<FakeImage&>(source).texels(sourceLevel, layer);
    }
    return true;
  }
  bool generateMipmaps(render::Image&) override { return true; }
  void flush() override { ++flushes; }
  void finish() override { ++finishes; }
  uint64_t insertFence() override { return 1; }
  bool waitFence(uint64_t, uint64_t) override { return true; }
  const render::Stats& stats() const override { return stats_; }

 private:
  static void copyRows(FakeImage& image, int level, int layer, const render::Rect& rect, std::byte* out,
                       size_t pitch) {
    const size_t bytes = render::info(image.desc().format).bytes;
    const auto& texels = image.texels(level, layer);
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        const int column = rect.x + x, row = rect.y + y;
        if (column < 0 || row < 0 || column >= image.width(level) || row >= image.height(level)) continue;
        std::memcpy(
            out + static_cast<size_t>(y) * pitch + static_cast<size_t>(x) * bytes,
            &texels[static_cast<size_t>(row) * image.pitch(level) + static_cast<size_t>(column) * bytes],
            bytes);
      }
    }
  }

  render::Stats stats_;
};

class FakeDevice : public render::Device {
 public:
  FakeDevice() {
    caps_.deviceName = "a fake";
    caps_.pointSizeRange[1] = 64;
    caps_.smoothPointSizeRange[1] = 32;
  }
  const render::Caps& caps() const override { return caps_; }
  std::shared_ptr<render::Image> createImage(const render::ImageDesc& desc) override {
    return std::make_shared<FakeImage>(desc);
  }
  std::shared_ptr<render::Buffer> createBuffer(size_t size, const void* data) override {
    return std::make_shared<FakeBuffer>(size, data);
  }
  std::unique_ptr<render::Context> createContext() override { return std::make_unique<FakeContext>(); }

 private:
  render::Caps caps_;
};

using ContextPtr = std::unique_ptr<Context, void (*)(Context*)>;

// A context that is current, with a framebuffer of 64 x 48 RGBA8, 24 bits of depth and 8 of stencil.
class GlTest : public testing::Test {
 protected:
  GlTest() : context(createContext(device, nullptr, {})) {
    framebuffer.width = 64;
    framebuffer.height = 48;
    framebuffer.color.image = image(render::Format::RGBA8);
    framebuffer.depth.image = framebuffer.stencil.image = image(render::Format::Depth24Stencil8);
    setDefaultFramebuffer(*context, &framebuffer);
    makeCurrent(context.get());
  }
  ~GlTest() override {
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    makeCurrent(nullptr);
  }

  std::shared_ptr<render::Image> image(render::Format format) {
    render::ImageDesc desc;
    desc.format = format;
    desc.width = 64;
    desc.height = 48;
    return device.createImage(desc);
  }
  FakeContext& renderer() { return static_cast<FakeContext&>(rendererOf(*context)); }
  render::State& state() { return context->state; }
  gen::Groups& changed() { return context->changed; }
  GLint integer(GLenum name) {
    GLint value[16] = {};
    glGetIntegerv(name, value);
    return value[0];
  }

  FakeDevice device;
  ContextPtr context;
  render::Framebuffer framebuffer;
};

}  // namespace anteroom::gl::test
