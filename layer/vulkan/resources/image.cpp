#include "layer/vulkan/resources/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

constexpr size_t kMostSpares = 3;

std::atomic<uint64_t> nextStoreId{1};

VkImageViewType sampledType(render::Dimension dimension) {
  switch (dimension) {
    case render::Dimension::Cube:
      return VK_IMAGE_VIEW_TYPE_CUBE;
    case render::Dimension::Volume:
      return VK_IMAGE_VIEW_TYPE_3D;
    default:
      return VK_IMAGE_VIEW_TYPE_2D;
  }
}

VkImageView createView(ImageStore& store, VkImageViewType type, VkImageAspectFlags aspects,
                       VkComponentMapping swizzle, VkImageSubresourceRange range) {
  VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = store.image;
  info.viewType = type;
  info.format = store.format;
  info.components = swizzle;
  info.subresourceRange = range;
  info.subresourceRange.aspectMask = aspects;
  VkImageView view = VK_NULL_HANDLE;
  if (store.device.fn().vkCreateImageView(store.device.handle(), &info, nullptr, &view) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  store.device.countObject();
  return view;
}

VkImageCreateInfo imageInfo(const render::ImageDesc& desc, const StoreFormat& format, int samples) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = desc.dimension == render::Dimension::Volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
  if (desc.dimension == render::Dimension::Cube) info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  if (desc.dimension == render::Dimension::Volume && format.renderable)
    info.flags = VK_IMAGE_CREATE_2D_ARRAY_COMPATIBLE_BIT;
  info.format = format.format;
  info.extent = {static_cast<uint32_t>(desc.width), static_cast<uint32_t>(desc.height),
                 static_cast<uint32_t>(desc.depth)};
  info.mipLevels = static_cast<uint32_t>(desc.levels);
  info.arrayLayers = desc.dimension == render::Dimension::Cube ? 6 : 1;
  info.samples = static_cast<VkSampleCountFlagBits>(samples);
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  if (format.aspects != VK_IMAGE_ASPECT_COLOR_BIT) {
    info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  } else {
    info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (samples == 1) info.usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (format.renderable) info.usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  }
  return info;
}

bool fits(VkPhysicalDevice device, const VkImageCreateInfo& info) {
  VkImageFormatProperties limits;
  return vkGetPhysicalDeviceImageFormatProperties(device, info.format, info.imageType, info.tiling,
                                                  info.usage, info.flags, &limits) == VK_SUCCESS &&
         info.extent.width <= limits.maxExtent.width && info.extent.height <= limits.maxExtent.height &&
         info.extent.depth <= limits.maxExtent.depth && info.mipLevels <= limits.maxMipLevels &&
         info.arrayLayers <= limits.maxArrayLayers && (info.samples & limits.sampleCounts);
}

// Contents nobody wrote: black, opaque where there is no alpha to see.
void fillFresh(ImageStore& store, const StoreFormat& format) {
  std::memset(store.mapped, 0, store.memory.size);
  if (!addsAlpha(format.conversion)) return;
  for (VkDeviceSize i = 3; i < store.memory.size; i += 4) store.mapped[i] = std::byte{255};
}

void readPlanes(ImageStore& store, const VkImageCreateInfo& info) {
  store.mapped = store.memory.mapped;
  for (uint32_t level = 0; level < info.mipLevels; ++level)
    for (uint32_t layer = 0; layer < info.arrayLayers; ++layer) {
      const VkImageSubresource subresource{VK_IMAGE_ASPECT_COLOR_BIT, level, layer};
      VkSubresourceLayout layout;
      store.device.fn().vkGetImageSubresourceLayout(store.device.handle(), store.image, &subresource,
                                                    &layout);
      store.planes.push_back({layout.offset, layout.rowPitch, layout.depthPitch});
    }
}

}  // namespace

uint64_t newStoreId() {
  return nextStoreId.fetch_add(1, std::memory_order_relaxed);
}

ImageStore::~ImageStore() {
  release();
}

void ImageStore::release() {
  const auto& fn = device.fn();
  if (image) device.removeFreshImage(image);
  for (const auto& held : legacyFramebuffers)
    fn.vkDestroyFramebuffer(device.handle(), held.framebuffer, nullptr);
  for (const auto& held : attachmentViews) fn.vkDestroyImageView(device.handle(), held.view, nullptr);
  for (const auto& held : partViews) fn.vkDestroyImageView(device.handle(), held.view, nullptr);
  fn.vkDestroyImageView(device.handle(), view, nullptr);
  if (!borrowed) fn.vkDestroyImage(device.handle(), image, nullptr);
  device.memory().free(memory);
  legacyFramebuffers.clear();
  attachmentViews.clear();
  partViews.clear();
  view = VK_NULL_HANDLE;
  image = VK_NULL_HANDLE;
}

VkImageView ImageStore::attachmentView(int level, int layer) {
  for (const auto& held : attachmentViews)
    if (held.level == level && held.layer == layer) return held.view;
  const VkImageView made =
      createView(*this, VK_IMAGE_VIEW_TYPE_2D, aspects, {},
                 {aspects, static_cast<uint32_t>(level), 1, static_cast<uint32_t>(layer), 1});
  if (made) attachmentViews.push_back({level, layer, made});
  return made;
}

VkImageView ImageStore::partView(int level, int layer, const VkComponentMapping& swizzle) {
  for (const auto& held : partViews)
    if (held.level == level && held.layer == layer) return held.view;
  const VkImageView made =
      createView(*this, VK_IMAGE_VIEW_TYPE_2D, aspects, swizzle,
                 {aspects, static_cast<uint32_t>(level), 1, static_cast<uint32_t>(layer), 1});
  if (made) partViews.push_back({level, layer, made});
  return made;
}

VulkanImage::VulkanImage(VulkanDevice& device, const render::ImageDesc& desc)
    : VulkanImage(device, desc, device.format(desc.format)) {}

VulkanImage::VulkanImage(VulkanDevice& device, const render::ImageDesc& desc, const StoreFormat& format)
    : render::Image(desc), device_(device), format_(format) {
  // A new depth image counts as cleared: it costs nothing until it is used.
  if (render::isDepthOrStencil(desc.format)) {
    pending.aspects = format_.aspects;
    pending.depthStencil = {1, 0};
  }
}

std::shared_ptr<ImageStore> VulkanImage::createStore(int samples, bool overwritten) const {
  const auto& fn = device_.fn();
  auto store = std::make_shared<ImageStore>(device_);
  VkImageCreateInfo info = imageInfo(desc_, format_, samples);
  bool linear = false;
  if (device_.isCpu() && format_.linear && samples == 1) {
    info.tiling = VK_IMAGE_TILING_LINEAR;
    linear = fits(device_.physical(), info);
  }
  info.tiling = linear ? VK_IMAGE_TILING_LINEAR : VK_IMAGE_TILING_OPTIMAL;
  info.initialLayout = linear ? VK_IMAGE_LAYOUT_PREINITIALIZED : VK_IMAGE_LAYOUT_UNDEFINED;
  if (!linear && !fits(device_.physical(), info)) return nullptr;

  store->format = format_.format;
  store->aspects = format_.aspects;
  store->type = info.imageType;
  store->layers = static_cast<int>(info.arrayLayers);
  store->id = newStoreId();
  if (fn.vkCreateImage(device_.handle(), &info, nullptr, &store->image) != VK_SUCCESS) return nullptr;
  device_.countObject();
  VkMemoryRequirements requirements;
  fn.vkGetImageMemoryRequirements(device_.handle(), store->image, &requirements);
  store->memory = device_.memory().allocate(linear ? MemoryKind::LinearImage : MemoryKind::OptimalImage,
                                            linear ? MemoryUse::ReadBack : MemoryUse::Device, requirements);
  if (!store->memory || fn.vkBindImageMemory(device_.handle(), store->image, store->memory.memory,
                                             store->memory.offset) != VK_SUCCESS)
    return nullptr;
  if (linear) {
    readPlanes(*store, info);
    if (!overwritten) fillFresh(*store, format_);
  }
  if (info.usage & VK_IMAGE_USAGE_SAMPLED_BIT) {
    store->view = createView(*store, sampledType(desc_.dimension), store->aspects, format_.swizzle,
                             {0, 0, info.mipLevels, 0, info.arrayLayers});
    if (!store->view) return nullptr;
  }
  const bool clear = !linear && format_.aspects == VK_IMAGE_ASPECT_COLOR_BIT;
  nameStore(*store, samples);
  device_.addFreshImage({store, store->image, store->aspects, info.initialLayout, clear});
  return store;
}

void VulkanImage::setLabel(std::string_view text) {
  label_ = text;
  if (store_) nameStore(*store_, desc_.samples);
  if (averaged_) nameStore(*averaged_, 1);
}

// "brick (texture 5) 512x512 RGB8, 10 levels"
void VulkanImage::nameStore(const ImageStore& store, int samples) const {
  const Labels& labels = device_.labels();
  if (!labels.nameAll()) {
    if (!label_.empty()) labels.name(VK_OBJECT_TYPE_IMAGE, store.image, label_);
    return;
  }
  std::string text =
      fmt::format("{} {}x{}", label_.empty() ? "image" : label_.c_str(), desc_.width, desc_.height);
  if (desc_.dimension == render::Dimension::Volume) text += fmt::format("x{}", desc_.depth);
  if (desc_.dimension == render::Dimension::Cube) text += " cube";
  text += fmt::format(" {}", render::nameOf(desc_.format));
  if (desc_.levels > 1) text += fmt::format(", {} levels", desc_.levels);
  if (samples > 1) text += fmt::format(", {} samples", samples);
  if (samples < desc_.samples) text += ", resolved";
  labels.name(VK_OBJECT_TYPE_IMAGE, store.image, text);
  if (store.view) labels.name(VK_OBJECT_TYPE_IMAGE_VIEW, store.view, text);
}

ImageStore* VulkanImage::store(bool overwritten) {
  if (!store_) store_ = createStore(desc_.samples, overwritten);
  return store_.get();
}

ImageStore* VulkanImage::averaged() {
  if (!averaged_) averaged_ = createStore(1, true);
  return averaged_.get();
}

std::shared_ptr<ImageStore> VulkanImage::replaceStore() {
  std::shared_ptr<ImageStore> next;
  for (auto& spare : spares_) {
    if (spare.use_count() != 1) continue;
    next = std::move(spare);
    std::swap(spare, spares_.back());
    spares_.pop_back();
    break;
  }
  if (!next) next = createStore(desc_.samples, true);
  if (!next) return nullptr;
  next->written = false;
  std::shared_ptr<ImageStore> former = std::exchange(store_, std::move(next));
  if (spares_.size() < kMostSpares) spares_.push_back(former);
  return former;
}

size_t VulkanImage::bytes() const {
  size_t sum = 0;
  for (int level = 0; level < desc_.levels; ++level)
    sum += static_cast<size_t>(levelWidth(level)) * levelHeight(level) * levelDepth(level);
  return sum * format_.bytes * (desc_.dimension == render::Dimension::Cube ? 6 : 1);
}

}  // namespace anteroom::vulkan
