// A context's commands: one primary command buffer a submission, a few in flight. Knows which stores a
// recording uses and when a barrier is due.
#pragma once

#include <volk.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "layer/vulkan/resources/image.h"

namespace anteroom::vulkan {

struct BufferStore;
class VulkanDevice;

class CommandStream {
 public:
  explicit CommandStream(VulkanDevice& device);
  ~CommandStream();
  bool initialise();

  // The command buffer, begun when necessary. Null: the device is lost or out of memory.
  VkCommandBuffer commands() { return recording_ ? slots_[slot_].main : begin(); }
  bool recording() const { return recording_; }
  // Changes with each command buffer: what was bound in another one is no longer bound.
  uint64_t recordingId() const { return recordingId_; }

  void hold(const std::shared_ptr<BufferStore>& store);
  // To be called before commands that read or write the image are recorded, and outside a pass where it says
  // so.
  void hold(const std::shared_ptr<ImageStore>& store);
  void read(const std::shared_ptr<ImageStore>& store) {
    hold(store);
    store->readEpoch = std::max(store->readEpoch, epoch_);
  }
  void write(const std::shared_ptr<ImageStore>& store) {
    hold(store);
    store->writeEpoch = std::max(store->writeEpoch, epoch_);
    store->written = true;
    ++store->version;
  }
  // Where contexts share an image, the epoch may be another one's that began later: also since then, then.
  bool mustWaitToRead(const ImageStore& store) const { return recording_ && store.writeEpoch >= epoch_; }
  bool mustWaitToWrite(const ImageStore& store) const {
    return recording_ && (store.writeEpoch >= epoch_ || store.readEpoch >= epoch_);
  }
  // Whether the present recording may use it: true, too, when a younger one of another context does.
  bool mayUse(const ImageStore& store) const { return recording_ && store.lastRecording >= recordingId_; }

  // What was recorded before is done, and visible, for what is recorded after. Not inside a pass.
  void barrier();

  // A set for the textures of a draw, without push descriptors. Lives as long as the recording.
  VkDescriptorSet allocateTextureSet();

  // Submits what was recorded and returns its number, or that of the last submission when there is nothing.
  // 0: the device is lost or out of memory. `signal`: a semaphore for presenting; there must be something.
  uint64_t submit(VkSemaphore signal = VK_NULL_HANDLE);
  uint64_t lastSubmitted() const { return lastSubmitted_; }
  // Drops the references of submissions that are complete.
  void retire();
  bool lost() const { return lost_; }

 private:
  static constexpr int kSlots = 3;
  struct Slot {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer fresh = VK_NULL_HANDLE, main = VK_NULL_HANDLE;
    uint64_t serial = 0;
    std::vector<std::shared_ptr<ImageStore>> images;
    std::vector<std::shared_ptr<BufferStore>> buffers;
    std::vector<VkDescriptorPool> descriptorPools;
    size_t usedPools = 0;
    uint32_t setsLeft = 0;
  };

  VkCommandBuffer begin();
  void release(Slot& slot);
  void nameSlot(const Slot& slot) const;

  VulkanDevice& device_;
  const unsigned number_;
  std::array<Slot, kSlots> slots_;
  int slot_ = 0;
  bool recording_ = false;
  bool lost_ = false;
  uint64_t recordingId_ = 0;
  uint64_t epoch_ = 0;
  uint64_t lastSubmitted_ = 0;
};

}  // namespace anteroom::vulkan
