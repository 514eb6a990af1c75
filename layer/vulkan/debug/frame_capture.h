// ANTEROOM_DEBUG=capture: RenderDoc captures a frame, from one eglSwapBuffers to the next, also of programs
// that have no window, whose frames it cannot see by itself.
#pragma once

#include <volk.h>

#include <mutex>

namespace anteroom::vulkan {

struct RenderDoc;  // its in-application interface

// Thread-safe. Frames are those of all contexts of a device.
class FrameCapture {
 public:
  // `frame` from 1. The first one begins here, and ends with the device when nothing is swapped.
  FrameCapture(VkInstance instance, int frame);
  ~FrameCapture();
  FrameCapture(const FrameCapture&) = delete;
  FrameCapture& operator=(const FrameCapture&) = delete;

  void endFrame();

 private:
  void begin();
  void end();

  const VkInstance instance_;
  const int frame_;
  const RenderDoc* renderDoc_ = nullptr;  // null: it is not there
  std::mutex mutex_;
  int ended_ = 0;
  bool capturing_ = false;
};

}  // namespace anteroom::vulkan
