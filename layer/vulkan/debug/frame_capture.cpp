#include "layer/vulkan/debug/frame_capture.h"

#include <dlfcn.h>

#include <cstdio>
#include <string>

namespace anteroom::vulkan {

// Version 1.0 of the interface, by the order of its functions; those that nobody calls here have no types.
struct RenderDoc {
  using Unused = void (*)();
  Unused version[1], options[4], keys[2], overlay[2], hooks[2], pathTemplate[2];
  uint32_t (*getNumCaptures)();
  uint32_t (*getCapture)(uint32_t index, char* fileName, uint32_t* length, uint64_t* timestamp);
  Unused triggerCapture, isConnected, launch, setActiveWindow;
  void (*startFrameCapture)(void* device, void* window);
  uint32_t (*isFrameCapturing)();
  uint32_t (*endFrameCapture)(void* device, void* window);
};

namespace {

constexpr int kVersion1_0 = 10000;

// Null: the process has not loaded it.
const RenderDoc* findRenderDoc() {
  void* const library = dlopen("librenderdoc.so", RTLD_NOW | RTLD_NOLOAD);
  if (!library) return nullptr;
  const auto getApi = reinterpret_cast<int (*)(int, void**)>(dlsym(library, "RENDERDOC_GetAPI"));
  void* api = nullptr;
  if (!getApi || getApi(kVersion1_0, &api) != 1) return nullptr;
  return static_cast<const RenderDoc*>(api);
}

// How RenderDoc knows an instance: by its dispatch table, which is the first thing in it.
void* deviceOf(VkInstance instance) {
  return *reinterpret_cast<void**>(instance);
}

}  // namespace

FrameCapture::FrameCapture(VkInstance instance, int frame)
    : instance_(instance), frame_(frame), renderDoc_(findRenderDoc()) {
  if (!renderDoc_)
    std::fprintf(stderr,
                 "anteroom: ANTEROOM_DEBUG=capture: RenderDoc is not loaded: start the program from it, or "
                 "set ENABLE_VULKAN_RENDERDOC_CAPTURE=1\n");
  else if (frame_ == 1)
    begin();
}

FrameCapture::~FrameCapture() {
  if (capturing_)
    end();
  else if (renderDoc_ && ended_ < frame_)
    std::fprintf(stderr, "anteroom: ANTEROOM_DEBUG=capture: there were only %d frames\n", ended_);
}

void FrameCapture::endFrame() {
  if (!renderDoc_) return;
  const std::lock_guard lock(mutex_);
  ++ended_;
  if (capturing_) end();
  if (ended_ + 1 == frame_) begin();
}

void FrameCapture::begin() {
  renderDoc_->startFrameCapture(deviceOf(instance_), nullptr);
  capturing_ = true;
}

void FrameCapture::end() {
  capturing_ = false;
  if (renderDoc_->endFrameCapture(deviceOf(instance_), nullptr) != 1) {
    std::fprintf(stderr, "anteroom: ANTEROOM_DEBUG=capture: RenderDoc failed to capture frame %d\n", frame_);
    return;
  }
  uint32_t length = 0;
  const uint32_t last = renderDoc_->getNumCaptures() - 1;
  std::string path;
  if (renderDoc_->getCapture(last, nullptr, &length, nullptr) == 1 && length) {
    path.resize(length);
    renderDoc_->getCapture(last, path.data(), &length, nullptr);
  }
  std::fprintf(stderr, "anteroom: frame %d is captured in %s\n", frame_, path.c_str());
}

}  // namespace anteroom::vulkan
