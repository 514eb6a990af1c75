// A small picture drawn through the seam alone: a device, a context, a state and a framebuffer.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "layer/render/renderer.h"

namespace anteroom::test {

// One device a profile for the whole test program; by default with validation.
render::Device& device(bool minimal, bool validation = true);

// The test parameter `minimal` as a name.
inline std::string profileName(const testing::TestParamInfo<bool>& minimal) {
  return minimal.param ? "minimal" : "full";
}

using Pixel = std::array<uint8_t, 4>;

struct Scene {
  explicit Scene(bool minimal = false, int width = 16, int height = 16,
                 render::Format color = render::Format::RGBA8,
                 render::Format depthStencil = render::Format::Depth24Stencil8, int samples = 1);
  Scene(render::Device& device, int width, int height, render::Format color, render::Format depthStencil,
        int samples);

  // Arrays of floats in client memory; `size` components.
  void array(gen::Attribute attribute, const float* data, int size);
  void noArray(gen::Attribute attribute);
  void color(float r, float g, float b, float a = 1);
  void draw(GLenum mode, int count, int first = 0);
  void draw(const render::DrawCall& call);
  // Covers the whole target at window depth `z` from -1 to 1.
  void cover(float z = 0);
  void clear(GLbitfield mask, float r = 0, float g = 0, float b = 0, float a = 1);
  std::vector<Pixel> read();
  Pixel at(int x, int y);

  render::Device& device;
  std::unique_ptr<render::Context> context;
  render::State state;
  gen::Groups changed = gen::kAllGroups;  // in `state` since the last draw
};

}  // namespace anteroom::test
