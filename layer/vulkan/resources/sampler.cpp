#include "layer/vulkan/resources/sampler.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gen/ati.h"
#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
SamplerCache::~SamplerCache() {
  for (const Entry& entry : entries_) device_.fn().vkDestroySampler(device_.handle(), entry.sampler, nullptr);
}

VkSamplerAddressMode SamplerCache::wrap(GLenum mode) const {
  switch (mode) {
    case GL_CLAMP_TO_EDGE:
      return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case GL_MIRRORED_REPEAT_OES:
      return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    // Where there is no mode of that kind, and at borders, shaders clamp to [-1, 1] (gen::MirroredEdge).
    case gen::kMirrorClamp:
    case gen::kMirrorClampToEdge:
    case gen::kMirrorClampToBorder:
      return device_.features().mirrorClampToEdge ? VK_SAMPLER_ADDRESS_MODE_MIRROR_CLAMP_TO_EDGE
                                                  : VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    default:
      return VK_SAMPLER_ADDRESS_MODE_REPEAT;
  }
}

SamplerCache::Key SamplerCache::canonical(const render::Sampler& s, int levels, float lodBias) const {
  Key key;
  key.minLinear = s.minFilter == GL_LINEAR || s.minFilter == GL_LINEAR_MIPMAP_NEAREST ||
                  s.minFilter == GL_LINEAR_MIPMAP_LINEAR;
  key.magLinear = s.magFilter == GL_LINEAR;
  key.maxLevel = static_cast<uint16_t>(std::clamp(std::min(s.maxLevel, levels - 1), 0, 1000));
  key.mips = s.minFilter != GL_NEAREST && s.minFilter != GL_LINEAR && key.maxLevel > 0;
  if (!key.mips) key.maxLevel = 0;
  key.mipLinear =
      key.mips && (s.minFilter == GL_NEAREST_MIPMAP_LINEAR || s.minFilter == GL_LINEAR_MIPMAP_LINEAR);
  key.wrap[0] = static_cast<uint8_t>(wrap(s.wrapS));
  key.wrap[1] = static_cast<uint8_t>(wrap(s.wrapT));
  key.wrap[2] = static_cast<uint8_t>(wrap(s.wrapR));
  // Anisotropy is a way of linear filtering: with nearest texels it stays off.
  if (device_.features().anisotropy && key.minLinear && key.magLinear)
    key.anisotropy = static_cast<uint8_t>(
        std::clamp(s.maxAnisotropy, 1.0f, std::min(16.0f, device_.limits().maxSamplerAnisotropy)));
  const float most = std::min(device_.limits().maxSamplerLodBias, 100.0f);
  const bool biased = lodBias == lodBias && (key.mips || key.minLinear != key.magLinear);
  if (biased) key.lodBias = static_cast<int16_t>(std::lround(std::clamp(lodBias, -most, most) * 256));
  return key;
}

VkSampler SamplerCache::create(const Key& key) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.minFilter = key.minLinear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.magFilter = key.magLinear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.mipmapMode = key.mipLinear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = static_cast<VkSamplerAddressMode>(key.wrap[0]);
  info.addressModeV = static_cast<VkSamplerAddressMode>(key.wrap[1]);
  info.addressModeW = static_cast<VkSamplerAddressMode>(key.wrap[2]);
  info.anisotropyEnable = key.anisotropy > 1;
  info.maxAnisotropy = key.anisotropy;
  info.mipLodBias = static_cast<float>(key.lodBias) / 256;
  // Without mip levels a little room above 0 still tells minification from magnification.
  info.maxLod = key.mips ? key.maxLevel : 0.25f;
  if (!key.mips && key.minLinear == key.magLinear) info.maxLod = 0;
  VkSampler sampler = VK_NULL_HANDLE;
  if (device_.fn().vkCreateSampler(device_.handle(), &info, nullptr, &sampler) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  device_.countObject();
  if (device_.labels().nameAll()) name(sampler, key);
  return sampler;
}

// "min linear, mag linear, mip nearest of 10 levels, repeat x repeat"
void SamplerCache::name(VkSampler sampler, const Key& key) const {
  constexpr const char* kFilters[] = {"nearest", "linear"};
  constexpr const char* kWraps[] = {"repeat", "mirrored repeat", "clamp to edge", "clamp to border",
                                    "mirror clamp to edge"};
  std::string text = std::string("min ") + kFilters[key.minLinear] + ", mag " + kFilters[key.magLinear];
  if (key.mips)
    text.append(", mip ").append(kFilters[key.mipLinear]).append(" of ") +=
        std::to_string(key.maxLevel + 1) + " levels";
  text.append(", ").append(kWraps[key.wrap[0]]).append(" x ").append(kWraps[key.wrap[1]]);
  if (key.anisotropy > 1) text += ", anisotropy " + std::to_string(key.anisotropy);
  if (key.lodBias) text += ", bias " + std::to_string(key.lodBias / 256.0);
  device_.labels().name(VK_OBJECT_TYPE_SAMPLER, sampler, text);
}

VkSampler SamplerCache::get(const render::Sampler& sampler, int levels, float lodBias) {
  const Key key = canonical(sampler, levels, lodBias);
  const std::lock_guard lock(mutex_);
  for (const Entry& entry : entries_)
    if (entry.key == key) return entry.sampler;
  const VkSampler made = create(key);
  if (made) entries_.push_back({key, made});
  return made;
}

}  // namespace anteroom::vulkan
