#include "layer/vulkan/resources/target.h"

#include <algorithm>
#include <cstdint>

namespace anteroom::vulkan {

Target targetOf(const render::Framebuffer& framebuffer) {
  Target target;
  const render::Attachment& color = framebuffer.color;
  const bool hasDepth = framebuffer.depth.image != nullptr;
  const render::Attachment& depth = hasDepth ? framebuffer.depth : framebuffer.stencil;
  target.colorImage = color.image;
  target.depthImage = depth.image;
  target.color = static_cast<VulkanImage*>(color.image.get());
  target.depth = static_cast<VulkanImage*>(depth.image.get());
  target.resolveImage = framebuffer.resolve.image;
  target.resolve = static_cast<VulkanImage*>(framebuffer.resolve.image.get());
  target.resolveLevel = framebuffer.resolve.level;
  target.resolveLayer = framebuffer.resolve.layer;
  target.colorLevel = color.level;
  target.colorLayer = color.layer;
  target.depthLevel = depth.level;
  target.depthLayer = depth.layer;
  target.hasDepth = hasDepth;
  target.hasStencil = framebuffer.stencil.image != nullptr && framebuffer.stencil.image == depth.image;
  target.width = framebuffer.width;
  target.height = framebuffer.height;
  target.samples = framebuffer.samples;
  target.yDown = framebuffer.yDown;
  return target;
}

render::Rect clipped(const render::Rect& rect, const Target& target) {
  const auto overlap = [](int start, int length, int limit, int& outStart, int& outLength) {
    const int64_t first = std::clamp<int64_t>(start, 0, limit);
    const int64_t last = std::clamp<int64_t>(int64_t{start} + length, 0, limit);
    outStart = static_cast<int>(first);
    outLength = static_cast<int>(std::max<int64_t>(0, last - first));
  };
  render::Rect out;
  overlap(rect.x, rect.width, target.width, out.x, out.width);
  overlap(rect.y, rect.height, target.height, out.y, out.height);
  return out;
}

VkRect2D flipped(const render::Rect& rect, const Target& target) {
  const int y = target.yDown ? target.height - rect.y - rect.height : rect.y;
  return {{rect.x, y}, {static_cast<uint32_t>(rect.width), static_cast<uint32_t>(rect.height)}};
}

uint8_t writeMask(const std::array<bool, 4>& mask, const Target& target) {
  if (!target.color) return 0;
  const bool alpha = render::info(target.color->desc().format).alpha != 0;
  return static_cast<uint8_t>(
      (mask[0] ? VK_COLOR_COMPONENT_R_BIT : 0) | (mask[1] ? VK_COLOR_COMPONENT_G_BIT : 0) |
      (mask[2] ? VK_COLOR_COMPONENT_B_BIT : 0) | (mask[3] && alpha ? VK_COLOR_COMPONENT_A_BIT : 0));
}

}  // namespace anteroom::vulkan
