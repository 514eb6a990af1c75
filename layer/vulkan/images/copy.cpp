#include "layer/vulkan/images/copy.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "layer/render/pixels.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/images/read_back.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/images/upload.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

bool copyOnDevice(Recorder& recorder, VulkanImage& image, const render::Region& region,
                  const render::Framebuffer& source, int x, int y) {
  const render::Attachment& read = source.readable();
  VulkanImage& from = vulkan(*read.image);
  const std::shared_ptr<ImageStore>* const in = readableStore(recorder, from);
  if (!in || !image.store()) return false;
  const VkCommandBuffer commands = recorder.beginTransfer(in, &image.held());
  if (!commands) return false;
  VkImageBlit blit{};
  const bool volume = (*in)->type == VK_IMAGE_TYPE_3D;
  const int slice = volume ? read.layer : 0;
  blit.srcSubresource = layersOf(read.level, volume ? 0 : read.layer);
  blit.dstSubresource = layersOf(region.level, region.layer);
  const int low = source.yDown ? source.height - y : y;
  const int high = source.yDown ? low - region.height : low + region.height;
  blit.srcOffsets[0] = {x, low, slice};
  blit.srcOffsets[1] = {x + region.width, high, slice + 1};
  blit.dstOffsets[0] = {region.x, region.y, region.z};
  blit.dstOffsets[1] = {region.x + region.width, region.y + region.height, region.z + 1};
  recorder.device().fn().vkCmdBlitImage(commands, (*in)->image, VK_IMAGE_LAYOUT_GENERAL, image.held()->image,
                                        VK_IMAGE_LAYOUT_GENERAL, 1, &blit, VK_FILTER_NEAREST);
  if (addsAlpha(image.format().conversion) && !addsAlpha(from.format().conversion)) image.alphaStale = true;
  return true;
}

bool copyThroughMemory(Recorder& recorder, VulkanImage& image, const render::Region& region,
                       const render::Framebuffer& source, int x, int y) {
  const size_t pixels = static_cast<size_t>(region.width) * region.height;
  const render::Format format = image.desc().format;
  const size_t rowBytes = static_cast<size_t>(region.width) * render::info(format).bytes;
  std::vector<std::byte> rgba(pixels * 4), texels(rowBytes * region.height);
  if (!readPixels(recorder, source, {x, y, region.width, region.height}, render::Format::RGBA8, rgba.data(),
                  static_cast<size_t>(region.width) * 4))
    return false;
  render::fromRgba8(format, rgba.data(), static_cast<int>(pixels), texels.data());
  return upload(recorder, image, region, texels.data(), rowBytes, rowBytes * region.height);
}

// Texels that the device does not write.
void copyMapped(const VulkanImage& image, const ImageStore& in, int sourceLevel, const ImageStore& out,
                int level) {
  for (int layer = 0; layer < out.layers; ++layer) {
    const ImageStore::Plane& from = in.plane(sourceLevel, layer);
    const ImageStore::Plane& to = out.plane(level, layer);
    for (int z = 0; z < image.levelDepth(level); ++z)
      for (int y = 0; y < image.levelHeight(level); ++y)
        std::memcpy(out.mapped + to.offset + z * to.slicePitch + y * to.rowPitch,
                    in.mapped + from.offset + z * from.slicePitch + y * from.rowPitch,
                    static_cast<size_t>(image.levelWidth(level)) * image.format().bytes);
  }
}

}  // namespace

bool copyFromFramebuffer(Recorder& recorder, VulkanImage& image, const render::Region& region,
                         const render::Framebuffer& source, int x, int y) {
  if (!source.color.image) return true;
  // Only pixels inside the framebuffer count.
  const int left = std::max(0, -x), bottom = std::max(0, -y);
  render::Region inside = region;
  inside.width = static_cast<int>(std::min<int64_t>(region.width, int64_t{source.width} - x)) - left;
  inside.height = static_cast<int>(std::min<int64_t>(region.height, int64_t{source.height} - y)) - bottom;
  if (inside.width <= 0 || inside.height <= 0) return true;
  inside.x += left;
  inside.y += bottom;
  x += left;
  y += bottom;
  VulkanImage& from = vulkan(*source.readable().image);
  if (!doPendingClear(recorder, from) || !doPendingClear(recorder, image)) return false;
  // Alpha cannot move to another channel in a blit, nor can a format that the device lacks; and sRGB colors
  // are copied as they are encoded.
  const bool swizzled = render::info(image.desc().format).alpha && !image.format().storesAlpha;
  const bool widened =
      image.format().conversion == Conversion::Widen || from.format().conversion == Conversion::Widen;
  const bool encoded = render::isSrgb(image.desc().format) || render::isSrgb(from.desc().format);
  const bool slice = recorder.device().quirks().blitsToFirstSlice &&
                     from.desc().dimension != image.desc().dimension &&
                     image.desc().dimension == render::Dimension::Volume;
  if (swizzled || widened || encoded || slice || &from == &image)
    return copyThroughMemory(recorder, image, inside, source, x, y);
  return copyOnDevice(recorder, image, inside, source, x, y);
}

bool copyLevel(Recorder& recorder, VulkanImage& image, int level, VulkanImage& source, int sourceLevel) {
  if (!doPendingClear(recorder, source) || !doPendingClear(recorder, image)) return false;
  const std::shared_ptr<ImageStore>* const in = readableStore(recorder, source);
  if (!in) return false;
  if ((*in)->mapped && !(*in)->written && &image != &source)
    if (const ImageStore* const out = writableMapped(recorder, image, false)) {
      copyMapped(image, **in, sourceLevel, *out, level);
      return true;
    }
  if (!image.store()) return false;
  const VkCommandBuffer commands = recorder.beginTransfer(in, &image.held());
  if (!commands) return false;
  VkImageCopy copy{};
  copy.srcSubresource = layersOf(sourceLevel, 0, image.held()->layers);
  copy.dstSubresource = layersOf(level, 0, image.held()->layers);
  copy.extent = {static_cast<uint32_t>(image.levelWidth(level)),
                 static_cast<uint32_t>(image.levelHeight(level)),
                 static_cast<uint32_t>(image.levelDepth(level))};
  recorder.device().fn().vkCmdCopyImage(commands, (*in)->image, VK_IMAGE_LAYOUT_GENERAL, image.held()->image,
                                        VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
  return true;
}

bool copyStore(Recorder& recorder, const std::shared_ptr<ImageStore>& from,
               const std::shared_ptr<ImageStore>& to, VkExtent2D extent) {
  const VkCommandBuffer commands = recorder.beginTransfer(&from, &to);
  if (!commands) return false;
  VkImageCopy copy{};
  copy.srcSubresource = copy.dstSubresource = layersOf(0, 0);
  copy.extent = {extent.width, extent.height, 1};
  recorder.device().fn().vkCmdCopyImage(commands, from->image, VK_IMAGE_LAYOUT_GENERAL, to->image,
                                        VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
  return true;
}

}  // namespace anteroom::vulkan
