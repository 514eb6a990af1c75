#include "layer/vulkan/images/upload.h"

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

bool isWhole(const VulkanImage& image, const render::Region& region) {
  const render::ImageDesc& desc = image.desc();
  return desc.levels == 1 && desc.dimension != render::Dimension::Cube && region.width == desc.width &&
         region.height == desc.height && region.depth == desc.depth;
}

void uploadMapped(const VulkanImage& image, ImageStore& store, const render::Region& region,
                  const std::byte* data, size_t rowPitch, size_t slicePitch) {
  const ImageStore::Plane& plane = store.plane(region.level, region.layer);
  const StoreFormat& format = image.format();
  for (int z = 0; z < region.depth; ++z)
    for (int y = 0; y < region.height; ++y) {
      std::byte* const to = store.mapped + plane.offset + (region.z + z) * plane.slicePitch +
                            (region.y + y) * plane.rowPitch + static_cast<size_t>(region.x) * format.bytes;
      toStore(image.desc().format, format.conversion, data + z * slicePitch + y * rowPitch, region.width, to);
    }
}

bool uploadStaged(Recorder& recorder, VulkanImage& image, const render::Region& region, const std::byte* data,
                  size_t rowPitch, size_t slicePitch) {
  ImageStore* const store = image.store();
  if (!store || !recorder.commands()) return false;
  const StoreFormat& format = image.format();
  const size_t row = static_cast<size_t>(region.width) * format.bytes;
  const StreamPiece piece = recorder.staging().allocate(row * region.height * region.depth, 16);
  if (!piece) return false;
  std::byte* to = piece.mapped;
  for (int z = 0; z < region.depth; ++z)
    for (int y = 0; y < region.height; ++y, to += row)
      toStore(image.desc().format, format.conversion, data + z * slicePitch + y * rowPitch, region.width, to);
  const VkCommandBuffer commands = recorder.beginTransfer(nullptr, &image.held());
  VkBufferImageCopy copy{};
  copy.bufferOffset = piece.offset;
  copy.imageSubresource = layersOf(region.level, region.layer);
  copy.imageOffset = {region.x, region.y, region.z};
  copy.imageExtent = {static_cast<uint32_t>(region.width), static_cast<uint32_t>(region.height),
                      static_cast<uint32_t>(region.depth)};
  recorder.device().fn().vkCmdCopyBufferToImage(commands, piece.buffer, store->image, VK_IMAGE_LAYOUT_GENERAL,
                                                1, &copy);
  return true;
}

}  // namespace

bool upload(Recorder& recorder, VulkanImage& image, const render::Region& region, const void* data,
            size_t rowPitch, size_t slicePitch) {
  if (region.width <= 0 || region.height <= 0 || region.depth <= 0) return true;
  const bool whole = isWhole(image, region);
  if (whole)
    image.pending.aspects = 0;
  else if (!doPendingClear(recorder, image))
    return false;
  const auto* bytes = static_cast<const std::byte*>(data);
  recorder.countUpload(static_cast<uint64_t>(region.width) * region.height * region.depth *
                       render::info(image.desc().format).bytes);
  ImageStore* const store = writableMapped(recorder, image, whole);
  if (!store) return uploadStaged(recorder, image, region, bytes, rowPitch, slicePitch);
  uploadMapped(image, *store, region, bytes, rowPitch, slicePitch);
  return true;
}

}  // namespace anteroom::vulkan
