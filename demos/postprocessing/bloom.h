// Light bloom, section 4.1 of the paper: a mask of what shines is reduced four times, the reductions are
// added up with weights, and that glare is blended with the scene.
#pragma once

#include <array>
#include <functional>

#include "room/framebuffer.h"

namespace postprocessing {

inline constexpr int kMaskSize = 256;

struct Reduction {
  int size;       // pixels
  double weight;  // in the glare
};
inline constexpr std::array<Reduction, 4> kReductions = {{{128, 0.12}, {64, 0.24}, {32, 0.44}, {16, 0.95}}};

// Changes what is bound and enabled, both matrices and the viewport, and leaves the context's surface bound.
class Bloom {
 public:
  explicit Bloom(const room::FramebufferFunctions& gl);

  // drawMask draws white and black into a cleared (black) target with depth.
  void render(const std::function<void()>& drawMask);
  // color + glare * (1 - color), over the whole viewport.
  void addGlare(const glm::dvec3& color) const;

  const room::RenderTarget& mask() const { return mask_; }
  const room::RenderTarget& reduction(std::size_t i) const { return reductions_.at(i); }
  const room::RenderTarget& glare() const { return glare_; }

 private:
  room::RenderTarget mask_;
  std::array<room::RenderTarget, kReductions.size()> reductions_;
  room::RenderTarget glare_;
};

// The target's picture over the whole viewport.
void showPicture(const room::RenderTarget& picture);

}  // namespace postprocessing
