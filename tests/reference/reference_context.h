// The seam's Context, in float64.
#pragma once

#include "layer/render/renderer.h"
#include "tests/reference/image_store.h"

namespace anteroom::reference {

class ReferenceContext final : public render::Context {
 public:
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
  // Every call is finished when it returns.
  void flush() override {}
  void finish() override {}
  uint64_t insertFence() override { return ++fence_; }
  bool waitFence(uint64_t, uint64_t) override { return true; }
  const render::Stats& stats() const override { return stats_; }

 private:
  render::Stats stats_;
  uint64_t fence_ = 0;
};

}  // namespace anteroom::reference
