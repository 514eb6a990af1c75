// A context: a façade over the four parts that a draw goes through, and the operations on images.
#pragma once

#include "layer/render/renderer.h"
#include "layer/vulkan/geometry/geometry_builder.h"
#include "layer/vulkan/plan/draw_planner.h"
#include "layer/vulkan/recording/recorder.h"

namespace anteroom::vulkan {

class VulkanContext final : public render::Context {
 public:
  explicit VulkanContext(VulkanDevice& device);
  ~VulkanContext() override;
  bool initialise() { return recorder_.initialise(); }

  void setListener(render::Listener* listener) override { recorder_.setListener(listener); }
  void pushGroup(std::string_view text) override;
  void popGroup() override;
  void mark(std::string_view text) override;
  bool lost() const override { return recorder_.lost(); }
  bool draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) override;
  bool clear(const render::State& state, gen::Groups changed, GLbitfield mask) override;
  bool readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect, render::Format format,
                  void* out, size_t rowPitch) override;
  bool upload(render::Image& image, const render::Region& region, const void* data, size_t rowPitch,
              size_t slicePitch) override;
  bool copyFromFramebuffer(render::Image& image, const render::Region& region,
                           const render::Framebuffer& source, int x, int y) override;
  bool copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) override;
  bool generateMipmaps(render::Image& image) override;
  void flush() override;
  void finish() override;
  render::Presented present(render::Window& window, std::span<const render::Rect> damage) override;
  uint64_t insertFence() override;
  bool waitFence(uint64_t fence, uint64_t timeout) override;
  void drawHud(const render::Framebuffer& framebuffer, const render::Hud& hud) override;
  const render::Stats& stats() const override;

 private:
  bool join(const render::State& state, gen::Groups changed, const render::DrawCall& call);
  bool record(const render::State& state, const render::DrawCall& call);
  Recorder& recorder();

  VulkanDevice& device_;
  Recorder recorder_;
  GeometryBuilder geometry_;
  DrawPlanner planner_;

  const Shader* configured_ = nullptr;  // whose arrays the geometry is configured for
  int openGroups_ = 0;
  uint64_t draws_ = 0;
  mutable render::Stats stats_;
};

}  // namespace anteroom::vulkan
