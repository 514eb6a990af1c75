#include "layer/vulkan/device/formats.h"

#include <cstring>
#include <span>

#include "layer/render/pixels.h"
#include "layer/vulkan/device/features.h"

namespace anteroom::vulkan {
namespace {

using render::Format;

constexpr VkComponentMapping kAsIs{};
constexpr VkComponentMapping kAlpha{VK_COMPONENT_SWIZZLE_ZERO, VK_COMPONENT_SWIZZLE_ZERO,
                                    VK_COMPONENT_SWIZZLE_ZERO, VK_COMPONENT_SWIZZLE_R};
constexpr VkComponentMapping kLuminance{VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_R,
                                        VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_ONE};
constexpr VkComponentMapping kLuminanceAlpha{VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_R,
                                             VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_G};
constexpr VkComponentMapping kOpaque{VK_COMPONENT_SWIZZLE_IDENTITY, VK_COMPONENT_SWIZZLE_IDENTITY,
                                     VK_COMPONENT_SWIZZLE_IDENTITY, VK_COMPONENT_SWIZZLE_ONE};

struct Candidate {
  VkFormat format;
  Conversion conversion;
  uint8_t bytes;
  bool lossless;
  bool needs4444 = false;  // VK_EXT_4444_formats
};

constexpr Candidate kRgba4444[] = {
    {VK_FORMAT_R4G4B4A4_UNORM_PACK16, Conversion::None, 2, true},
    {VK_FORMAT_A4R4G4B4_UNORM_PACK16_EXT, Conversion::RotateNibble, 2, true, true},
    {VK_FORMAT_B4G4R4A4_UNORM_PACK16, Conversion::SwapRedBlue, 2, true},
    {VK_FORMAT_R8G8B8A8_UNORM, Conversion::Widen, 4, false},
};
constexpr Candidate kRgba5551[] = {
    {VK_FORMAT_R5G5B5A1_UNORM_PACK16, Conversion::None, 2, true},
    {VK_FORMAT_A1R5G5B5_UNORM_PACK16, Conversion::RotateBit, 2, true},
    {VK_FORMAT_R8G8B8A8_UNORM, Conversion::Widen, 4, false},
};
constexpr Candidate kRgb565[] = {
    {VK_FORMAT_R5G6B5_UNORM_PACK16, Conversion::None, 2, true},
    {VK_FORMAT_R8G8B8A8_UNORM, Conversion::Widen, 4, false},
};
constexpr Candidate kRgba8[] = {{VK_FORMAT_R8G8B8A8_UNORM, Conversion::None, 4, true}};
constexpr Candidate kRgb8[] = {{VK_FORMAT_R8G8B8A8_UNORM, Conversion::AddAlpha, 4, true}};
constexpr Candidate kSrgb8[] = {{VK_FORMAT_R8G8B8A8_SRGB, Conversion::AddAlpha, 4, true}};
constexpr Candidate kSrgb8Alpha8[] = {{VK_FORMAT_R8G8B8A8_SRGB, Conversion::None, 4, true}};
constexpr Candidate kR8[] = {{VK_FORMAT_R8_UNORM, Conversion::None, 1, true}};
constexpr Candidate kRg8[] = {{VK_FORMAT_R8G8_UNORM, Conversion::None, 2, true}};

StoreFormat chooseColor(VkPhysicalDevice device, const Features& features,
                        std::span<const Candidate> candidates, VkComponentMapping swizzle, bool renders) {
  constexpr VkFormatFeatureFlags sampled =
      VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT |
      VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
  const VkFormatFeatureFlags wanted =
      sampled | (renders ? VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT | VK_FORMAT_FEATURE_BLIT_SRC_BIT |
                               VK_FORMAT_FEATURE_BLIT_DST_BIT
                         : 0);
  StoreFormat store;
  for (const Candidate& candidate : candidates) {
    if (candidate.needs4444 && !features.formats4444) continue;
    VkFormatProperties properties;
    vkGetPhysicalDeviceFormatProperties(device, candidate.format, &properties);
    if ((properties.optimalTilingFeatures & wanted) != wanted) continue;
    store.format = candidate.format;
    store.conversion = candidate.conversion;
    store.bytes = candidate.bytes;
    store.linear = (properties.linearTilingFeatures & wanted) == wanted;
    store.renderable = renders && candidate.lossless;
    store.storesAlpha = renders && candidate.format != VK_FORMAT_R5G6B5_UNORM_PACK16;
    break;
  }
  store.swizzle = swizzle;
  return store;
}

StoreFormat chooseDepth(VkPhysicalDevice device, std::span<const VkFormat> candidates,
                        VkImageAspectFlags aspects) {
  StoreFormat store;
  for (VkFormat candidate : candidates) {
    VkFormatProperties properties;
    vkGetPhysicalDeviceFormatProperties(device, candidate, &properties);
    if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT)) continue;
    store.format = candidate;
    store.renderable = true;
    break;
  }
  store.aspects = aspects;
  if (store.format == VK_FORMAT_D24_UNORM_S8_UINT || store.format == VK_FORMAT_D32_SFLOAT_S8_UINT)
    store.aspects = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
  return store;
}

template <class Function>
void mapWords(const std::byte* in, int count, std::byte* out, Function function) {
  for (int i = 0; i < count; ++i, in += 2, out += 2) {
    uint16_t value;
    std::memcpy(&value, in, 2);
    value = static_cast<uint16_t>(function(static_cast<uint32_t>(value)));
    std::memcpy(out, &value, 2);
  }
}

// The first and the third of the bytes of a texel change places; alpha is 1 where there is none.
template <int In, int Out>
void swapBytes(const std::byte* in, int count, std::byte* out) {
  for (int i = 0; i < count; ++i, in += In, out += Out) {
    const std::byte first = in[0];
    out[0] = in[2];
    out[1] = in[1];
    out[2] = first;
    if constexpr (Out == 4) out[3] = In == 4 ? in[3] : std::byte{255};
  }
}

constexpr uint32_t swapRedBlue(uint32_t v) {
  return (v & 0x0f0f) | (v >> 8 & 0xf0) | (v & 0xf0) << 8;
}

}  // namespace

StoreFormats chooseFormats(VkPhysicalDevice device, const Features& features) {
  StoreFormats formats;
  const auto at = [&](Format format) -> StoreFormat& { return formats[static_cast<int>(format)]; };
  at(Format::A8) = chooseColor(device, features, kR8, kAlpha, false);
  at(Format::L8) = chooseColor(device, features, kR8, kLuminance, false);
  at(Format::LA8) = chooseColor(device, features, kRg8, kLuminanceAlpha, false);
  at(Format::RGB8) = chooseColor(device, features, kRgb8, kOpaque, true);
  at(Format::RGBA8) = chooseColor(device, features, kRgba8, kAsIs, true);
  at(Format::RGB565) = chooseColor(device, features, kRgb565, kOpaque, true);
  at(Format::RGBA4444) = chooseColor(device, features, kRgba4444, kAsIs, true);
  at(Format::RGBA5551) = chooseColor(device, features, kRgba5551, kAsIs, true);
  at(Format::SRGB8) = chooseColor(device, features, kSrgb8, kOpaque, true);
  at(Format::SRGB8Alpha8) = chooseColor(device, features, kSrgb8Alpha8, kAsIs, true);

  constexpr VkImageAspectFlags depth = VK_IMAGE_ASPECT_DEPTH_BIT, stencil = VK_IMAGE_ASPECT_STENCIL_BIT;
  constexpr VkFormat d16[] = {VK_FORMAT_D16_UNORM};
  constexpr VkFormat d24[] = {VK_FORMAT_X8_D24_UNORM_PACK32, VK_FORMAT_D32_SFLOAT};
  constexpr VkFormat d32[] = {VK_FORMAT_D32_SFLOAT};
  constexpr VkFormat d24s8[] = {VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT};
  constexpr VkFormat s8[] = {VK_FORMAT_S8_UINT, VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT};
  at(Format::Depth16) = chooseDepth(device, d16, depth);
  at(Format::Depth24) = chooseDepth(device, d24, depth);
  at(Format::Depth32) = chooseDepth(device, d32, depth);
  at(Format::Depth24Stencil8) = chooseDepth(device, d24s8, depth | stencil);
  at(Format::Stencil8) = chooseDepth(device, s8, stencil);
  return formats;
}

void toStore(Format format, Conversion conversion, const std::byte* in, int count, std::byte* out) {
  switch (conversion) {
    case Conversion::None:
      std::memcpy(out, in, static_cast<size_t>(count) * render::info(format).bytes);
      return;
    case Conversion::AddAlpha:
      for (int i = 0; i < count; ++i, in += 3, out += 4) {
        std::memcpy(out, in, 3);
        out[3] = std::byte{255};
      }
      return;
    case Conversion::SwapBytes:
      return swapBytes<4, 4>(in, count, out);
    case Conversion::SwapAddAlpha:
      return swapBytes<3, 4>(in, count, out);
    case Conversion::RotateNibble:
      mapWords(in, count, out, [](uint32_t v) { return v >> 4 | v << 12; });
      return;
    case Conversion::SwapRedBlue:
      mapWords(in, count, out, swapRedBlue);
      return;
    case Conversion::RotateBit:
      mapWords(in, count, out, [](uint32_t v) { return v >> 1 | v << 15; });
      return;
    case Conversion::Widen:
      render::toRgba8(format, in, count, out);
      return;
  }
}

void fromStore(Format format, Conversion conversion, const std::byte* in, int count, std::byte* out) {
  switch (conversion) {
    case Conversion::None:
      std::memcpy(out, in, static_cast<size_t>(count) * render::info(format).bytes);
      return;
    case Conversion::AddAlpha:
      for (int i = 0; i < count; ++i, in += 4, out += 3) std::memcpy(out, in, 3);
      return;
    case Conversion::SwapBytes:
      return swapBytes<4, 4>(in, count, out);
    case Conversion::SwapAddAlpha:
      return swapBytes<4, 3>(in, count, out);
    case Conversion::RotateNibble:
      mapWords(in, count, out, [](uint32_t v) { return v << 4 | v >> 12; });
      return;
    case Conversion::SwapRedBlue:
      mapWords(in, count, out, swapRedBlue);
      return;
    case Conversion::RotateBit:
      mapWords(in, count, out, [](uint32_t v) { return v << 1 | v >> 15; });
      return;
    case Conversion::Widen:
      render::fromRgba8(format, in, count, out);
      return;
  }
}

}  // namespace anteroom::vulkan
