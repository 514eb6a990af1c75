// The pipelines that this program usually needs, made beside its own start.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>

namespace anteroom::cache {
struct PipelineRow;
}

namespace anteroom::vulkan {

class VulkanDevice;

// Whether this device can make it, and did. Both shaders are made, too.
bool makeAhead(VulkanDevice& device, const cache::PipelineRow& row);

class PipelineWarmUp {
 public:
  explicit PipelineWarmUp(VulkanDevice& device) : device_(device) {}
  ~PipelineWarmUp();
  PipelineWarmUp(const PipelineWarmUp&) = delete;
  PipelineWarmUp& operator=(const PipelineWarmUp&) = delete;

  // Once; nothing without a shader cache. It ends with the device or the process.
  void start();
  // Waits for no more than the pipeline that is being made, and saves what the driver keeps.
  void stop();

 private:
  void run();

  VulkanDevice& device_;
  std::mutex mutex_;  // guards the thread
  std::thread thread_;
  int process_ = 0;  // that started it
  bool started_ = false;
  std::atomic<bool> stopping_{false};
};

}  // namespace anteroom::vulkan
