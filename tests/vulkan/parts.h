// The parts of the renderer, each on its own: a device, and no context.
#pragma once

#include <gtest/gtest.h>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/recording/recorder.h"
#include "layer/vulkan/vulkan_device.h"
#include "tests/vulkan/scene.h"

namespace anteroom::test {

// A test for each profile.
class Part : public testing::TestWithParam<bool> {
 protected:
  void TearDown() override { EXPECT_EQ(vulkan::validationMessages(), 0u); }
  vulkan::VulkanDevice& device() { return static_cast<vulkan::VulkanDevice&>(test::device(GetParam())); }
};

// A target of one flat image, and what it holds.
struct Picture {
  explicit Picture(vulkan::VulkanDevice& device, int width = 8, int height = 8, int levels = 1,
                   render::Format format = render::Format::RGBA8) {
    render::ImageDesc desc;
    desc.format = format;
    desc.width = width;
    desc.height = height;
    desc.levels = levels;
    desc.renderable = true;
    framebuffer.color.image = device.createImage(desc);
    framebuffer.width = width;
    framebuffer.height = height;
  }
  vulkan::VulkanImage& image() { return vulkan::vulkan(*framebuffer.color.image); }
  vulkan::Target target() { return vulkan::targetOf(framebuffer); }

  render::Framebuffer framebuffer;
};

}  // namespace anteroom::test
