// What a draw needs besides its vertices, as plain data.
#pragma once

#include <volk.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "gen/gen.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/draw_state.h"
#include "layer/vulkan/resources/target.h"

namespace anteroom::vulkan {

struct Shader;

// A block of constants as shaders read it.
template <uint32_t Most>
struct ConstantBlock {
  alignas(16) std::array<std::byte, Most> data{};
  uint32_t size = 0;     // bytes that are read; 0: none
  uint64_t version = 0;  // changes when `data` does
};

// An image that a unit samples, or one level of one of its layers (onlyLevel >= 0).
struct SampledImage {
  VulkanImage* image = nullptr;  // null: there is none, and nothing can be drawn
  int onlyLevel = -1, onlyLayer = 0;
};

// What is bound for it.
struct Texture {
  VkImageView view = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
  bool operator==(const Texture&) const = default;
};

struct DrawPlan {
  bool nothing = false;  // can be seen of the draw
  Target target;
  gen::VertexKey vertexKey{};
  gen::FragmentKey fragmentKey{};
  const Shader* vertexShader = nullptr;
  const Shader* fragmentShader = nullptr;
  gen::Blocks blocks;  // of both keys
  DrawState state;     // but the topology, which the geometry decides
  // With VertexKey::ownValues each vertex carries what would be push constants.
  ConstantBlock<kPushRange> push;
  ConstantBlock<kConstantRange> vertex, fragment, palette;
  uint32_t units = 0;  // bit i: unit i is sampled
  std::array<SampledImage, gen::kMaxTextureUnits> sampled{};
  // By unit. The views are those of the images' stores of the moment: prepareTextures() sets them.
  std::array<Texture, gen::kMaxTextureUnits> textures{};

  bool usesDepth() const { return state.fixed.depthTest || state.fixed.stencilTest; }
};

}  // namespace anteroom::vulkan
