// A bare Vulkan device that draws a pass with hand-written shaders: what the driver does by itself.
#pragma once

#include <volk.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace driver {

struct Vertex {
  float position[4];  // clip coordinates
  float value[4];
};

// A square RGBA8 texture that repeats: levels[i] has (size >> i)^2 texels.
struct Texture {
  int size = 1;
  std::vector<std::vector<std::uint8_t>> levels;
  VkSamplerMipmapMode mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  float anisotropy = 1;
};

struct Draw {
  std::span<const std::uint32_t> fragmentShader;
  std::vector<Vertex> vertices;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const Texture* texture = nullptr;
  VkPipelineColorBlendAttachmentState blend = {};  // the write mask is set for it
  VkLineRasterizationModeEXT lineMode = VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT;
  float lineWidth = 1;
};

// Destroys in the reverse order.
class Cleanup {
 public:
  Cleanup() = default;
  ~Cleanup();
  Cleanup(const Cleanup&) = delete;
  Cleanup& operator=(const Cleanup&) = delete;
  void add(std::function<void()> destroy) { destroy_.push_back(std::move(destroy)); }

 private:
  std::vector<std::function<void()>> destroy_;
};

// Every failure is a std::runtime_error.
class Device {
 public:
  Device();

  // One pass over a cleared target of the format; RGBA a pixel, the first row is that of y = -1.
  std::vector<float> render(VkFormat format, int width, int height, const std::vector<Draw>& draws);

  const char* name() const { return properties_.deviceName; }
  bool bresenhamLines() const { return lines_.bresenhamLines != 0; }
  bool smoothLines() const { return lines_.smoothLines != 0 && features_.wideLines != 0; }
  float maxAnisotropy() const {
    return features_.samplerAnisotropy ? properties_.limits.maxSamplerAnisotropy : 1;
  }

 private:
  struct Image {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
  };
  struct HostBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    void* mapped = nullptr;
  };

  void choosePhysical();
  void createDevice();
  VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted, Cleanup& cleanup);
  Image createImage(VkFormat format, int width, int height, int levels, VkImageUsageFlags usage,
                    Cleanup& cleanup);
  HostBuffer createBuffer(std::size_t size, VkBufferUsageFlags usage, Cleanup& cleanup);
  VkRenderPass createRenderPass(VkFormat format, Cleanup& cleanup);
  VkPipeline createPipeline(const Draw& draw, VkRenderPass pass, int width, int height, Cleanup& cleanup);
  VkShaderModule createShader(std::span<const std::uint32_t> code, Cleanup& cleanup);
  VkDescriptorSet createTexture(VkCommandBuffer commands, const Texture& texture, Cleanup& cleanup);
  VkCommandBuffer begin(Cleanup& cleanup);
  void finish(VkCommandBuffer commands);
  void barrier(VkCommandBuffer commands, VkImage image, int levels, VkImageLayout from, VkImageLayout to);

  Cleanup cleanup_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceFeatures features_{};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines_{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT};
  std::uint32_t family_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
};

}  // namespace driver
