#include "layer/vulkan/context.h"

#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/timeline.h"
#include "layer/vulkan/images/attachments.h"
#include "layer/vulkan/images/clear.h"
#include "layer/vulkan/images/copy.h"
#include "layer/vulkan/images/hud.h"
#include "layer/vulkan/images/mipmaps.h"
#include "layer/vulkan/images/read_back.h"
#include "layer/vulkan/images/stores.h"
#include "layer/vulkan/images/upload.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/windows/present.h"
#include "layer/vulkan/windows/presenter.h"

namespace anteroom::vulkan {

VulkanContext::VulkanContext(VulkanDevice& device)
    : device_(device),
      recorder_(device),
      geometry_(device, recorder_.vertices(), recorder_.indices()),
      planner_(device) {}

VulkanContext::~VulkanContext() {
  while (openGroups_ > 0) popGroup();
  finish();
  ShaderLibrary::flush();
  device_.driverCache().save();
}

// The road of a draw.
bool VulkanContext::draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) {
  ++draws_;
  if (recorder_.held() && join(state, changed, call)) return true;
  recorder_.drawHeld();
  recorder_.submitLong();
  const DrawPlan& plan = planner_.plan();
  changed |= geometry_.batch().chooseCarried(state, call, changed, plan.blocks);
  if (!planner_.update(state, changed, geometry_.batch().carried())) return false;
  if (changed & gen::kGroupArrays || configured_ != plan.vertexShader)
    geometry_.configure(state, plan.vertexKey, plan.push.data.data(), plan.push.size);
  configured_ = plan.vertexShader;
  return plan.nothing || record(state, call);
}

// Appends the draw to the one that is held back. False: it is not of its kind.
bool VulkanContext::join(const render::State& state, gen::Groups changed, const render::DrawCall& call) {
  const DrawPlan& plan = planner_.plan();
  if (!geometry_.batch().accepts(call, changed, plan.blocks, recorder_.held())) return false;
  const bool arraysMoved = changed & gen::kGroupArrays;
  if (arraysMoved && !planner_.sameArrays(state.fixed)) return false;
  if (geometry_.batch().carried() == Carried::Values && changed & plan.blocks.pushGroups)
    planner_.packCarried(state);
  uint32_t count = 0;
  if (!geometry_.append(state, call, arraysMoved, recorder_.recordingId(), count)) return false;
  recorder_.growHeld(count);
  return true;
}

// Records a draw whose plan is made.
bool VulkanContext::record(const render::State& state, const render::DrawCall& call) {
  DrawPlan& plan = planner_.plan();
  if (!recorder_.commands() || !prepareTextures(recorder_, plan)) return false;
  Geometry geometry;
  if (!geometry_.build(state, call, recorder_.recordingId(), geometry)) return false;
  if (geometry.range.count == 0) return true;
  if (!prepareAttachments(recorder_, plan.target) || !recorder_.bind(plan, geometry)) return false;
  DrawRange batch;
  if (geometry_.opensBatch(call, geometry, batch))
    recorder_.holdBack(batch);
  else
    recorder_.draw(geometry.range);
  return true;
}

// For all but draws: what was held back comes before, and what comes may change what draws after it see.
Recorder& VulkanContext::recorder() {
  recorder_.drawHeld();
  return recorder_;
}

bool VulkanContext::clear(const render::State& state, gen::Groups changed, GLbitfield mask) {
  planner_.updateTarget(state, changed);
  return vulkan::clear(recorder(), planner_.plan().target, state, mask);
}

bool VulkanContext::readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect,
                               render::Format format, void* out, size_t rowPitch) {
  return vulkan::readPixels(recorder(), framebuffer, rect, format, out, rowPitch);
}

bool VulkanContext::upload(render::Image& image, const render::Region& region, const void* data,
                           size_t rowPitch, size_t slicePitch) {
  return vulkan::upload(recorder(), vulkan(image), region, data, rowPitch, slicePitch);
}

bool VulkanContext::copyFromFramebuffer(render::Image& image, const render::Region& region,
                                        const render::Framebuffer& source, int x, int y) {
  return vulkan::copyFromFramebuffer(recorder(), vulkan(image), region, source, x, y);
}

bool VulkanContext::copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) {
  return vulkan::copyLevel(recorder(), vulkan(image), level, vulkan(source), sourceLevel);
}

bool VulkanContext::generateMipmaps(render::Image& image) {
  return vulkan::generateMipmaps(recorder(), vulkan(image));
}

void VulkanContext::drawHud(const render::Framebuffer& framebuffer, const render::Hud& hud) {
  vulkan::drawHud(recorder(), targetOf(framebuffer), hud);
}

render::Presented VulkanContext::present(render::Window& window, std::span<const render::Rect> damage) {
  return vulkan::present(recorder(), static_cast<VulkanWindow&>(window), damage);
}

void VulkanContext::pushGroup(std::string_view text) {
  const VkCommandBuffer commands = device_.labels().inCommands() ? recorder().commands() : VK_NULL_HANDLE;
  if (!commands) return;
  device_.labels().begin(commands, text);
  ++openGroups_;
}

void VulkanContext::popGroup() {
  if (openGroups_ == 0) return;
  --openGroups_;
  if (const VkCommandBuffer commands = recorder().commands()) device_.labels().end(commands);
}

void VulkanContext::mark(std::string_view text) {
  const VkCommandBuffer commands = device_.labels().inCommands() ? recorder().commands() : VK_NULL_HANDLE;
  if (commands) device_.labels().insert(commands, text);
}

void VulkanContext::flush() {
  recorder_.submit();
}

void VulkanContext::finish() {
  recorder_.submit();
  recorder_.waitForSubmitted();
  device_.presenter().wait(nullptr);
  recorder_.retire();
}

uint64_t VulkanContext::insertFence() {
  recorder_.submit();
  return recorder_.lastSubmitted();
}

bool VulkanContext::waitFence(uint64_t fence, uint64_t timeout) {
  return device_.timeline().wait(fence, timeout);
}

const render::Stats& VulkanContext::stats() const {
  stats_.draws = draws_;
  stats_.submits = recorder_.submits();
  stats_.bytesUploaded = recorder_.uploaded();
  stats_.renderPasses = recorder_.passes();
  stats_.pipelinesCreated = device_.pipelines().created();
  stats_.shadersCompiled = device_.shaders().compiled();
  stats_.shadersFromCache = device_.shaders().fromCache();
  stats_.vulkanObjectsCreated = device_.objects();
  stats_.memoryAllocations = device_.memoryAllocations();
  stats_.memoryBytes = device_.memoryBytes();
  return stats_;
}

}  // namespace anteroom::vulkan
