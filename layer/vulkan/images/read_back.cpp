// glReadPixels (section 4.3.1): straight from mapped memory where the color image is there, else by a copy.
#include <vector>

#include "layer/render/pixels.h"
#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"

namespace anteroom::vulkan {
namespace {

using render::Format;

// A row of the store in the format that is asked for: the image's own, or RGBA8.
class RowReader {
 public:
  RowReader(const VulkanImage& image, Format wanted)
      : own_(image.desc().format), wanted_(wanted), conversion_(image.format().conversion) {}
  void read(const std::byte* in, int count, std::byte* out) {
    if (own_ == wanted_) return fromStore(own_, conversion_, in, count, out);
    row_.resize(static_cast<size_t>(count) * render::info(own_).bytes);
    fromStore(own_, conversion_, in, count, row_.data());
    render::toRgba8(own_, row_.data(), count, out);
  }

 private:
  const Format own_, wanted_;
  const Conversion conversion_;
  std::vector<std::byte> row_;
};

}  // namespace

bool VulkanContext::readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect,
                               Format format, void* out, size_t rowPitch) {
  flushBatch();
  const Target target = targetOf(framebuffer);
  const render::Rect inside = clipped(rect, target);
  const render::Attachment& from = framebuffer.readable();
  if (!from.image || inside.width <= 0 || inside.height <= 0) return true;
  VulkanImage& image = vulkan(*from.image);
  if (image.pending.aspects && !materialise(image)) return false;
  ImageStore* const store = readable(image);
  if (!store) return false;

  const VkRect2D area = flipped(inside, target);
  const std::byte* texels;
  size_t pitch;
  const bool volume = store->type == VK_IMAGE_TYPE_3D;
  if (store->mapped) {
    if (!waitFor(*store)) return false;
    const ImageStore::Plane& plane = store->plane(from.level, volume ? 0 : from.layer);
    pitch = plane.rowPitch;
    texels = store->mapped + plane.offset + (volume ? from.layer * plane.slicePitch : 0) +
             area.offset.y * pitch + static_cast<size_t>(area.offset.x) * image.format().bytes;
  } else {
    pitch = static_cast<size_t>(area.extent.width) * image.format().bytes;
    const VkCommandBuffer commands = commands_.commands();
    const StreamPiece piece = readBack_.allocate(pitch * area.extent.height, 16);
    if (!commands || !piece) return false;
    leavePass(*store, false);
    VkBufferImageCopy copy{};
    copy.bufferOffset = piece.offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<uint32_t>(from.level),
                             static_cast<uint32_t>(volume ? 0 : from.layer), 1};
    copy.imageOffset = {area.offset.x, area.offset.y, volume ? from.layer : 0};
    copy.imageExtent = {area.extent.width, area.extent.height, 1};
    device_.fn().vkCmdCopyImageToBuffer(commands, store->image, VK_IMAGE_LAYOUT_GENERAL, piece.buffer, 1,
                                        &copy);
    commands_.read(heldReadable(image));
    if (!submit() || !device_.timeline().wait(commands_.lastSubmitted(), UINT64_MAX)) return false;
    texels = piece.mapped;
  }

  RowReader reader(image, format);
  const size_t left = static_cast<size_t>(int64_t{inside.x} - rect.x) * render::info(format).bytes;
  for (int y = 0; y < inside.height; ++y) {
    const int row = target.yDown ? inside.height - 1 - y : y;
    const auto at = static_cast<size_t>(int64_t{inside.y} + y - rect.y);
    reader.read(texels + row * pitch, inside.width, static_cast<std::byte*>(out) + at * rowPitch + left);
  }
  return true;
}

}  // namespace anteroom::vulkan
