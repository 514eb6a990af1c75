// Texels of the color formats as four bytes and back, by GL's rules: n bits to float by c / (2^n - 1)
// (section 3.6.4), float to n bits by rounding to nearest.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "layer/render/format.h"

namespace anteroom::render {

// Changes the number of bits of a color component.
constexpr uint32_t rescale(uint32_t value, uint32_t fromMax, uint32_t toMax) {
  return (value * toMax * 2 + fromMax) / (fromMax * 2);
}

// Rows of `count` texels. What a format lacks becomes 0, and alpha 1; luminance goes to red, green and blue,
// and comes from red. sRGB colors stay encoded.
inline void toRgba8(Format format, const std::byte* in, int count, std::byte* out) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(in);
  auto* to = reinterpret_cast<uint8_t*>(out);
  const auto put = [&](uint32_t r, uint32_t g, uint32_t b, uint32_t a) {
    *to++ = static_cast<uint8_t>(r);
    *to++ = static_cast<uint8_t>(g);
    *to++ = static_cast<uint8_t>(b);
    *to++ = static_cast<uint8_t>(a);
  };
  for (int i = 0; i < count; ++i) {
    const uint8_t* t = bytes + static_cast<size_t>(i) * info(format).bytes;
    uint16_t packed = 0;
    if (info(format).bytes == 2) std::memcpy(&packed, t, 2);
    const uint32_t v = packed;
    switch (format) {
      case Format::A8:
        put(0, 0, 0, t[0]);
        break;
      case Format::L8:
        put(t[0], t[0], t[0], 255);
        break;
      case Format::LA8:
        put(t[0], t[0], t[0], t[1]);
        break;
      case Format::RGB8:
      case Format::SRGB8:
        put(t[0], t[1], t[2], 255);
        break;
      case Format::RGBA8:
      case Format::SRGB8Alpha8:
        put(t[0], t[1], t[2], t[3]);
        break;
      case Format::RGB565:
        put(rescale(v >> 11, 31, 255), rescale(v >> 5 & 63, 63, 255), rescale(v & 31, 31, 255), 255);
        break;
      case Format::RGBA4444:
        put((v >> 12) * 17, (v >> 8 & 15) * 17, (v >> 4 & 15) * 17, (v & 15) * 17);
        break;
      case Format::RGBA5551:
        put(rescale(v >> 11, 31, 255), rescale(v >> 6 & 31, 31, 255), rescale(v >> 1 & 31, 31, 255),
            (v & 1) * 255);
        break;
      default:
        put(0, 0, 0, 0);
        break;
    }
  }
}

inline void fromRgba8(Format format, const std::byte* in, int count, std::byte* out) {
  const auto* t = reinterpret_cast<const uint8_t*>(in);
  auto* to = reinterpret_cast<uint8_t*>(out);
  const auto put16 = [&](uint32_t value) {
    const auto packed = static_cast<uint16_t>(value);
    std::memcpy(to, &packed, 2);
  };
  for (int i = 0; i < count; ++i, t += 4, to += info(format).bytes) {
    switch (format) {
      case Format::A8:
        to[0] = t[3];
        break;
      case Format::L8:
        to[0] = t[0];
        break;
      case Format::LA8:
        to[0] = t[0], to[1] = t[3];
        break;
      case Format::RGB8:
      case Format::SRGB8:
        std::memcpy(to, t, 3);
        break;
      case Format::RGBA8:
      case Format::SRGB8Alpha8:
        std::memcpy(to, t, 4);
        break;
      case Format::RGB565:
        put16(rescale(t[0], 255, 31) << 11 | rescale(t[1], 255, 63) << 5 | rescale(t[2], 255, 31));
        break;
      case Format::RGBA4444:
        put16(rescale(t[0], 255, 15) << 12 | rescale(t[1], 255, 15) << 8 | rescale(t[2], 255, 15) << 4 |
              rescale(t[3], 255, 15));
        break;
      case Format::RGBA5551:
        put16(rescale(t[0], 255, 31) << 11 | rescale(t[1], 255, 31) << 6 | rescale(t[2], 255, 31) << 1 |
              rescale(t[3], 255, 1));
        break;
      default:
        break;
    }
  }
}

}  // namespace anteroom::render
