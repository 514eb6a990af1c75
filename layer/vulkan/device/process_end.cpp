#include "layer/vulkan/device/process_end.h"

#include <unistd.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

struct Devices {
  struct Entry {
    VulkanDevice* device;
    int process;  // that made it: children of fork have not got its threads
  };
  std::atomic<int> process{0};  // that made the last one: a child may find the mutex locked by nobody
  mutable std::mutex mutex;
  std::vector<Entry> all;

  static Devices& ofProcess() {
    // Never destroyed: devices may be, later.
    static Devices* const devices = new Devices;
    // Made after the first device, and so after the driver was loaded: destroyed before its threads are.
    static const struct End {
      ~End() {
        if (devices->process != getpid()) return;
        const std::lock_guard lock(devices->mutex);
        for (const Entry& entry : devices->all)
          if (entry.process == getpid()) entry.device->waitForThreads();
      }
    } end;
    return *devices;
  }
};

// Destroyed when its thread ends, and first of all by exit(). Only the first thread's end is for
// certain the process's.
struct Worker {
  ~Worker() {
    const bool ends = gettid() == getpid();
    const Devices& devices = Devices::ofProcess();
    if (devices.process != getpid()) return;
    const std::lock_guard lock(devices.mutex);
    for (const Devices::Entry& entry : devices.all) {
      if (entry.process != getpid()) continue;
      if (ends)
        entry.device->finishWork();
      else
        entry.device->wait();
    }
  }
  bool noted = false;
};

}  // namespace

void noteWorker() {
  thread_local Worker worker;
  worker.noted = true;
}

void finishAtExit(VulkanDevice& device) {
  noteWorker();
  Devices& devices = Devices::ofProcess();
  const std::lock_guard lock(devices.mutex);
  devices.process = getpid();
  devices.all.push_back({&device, getpid()});
}

void forgetAtExit(VulkanDevice& device) {
  Devices& devices = Devices::ofProcess();
  const std::lock_guard lock(devices.mutex);
  std::erase_if(devices.all, [&](const Devices::Entry& entry) { return entry.device == &device; });
}

}  // namespace anteroom::vulkan
