#include "tests/reference/image_store.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

namespace anteroom::reference {

using render::Format;
using render::info;

namespace {

std::atomic<uint64_t> imagesMade{0};

}  // namespace

StoredImage::StoredImage(const render::ImageDesc& desc) : Image(desc), id_(++imagesMade) {
  const size_t samples = static_cast<size_t>(desc.samples);
  for (int i = 0; i < desc.levels; ++i) {
    Level level;
    level.width = std::max(1, desc.width >> i);
    level.height = std::max(1, desc.height >> i);
    level.depth = desc.dimension == render::Dimension::Cube     ? 6
                  : desc.dimension == render::Dimension::Volume ? std::max(1, desc.depth >> i)
                                                                : 1;
    const size_t texels = static_cast<size_t>(level.width) * static_cast<size_t>(level.height) *
                          static_cast<size_t>(level.depth) * samples;
    if (!render::isDepthOrStencil(desc.format))
      level.color.resize(texels, quantise(desc.format, {0, 0, 0, 0}));
    if (info(desc.format).depth != 0) level.z.resize(texels, 1.0);
    if (info(desc.format).stencil != 0) level.stencil.resize(texels, 0);
    levels_.push_back(std::move(level));
  }
}

size_t StoredImage::index(int level, int x, int y, int z, int sample) const {
  const Level& l = levels_[static_cast<size_t>(level)];
  const size_t texel = (static_cast<size_t>(z) * static_cast<size_t>(l.height) + static_cast<size_t>(y)) *
                           static_cast<size_t>(l.width) +
                       static_cast<size_t>(x);
  return texel * static_cast<size_t>(desc_.samples) + static_cast<size_t>(sample);
}

StoredBuffer::StoredBuffer(size_t size, const void* data) : Buffer(size), bytes_(size) {
  if (data != nullptr && size > 0) std::memcpy(bytes_.data(), data, size);
}

bool StoredBuffer::write(size_t offset, const void* data, size_t size) {
  if (size > 0) std::memcpy(bytes_.data() + offset, data, size);
  return true;
}

namespace {

// An unsigned n-bit field as [0, 1] and back, to nearest (sections 2.12.8 and 3.6.2).
double fromBits(unsigned value, int bits) {
  return value / (std::ldexp(1.0, bits) - 1);
}
unsigned toBits(double value, int bits) {
  if (!(value > 0)) return 0;
  const double largest = std::ldexp(1.0, bits) - 1;
  return static_cast<unsigned>(std::floor(std::min(value, 1.0) * largest + 0.5));
}
double toNearest(double value, int bits) {
  return fromBits(toBits(value, bits), bits);
}

struct Field {
  int shift, bits;
};
// red, green, blue, alpha of the 16-bit formats
struct Packed {
  Field field[4];
};
Packed packed(Format format) {
  switch (format) {
    case Format::RGB565:
      return {{{11, 5}, {5, 6}, {0, 5}, {0, 0}}};
    case Format::RGBA4444:
      return {{{12, 4}, {8, 4}, {4, 4}, {0, 4}}};
    default:
      return {{{11, 5}, {6, 5}, {1, 5}, {0, 1}}};  // RGBA5551
  }
}

bool isPacked(Format format) {
  return format == Format::RGB565 || format == Format::RGBA4444 || format == Format::RGBA5551;
}

}  // namespace

glm::dvec4 encoded(Format format, const glm::dvec4& color) {
  if (!render::isSrgb(format)) return color;
  const auto encode = [](double c) {
    if (!(c > 0)) return 0.0;
    return c < 0.0031308 ? 12.92 * c : std::min(1.055 * std::pow(c, 1 / 2.4) - 0.055, 1.0);
  };
  return {encode(color.r), encode(color.g), encode(color.b), color.a};
}

glm::dvec4 linear(Format format, const glm::dvec4& encodedColor) {
  if (!render::isSrgb(format)) return encodedColor;
  const auto decode = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return {decode(encodedColor.r), decode(encodedColor.g), decode(encodedColor.b), encodedColor.a};
}

glm::dvec4 decode(Format format, const std::byte* texel) {
  const auto byte = [&](int i) { return fromBits(std::to_integer<unsigned>(texel[i]), 8); };
  switch (format) {
    case Format::A8:
      return {0, 0, 0, byte(0)};
    case Format::L8:
      return {byte(0), byte(0), byte(0), 1};
    case Format::LA8:
      return {byte(0), byte(0), byte(0), byte(1)};
    case Format::RGB8:
    case Format::SRGB8:
      return {byte(0), byte(1), byte(2), 1};
    case Format::RGBA8:
    case Format::SRGB8Alpha8:
      return {byte(0), byte(1), byte(2), byte(3)};
    default:
      break;
  }
  uint16_t word = 0;
  std::memcpy(&word, texel, sizeof word);
  glm::dvec4 color(0, 0, 0, 1);
  const Packed layout = packed(format);
  for (int i = 0; i < 4; ++i) {
    const Field field = layout.field[i];
    if (field.bits > 0) color[i] = fromBits((word >> field.shift) & ((1u << field.bits) - 1), field.bits);
  }
  return color;
}

void encode(Format format, const glm::dvec4& color, std::byte* texel) {
  const auto byte = [](double value) { return static_cast<std::byte>(toBits(value, 8)); };
  if (isPacked(format)) {
    const Packed layout = packed(format);
    unsigned word = 0;
    for (int i = 0; i < 4; ++i) {
      const Field field = layout.field[i];
      if (field.bits > 0) word |= toBits(color[i], field.bits) << field.shift;
    }
    const uint16_t stored = static_cast<uint16_t>(word);
    std::memcpy(texel, &stored, sizeof stored);
    return;
  }
  switch (format) {
    case Format::A8:
      texel[0] = byte(color.a);
      break;
    case Format::L8:
      texel[0] = byte(color.r);
      break;
    case Format::LA8:
      texel[0] = byte(color.r);
      texel[1] = byte(color.a);
      break;
    default:
      for (int i = 0; i < info(format).bytes; ++i) texel[i] = byte(color[i]);
  }
}

glm::dvec4 quantise(Format format, const glm::dvec4& color) {
  const render::FormatInfo& bits = info(format);
  switch (format) {
    case Format::A8:
      return {0, 0, 0, toNearest(color.a, 8)};
    case Format::L8:
      return {glm::dvec3(toNearest(color.r, 8)), 1};
    case Format::LA8:
      return {glm::dvec3(toNearest(color.r, 8)), toNearest(color.a, 8)};
    default: {
      const glm::dvec4 c = encoded(format, color);
      return linear(format, {toNearest(c.r, bits.red), toNearest(c.g, bits.green), toNearest(c.b, bits.blue),
                             bits.alpha != 0 ? toNearest(c.a, bits.alpha) : 1.0});
    }
  }
}

double quantiseDepth(Format format, double z) {
  const double largest = std::ldexp(1.0, info(format).depth) - 1;
  if (!(z > 0)) return 0;
  if (format == Format::Depth32) return static_cast<float>(std::min(z, 1.0));
  return std::floor(std::min(z, 1.0) * largest + 0.5) / largest;
}

}  // namespace anteroom::reference
