#include "layer/vulkan/windows/presenter.h"

#include <algorithm>
#include <utility>

#include "layer/cache/quiet_thread.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/windows/swapchain.h"

namespace anteroom::vulkan {

Presenter::~Presenter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Presenter::add(Swapchain& swapchain, uint32_t image, uint64_t serial,
                    const std::vector<VkRectLayerKHR>& damage) {
  {
    const std::lock_guard lock(mutex_);
    if (!thread_.joinable()) thread_ = cache::quietThread([this] { run(); });
    if (thread_.joinable()) {
      pictures_.push_back({&swapchain, image, serial, damage});
      changed_.notify_all();
      return;
    }
  }
  swapchain.show(image, damage);  // there is no thread to be had
}

void Presenter::wait(const Swapchain* swapchain) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] {
    return std::none_of(pictures_.begin(), pictures_.end(), [&](const Picture& picture) {
      return swapchain == nullptr || picture.swapchain == swapchain;
    });
  });
}

void Presenter::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return stop_ || !pictures_.empty(); });
    if (pictures_.empty()) return;
    // Taken out: others may be added meanwhile, and move it.
    Picture& first = pictures_.front();
    const Picture picture{first.swapchain, first.image, first.serial, std::move(first.damage)};
    lock.unlock();
    // Not with the queue in hand: others submit meanwhile.
    device_.timeline().wait(picture.serial, UINT64_MAX);
    picture.swapchain->show(picture.image, picture.damage);
    lock.lock();
    pictures_.erase(pictures_.begin());
    changed_.notify_all();
  }
}

}  // namespace anteroom::vulkan
