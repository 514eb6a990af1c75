#include "layer/vulkan/images/read_back.h"

#include <vector>

#include "layer/render/pixels.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

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

// Rows of texels as the store has them.
struct Texels {
  const std::byte* first = nullptr;  // null: out of memory, or the device is lost
  size_t pitch = 0;                  // bytes
};

Texels mappedTexels(Recorder& recorder, const VulkanImage& image, const ImageStore& store,
                    const render::Attachment& from, const VkRect2D& area) {
  if (!recorder.waitFor(store)) return {};
  const bool volume = store.type == VK_IMAGE_TYPE_3D;
  const ImageStore::Plane& plane = store.plane(from.level, volume ? 0 : from.layer);
  return {store.mapped + plane.offset + (volume ? from.layer * plane.slicePitch : 0) +
              area.offset.y * plane.rowPitch + static_cast<size_t>(area.offset.x) * image.format().bytes,
          plane.rowPitch};
}

Texels copiedTexels(Recorder& recorder, const VulkanImage& image, const std::shared_ptr<ImageStore>& store,
                    const render::Attachment& from, const VkRect2D& area) {
  const bool volume = store->type == VK_IMAGE_TYPE_3D;
  const size_t pitch = static_cast<size_t>(area.extent.width) * image.format().bytes;
  if (!recorder.commands()) return {};
  const StreamPiece piece = recorder.readBack().allocate(pitch * area.extent.height, 16);
  if (!piece) return {};
  const VkCommandBuffer commands = recorder.beginTransfer(&store, nullptr);
  VkBufferImageCopy copy{};
  copy.bufferOffset = piece.offset;
  copy.imageSubresource = layersOf(from.level, volume ? 0 : from.layer);
  copy.imageOffset = {area.offset.x, area.offset.y, volume ? from.layer : 0};
  copy.imageExtent = {area.extent.width, area.extent.height, 1};
  recorder.device().fn().vkCmdCopyImageToBuffer(commands, store->image, VK_IMAGE_LAYOUT_GENERAL, piece.buffer,
                                                1, &copy);
  if (!recorder.submit() || !recorder.waitForSubmitted()) return {};
  return {piece.mapped, pitch};
}

}  // namespace

bool readPixels(Recorder& recorder, const render::Framebuffer& framebuffer, const render::Rect& rect,
                Format format, void* out, size_t rowPitch) {
  const Target target = targetOf(framebuffer);
  const render::Rect inside = clipped(rect, target);
  const render::Attachment& from = framebuffer.readable();
  if (!from.image || inside.width <= 0 || inside.height <= 0) return true;
  VulkanImage& image = vulkan(*from.image);
  const std::shared_ptr<ImageStore>* const store = readableStore(recorder, image);
  if (!store) return false;
  const VkRect2D area = flipped(inside, target);
  const Texels texels = (*store)->mapped ? mappedTexels(recorder, image, **store, from, area)
                                         : copiedTexels(recorder, image, *store, from, area);
  if (!texels.first) return false;
  RowReader reader(image, format);
  const size_t left = static_cast<size_t>(int64_t{inside.x} - rect.x) * render::info(format).bytes;
  for (int y = 0; y < inside.height; ++y) {
    const int row = target.yDown ? inside.height - 1 - y : y;
    const auto at = static_cast<size_t>(int64_t{inside.y} + y - rect.y);
    reader.read(texels.first + row * texels.pitch, inside.width,
                static_cast<std::byte*>(out) + at * rowPitch + left);
  }
  return true;
}

}  // namespace anteroom::vulkan
