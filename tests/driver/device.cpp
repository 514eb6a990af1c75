#define VOLK_IMPLEMENTATION
#include "device.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "pass_vert.h"

namespace driver {

namespace {

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(fmt::format("{} failed with {}", what, static_cast<int>(result)));
}

std::size_t texelSize(VkFormat format) {
  return format == VK_FORMAT_R32G32B32A32_SFLOAT ? 16 : 4;
}

// As ours chooses: the device that ANTEROOM_DEVICE names, else a discrete one before an integrated one before
// a CPU.
int preference(const VkPhysicalDeviceProperties& properties) {
  const char* name = std::getenv("ANTEROOM_DEVICE");
  if (name && !std::strstr(properties.deviceName, name)) return -1;
  switch (properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 1;
    default:
      return 0;
  }
}

}  // namespace

Cleanup::~Cleanup() {
  for (auto destroy = destroy_.rbegin(); destroy != destroy_.rend(); ++destroy) (*destroy)();
}

Device::Device() {
  check(volkInitialize(), "volkInitialize");
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_1;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  check(vkCreateInstance(&info, nullptr, &instance_), "vkCreateInstance");
  cleanup_.add([this] { vkDestroyInstance(instance_, nullptr); });
  volkLoadInstance(instance_);
  choosePhysical();
  createDevice();
}

void Device::choosePhysical() {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  std::vector<VkPhysicalDevice> all(count);
  vkEnumeratePhysicalDevices(instance_, &count, all.data());
  int best = -1;
  for (VkPhysicalDevice candidate : all) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(candidate, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_1 || preference(properties) <= best) continue;
    best = preference(properties);
    physical_ = candidate;
    properties_ = properties;
  }
  if (!physical_) throw std::runtime_error("no Vulkan 1.1 device");
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
  while (family_ < count && !(families[family_].queueFlags & VK_QUEUE_GRAPHICS_BIT)) ++family_;
  if (family_ == count) throw std::runtime_error("no graphics queue");
}

void Device::createDevice() {
  std::uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, extensions.data());
  std::vector<const char*> names;
  for (const VkExtensionProperties& extension : extensions)
    if (!std::strcmp(extension.extensionName, VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME))
      names.push_back(VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME);
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  if (!names.empty()) features.pNext = &lines_;
  vkGetPhysicalDeviceFeatures2(physical_, &features);
  features_ = features.features;
  features.features = {};
  features.features.samplerAnisotropy = features_.samplerAnisotropy;
  features.features.wideLines = features_.wideLines;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
  info.ppEnabledExtensionNames = names.data();
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  cleanup_.add([this] { vkDestroyDevice(device_, nullptr); });
  volkLoadDevice(device_);
  vkGetDeviceQueue(device_, family_, 0, &queue_);

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.queueFamilyIndex = family_;
  check(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "vkCreateCommandPool");
  cleanup_.add([this] { vkDestroyCommandPool(device_, pool_, nullptr); });

  VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                                       VK_SHADER_STAGE_FRAGMENT_BIT};
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.bindingCount = 1;
  set.pBindings = &binding;
  check(vkCreateDescriptorSetLayout(device_, &set, nullptr, &setLayout_), "vkCreateDescriptorSetLayout");
  cleanup_.add([this] { vkDestroyDescriptorSetLayout(device_, setLayout_, nullptr); });
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &setLayout_;
  check(vkCreatePipelineLayout(device_, &layout, nullptr, &layout_), "vkCreatePipelineLayout");
  cleanup_.add([this] { vkDestroyPipelineLayout(device_, layout_, nullptr); });
}

VkDeviceMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted,
                                Cleanup& cleanup) {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    if (!(needs.memoryTypeBits >> i & 1) || (memory.memoryTypes[i].propertyFlags & wanted) != wanted)
      continue;
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = i;
    VkDeviceMemory result = VK_NULL_HANDLE;
    check(vkAllocateMemory(device_, &info, nullptr, &result), "vkAllocateMemory");
    cleanup.add([this, result] { vkFreeMemory(device_, result, nullptr); });
    return result;
  }
  throw std::runtime_error("no memory of the kind");
}

Device::Image Device::createImage(VkFormat format, int width, int height, int levels, VkImageUsageFlags usage,
                                  Cleanup& cleanup) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1};
  info.mipLevels = static_cast<std::uint32_t>(levels);
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = usage;
  Image result;
  check(vkCreateImage(device_, &info, nullptr, &result.image), "vkCreateImage");
  cleanup.add([this, image = result.image] { vkDestroyImage(device_, image, nullptr); });
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device_, result.image, &needs);
  check(vkBindImageMemory(device_, result.image, allocate(needs, 0, cleanup), 0), "vkBindImageMemory");
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = result.image;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, info.mipLevels, 0, 1};
  check(vkCreateImageView(device_, &view, nullptr, &result.view), "vkCreateImageView");
  cleanup.add([this, made = result.view] { vkDestroyImageView(device_, made, nullptr); });
  return result;
}

Device::HostBuffer Device::createBuffer(std::size_t size, VkBufferUsageFlags usage, Cleanup& cleanup) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size;
  info.usage = usage;
  HostBuffer result;
  check(vkCreateBuffer(device_, &info, nullptr, &result.buffer), "vkCreateBuffer");
  cleanup.add([this, buffer = result.buffer] { vkDestroyBuffer(device_, buffer, nullptr); });
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device_, result.buffer, &needs);
  const VkDeviceMemory memory =
      allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, cleanup);
  check(vkBindBufferMemory(device_, result.buffer, memory, 0), "vkBindBufferMemory");
  check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &result.mapped), "vkMapMemory");
  return result;
}

VkRenderPass Device::createRenderPass(VkFormat format, Cleanup& cleanup) {
  VkAttachmentDescription color{};
  color.format = format;
  color.samples = VK_SAMPLE_COUNT_1_BIT;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  color.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkSubpassDependency toCopy{0, VK_SUBPASS_EXTERNAL};
  toCopy.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  toCopy.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  toCopy.dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
  toCopy.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = info.subpassCount = info.dependencyCount = 1;
  info.pAttachments = &color;
  info.pSubpasses = &subpass;
  info.pDependencies = &toCopy;
  VkRenderPass result = VK_NULL_HANDLE;
  check(vkCreateRenderPass(device_, &info, nullptr, &result), "vkCreateRenderPass");
  cleanup.add([this, result] { vkDestroyRenderPass(device_, result, nullptr); });
  return result;
}

VkShaderModule Device::createShader(std::span<const std::uint32_t> code, Cleanup& cleanup) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  VkShaderModule result = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device_, &info, nullptr, &result), "vkCreateShaderModule");
  cleanup.add([this, result] { vkDestroyShaderModule(device_, result, nullptr); });
  return result;
}

VkPipeline Device::createPipeline(const Draw& draw, VkRenderPass pass, int width, int height,
                                  Cleanup& cleanup) {
  VkPipelineShaderStageCreateInfo stages[2]{};
  for (VkPipelineShaderStageCreateInfo& stage : stages) {
    stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.pName = "main";
  }
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = createShader(pass_vert, cleanup);
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages[1].module = createShader(draw.fragmentShader, cleanup);

  const VkVertexInputBindingDescription binding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
  const VkVertexInputAttributeDescription attributes[] = {
      {0, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, position)},
      {1, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, value)}};
  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = 1;
  input.pVertexBindingDescriptions = &binding;
  input.vertexAttributeDescriptionCount = 2;
  input.pVertexAttributeDescriptions = attributes;
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = draw.topology;
  const VkViewport view{0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1};
  const VkRect2D scissor{{0, 0}, {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)}};
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  viewport.pViewports = &view;
  viewport.pScissors = &scissor;
  VkPipelineRasterizationLineStateCreateInfoEXT line{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_LINE_STATE_CREATE_INFO_EXT};
  line.lineRasterizationMode = draw.lineMode;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  if (draw.lineMode != VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT) raster.pNext = &line;
  raster.lineWidth = draw.lineWidth;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState attachment = draw.blend;
  attachment.colorWriteMask = 15;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = 1;
  blend.pAttachments = &attachment;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.stageCount = 2;
  info.pStages = stages;
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blend;
  info.layout = layout_;
  info.renderPass = pass;
  VkPipeline result = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &result),
        "vkCreateGraphicsPipelines");
  cleanup.add([this, result] { vkDestroyPipeline(device_, result, nullptr); });
  return result;
}

void Device::barrier(VkCommandBuffer commands, VkImage image, int levels, VkImageLayout from,
                     VkImageLayout to) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, static_cast<std::uint32_t>(levels), 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                       nullptr, 0, nullptr, 1, &barrier);
}

VkDescriptorSet Device::createTexture(VkCommandBuffer commands, const Texture& texture, Cleanup& cleanup) {
  const int levels = static_cast<int>(texture.levels.size());
  const Image image = createImage(VK_FORMAT_R8G8B8A8_UNORM, texture.size, texture.size, levels,
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, cleanup);
  barrier(commands, image.image, levels, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  for (int i = 0; i < levels; ++i) {
    const std::vector<std::uint8_t>& texels = texture.levels[static_cast<std::size_t>(i)];
    const HostBuffer staging = createBuffer(texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, cleanup);
    std::memcpy(staging.mapped, texels.data(), texels.size());
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<std::uint32_t>(i), 0, 1};
    region.imageExtent = {static_cast<std::uint32_t>(texture.size >> i),
                          static_cast<std::uint32_t>(texture.size >> i), 1};
    vkCmdCopyBufferToImage(commands, staging.buffer, image.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
  }
  barrier(commands, image.image, levels, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

  VkSamplerCreateInfo how{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  how.magFilter = how.minFilter = VK_FILTER_LINEAR;
  how.mipmapMode = texture.mipmapMode;
  how.anisotropyEnable = texture.anisotropy > 1;
  how.maxAnisotropy = texture.anisotropy;
  how.maxLod = static_cast<float>(levels);
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device_, &how, nullptr, &sampler), "vkCreateSampler");
  cleanup.add([this, sampler] { vkDestroySampler(device_, sampler, nullptr); });

  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = poolInfo.poolSizeCount = 1;
  poolInfo.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_, &poolInfo, nullptr, &pool), "vkCreateDescriptorPool");
  cleanup.add([this, pool] { vkDestroyDescriptorPool(device_, pool, nullptr); });
  VkDescriptorSetAllocateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  setInfo.descriptorPool = pool;
  setInfo.descriptorSetCount = 1;
  setInfo.pSetLayouts = &setLayout_;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device_, &setInfo, &set), "vkAllocateDescriptorSets");
  const VkDescriptorImageInfo entry{sampler, image.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  write.pImageInfo = &entry;
  vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
  return set;
}

VkCommandBuffer Device::begin(Cleanup& cleanup) {
  VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  info.commandPool = pool_;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device_, &info, &commands), "vkAllocateCommandBuffers");
  cleanup.add([this, commands] { vkFreeCommandBuffers(device_, pool_, 1, &commands); });
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  return commands;
}

void Device::finish(VkCommandBuffer commands) {
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
  check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
}

std::vector<float> Device::render(VkFormat format, int width, int height, const std::vector<Draw>& draws) {
  Cleanup cleanup;
  const Image target =
      createImage(format, width, height, 1,
                  VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, cleanup);
  const VkRenderPass pass = createRenderPass(format, cleanup);
  VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
  info.renderPass = pass;
  info.attachmentCount = 1;
  info.pAttachments = &target.view;
  info.width = static_cast<std::uint32_t>(width);
  info.height = static_cast<std::uint32_t>(height);
  info.layers = 1;
  VkFramebuffer framebuffer = VK_NULL_HANDLE;
  check(vkCreateFramebuffer(device_, &info, nullptr, &framebuffer), "vkCreateFramebuffer");
  cleanup.add([this, framebuffer] { vkDestroyFramebuffer(device_, framebuffer, nullptr); });
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const HostBuffer out = createBuffer(pixels * texelSize(format), VK_BUFFER_USAGE_TRANSFER_DST_BIT, cleanup);

  const VkCommandBuffer commands = begin(cleanup);
  std::vector<VkDescriptorSet> sets;
  for (const Draw& draw : draws)
    sets.push_back(draw.texture ? createTexture(commands, *draw.texture, cleanup) : VK_NULL_HANDLE);
  const VkClearValue zero{};
  VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  begin.renderPass = pass;
  begin.framebuffer = framebuffer;
  begin.renderArea.extent = {info.width, info.height};
  begin.clearValueCount = 1;
  begin.pClearValues = &zero;
  vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const std::size_t size = draws[i].vertices.size() * sizeof(Vertex);
    const HostBuffer vertices = createBuffer(size, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, cleanup);
    std::memcpy(vertices.mapped, draws[i].vertices.data(), size);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      createPipeline(draws[i], pass, width, height, cleanup));
    if (sets[i])
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &sets[i], 0, nullptr);
    const VkDeviceSize start = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices.buffer, &start);
    vkCmdDraw(commands, static_cast<std::uint32_t>(draws[i].vertices.size()), 1, 0, 0);
  }
  vkCmdEndRenderPass(commands);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {info.width, info.height, 1};
  vkCmdCopyImageToBuffer(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, out.buffer, 1,
                         &region);
  finish(commands);

  std::vector<float> result(pixels * 4);
  if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
    std::memcpy(result.data(), out.mapped, result.size() * sizeof(float));
  } else {
    const auto* bytes = static_cast<const std::uint8_t*>(out.mapped);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<float>(bytes[i]) / 255;
  }
  return result;
}

}  // namespace driver
