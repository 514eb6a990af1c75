// Images of the reference renderer: texels as float64, already rounded to what the image's format can hold;
// colors of sRGB formats as linear ones.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "layer/render/renderer.h"

namespace anteroom::reference {

struct Level {
  int width = 0, height = 0, depth = 0;  // depth: faces of a cube map, slices of a volume
  std::vector<glm::dvec4> color;         // [(z * height + y) * width + x] * samples + sample
  std::vector<double> z;
  std::vector<uint8_t> stencil;
};

class StoredImage final : public render::Image {
 public:
  explicit StoredImage(const render::ImageDesc& desc);
  Level& level(int index) { return levels_[static_cast<size_t>(index)]; }
  const Level& level(int index) const { return levels_[static_cast<size_t>(index)]; }
  int levelCount() const { return static_cast<int>(levels_.size()); }
  size_t index(int level, int x, int y, int z, int sample = 0) const;

  // What samples that belong to a level of another image were resolved into last.
  struct Contents {
    uint64_t image = 0, version = 0;
    int level = 0, layer = 0;
    bool operator==(const Contents&) const = default;
  };
  Contents contents(int level, int layer) const { return {id_, version, level, layer}; }
  Contents follows;
  uint64_t version = 0;  // raised by everything that writes texels

 private:
  const uint64_t id_;  // unlike any other image's
  std::vector<Level> levels_;
};

class StoredBuffer final : public render::Buffer {
 public:
  StoredBuffer(size_t size, const void* data);
  const std::byte* contents() const override { return bytes_.data(); }
  bool write(size_t offset, const void* data, size_t size) override;

 private:
  std::vector<std::byte> bytes_;
};

// EXT_sRGB: colors of sRGB formats as they are encoded, and back. Others stay as they are.
glm::dvec4 encoded(render::Format format, const glm::dvec4& color);
glm::dvec4 linear(render::Format format, const glm::dvec4& encodedColor);

// One texel between client memory and float64; components that the format lacks read as Table 3.11 fills
// them: luminance in red, green and blue, alpha 1, colors of an alpha format 0. Neither decodes nor encodes
// sRGB colors.
glm::dvec4 decode(render::Format format, const std::byte* texel);
void encode(render::Format format, const glm::dvec4& color, std::byte* texel);

// The nearest color that the format can hold.
glm::dvec4 quantise(render::Format format, const glm::dvec4& color);
double quantiseDepth(render::Format format, double z);

}  // namespace anteroom::reference
