#include "layer/vulkan/windows/present.h"

#include "layer/vulkan/images/copy.h"
#include "layer/vulkan/images/hud.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {
namespace {

// Over what goes to the screen alone: the picture that a program goes on with may be another image.
bool drawHudOver(Recorder& recorder, VulkanWindow& window) {
  render::Framebuffer framebuffer;
  framebuffer.color.image = window.overlay();
  framebuffer.width = framebuffer.color.image->desc().width;
  framebuffer.height = framebuffer.color.image->desc().height;
  framebuffer.yDown = true;
  const bool done = drawHud(recorder, targetOf(framebuffer), *window.hud());
  recorder.endPass();
  vulkan(*framebuffer.color.image).setStore(nullptr);
  return done;
}

render::Presented show(Recorder& recorder, VulkanWindow& window, std::span<const render::Rect> damage) {
  VulkanImage& picture = window.drawn();
  if (!doPendingClear(recorder, picture)) return render::Presented::OutOfMemory;
  recorder.endPass();
  if (window.isGone()) {
    recorder.submit();
    window.lose();
  }
  if (!window.shown()) {
    recorder.submit();
    return window.lost() ? render::Presented::Lost : render::Presented::Shown;
  }
  const std::shared_ptr<ImageStore> shown = *window.shown();
  if (picture.held() != shown) {
    if (!copyStore(recorder, picture.held(), shown, window.extent())) return render::Presented::OutOfMemory;
  } else if (window.preserved()) {
    std::shared_ptr<ImageStore> kept = picture.newStore();
    if (!kept || !copyStore(recorder, shown, kept, window.extent())) return render::Presented::OutOfMemory;
    picture.setStore(std::move(kept));
  }
  if (window.hud() && !drawHudOver(recorder, window)) return render::Presented::OutOfMemory;
  if (!recorder.leaveForPresentation(shown) || !recorder.submit(window.semaphore()))
    return render::Presented::OutOfMemory;
  return window.present(recorder.lastSubmitted(), damage);
}

}  // namespace

render::Presented present(Recorder& recorder, VulkanWindow& window, std::span<const render::Rect> damage) {
  // A picture that nobody drew is shown, too.
  const bool ready = window.makeReady();
  const render::Presented result = ready ? show(recorder, window, damage) : render::Presented::OutOfMemory;
  window.expire();
  return result;
}

}  // namespace anteroom::vulkan
