#include "layer/vulkan/device/device.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "layer/cache/location.h"
#include "layer/vulkan/context.h"
#include "layer/vulkan/debug/frame_capture.h"
#include "layer/vulkan/device/no_fork.h"
#include "layer/vulkan/device/process_end.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/legacy_passes.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/pipeline_warm_up.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/resources/buffer.h"
#include "layer/vulkan/resources/image.h"
#include "layer/vulkan/resources/sampler.h"
#include "layer/vulkan/windows/presenter.h"
#include "layer/vulkan/windows/window.h"

namespace anteroom::vulkan {
namespace {

constexpr uint32_t kSetsAPool = 64;

void keepPages() {
#ifdef __GLIBC__
  const char* setting = std::getenv("ANTEROOM_MALLOPT");
  if (setting && !std::strcmp(setting, "off")) return;
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

}  // namespace

std::unique_ptr<render::Device> createDevice(const DeviceOptions& options, std::string& error) {
  return VulkanDevice::create(options, error);
}

std::unique_ptr<VulkanDevice> VulkanDevice::create(const DeviceOptions& options, std::string& error) {
  NoFork::guardForks();
  NoFork::prepareChild();
  std::unique_ptr<VulkanDevice> device(new VulkanDevice);
  if (!device->initialise(options, error)) return nullptr;
  return device;
}

bool VulkanDevice::initialise(const DeviceOptions& options, std::string& error) {
  debug_ = options.debug;
  {
    const DeviceLock lock;
    if (!createInstance(options, instance_, error)) return false;
    const VkResult result = createLogicalDevice(instance_, options.minimal, handle_, features_);
    if (result != VK_SUCCESS) {
      error = "vkCreateDevice failed with " + std::to_string(result) + ": check the Vulkan driver";
      return false;
    }
    volkLoadDeviceTable(&fn_, handle_);
  }
  fn_.vkGetDeviceQueue(handle_, instance_.queueFamily, 0, &queue_);
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(instance_.physical, &properties);
  limits_ = properties.limits;
  isCpu_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  driver_ = driverOf(instance_.physical);
  quirks_ = quirksOf(driver_);
  formats_ = chooseFormats(instance_.physical, features_);
  fillCaps(properties);
  labels_.load(handle_, {instance_.debugUtils, !quirks_.crashesInLabels, debug_.markers});
  caps_.objectNames = labels_.nameAll();
  caps_.drawGroups = labels_.nameAll() && labels_.inCommands();
  if (labels_.nameAll()) labels_.name(VK_OBJECT_TYPE_QUEUE, queue_, "the queue of all contexts");
  if (quirks_.returnsPages) keepPages();

  memory_ = std::make_unique<MemoryPool>(*this);
  timeline_ = std::make_unique<Timeline>(*this);
  presenter_ = std::make_unique<Presenter>(*this);
  samplers_ = std::make_unique<SamplerCache>(*this);
  shaders_ = std::make_unique<ShaderLibrary>(*this);
  legacyPasses_ = std::make_unique<LegacyPasses>(*this);
  driverCache_ = std::make_unique<DriverCache>(*this);
  pipelines_ = std::make_unique<PipelineCache>(*this);
  warmUp_ = std::make_unique<PipelineWarmUp>(*this);
  if (timeline_->initialise() && createLayouts()) {
    if (debug_.captureFrame) capture_ = std::make_unique<FrameCapture>(instance_.handle, debug_.captureFrame);
    finishAtExit(*this);
    return true;
  }
  error = "the Vulkan device is out of memory";
  return false;
}

void VulkanDevice::wait() {
  timeline_->wait(timeline_->submitted(), UINT64_MAX);
  presenter_->wait(nullptr);
}

void VulkanDevice::finishWork() {
  timeline_->end();
  waitForThreads();
}

void VulkanDevice::waitForThreads() {
  warmUp_->stop();
  presenter_->wait(nullptr);
}

VulkanDevice::~VulkanDevice() {
  forgetAtExit(*this);
  if (handle_) {
    capture_.reset();
    warmUp_.reset();
    presenter_.reset();
    fn_.vkDeviceWaitIdle(handle_);
    pipelines_.reset();
    driverCache_.reset();
    legacyPasses_.reset();
    shaders_.reset();
    samplers_.reset();
    timeline_.reset();
    memory_.reset();
    for (VkDescriptorPool pool : constantPools_) fn_.vkDestroyDescriptorPool(handle_, pool, nullptr);
    fn_.vkDestroyPipelineLayout(handle_, pipelineLayout_, nullptr);
    for (VkDescriptorSetLayout layout : setLayouts_)
      fn_.vkDestroyDescriptorSetLayout(handle_, layout, nullptr);
    fn_.vkDestroyDevice(handle_, nullptr);
  }
  const DeviceLock lock;
  destroyInstance(instance_);
}

int VulkanDevice::commonSamples() const {
  const VkSampleCountFlags counts = limits_.framebufferColorSampleCounts &
                                    limits_.framebufferDepthSampleCounts &
                                    limits_.framebufferStencilSampleCounts;
  for (int samples : {8, 4, 2})
    if (counts & static_cast<VkSampleCountFlags>(samples)) return samples;
  return 1;
}

void VulkanDevice::fillCaps(const VkPhysicalDeviceProperties& properties) {
  caps_.deviceName = properties.deviceName;
  caps_.origin.devices = instance_.devices;
  caps_.origin.choice = instance_.choice;
  caps_.origin.driver = driver_.text;
  caps_.origin.quirks = namesOf(quirks_);
  const cache::CacheLocation cache = cache::cacheLocation();
  caps_.origin.cache = !cache.file.empty()    ? cache.file.string()
                       : cache.reason.empty() ? "none: switched off"
                                              : "none: " + cache.reason;
  caps_.profile.clipDistance = features_.clipDistance && limits_.maxClipDistances >= gen::kMaxClipPlanes;
  caps_.profile.largePoints = features_.largePoints;
  caps_.profile.mirrorClampToEdge = features_.mirrorClampToEdge;
  caps_.maxTextureSize = static_cast<int>(std::min(limits_.maxImageDimension2D, 16384u));
  caps_.maxCubeMapSize = static_cast<int>(std::min(limits_.maxImageDimensionCube, 16384u));
  caps_.maxVolumeSize = static_cast<int>(std::min(limits_.maxImageDimension3D, 2048u));
  for (int i = 0; i < 2; ++i) {
    const uint32_t framebuffer = i == 0 ? limits_.maxFramebufferWidth : limits_.maxFramebufferHeight;
    caps_.maxViewport[i] = static_cast<int>(std::min(limits_.maxViewportDimensions[i], framebuffer));
    if (features_.largePoints) caps_.pointSizeRange[i] = std::max(1.0f, limits_.pointSizeRange[i]);
    if (features_.wideLines) caps_.lineWidthRange[i] = std::max(1.0f, limits_.lineWidthRange[i]);
    caps_.smoothPointSizeRange[i] = caps_.pointSizeRange[i];
    if (features_.smoothLines) caps_.smoothLineWidthRange[i] = caps_.lineWidthRange[i];
  }
  caps_.subpixelBits = static_cast<int>(limits_.subPixelPrecisionBits);
  caps_.maxAnisotropy = features_.anisotropy ? std::min(limits_.maxSamplerAnisotropy, 16.0f) : 1;
  caps_.maxLodBias = std::min(limits_.maxSamplerLodBias, 100.0f);
  for (size_t i = 0; i < formats_.size(); ++i) caps_.renderable[i] = formats_[i].renderable;
  caps_.maxSamples = commonSamples();
  caps_.polygonOffsetClamp = features_.depthBiasClamp;
  caps_.windows = features_.swapchain;
  caps_.x11Alpha = !quirks_.showsX11Opaque;
}

bool VulkanDevice::createLayouts() {
  VkDescriptorSetLayoutBinding bindings[gen::kMaxTextureUnits]{};
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.pBindings = bindings;
  for (uint32_t set : {0u, 2u}) {
    bindings[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    bindings[0].descriptorCount = info.bindingCount = 1;
    bindings[0].stageFlags = set == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
    if (fn_.vkCreateDescriptorSetLayout(handle_, &info, nullptr, &setLayouts_[set]) != VK_SUCCESS)
      return false;
  }
  for (uint32_t i = 0; i < gen::kMaxTextureUnits; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  }
  info.bindingCount = gen::kMaxTextureUnits;
  if (features_.pushDescriptors) info.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  if (fn_.vkCreateDescriptorSetLayout(handle_, &info, nullptr, &setLayouts_[1]) != VK_SUCCESS) return false;

  const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0, kPushRange};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  // The palette lies in buffers of vertex constants, too.
  const VkDescriptorSetLayout sets[4] = {setLayouts_[0], setLayouts_[1], setLayouts_[2], setLayouts_[0]};
  layout.setLayoutCount = 4;
  layout.pSetLayouts = sets;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &push;
  for (int i = 0; i < 4; ++i) countObject();
  return fn_.vkCreatePipelineLayout(handle_, &layout, nullptr, &pipelineLayout_) == VK_SUCCESS;
}

bool VulkanDevice::growConstantSets() {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, 2 * kSetsAPool};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 2 * kSetsAPool;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  VkDescriptorPool made;
  if (fn_.vkCreateDescriptorPool(handle_, &pool, nullptr, &made) != VK_SUCCESS) return false;
  countObject();
  constantPools_.push_back(made);
  const VkDescriptorSetLayout layouts[2] = {setLayouts_[0], setLayouts_[2]};
  for (uint32_t i = 0; i < kSetsAPool; ++i) {
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = made;
    info.descriptorSetCount = 2;
    info.pSetLayouts = layouts;
    VkDescriptorSet sets[2];
    if (fn_.vkAllocateDescriptorSets(handle_, &info, sets) != VK_SUCCESS) break;
    freeConstantSets_.push_back({sets[0], sets[1]});
  }
  return !freeConstantSets_.empty();
}

ConstantSets VulkanDevice::allocateConstantSets(VkBuffer buffer) {
  const std::lock_guard lock(mutex_);
  if (freeConstantSets_.empty() && !growConstantSets()) return {};
  const ConstantSets sets = freeConstantSets_.back();
  freeConstantSets_.pop_back();
  const VkDescriptorBufferInfo shown{buffer, 0, kConstantRange};
  VkWriteDescriptorSet writes[2];
  for (VkWriteDescriptorSet& write : writes) {
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = &write == writes ? sets.vertex : sets.fragment;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    write.pBufferInfo = &shown;
  }
  fn_.vkUpdateDescriptorSets(handle_, 2, writes, 0, nullptr);
  return sets;
}

void VulkanDevice::freeConstantSets(const ConstantSets& sets) {
  const std::lock_guard lock(mutex_);
  freeConstantSets_.push_back(sets);
}

bool VulkanDevice::vertexFormat(VkFormat format) const {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(instance_.physical, format, &properties);
  return properties.bufferFeatures & VK_FORMAT_FEATURE_VERTEX_BUFFER_BIT;
}

void VulkanDevice::addFreshImage(const FreshImage& image) {
  const std::lock_guard lock(mutex_);
  freshImages_.push_back(image);
}

bool VulkanDevice::removeFreshImage(VkImage image) {
  const std::lock_guard lock(mutex_);
  return std::erase_if(freshImages_, [&](const FreshImage& fresh) { return fresh.image == image; }) != 0;
}

void VulkanDevice::takeFreshImages(std::vector<FreshImage>& images) {
  const std::lock_guard lock(mutex_);
  images.swap(freshImages_);
}

std::shared_ptr<render::Image> VulkanDevice::createImage(const render::ImageDesc& desc) {
  const StoreFormat& store = format(desc.format);
  const int limit = desc.dimension == render::Dimension::Cube     ? caps_.maxCubeMapSize
                    : desc.dimension == render::Dimension::Volume ? caps_.maxVolumeSize
                                                                  : caps_.maxTextureSize;
  if (store.format == VK_FORMAT_UNDEFINED || desc.width < 1 || desc.height < 1 || desc.depth < 1 ||
      desc.width > limit || desc.height > limit || desc.depth > limit || desc.levels < 1 ||
      desc.samples > caps_.maxSamples)
    return nullptr;
  workAhead();
  return std::make_shared<VulkanImage>(*this, desc);
}

std::shared_ptr<render::Buffer> VulkanDevice::createBuffer(size_t size, const void* data) {
  workAhead();
  return VulkanBuffer::create(*this, size, data);
}

void VulkanDevice::endFrame() {
  if (capture_) capture_->endFrame();
}

void VulkanDevice::workAhead() {
  if (workingAhead_.exchange(true, std::memory_order_relaxed)) return;
  ShaderLibrary::warmUp();
  warmUp_->start();
}

std::unique_ptr<render::Context> VulkanDevice::createContext() {
  auto context = std::make_unique<VulkanContext>(*this);
  if (!context->initialise()) return nullptr;
  return context;
}

}  // namespace anteroom::vulkan
