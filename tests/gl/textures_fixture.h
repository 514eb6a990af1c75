// A current context on the fake renderer, with a framebuffer of known colors.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "layer/gl/context/context.h"
#include "layer/gl/front_end.h"
#include "tests/fake_renderer/fake_renderer.h"

namespace anteroom::test {

using ContextPtr = std::unique_ptr<gl::Context, void (*)(gl::Context*)>;

// Table 3.4.
struct Pair {
  GLenum format, type;
  render::Format stored;
  size_t element;   // bytes
  size_t perTexel;  // elements
};
inline constexpr Pair kPairs[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, render::Format::RGBA8, 1, 4},
    {GL_RGB, GL_UNSIGNED_BYTE, render::Format::RGB8, 1, 3},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, render::Format::RGBA4444, 2, 1},
    {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, render::Format::RGBA5551, 2, 1},
    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, render::Format::RGB565, 2, 1},
    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, render::Format::LA8, 1, 2},
    {GL_LUMINANCE, GL_UNSIGNED_BYTE, render::Format::L8, 1, 1},
    {GL_ALPHA, GL_UNSIGNED_BYTE, render::Format::A8, 1, 1},
};

// Equation 3.11, in bytes.
inline size_t specifiedPitch(const Pair& pair, int width, size_t alignment) {
  const size_t s = pair.element, nl = pair.perTexel * static_cast<size_t>(width);
  const size_t k = s >= alignment ? nl : alignment / s * ((s * nl + alignment - 1) / alignment);
  return k * s;
}

inline std::vector<uint8_t> noise(size_t size, unsigned seed) {
  std::minstd_rand random(seed + 1);
  std::vector<uint8_t> bytes(size);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random() >> 8);
  return bytes;
}

inline Texel framebufferTexel(int x, int y) {
  return {x * 7 & 255, y * 11 & 255, (x + y) * 3 & 255, x * y & 255};
}

// With limits that tests can afford to exceed.
class SmallDevice : public FakeDevice {
 public:
  SmallDevice() {
    caps_.maxTextureSize = 1024;
    caps_.maxCubeMapSize = 256;
  }
};

class TexturesTest : public testing::Test {
 protected:
  static constexpr int kWidth = 32, kHeight = 24;

  void SetUp() override {
    useFramebuffer(render::Format::RGBA8);
    gl::makeCurrent(context.get());
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kPositions);
  }
  void TearDown() override { gl::makeCurrent(nullptr); }

  void useFramebuffer(render::Format format) {
    render::ImageDesc desc;
    desc.format = format;
    desc.width = kWidth;
    desc.height = kHeight;
    auto image = std::make_shared<FakeImage>(desc);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) encodeTexel(format, framebufferTexel(x, y), image->at(0, 0, x, y));
    }
    render::Framebuffer framebuffer;
    framebuffer.color.image = image;
    framebuffer.width = kWidth;
    framebuffer.height = kHeight;
    gl::setDefaultFramebuffer(*context, &framebuffer);
    color = image;
  }

  FakeContext& renderer(ContextPtr& c) { return dynamic_cast<FakeContext&>(gl::rendererOf(*c)); }

  // Draws, and hands back the image that unit 0 sampled; null: the unit was off.
  FakeImage* draw() { return drawWith(context); }
  FakeImage* drawWith(ContextPtr& c) {
    const int before = device.log.draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (device.log.draws == before) ADD_FAILURE() << "nothing was drawn";
    return dynamic_cast<FakeImage*>(renderer(c).textures[0].image);
  }

  static void filter(GLenum target, GLenum minFilter) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
  }

  static constexpr GLfloat kPositions[6] = {0, 0, 1, 0, 0, 1};

  SmallDevice device;
  ContextPtr context = gl::createContext(device, nullptr, {});
  std::shared_ptr<FakeImage> color;
};

// One texture, enabled on unit 0 without mipmapping.
class Texture2DTest : public TexturesTest {
 protected:
  void SetUp() override {
    TexturesTest::SetUp();
    glBindTexture(GL_TEXTURE_2D, 1);
    glEnable(GL_TEXTURE_2D);
    filter(GL_TEXTURE_2D, GL_NEAREST);
  }

  static void specify(int level, int width, int height, GLenum format = GL_RGBA, const void* data = nullptr) {
    glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), width, height, 0, format, GL_UNSIGNED_BYTE,
                 data);
  }
};

}  // namespace anteroom::test
