// A picture goes to the screen.
#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/windows/window.h"

namespace anteroom::vulkan {

bool VulkanContext::copyStore(const std::shared_ptr<ImageStore>& from, const std::shared_ptr<ImageStore>& to,
                              VkExtent2D extent) {
  const VkCommandBuffer commands = commands_.commands();
  if (!commands) return false;
  leavePass(*from, false);
  leavePass(*to, true);
  VkImageCopy copy{};
  copy.srcSubresource = copy.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.extent = {extent.width, extent.height, 1};
  device_.fn().vkCmdCopyImage(commands, from->image, VK_IMAGE_LAYOUT_GENERAL, to->image,
                              VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
  commands_.read(from);
  commands_.write(to);
  return true;
}

// The window system sees what was drawn.
bool VulkanContext::leaveForPresentation(const std::shared_ptr<ImageStore>& store) {
  const VkCommandBuffer commands = commands_.commands();
  if (!commands) return false;
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
  barrier.newLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = store->image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  device_.fn().vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                    VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0, nullptr, 0, nullptr, 1,
                                    &barrier);
  commands_.write(store);
  return true;
}

render::Presented VulkanContext::present(render::Window& target, std::span<const render::Rect> damage) {
  auto& window = static_cast<VulkanWindow&>(target);
  // A picture that nobody drew is shown, too.
  const render::Presented result = window.makeReady() ? show(window, damage) : render::Presented::OutOfMemory;
  window.expire();
  return result;
}

render::Presented VulkanContext::show(VulkanWindow& window, std::span<const render::Rect> damage) {
  VulkanImage& picture = window.drawn();
  flushBatch();
  if (picture.pending.aspects && !materialise(picture)) return render::Presented::OutOfMemory;
  pass_.end();
  if (window.isGone()) {
    submit();
    window.lose();
  }
  if (!window.shown()) {
    submit();
    return window.lost() ? render::Presented::Lost : render::Presented::Shown;
  }
  const std::shared_ptr<ImageStore> shown = *window.shown();
  if (picture.held() != shown) {
    if (!copyStore(picture.held(), shown, window.extent())) return render::Presented::OutOfMemory;
  } else if (window.preserved()) {
    std::shared_ptr<ImageStore> kept = picture.newStore();
    if (!kept || !copyStore(shown, kept, window.extent())) return render::Presented::OutOfMemory;
    picture.setStore(std::move(kept));
  }
  if (window.hud() && !drawHud(window)) return render::Presented::OutOfMemory;
  if (!leaveForPresentation(shown) || !submit(window.semaphore())) return render::Presented::OutOfMemory;
  return window.present(commands_.lastSubmitted(), damage);
}

}  // namespace anteroom::vulkan
