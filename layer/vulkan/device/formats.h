// What each of the seam's formats is stored as.
#pragma once

#include <volk.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "layer/render/format.h"

namespace anteroom::vulkan {

struct Features;

// How a texel in client memory becomes one in the store.
enum class Conversion : uint8_t {
  None,
  AddAlpha,      // three bytes to four, alpha 1
  RotateNibble,  // RGBA4444 to ARGB4444
  SwapRedBlue,   // RGBA4444 to BGRA4444
  RotateBit,     // RGBA5551 to ARGB1555
  SwapBytes,     // RGBA8 to BGRA8
  SwapAddAlpha,  // RGB8 to BGRA8, alpha 1
  Widen,         // any packed format to RGBA8: no device format holds it
};

constexpr bool addsAlpha(Conversion conversion) {
  return conversion == Conversion::AddAlpha || conversion == Conversion::SwapAddAlpha;
}

struct StoreFormat {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageAspectFlags aspects = VK_IMAGE_ASPECT_COLOR_BIT;
  VkComponentMapping swizzle{};  // for sampling
  Conversion conversion = Conversion::None;
  uint8_t bytes = 0;         // a texel in the store
  bool linear = false;       // may be sampled and rendered in LINEAR tiling
  bool renderable = false;   // without loss
  bool storesAlpha = false;  // the store has an alpha channel
};
using StoreFormats = std::array<StoreFormat, render::kFormatCount>;

StoreFormats chooseFormats(VkPhysicalDevice device, const Features& features);

// Rows of `count` texels; `format` is the client's.
void toStore(render::Format format, Conversion conversion, const std::byte* in, int count, std::byte* out);
void fromStore(render::Format format, Conversion conversion, const std::byte* in, int count, std::byte* out);

}  // namespace anteroom::vulkan
