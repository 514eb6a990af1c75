// The Vulkan device and what its contexts share: memory, the queue, formats, samplers, shaders and pipelines.
#pragma once

#include <volk.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "layer/vulkan/debug/labels.h"
#include "layer/vulkan/device/constant_sets.h"
#include "layer/vulkan/device/features.h"
#include "layer/vulkan/device/formats.h"
#include "layer/vulkan/device/instance.h"
#include "layer/vulkan/device/memory.h"
#include "layer/vulkan/device/quirks.h"
#include "layer/vulkan/vulkan_device.h"

namespace anteroom::vulkan {

class DriverCache;
class FrameCapture;
struct ImageStore;
class LegacyPasses;
class PipelineCache;
class PipelineWarmUp;
class Presenter;
class SamplerCache;
class ShaderLibrary;
class Timeline;

// The largest constants of a stage: what a descriptor of the constants covers.
inline constexpr uint32_t kConstantRange = 16 << 10;
// Push constants that every device has.
inline constexpr uint32_t kPushRange = 128;

// An image that no submission has touched yet, or not since the window system had it.
struct FreshImage {
  std::weak_ptr<ImageStore> store;
  VkImage image;
  VkImageAspectFlags aspects;
  VkImageLayout layout;
  bool clear;                          // its contents are unknown, and must become something
  VkSemaphore ready = VK_NULL_HANDLE;  // signaled when it can be touched; null: it can
};

class VulkanDevice : public render::Device {
 public:
  // Null: `error` says why.
  static std::unique_ptr<VulkanDevice> create(const DeviceOptions& options, std::string& error);
  ~VulkanDevice() override;

  const render::Caps& caps() const override { return caps_; }
  std::shared_ptr<render::Image> createImage(const render::ImageDesc& desc) override;
  std::shared_ptr<render::Buffer> createBuffer(size_t size, const void* data) override;
  std::unique_ptr<render::Context> createContext() override;
  std::unique_ptr<render::Window> createWindow(const render::WindowDesc& desc) override;
  void endFrame() override;

  // The process ends: see process_end.h.
  void finishWork();
  // The same without calls of the driver, of which parts may be gone.
  void waitForThreads();
  // All that was submitted is done and shown.
  void wait();

  const Instance& instance() const { return instance_; }
  VkDevice handle() const { return handle_; }
  VkPhysicalDevice physical() const { return instance_.physical; }
  uint32_t queueFamily() const { return instance_.queueFamily; }
  VkQueue queue() const { return queue_; }
  const VolkDeviceTable& fn() const { return fn_; }
  const Features& features() const { return features_; }
  const Driver& driver() const { return driver_; }
  const Quirks& quirks() const { return quirks_; }
  // Its memory is the CPU's, and what it does takes the program's own time.
  bool isCpu() const { return isCpu_; }
  const VkPhysicalDeviceLimits& limits() const { return limits_; }
  const StoreFormat& format(render::Format format) const { return formats_[static_cast<int>(format)]; }
  // Whether a vertex attribute may have this format.
  bool vertexFormat(VkFormat format) const;

  const render::DebugOptions& debug() const { return debug_; }
  const Labels& labels() const { return labels_; }
  MemoryPool& memory() { return *memory_; }
  Timeline& timeline() { return *timeline_; }
  Presenter& presenter() { return *presenter_; }
  SamplerCache& samplers() { return *samplers_; }
  ShaderLibrary& shaders() { return *shaders_; }
  PipelineCache& pipelines() { return *pipelines_; }
  DriverCache& driverCache() { return *driverCache_; }
  LegacyPasses& legacyPasses() { return *legacyPasses_; }

  // The sets of gen/gen.h. One layout for all pipelines, so that nothing that is bound is disturbed by
  // another one.
  VkPipelineLayout pipelineLayout() const { return pipelineLayout_; }
  VkDescriptorSetLayout textureSetLayout() const { return setLayouts_[1]; }
  // Sets that show `buffer`. Null: out of memory. Give them back with freeConstantSets.
  ConstantSets allocateConstantSets(VkBuffer buffer);
  void freeConstantSets(const ConstantSets& sets);

  // New images leave their first layout at the head of the next submission, whoever makes it.
  void addFreshImage(const FreshImage& image);
  // Whether it was one.
  bool removeFreshImage(VkImage image);
  void takeFreshImages(std::vector<FreshImage>& images);

  void countObject() { objects_.fetch_add(1, std::memory_order_relaxed); }
  void countMemory() {
    countObject();
    memoryAllocations_.fetch_add(1, std::memory_order_relaxed);
  }
  uint64_t objects() const { return objects_.load(std::memory_order_relaxed); }
  void countMemoryBytes(int64_t bytes) { memoryBytes_.fetch_add(bytes, std::memory_order_relaxed); }
  uint64_t memoryBytes() const { return static_cast<uint64_t>(memoryBytes_.load(std::memory_order_relaxed)); }
  uint64_t memoryAllocations() const { return memoryAllocations_.load(std::memory_order_relaxed); }

 private:
  VulkanDevice() = default;
  // Whoever makes an image or a buffer will draw, unlike programs that ask what there is: time to make what
  // that usually needs.
  void workAhead();
  bool initialise(const DeviceOptions& options, std::string& error);
  bool createLayouts();
  bool growConstantSets();
  void fillCaps(const VkPhysicalDeviceProperties& properties);
  int commonSamples() const;

  Instance instance_;
  VkDevice handle_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VolkDeviceTable fn_{};
  Features features_;
  Driver driver_;
  Quirks quirks_;
  bool isCpu_ = false;
  render::DebugOptions debug_;
  Labels labels_;
  VkPhysicalDeviceLimits limits_{};
  render::Caps caps_;
  StoreFormats formats_;
  std::atomic<uint64_t> objects_{0}, memoryAllocations_{0};
  std::atomic<bool> workingAhead_{false};
  std::atomic<int64_t> memoryBytes_{0};

  VkDescriptorSetLayout setLayouts_[3]{};
  VkPipelineLayout pipelineLayout_ = VK_NULL_HANDLE;

  std::mutex mutex_;  // guards what follows
  std::vector<VkDescriptorPool> constantPools_;
  std::vector<ConstantSets> freeConstantSets_;
  std::vector<FreshImage> freshImages_;

  std::unique_ptr<MemoryPool> memory_;
  std::unique_ptr<Timeline> timeline_;
  std::unique_ptr<Presenter> presenter_;
  std::unique_ptr<SamplerCache> samplers_;
  std::unique_ptr<ShaderLibrary> shaders_;
  std::unique_ptr<LegacyPasses> legacyPasses_;
  std::unique_ptr<DriverCache> driverCache_;
  std::unique_ptr<PipelineCache> pipelines_;
  std::unique_ptr<PipelineWarmUp> warmUp_;
  std::unique_ptr<FrameCapture> capture_;  // null: none is wanted
};

}  // namespace anteroom::vulkan
