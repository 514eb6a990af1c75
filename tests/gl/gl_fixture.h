// A context that is current, on a renderer that draws nothing.
#pragma once

#include <gtest/gtest.h>

#include "layer/gl/context/context.h"
#include "layer/gl/front_end.h"
#include "tests/fake_renderer/fake_renderer.h"

namespace anteroom::gl::test {

using anteroom::test::FakeContext;
using anteroom::test::FakeDevice;
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
