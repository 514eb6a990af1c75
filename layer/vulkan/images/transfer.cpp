// Texels in and between images.
#include <algorithm>
#include <cstring>
#include <vector>

#include "layer/render/pixels.h"
#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"

namespace anteroom::vulkan {
namespace {

// A larger image that is in use is not replaced for the sake of a part of it.
constexpr size_t kMostVersioned = 1 << 20;

bool isWhole(const VulkanImage& image, const render::Region& region) {
  const render::ImageDesc& desc = image.desc();
  return desc.levels == 1 && desc.dimension != render::Dimension::Cube && region.width == desc.width &&
         region.height == desc.height && region.depth == desc.depth;
}

VkImageSubresourceLayers layersOf(int level, int layer) {
  return {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<uint32_t>(level), static_cast<uint32_t>(layer), 1};
}

}  // namespace

// Commands that touch `store` outside a pass are about to be recorded.
void VulkanContext::leavePass(ImageStore& store, bool write) {
  pass_.end();
  if (write ? commands_.mustWaitToWrite(store) : commands_.mustWaitToRead(store)) commands_.barrier();
}

bool VulkanContext::waitFor(const ImageStore& store) {
  if (commands_.mayUse(store) && !submit()) return false;
  return device_.timeline().wait(store.lastUse.load(std::memory_order_relaxed), UINT64_MAX);
}

// The store with one sample a pixel that holds what was recorded so far.
ImageStore* VulkanContext::readable(VulkanImage& image) {
  ImageStore* const store = image.store();
  if (image.desc().samples == 1 || !store) return store;
  ImageStore* const resolved = image.resolved();
  if (!resolved || !image.resolveStale) return resolved;
  const VkCommandBuffer commands = commands_.commands();
  if (!commands) return nullptr;
  leavePass(*store, false);
  leavePass(*resolved, true);
  VkImageResolve region{};
  region.srcSubresource = region.dstSubresource = layersOf(0, 0);
  region.extent = {static_cast<uint32_t>(image.desc().width), static_cast<uint32_t>(image.desc().height), 1};
  device_.fn().vkCmdResolveImage(commands, store->image, VK_IMAGE_LAYOUT_GENERAL, resolved->image,
                                 VK_IMAGE_LAYOUT_GENERAL, 1, &region);
  commands_.read(image.held());
  commands_.write(image.heldResolved());
  image.resolveStale = false;
  return resolved;
}

const std::shared_ptr<ImageStore>& VulkanContext::heldReadable(VulkanImage& image) {
  return image.desc().samples == 1 ? image.held() : image.heldResolved();
}

// A mapped store that nothing uses, with the image's contents unless they are about to be overwritten as a
// whole: its own, or a new version. Null: the image must be written by commands, or memory is short.
ImageStore* VulkanContext::writableMapped(VulkanImage& image, bool whole) {
  ImageStore* store = image.store(whole);
  if (!store || !store->mapped) return nullptr;
  if (image.held().use_count() > 1) commands_.retire();
  if (image.held().use_count() == 1) {
    store->written = false;
    ++store->version;
    return store;
  }
  if (!whole && (store->written || image.bytes() > kMostVersioned)) return nullptr;
  if (pass_.attaches(*store)) pass_.end();
  const std::shared_ptr<ImageStore> former = image.replaceStore();
  if (!former) return nullptr;
  store = image.store();
  ++store->version;
  if (!whole) std::memcpy(store->mapped, former->mapped, std::min(store->memory.size, former->memory.size));
  return store;
}

bool VulkanContext::upload(render::Image& target, const render::Region& region, const void* data,
                           size_t rowPitch, size_t slicePitch) {
  flushBatch();
  VulkanImage& image = vulkan(target);
  if (region.width <= 0 || region.height <= 0 || region.depth <= 0) return true;
  const bool whole = isWhole(image, region);
  if (whole)
    image.pending.aspects = 0;
  else if (image.pending.aspects && !materialise(image))
    return false;
  const auto* bytes = static_cast<const std::byte*>(data);
  stats_.bytesUploaded += static_cast<uint64_t>(region.width) * region.height * region.depth *
                          render::info(image.desc().format).bytes;
  ImageStore* const store = writableMapped(image, whole);
  if (!store) return uploadStaged(image, region, bytes, rowPitch, slicePitch);
  uploadMapped(image, *store, region, bytes, rowPitch, slicePitch);
  return true;
}

void VulkanContext::uploadMapped(const VulkanImage& image, ImageStore& store, const render::Region& region,
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

bool VulkanContext::uploadStaged(VulkanImage& image, const render::Region& region, const std::byte* data,
                                 size_t rowPitch, size_t slicePitch) {
  ImageStore* const store = image.store();
  const VkCommandBuffer commands = commands_.commands();
  if (!store || !commands) return false;
  const StoreFormat& format = image.format();
  const size_t row = static_cast<size_t>(region.width) * format.bytes;
  const StreamPiece piece = staging_.allocate(row * region.height * region.depth, 16);
  if (!piece) return false;
  std::byte* to = piece.mapped;
  for (int z = 0; z < region.depth; ++z)
    for (int y = 0; y < region.height; ++y, to += row)
      toStore(image.desc().format, format.conversion, data + z * slicePitch + y * rowPitch, region.width, to);
  leavePass(*store, true);
  VkBufferImageCopy copy{};
  copy.bufferOffset = piece.offset;
  copy.imageSubresource = layersOf(region.level, region.layer);
  copy.imageOffset = {region.x, region.y, region.z};
  copy.imageExtent = {static_cast<uint32_t>(region.width), static_cast<uint32_t>(region.height),
                      static_cast<uint32_t>(region.depth)};
  device_.fn().vkCmdCopyBufferToImage(commands, piece.buffer, store->image, VK_IMAGE_LAYOUT_GENERAL, 1,
                                      &copy);
  commands_.write(image.held());
  return true;
}

bool VulkanContext::copyFromFramebuffer(render::Image& target, const render::Region& region,
                                        const render::Framebuffer& source, int x, int y) {
  flushBatch();
  VulkanImage& image = vulkan(target);
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
  if (from.pending.aspects && !materialise(from)) return false;
  if (image.pending.aspects && !materialise(image)) return false;
  // Alpha cannot move to another channel in a blit, nor can a format that the device lacks; and sRGB colors
  // are copied as they are encoded.
  const bool swizzled = render::info(image.desc().format).alpha && !image.format().storesAlpha;
  const bool widened =
      image.format().conversion == Conversion::Widen || from.format().conversion == Conversion::Widen;
  const bool encoded = render::isSrgb(image.desc().format) || render::isSrgb(from.desc().format);
  const bool slice = device_.quirks().blitsToFirstSlice && from.desc().dimension != image.desc().dimension &&
                     image.desc().dimension == render::Dimension::Volume;
  if (swizzled || widened || encoded || slice || &from == &image)
    return copyThroughMemory(image, inside, source, x, y);
  return copyOnDevice(image, inside, source, x, y);
}

bool VulkanContext::copyOnDevice(VulkanImage& image, const render::Region& region,
                                 const render::Framebuffer& source, int x, int y) {
  const render::Attachment& read = source.readable();
  VulkanImage& from = vulkan(*read.image);
  ImageStore* const in = readable(from);
  ImageStore* const out = image.store();
  const VkCommandBuffer commands = commands_.commands();
  if (!in || !out || !commands) return false;
  leavePass(*in, false);
  leavePass(*out, true);
  VkImageBlit blit{};
  const bool volume = in->type == VK_IMAGE_TYPE_3D;
  const int slice = volume ? read.layer : 0;
  blit.srcSubresource = layersOf(read.level, volume ? 0 : read.layer);
  blit.dstSubresource = layersOf(region.level, region.layer);
  const int low = source.yDown ? source.height - y : y;
  const int high = source.yDown ? low - region.height : low + region.height;
  blit.srcOffsets[0] = {x, low, slice};
  blit.srcOffsets[1] = {x + region.width, high, slice + 1};
  blit.dstOffsets[0] = {region.x, region.y, region.z};
  blit.dstOffsets[1] = {region.x + region.width, region.y + region.height, region.z + 1};
  device_.fn().vkCmdBlitImage(commands, in->image, VK_IMAGE_LAYOUT_GENERAL, out->image,
                              VK_IMAGE_LAYOUT_GENERAL, 1, &blit, VK_FILTER_NEAREST);
  commands_.read(heldReadable(from));
  commands_.write(image.held());
  if (addsAlpha(image.format().conversion) && !addsAlpha(from.format().conversion)) image.alphaStale = true;
  return true;
}

bool VulkanContext::copyThroughMemory(VulkanImage& image, const render::Region& region,
                                      const render::Framebuffer& source, int x, int y) {
  const size_t pixels = static_cast<size_t>(region.width) * region.height;
  const render::Format format = image.desc().format;
  const size_t rowBytes = static_cast<size_t>(region.width) * render::info(format).bytes;
  std::vector<std::byte> rgba(pixels * 4), texels(rowBytes * region.height);
  if (!readPixels(source, {x, y, region.width, region.height}, render::Format::RGBA8, rgba.data(),
                  static_cast<size_t>(region.width) * 4))
    return false;
  render::fromRgba8(format, rgba.data(), static_cast<int>(pixels), texels.data());
  return upload(image, region, texels.data(), rowBytes, rowBytes * region.height);
}

bool VulkanContext::copyLevel(render::Image& target, int level, render::Image& origin, int sourceLevel) {
  flushBatch();
  VulkanImage& image = vulkan(target);
  VulkanImage& source = vulkan(origin);
  if (source.pending.aspects && !materialise(source)) return false;
  if (image.pending.aspects && !materialise(image)) return false;
  ImageStore* const in = readable(source);
  if (!in) return false;
  const int layers = image.desc().dimension == render::Dimension::Cube ? 6 : 1;
  const int width = image.levelWidth(level), height = image.levelHeight(level),
            depth = image.levelDepth(level);
  // Texels that the device does not write are copied by hand.
  ImageStore* const mapped =
      in->mapped && !in->written && &image != &source ? writableMapped(image, false) : nullptr;
  if (mapped) {
    for (int layer = 0; layer < layers; ++layer) {
      const ImageStore::Plane& from = in->plane(sourceLevel, layer);
      const ImageStore::Plane& to = mapped->plane(level, layer);
      for (int z = 0; z < depth; ++z)
        for (int y = 0; y < height; ++y)
          std::memcpy(mapped->mapped + to.offset + z * to.slicePitch + y * to.rowPitch,
                      in->mapped + from.offset + z * from.slicePitch + y * from.rowPitch,
                      static_cast<size_t>(width) * image.format().bytes);
    }
    return true;
  }
  ImageStore* const out = image.store();
  const VkCommandBuffer commands = commands_.commands();
  if (!out || !commands) return false;
  leavePass(*in, false);
  leavePass(*out, true);
  VkImageCopy copy{};
  copy.srcSubresource = layersOf(sourceLevel, 0);
  copy.dstSubresource = layersOf(level, 0);
  copy.srcSubresource.layerCount = copy.dstSubresource.layerCount = static_cast<uint32_t>(layers);
  copy.extent = {static_cast<uint32_t>(width), static_cast<uint32_t>(height), static_cast<uint32_t>(depth)};
  device_.fn().vkCmdCopyImage(commands, in->image, VK_IMAGE_LAYOUT_GENERAL, out->image,
                              VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
  commands_.read(heldReadable(source));
  commands_.write(image.held());
  return true;
}

}  // namespace anteroom::vulkan
