// Where drawing goes, and rectangles of it.
#pragma once

#include <volk.h>

#include <array>
#include <memory>

#include "layer/render/state.h"
#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

// A framebuffer as the device takes it. Depth and stencil are one image.
struct Target {
  // Held: a pass may outlive the framebuffer object.
  std::shared_ptr<render::Image> colorImage, depthImage, resolveImage;
  VulkanImage* color = nullptr;
  VulkanImage* depth = nullptr;
  VulkanImage* resolve = nullptr;  // gets the mean of color's samples at the end of a pass
  int colorLevel = 0, colorLayer = 0;
  int depthLevel = 0, depthLayer = 0;
  int resolveLevel = 0, resolveLayer = 0;
  bool hasDepth = false, hasStencil = false;  // what the framebuffer has of the image
  int width = 0, height = 0, samples = 1;
  bool yDown = false;
  bool same(const Target& other) const {
    return color == other.color && depth == other.depth && resolve == other.resolve &&
           colorLevel == other.colorLevel && colorLayer == other.colorLayer &&
           depthLevel == other.depthLevel && depthLayer == other.depthLayer &&
           resolveLevel == other.resolveLevel && resolveLayer == other.resolveLayer &&
           hasDepth == other.hasDepth && hasStencil == other.hasStencil && width == other.width &&
           height == other.height && samples == other.samples && yDown == other.yDown;
  }
};
Target targetOf(const render::Framebuffer& framebuffer);

// From GL's coordinates to Vulkan's.
VkRect2D flipped(const render::Rect& rect, const Target& target);
// The part of `rect` that lies inside the target.
render::Rect clipped(const render::Rect& rect, const Target& target);
// Components of a color mask that the target has.
uint8_t writeMask(const std::array<bool, 4>& mask, const Target& target);

}  // namespace anteroom::vulkan
