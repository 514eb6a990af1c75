// Images: what the GL sees, and the stores behind it.
#pragma once

#include <volk.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "layer/render/renderer.h"
#include "layer/vulkan/device/formats.h"
#include "layer/vulkan/device/memory.h"

namespace anteroom::vulkan {

class VulkanDevice;

// One VkImage, always in layout GENERAL for the contexts. Recordings that use it hold a reference until they
// are complete: it is idle when its image alone holds it.
struct ImageStore {
  explicit ImageStore(VulkanDevice& owner) : device(owner) {}
  ~ImageStore();
  ImageStore(const ImageStore&) = delete;
  ImageStore& operator=(const ImageStore&) = delete;

  struct Plane {  // one level of one layer of a LINEAR image
    VkDeviceSize offset, rowPitch, slicePitch;
  };
  struct AttachmentView {
    int level, layer;
    VkImageView view;
  };
  using PartView = AttachmentView;
  // Without dynamic rendering: this image as color (or as depth, where there is no color) with others, whose
  // views are told apart by the stores' numbers: handles are used again.
  struct LegacyFramebuffer {
    VkRenderPass renderPass;
    VkImageView color, depth, resolve;
    uint64_t depthStore, resolveStore;
    VkFramebuffer framebuffer;
  };

  const Plane& plane(int level, int layer) const { return planes[level * layers + layer]; }
  // Destroys the image, unless it is borrowed, and all that refers to it. Nothing uses it any more.
  void release();

  // Null: out of memory.
  VkImageView attachmentView(int level, int layer);
  // One level of one layer, for sampling.
  VkImageView partView(int level, int layer, const VkComponentMapping& swizzle);

  VulkanDevice& device;
  VkImage image = VK_NULL_HANDLE;
  bool borrowed = false;              // from a swapchain
  VkImageView view = VK_NULL_HANDLE;  // for sampling; null for what is never sampled
  Allocation memory;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageAspectFlags aspects = 0;
  VkImageType type = VK_IMAGE_TYPE_2D;
  int layers = 1;
  uint64_t id = 0;              // never used twice in a process
  uint64_t version = 0;         // of its contents
  std::byte* mapped = nullptr;  // LINEAR: the image's memory
  std::vector<Plane> planes;    // LINEAR only
  std::vector<AttachmentView> attachmentViews;
  std::vector<PartView> partViews;
  std::vector<LegacyFramebuffer> legacyFramebuffers;

  uint64_t recording = 0;      // that came to hold it last
  uint64_t lastRecording = 0;  // the youngest that ever held it
  uint64_t readEpoch = 0;      // the youngest in which recorded commands read it, and write it
  uint64_t writeEpoch = 0;
  bool written = false;              // by the device, since it was last known idle
  std::atomic<uint64_t> lastUse{0};  // the last submission that uses it
};

// A glClear that nobody has seen yet.
struct PendingClear {
  VkImageAspectFlags aspects = 0;
  int level = 0, layer = 0;
  VkClearColorValue color{};
  VkClearDepthStencilValue depthStencil{};
};

// Contents of a level: what samples were resolved into it last is still there while this holds.
struct Contents {
  uint64_t store = 0, version = 0;
  int level = 0, layer = 0;
  bool operator==(const Contents&) const = default;
};

// A number for a new store.
uint64_t newStoreId();

class VulkanImage final : public render::Image {
 public:
  VulkanImage(VulkanDevice& device, const render::ImageDesc& desc);
  VulkanImage(VulkanDevice& device, const render::ImageDesc& desc, const StoreFormat& format);

  void setLabel(std::string_view text) override;

  // The store, made at the first call. Null: out of memory. `overwritten`: all of it is about to be.
  ImageStore* store(bool overwritten = false);
  bool hasStore() const { return store_ != nullptr; }
  const std::shared_ptr<ImageStore>& held() const { return store_; }
  // A store that could be the image's. Null: out of memory.
  std::shared_ptr<ImageStore> newStore() const { return createStore(desc_.samples, true); }
  // Null: the image will make one of its own. For windows, whose stores are the swapchain's.
  void setStore(std::shared_ptr<ImageStore> store) { store_ = std::move(store); }
  // Puts an idle store in the place of the present one and returns the former. Null: out of memory.
  std::shared_ptr<ImageStore> replaceStore();
  // A store with one sample a pixel, for the mean of the samples of a multisampled image. Null: out of
  // memory.
  ImageStore* averaged();
  const std::shared_ptr<ImageStore>& heldAveraged() const { return averaged_; }

  const StoreFormat& format() const { return format_; }
  int levelWidth(int level) const { return std::max(1, desc_.width >> level); }
  int levelHeight(int level) const { return std::max(1, desc_.height >> level); }
  int levelDepth(int level) const { return std::max(1, desc_.depth >> level); }
  // Bytes of all levels in the store.
  size_t bytes() const;

  PendingClear pending;
  bool averageStale = true;
  Contents resolvedInto;    // samples that belong to a level of another image: what they were resolved into
  bool alphaStale = false;  // an opaque format whose stored alpha is not 1

 private:
  std::shared_ptr<ImageStore> createStore(int samples, bool overwritten) const;
  void nameStore(const ImageStore& store, int samples) const;

  VulkanDevice& device_;
  const StoreFormat format_;
  std::string label_;
  std::shared_ptr<ImageStore> store_, averaged_;
  std::vector<std::shared_ptr<ImageStore>> spares_;  // former stores, to be used again when idle
};

inline VulkanImage& vulkan(render::Image& image) {
  return static_cast<VulkanImage&>(image);
}

}  // namespace anteroom::vulkan
