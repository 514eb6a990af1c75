#include "layer/vulkan/images/mipmaps.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

struct Field {
  uint8_t shift, bits;
};
constexpr Field k565[] = {{11, 5}, {5, 6}, {0, 5}};
constexpr Field k5551[] = {{11, 5}, {6, 5}, {1, 5}, {0, 1}};
constexpr Field k1555[] = {{15, 1}, {10, 5}, {5, 5}, {0, 5}};
constexpr Field k4444[] = {{12, 4}, {8, 4}, {4, 4}, {0, 4}};

// The components of a packed texel; empty: whole bytes.
std::span<const Field> fieldsOf(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R5G6B5_UNORM_PACK16:
      return k565;
    case VK_FORMAT_R5G5B5A1_UNORM_PACK16:
      return k5551;
    case VK_FORMAT_A1R5G5B5_UNORM_PACK16:
      return k1555;
    case VK_FORMAT_R4G4B4A4_UNORM_PACK16:
    case VK_FORMAT_B4G4R4A4_UNORM_PACK16:
    case VK_FORMAT_A4R4G4B4_UNORM_PACK16_EXT:
      return k4444;
    default:
      return {};
  }
}

// The mean of 4 or 8 texels, rounded to nearest.
void average(const std::byte* const* texels, uint32_t count, uint32_t bytes, std::span<const Field> fields,
             std::byte* out) {
  if (fields.empty()) {
    for (uint32_t b = 0; b < bytes; ++b) {
      uint32_t sum = count / 2;
      for (uint32_t i = 0; i < count; ++i) sum += std::to_integer<uint32_t>(texels[i][b]);
      out[b] = static_cast<std::byte>(sum / count);
    }
    return;
  }
  uint16_t values[8];
  for (uint32_t i = 0; i < count; ++i) std::memcpy(&values[i], texels[i], 2);
  uint32_t packed = 0;
  for (const Field field : fields) {
    uint32_t sum = count / 2;
    for (uint32_t i = 0; i < count; ++i) sum += values[i] >> field.shift & ((1u << field.bits) - 1);
    packed |= sum / count << field.shift;
  }
  const auto result = static_cast<uint16_t>(packed);
  std::memcpy(out, &result, 2);
}

void halve(const VulkanImage& image, ImageStore& store, int level, int layer) {
  const ImageStore::Plane& from = store.plane(level - 1, layer);
  const ImageStore::Plane& to = store.plane(level, layer);
  const int width = image.levelWidth(level - 1), height = image.levelHeight(level - 1),
            depth = image.levelDepth(level - 1);
  const uint32_t bytes = image.format().bytes;
  const std::span<const Field> fields = fieldsOf(store.format);
  const std::byte* texels[8];
  for (int z = 0; z < image.levelDepth(level); ++z)
    for (int y = 0; y < image.levelHeight(level); ++y)
      for (int x = 0; x < image.levelWidth(level); ++x) {
        uint32_t count = 0;
        for (int dz = 0; dz < (depth > 1 ? 2 : 1); ++dz)
          for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx)
              texels[count++] = store.mapped + from.offset +
                                std::min(2 * z + dz, depth - 1) * from.slicePitch +
                                std::min(2 * y + dy, height - 1) * from.rowPitch +
                                static_cast<size_t>(std::min(2 * x + dx, width - 1)) * bytes;
        average(
            texels, count, bytes, fields,
            store.mapped + to.offset + z * to.slicePitch + y * to.rowPitch + static_cast<size_t>(x) * bytes);
      }
}

bool blitMipmaps(Recorder& recorder, VulkanImage& image) {
  ImageStore* const store = image.store();
  const VkCommandBuffer commands = store ? recorder.beginTransfer(nullptr, &image.held()) : VK_NULL_HANDLE;
  if (!commands) return false;
  const auto corner = [&](int level) {
    return VkOffset3D{image.levelWidth(level), image.levelHeight(level), image.levelDepth(level)};
  };
  for (int level = 1; level < image.desc().levels; ++level) {
    if (level > 1) recorder.barrier();
    VkImageBlit blit{};
    blit.srcSubresource = layersOf(level - 1, 0, store->layers);
    blit.dstSubresource = layersOf(level, 0, store->layers);
    blit.srcOffsets[1] = corner(level - 1);
    blit.dstOffsets[1] = corner(level);
    recorder.device().fn().vkCmdBlitImage(commands, store->image, VK_IMAGE_LAYOUT_GENERAL, store->image,
                                          VK_IMAGE_LAYOUT_GENERAL, 1, &blit, VK_FILTER_LINEAR);
  }
  return true;
}

}  // namespace

bool generateMipmaps(Recorder& recorder, VulkanImage& image) {
  if (!doPendingClear(recorder, image)) return false;
  ImageStore* const store = writableMapped(recorder, image, false);
  if (!store) return blitMipmaps(recorder, image);
  for (int layer = 0; layer < store->layers; ++layer)
    for (int level = 1; level < image.desc().levels; ++level) halve(image, *store, level, layer);
  return true;
}

}  // namespace anteroom::vulkan
